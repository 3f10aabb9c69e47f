"""A calibration is refused for other cameras, warned of when old or cold, and every scan says whether a camera moved since."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from demo_fixture import Demo

from measureapp.data.calibration import RigCalibration
from measureapp.data.plan import ExposureBracket, ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.errors import CalibrationError, DeviceError
from measureapp.pipeline.board_check import check_with_board
from measureapp.pipeline.events import Event, ValidityKnown
from measureapp.pipeline.rig_calibration import calibrate_rig
from measureapp.pipeline.scan import scan
from measureapp.pipeline.validity import check_before_scan, validity_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.viewpoints import plan_around_part
from measureapp.progress import NoProgress
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder, ProjectSettings

KNOCK_DEG = 0.06  # a pixel at a quarter of the resolution; half of it, in two noisy views, leaves two cameras in question
CAMERAS = ("left", "right", "upper")


def described(rig: RigDescription, seed: int = 1, **world: object) -> RigDescription:
    return rig.model_copy(update={"driver_settings": {"part": "gypsum", "seed": seed, "world": world}})


def two_views(rig: RigDescription) -> ScanPlan:
    plan = plan_around_part(rig, "two views", radius_mm=100, height_mm=80, count=4)
    return plan.model_copy(update={"viewpoints": plan.viewpoints[:2], "bracket": ExposureBracket(exposures_us=(40_000,))})


def scanned(folder: Path, rig: RigDescription, calibration: RigCalibration, on_event: Callable[[Event], None] = lambda _: None):
    """Scan two views into a new project and judge the calibration by them."""
    project = ProjectFolder.create(folder, ProjectSettings(name="two views", part="gypsum", rig=rig))
    project.save_plan(two_views(rig))
    project.save_calibration(calibration)
    views = scan(connect_rig(rig), project, calibration, on_event, NoProgress(), Stopwatch())
    return project, validity_of(project, calibration, views)


@pytest.fixture(scope="module")
def calibration(demo: Demo) -> RigCalibration:
    return demo.project.require_calibration()


@pytest.fixture(scope="module")
def rig(demo: Demo) -> RigDescription:
    return demo.project.rig()


def test_a_calibration_says_when_and_how_warm_it_was_made_and_of_which_images(demo: Demo, calibration: RigCalibration) -> None:
    provenance = calibration.provenance
    stored = json.loads((demo.folder / "calibration" / "views" / "pose01" / "view.json").read_text())
    assert provenance.inputs["pose01/left"] == stored["checksums"]["left"]
    assert provenance.temperature_c == stored["conditions"]["temperature_c"] == pytest.approx(35.0, abs=0.05)
    assert provenance.created >= stored["conditions"]["taken_at"]
    assert provenance.valid_days == demo.project.rig().calibration_rules.valid_days
    assert {camera.serial for camera in calibration.cameras.cameras.values()} == {camera.serial for camera in demo.project.rig().cameras}


def test_the_demo_finds_its_cameras_where_they_were_calibrated_and_notes_it(demo: Demo, calibration: RigCalibration) -> None:
    drift = demo.document["validity"]["drift"]
    assert (drift["standing"], drift["cameras"], demo.document["validity"]["warnings"]) == ("good", [], [])
    lines = [line for line in demo.project.calibration_history() if line.kind == "scan"]
    assert [(line.calibration, line.status) for line in lines] == [(calibration_id(calibration), "good")]
    assert lines[0].temperature_c == pytest.approx(35.0, abs=0.05)
    measurement = demo.project.measurement()
    assert measurement is not None and measurement.validity.drift is not None
    assert measurement.validity.drift.sentence == drift["sentence"]
    assert measurement.validity.drift.undetectable_deg == drift["unseen_deg"] and set(drift["unseen_deg"]) == set(CAMERAS)
    for name, turns in drift["unseen_deg"].items():  # upright fringes: a camera that tips is seen least
        assert max(turns, key=turns.get) in ("pitch", "roll") and turns["yaw"] < KNOCK_DEG, (name, turns)
    assert "would not show" in drift["unseen"]


@pytest.mark.parametrize("name", CAMERAS)
def test_a_camera_that_was_knocked_is_named(tmp_path: Path, rig: RigDescription, calibration: RigCalibration, name: str) -> None:
    project, validity = scanned(tmp_path / "project", described(rig, knocked_deg={name: [0.0, KNOCK_DEG, 0.0]}), calibration)
    drift = validity.drift
    assert drift is not None and (drift.status, drift.cameras) == ("drifted", (name,))
    assert drift.turn_deg == pytest.approx(KNOCK_DEG, rel=0.1)
    assert validity.all_warnings == (drift.sentence,) and "px" in drift.sentence and "mm" in drift.sentence
    (line,) = project.calibration_history()
    assert (line.status, line.cameras, line.shift_px) == ("drifted", (name,), drift.shift_px)


def test_a_warm_head_is_warned_of_before_it_moves_and_with_the_result(
    tmp_path: Path, rig: RigDescription, calibration: RigCalibration
) -> None:
    told: list[ValidityKnown] = []

    def listen(event: Event) -> None:
        if isinstance(event, ValidityKnown):
            told.append(event)

    _, validity = scanned(tmp_path / "project", described(rig, temperature_c=27.0), calibration, listen)
    assert validity.temperature_c == pytest.approx(41.0, abs=0.05)
    assert told[0].validity.warnings == validity.warnings
    expected_mm = 6.0 * rig.calibration_rules.head_expansion_per_k * rig.standoff_mm
    assert f"{expected_mm:.3f} mm" in validity.warnings[0] and "check the calibration" in validity.warnings[0]


def test_the_rule_may_refuse_an_expired_calibration(rig: RigDescription, calibration: RigCalibration) -> None:
    old = replace(calibration, provenance=replace(calibration.provenance, created="2020-01-01T00:00:00+00:00"))
    assert "has expired" in check_before_scan(connect_rig(described(rig)), old).warnings[0]
    strict = rig.model_copy(update={"calibration_rules": rig.calibration_rules.model_copy(update={"when_exceeded": "refuse"})})
    with pytest.raises(CalibrationError, match="has expired"):
        check_before_scan(connect_rig(described(strict)), old)


def test_other_cameras_are_refused_before_anything_moves(rig: RigDescription, calibration: RigCalibration) -> None:
    exchanged = tuple(
        camera.model_copy(update={"serial": other.serial}) for camera, other in zip(rig.cameras, reversed(rig.cameras), strict=True)
    )
    with pytest.raises(CalibrationError, match="which was calibrated as 'upper'"):
        check_before_scan(connect_rig(described(rig.model_copy(update={"cameras": exchanged}))), calibration)


def test_a_check_with_the_board_is_noted_with_its_images(tmp_path: Path, rig: RigDescription, calibration: RigCalibration) -> None:
    project = ProjectFolder.create(tmp_path / "project", ProjectSettings(name="checked", part="gypsum", rig=described(rig)))
    project.save_calibration(calibration)
    found = check_with_board(project, connect_rig(project.rig()), NoProgress())
    assert found.good and found.not_tested == ()
    (line,) = project.calibration_history()
    assert (line.kind, line.status, line.calibration) == ("board check", "good", calibration_id(calibration))
    (place,) = (project.path / "calibration" / "checks").iterdir()
    assert len([*place.glob("*/left.png")]) == len(found.views) >= 3
    with pytest.raises(CalibrationError, match="has no calibration"):
        check_with_board(ProjectFolder.create(tmp_path / "empty", project.settings), connect_rig(project.rig()), NoProgress())


def test_a_knock_of_a_camera_that_does_not_exist_is_refused(rig: RigDescription) -> None:
    with pytest.raises(DeviceError, match="knocked_deg names camera 'fourth'"):
        connect_rig(rig.model_copy(update={"driver_settings": {"world": {"knocked_deg": {"fourth": [0, 1, 0]}}}}))


@pytest.mark.slow
@pytest.mark.parametrize("seed", [2, 3, 4])
def test_over_rigs_clean_scans_are_silent_and_every_knock_is_named(tmp_path: Path, rig: RigDescription, seed: int) -> None:
    clean = described(rig, seed)
    project = ProjectFolder.create(tmp_path / "calibrated", ProjectSettings(name="calibrated", part="gypsum", rig=clean))
    calibrated = calibrate_rig(connect_rig(clean), project, lambda _: None, NoProgress(), Stopwatch()).solved.solution.calibration
    _, validity = scanned(tmp_path / "clean", clean, calibrated)
    assert validity.drift is not None and (validity.drift.status, validity.all_warnings) == ("good", ())
    for name in CAMERAS:
        for number, turn in enumerate(([0.0, KNOCK_DEG, 0.0], [0.0, -5 * KNOCK_DEG, 0.0], [0.0, 0.0, 5 * KNOCK_DEG])):
            _, validity = scanned(tmp_path / f"{name}{number}", described(rig, seed, knocked_deg={name: turn}), calibrated)
            assert validity.drift is not None
            assert validity.drift.cameras == (name,), (turn, validity.drift.sentence)
            assert validity.drift.status == "drifted"
