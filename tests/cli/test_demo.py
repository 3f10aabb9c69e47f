"""What `demo` says to people; the run itself is proved in tests/pipeline."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import trimesh
from demo_fixture import Demo

from measureapp.cli import main
from measureapp.data.dimension import Verdict
from measureapp.demo import DemoRequest
from measureapp.pipeline.run import Outcome


@pytest.fixture
def finished_as(demo: Demo, monkeypatch: pytest.MonkeyPatch):
    """Make `demo` end as the suite's demo did, with chosen verdicts; return the list of what was asked for."""

    def ending(*verdicts: Verdict) -> list[DemoRequest]:
        measurement = demo.project.measurement()
        assert measurement is not None and measurement.inspection is not None
        chosen = zip(measurement.inspection.dimensions, verdicts, strict=True)
        inspection = replace(measurement.inspection, dimensions=tuple(replace(one, verdict=verdict) for one, verdict in chosen))
        outcome = Outcome(
            replace(measurement, inspection=inspection), demo.document, {"report_pdf": Path(demo.document["files"]["report_pdf"])}
        )
        asked: list[DemoRequest] = []
        monkeypatch.setattr("measureapp.demo.run_demo", lambda request, *_: asked.append(request) or outcome)
        return asked

    return ending


def test_without_options_half_a_resolution_of_gypsum_goes_into_a_folder_named_after_it(finished_as, capsys) -> None:
    asked = finished_as(*[Verdict.PASS] * 4)
    assert main(["demo"]) == 0
    assert asked == [DemoRequest(Path("demo-gypsum-half"), "gypsum", "half", None, 1)]


def test_a_part_given_as_a_file_names_the_folder(finished_as, capsys) -> None:
    asked = finished_as(*[Verdict.PASS] * 4)
    main(["demo", "--part", "somewhere/bracket.stl", "--resolution", "quarter", "--viewpoints", "3", "--seed", "7"])
    assert asked == [DemoRequest(Path("demo-bracket-quarter"), "somewhere/bracket.stl", "quarter", 3, 7)]


def test_the_report_is_written_in_the_chosen_language(finished_as, capsys) -> None:
    asked = finished_as(*[Verdict.PASS] * 4)
    assert main(["demo", "--language", "zh_CN"]) == 0
    assert asked == [DemoRequest(Path("demo-gypsum-half"), language="zh_CN")]
    assert main(["demo", "--language", "klingon"]) == 2 and len(asked) == 1


def test_people_read_points_dimensions_truth_and_where_the_report_is(finished_as, demo: Demo, capsys) -> None:
    finished_as(*[Verdict.PASS] * 4)
    assert main(["demo"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("gypsum: ") and "from 6 of 6 views" in said
    assert [line.split()[1] for line in said.splitlines() if line.startswith("  ✓")] == ["a", "b", "c", "d"]
    assert f"rms {demo.document['truth_deviation']['rms']:.3f} mm" in said
    assert f"kinematic positions: rms {demo.document['truth_deviation']['kinematic_only']['rms']:.3f} mm" in said
    assert said.endswith("report.pdf\n")


@pytest.mark.parametrize("verdict", [Verdict.FAIL, Verdict.NOT_PROVEN, Verdict.NOT_MEASURED])
def test_one_dimension_that_does_not_pass_is_the_exit_code(verdict: Verdict, finished_as, capsys) -> None:
    finished_as(Verdict.PASS, Verdict.PASS, verdict, Verdict.PASS)
    assert main(["demo"]) == 1
    assert main(["demo", "--json"]) == 1


def test_a_mesh_that_is_no_part_in_millimetres_is_asked_about_before_anything_starts(finished_as, capsys, tmp_path) -> None:
    asked, path = finished_as(*[Verdict.PASS] * 4), tmp_path / "block.stl"
    trimesh.creation.box([4.0, 2.0, 1.0]).export(path)
    assert main(["demo", "--part", str(path)]) == 2
    assert asked == [] and "--unit inch" in capsys.readouterr().err
    for unit in ("inch", "mm"):
        assert main(["demo", "--part", str(path), "--unit", unit]) == 0
        assert asked[-1].unit == unit
