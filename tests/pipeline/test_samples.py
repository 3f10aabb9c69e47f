"""The sample projects that come with the program are whole, small, and measure again what they state."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from measureapp.cli import main
from measureapp.data.dimension import Verdict
from measureapp.errors import InputError, StorageError
from measureapp.pipeline import samples
from measureapp.pipeline.measure_again import measure_again
from measureapp.pipeline.samples import LARGEST_BYTES, pack_sample, sample_names, unpack_sample
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.upkeep import verify
from measureapp.resources import resource

VERDICTS = {"gypsum": {Verdict.PASS}, "gear": {Verdict.PASS, Verdict.NOT_PROVEN}}
ALL_MB = 4.0


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory: pytest.TempPathFactory) -> dict[str, ProjectFolder]:
    root = tmp_path_factory.mktemp("samples")
    return {name: unpack_sample(name, root / name) for name in sample_names()}


def test_every_sample_opens_undamaged_with_verdicts_clouds_and_surface(unpacked: dict[str, ProjectFolder]) -> None:
    assert set(unpacked) == set(VERDICTS)
    for name, project in unpacked.items():
        assert verify(project.path).whole
        measurement = project.measurement()
        assert measurement is not None and measurement.inspection is not None and measurement.mesh is not None
        assert {one.verdict for one in measurement.inspection.dimensions} == VERDICTS[name]
        assert all(len(view.cloud) == view.quality.points > 1000 for view in measurement.views)
        assert project.calibration() is not None and project.plan() is not None and project.rig_uncertainty() is not None
        assert project.stale_results() == ()


def test_the_samples_are_small_and_open_at_once(tmp_path: Path) -> None:
    sizes = [resource(f"samples/{name}.zip").stat().st_size for name in sample_names()]
    assert max(sizes) <= LARGEST_BYTES
    assert sum(sizes) < ALL_MB * 1e6
    began = time.process_time()
    assert unpack_sample("gypsum", tmp_path / "new").measurement() is not None
    assert time.process_time() - began < 3.0


def test_a_sample_is_measured_again_with_the_same_result(unpacked: dict[str, ProjectFolder]) -> None:
    project = unpacked["gypsum"]
    before = project.measurement()
    assert before is not None and before.inspection is not None
    again = measure_again(project, before, NoProgress()).measurement
    assert again.inspection is not None
    for one, other in zip(before.inspection.dimensions, again.inspection.dimensions, strict=True):
        assert one.measured == pytest.approx(other.measured, abs=1e-4)
        assert one.verdict is other.verdict


def test_a_sample_is_unpacked_once_and_then_opened(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "mine"
    assert main(["sample", "open", "gypsum", "--out", str(folder)]) == 0
    (folder / "identification.json").write_text('{"schema_version": 1, "operator": "me"}', encoding="utf-8")
    capsys.readouterr()
    assert main(["sample", "open", "gypsum", "--out", str(folder), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["project"] == str(folder)
    assert "me" in (folder / "identification.json").read_text(encoding="utf-8")


def test_samples_are_refused_into_other_folders_and_under_other_names(tmp_path: Path) -> None:
    (tmp_path / "letter.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(InputError, match="not an empty folder"):
        unpack_sample("gypsum", tmp_path)
    with pytest.raises(InputError, match="no sample project"):
        unpack_sample("../secret", tmp_path / "new")
    assert not (tmp_path / "new").exists()


@pytest.mark.slow
def test_a_measured_project_is_packed_as_a_sample(unpacked: dict[str, ProjectFolder], tmp_path: Path, monkeypatch) -> None:
    source, archive = unpacked["gypsum"], tmp_path / "again.zip"
    pack_sample(source.path, archive, title="Packed again", every=1)
    monkeypatch.setattr(samples, "resource", lambda path: tmp_path if path == samples.FOLDER else tmp_path / Path(path).name)
    packed = unpack_sample("again", tmp_path / "project")
    before, after = source.measurement(), packed.measurement()
    assert before is not None and after is not None and after.inspection is not None and before.inspection is not None
    assert packed.name == "Packed again" and packed.storage_rules().raw == "drop"
    assert [len(view.cloud) for view in after.views] == [len(view.cloud) for view in before.views]
    for one, other in zip(before.inspection.dimensions, after.inspection.dimensions, strict=True):
        assert one.measured == pytest.approx(other.measured, abs=2e-3)
    monkeypatch.setattr(samples, "LARGEST_BYTES", 1000)
    with pytest.raises(StorageError, match="--every"):
        pack_sample(source.path, tmp_path / "large.zip", title="Too large", every=1)
    assert not (tmp_path / "large.zip").exists()
