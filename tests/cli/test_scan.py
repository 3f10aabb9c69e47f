"""`scan` on the virtual rig."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from demo_fixture import Demo
from without_pictures import without_surface_and_pictures

from measureapp.cli import main
from measureapp.data.plan import ExposureBracket, ScanPlan
from measureapp.project.folder import ProjectFolder
from tests.cli.rig_files import write_binned_rig

CHINESE = ("--language", "zh_CN")


@pytest.fixture(scope="module", autouse=True)
def _without_surface_and_pictures() -> Iterator[None]:
    with without_surface_and_pictures():
        yield


@pytest.fixture(scope="module")
def rig(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The demo's rig as a file: the paper's at a quarter of its resolution, with the demo's seed."""
    return write_binned_rig(tmp_path_factory.mktemp("rig") / "quarter.toml", 'part = "gypsum", seed = 1')


@pytest.fixture(scope="module")
def demo_plan() -> ScanPlan:
    """Two viewpoints at one exposure; where they are needs no demo."""
    from measureapp.planning.viewpoints import plan_around_part
    from measureapp.project.rig_file import read_rig

    plan = plan_around_part(read_rig("paper"), "two views", radius_mm=100, height_mm=80, count=4)
    return plan.model_copy(update={"viewpoints": plan.viewpoints[:2], "bracket": ExposureBracket(exposures_us=(40_000,))})


@pytest.fixture
def plan(demo_plan: ScanPlan, tmp_path: Path) -> Path:
    path = tmp_path / "plan.json"
    path.write_text(demo_plan.model_dump_json(), encoding="utf-8")
    return path


