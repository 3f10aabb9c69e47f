"""A measured project is filed in the series of its program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from measureapp.data.dimension import Verdict
from measureapp.data.identification import Identification
from measureapp.errors import InputError
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.identification_file import save_identification
from measureapp.project.rig_file import read_rig
from measureapp.project.series.filing import file_run, find_runs
from measureapp.project.series.store import SeriesStore
from measureapp.resources import resource


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    made = ProjectFolder.create(
        tmp_path / "projects" / "p", ProjectSettings(name="p", part="part", rig=read_rig(resource("rigs/paper.toml")))
    )
    save_identification(made.path, Identification(serial_number="件-7", operator="Ö. Müller"))
    return made


def test_a_run_holds_what_the_measurement_found(project: ProjectFolder, measured, tmp_path: Path) -> None:
    measurement = measured()
    run, _ = file_run(project, measurement, root=tmp_path / "results")
    assert run.verdict is Verdict.FAIL and run.program == measurement.inspection.program
    assert (run.identification.serial_number, run.identification.operator, run.identification.machine) == ("件-7", "Ö. Müller", "Paper rig")
    for value, dimension in zip(run.values, measurement.inspection.dimensions, strict=True):
        assert (value.name, value.measured, value.uncertainty, value.verdict) == (
            dimension.name, dimension.measured, dimension.uncertainty, dimension.verdict,
        )  # fmt: skip
    assert SeriesStore(run.program, tmp_path / "results").runs() == (run,)


def test_filing_the_same_measurement_again_adds_nothing_but_another_one_needs_a_reason(project, measured, tmp_path: Path) -> None:
    root = tmp_path / "results"
    first, is_new = file_run(project, measured(), root=root)
    assert is_new and file_run(project, measured(), root=root) == (first, False)
    later = replace(measured(), measured_at="2026-05-05T10:20:30+00:00")
    with pytest.raises(InputError, match="measured before"):
        file_run(project, later, root=root)
    file_run(project, later, repeat_reason="dust on the part", root=root)
    assert [run.repeat_reason for run in SeriesStore(first.program, root).runs()] == ["", "dust on the part"]


def test_a_lost_series_is_found_in_the_projects(project: ProjectFolder, measured, tmp_path: Path) -> None:
    run, _ = file_run(project, measured(), root=tmp_path / "results")
    assert find_runs([tmp_path]) == (run,)
    store = SeriesStore(run.program, tmp_path / "results")
    store.path.unlink()
    store.rebuild(find_runs([tmp_path]))
    assert store.runs() == (run,)
    contents = project.journal.contents()
    assert contents is not None and f"series/{run.run_id}.json" in contents.files


def test_a_project_without_dimensions_is_not_filed(project: ProjectFolder, measured, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no evaluated dimensions"):
        file_run(project, measured(dimensions=None), root=tmp_path)