@pytest.fixture
def standing_still(monkeypatch: pytest.MonkeyPatch) -> None:
    """Any attempt to move, or to show a pattern, fails the test."""

    def moved(*_: object) -> None:
        pytest.fail("the rig was set in motion")

    monkeypatch.setattr("measureapp.pipeline.scan.Engine", moved)


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, dict]:
    code = main([*map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


def written(path: Path) -> tuple[int, int]:
    """Which file lies there, and when it was written."""
    return path.stat().st_ino, path.stat().st_mtime_ns


def test_a_scan_without_calibration_keeps_its_images_and_one_that_is_resumed_takes_what_is_missing(
    demo: Demo, rig: Path, plan: Path, tmp_path: Path, capsys
) -> None:
    project = tmp_path / "project"
    code, document = answer(capsys, "scan", plan, "--rig", rig, "--project", project)
    assert (code, document["ended"], document["processed"]) == (0, "done", False)
    assert [(view["name"], view["state"]) for view in document["views"]] == [("view01", "stored"), ("view02", "stored")]

    assert main(["discard", str(project), "view02"]) == 0
    capsys.readouterr()
    kept = written(project / "stacks" / "view01" / "left.npy")
    code, document = answer(capsys, "scan", plan, "--rig", rig, "--project", project, "--resume", "--calibration", demo.folder, *CHINESE)
    assert (code, document["ended"], document["processed"]) == (0, "done", True)
    first, second = document["views"]
    assert (first["state"], second["state"]) == ("stored", "stored")
    assert "seconds" not in first and second["seconds"] > 0
    assert min(first["points"], second["points"]) > 5000
    assert written(project / "stacks" / "view01" / "left.npy") == kept
    assert Path(document["files"]["report_pdf"]).read_bytes().startswith(b"%PDF")
    assert json.loads(Path(document["files"]["report_json"]).read_text(encoding="utf-8"))["language"] == "zh_CN"  # of the PDF beside it
    assert document["dimensions"] == []

    assert main(["verify", str(project)]) == 0
    capsys.readouterr()
    refused(capsys, "contains images already", "--resume", "scan", plan, "--rig", rig, "--project", project)


def refused(capsys: pytest.CaptureFixture[str], message: str, hint: str, *arguments: object) -> None:
    code, document = answer(capsys, *arguments)
    assert code == 2, document
    assert message in document["error"]["message"]
    assert hint in document["error"]["hint"]


def test_a_plan_outside_the_limits_is_refused_before_anything_is_connected(
    rig: Path, demo_plan: ScanPlan, tmp_path: Path, capsys, monkeypatch
) -> None:
    monkeypatch.setattr("measureapp.pipeline.connecting.connect_rig", lambda _: pytest.fail("the rig was connected"))
    far = demo_plan.viewpoints[1].model_copy(update={"guide_mm": 700.0})
    path = tmp_path / "far.json"
    path.write_text(demo_plan.model_copy(update={"viewpoints": (demo_plan.viewpoints[0], far)}).model_dump_json())
    refused(
        capsys,
        "view02: guide at 700.0 mm is outside -650…650 mm",
        "nothing was moved",
        "scan",
        path,
        "--rig",
        rig,
        "--project",
        tmp_path / "p",
    )
    assert not (tmp_path / "p").exists()


@pytest.mark.parametrize(
    ("place", "value"),
    [("guide_mm", "NaN"), ("table_deg", "Infinity"), ("quaternion_wxyz", "[NaN, 0, 0, 0]"), ("position_mm", "[0, 0, NaN]")],
)
def test_a_plan_with_a_value_that_is_no_number_is_refused(
    place: str, value: str, rig: Path, plan: Path, tmp_path: Path, capsys, standing_still
) -> None:
    document = json.loads(plan.read_text())
    viewpoint = document["viewpoints"][0]
    (viewpoint["flange"] if place in viewpoint["flange"] else viewpoint)[place] = "here"
    plan.write_text(json.dumps(document).replace('"here"', value))
    refused(capsys, place, "", "scan", plan, "--rig", rig, "--project", tmp_path / "p")
    assert not (tmp_path / "p").exists()


def test_patterns_that_do_not_determine_the_phase_are_refused(
    rig: Path, demo_plan: ScanPlan, tmp_path: Path, capsys, standing_still
) -> None:
    one_pitch = demo_plan.patterns.model_copy(update={"groups": demo_plan.patterns.groups[:1]})
    path = tmp_path / "one_pitch.json"
    path.write_text(demo_plan.model_copy(update={"patterns": one_pitch}).model_dump_json())
    refused(capsys, "pitch", "", "scan", path, "--rig", rig, "--project", tmp_path / "p")
    assert not (tmp_path / "p").exists()


def test_a_calibration_at_another_resolution_is_refused(demo: Demo, plan: Path, tmp_path: Path, capsys, standing_still) -> None:
    project = tmp_path / "p"
    refused(
        capsys,
        "gives 2592 × 1944 px, 648 × 486 px were calibrated",
        "or calibrate them",
        *("scan", plan, "--rig", "paper", "--project", project, "--calibration", demo.folder),
    )
    assert not project.exists()


def test_a_calibration_of_another_camera_is_refused(demo: Demo, rig: Path, plan: Path, tmp_path: Path, capsys, standing_still) -> None:
    other = tmp_path / "other.toml"
    other.write_text(rig.read_text().replace("VR-21000002", "VR-99"))
    refused(
        capsys,
        "camera 'right' has serial number VR-99, VR-21000002 was calibrated",
        "or calibrate them",
        *("scan", plan, "--rig", other, "--project", tmp_path / "p", "--calibration", demo.folder),
    )
    assert not (tmp_path / "p").exists()


def test_a_scan_that_does_not_fit_on_the_disk_is_refused(
    rig: Path, plan: Path, tmp_path: Path, capsys, monkeypatch, standing_still
) -> None:
    monkeypatch.setattr("shutil.disk_usage", lambda _: type("usage", (), {"free": 1_000_000}))
    refused(capsys, "0.0 GB free", "Free some space", "scan", plan, "--rig", rig, "--project", tmp_path / "p" / "q")
    assert not (tmp_path / "p").exists()


def test_a_rig_that_cannot_be_connected_leaves_nothing_behind(rig: Path, plan: Path, tmp_path: Path, capsys) -> None:
    absent = tmp_path / "absent.toml"
    absent.write_text(rig.read_text().replace('driver = "virtual_rig"', 'driver = "absent_rig"'))
    code, document = answer(capsys, "scan", plan, "--rig", absent, "--project", tmp_path / "p")
    assert (code, document["error"]["type"]) == (3, "PluginError")
    assert not (tmp_path / "p").exists()


def test_an_unknown_rig_is_refused(plan: Path, tmp_path: Path, capsys, standing_still) -> None:
    refused(capsys, "no-such-rig", "paper", "scan", plan, "--rig", "no-such-rig", "--project", tmp_path / "p")
    assert not (tmp_path / "p").exists()


def test_another_project_without_calibration_is_refused(rig: Path, plan: Path, tmp_path: Path, capsys, standing_still) -> None:
    from measureapp.project.folder import ProjectSettings
    from measureapp.project.rig_file import read_rig

    ProjectFolder.create(tmp_path / "bare", ProjectSettings(name="bare", part="gypsum", rig=read_rig(rig)))
    refused(
        capsys,
        "has no calibration",
        "Calibrate",
        "scan",
        plan,
        "--rig",
        rig,
        "--project",
        tmp_path / "p",
        "--calibration",
        tmp_path / "bare",
    )
    assert not (tmp_path / "p").exists()


def test_a_folder_that_holds_something_else_is_left_as_it_was(rig: Path, plan: Path, tmp_path: Path, capsys, standing_still) -> None:
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "letter.txt").write_text("dear reader")
    refused(capsys, "is not an empty folder", "empty folder", "scan", plan, "--rig", rig, "--project", tmp_path / "full")
    assert [path.name for path in (tmp_path / "full").iterdir()] == ["letter.txt"]


def test_a_dry_run_states_what_a_scan_needs_and_moves_and_writes_nothing(
    rig: Path, plan: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], standing_still: None
) -> None:
    code, document = answer(capsys, "scan", plan, "--rig", rig, "--project", tmp_path / "new", "--dry-run")
    assert (code, document["viewpoints"], document["problems"]) == (0, 2, [])
    assert document["bytes"] > 0
    assert not (tmp_path / "new").exists()


def test_a_dry_run_lists_every_problem_and_is_refused(
    rig: Path, demo_plan: ScanPlan, tmp_path: Path, capsys: pytest.CaptureFixture[str], standing_still: None
) -> None:
    far = demo_plan.viewpoints[0].model_copy(update={"guide_mm": 5000.0})
    path = tmp_path / "plan.json"
    path.write_text(demo_plan.model_copy(update={"viewpoints": (far,)}).model_dump_json(), encoding="utf-8")
    code, document = answer(capsys, "scan", path, "--rig", rig, "--project", tmp_path / "new", "--dry-run")
    assert code == 2
    assert "5000" in document["problems"][0]["message"]
