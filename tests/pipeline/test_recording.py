"""Recordings of the demo's rig, whole and in parts, processed as recordings: they yield what the rig itself yielded."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo
from recording_export import Chosen, views_named, write_recording

from measureapp.arrays import FloatArray
from measureapp.cli import main
from measureapp.data.calibration import RigCalibration
from measureapp.errors import CalibrationError
from measureapp.pipeline.recording.learn import STATIONARY, learn
from measureapp.pipeline.recording.process import process_recording
from measureapp.pipeline.recording.store import import_recording
from measureapp.pipeline.run import process_project
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_point_cloud
from measureapp.project.upkeep import verify
from measureapp.simulate.truth import Truth

STATION = tuple(f"station01-{number}" for number in range(1, 6))  # the table turns before stationary cameras
AT_STATION = ("view01", "view02", "view03", "view04")
POSES = tuple(f"pose{number:02d}" for number in (1, 2, 4, 6, 8, 11, 12, 14, 16, 18, 20, 22))
SLIDE = tuple(f"guide{number:02d}" for number in range(1, 12, 2))


def imported(demo: Demo, folder: Path, chosen: Chosen) -> ProjectFolder:
    return import_recording(write_recording(demo.project, folder / "recording", chosen), folder / "project", NoProgress()).project


def silent(event: object) -> None:
    pass


def test_what_is_stored_is_what_the_rig_stored(demo: Demo, tmp_path: Path) -> None:
    project = imported(demo, tmp_path, Chosen(board_views=("pose01", "axis01"), viewpoints=("view01", "view05")))
    original = demo.project
    assert project.stored_viewpoints() == ("view01", "view05")
    for name in project.stored_viewpoints():
        stack, known = project.frames.load(name), original.frames.load(name)
        assert stack.patterns == known.patterns
        assert (stack.exposures_us, stack.saturation) == (known.exposures_us, known.saturation)
        for camera, images in known.images.items():
            np.testing.assert_array_equal(stack.images[camera], images)
        assert stack.readback is not None and known.readback is not None
        np.testing.assert_allclose(stack.readback.base_from_flange.matrix, known.readback.base_from_flange.matrix, atol=1e-12)
        assert (stack.readback.guide_mm, stack.readback.table_rad) == pytest.approx((known.readback.guide_mm, known.readback.table_rad))
    for view, known in zip(project.board_views(), views_named(original, ("pose01", "axis01")), strict=True):
        np.testing.assert_array_equal(view.images["upper"], known.images["upper"])
    plan = project.plan()
    assert plan is not None and [viewpoint.id for viewpoint in plan] == ["view01", "view05"]
    assert project.rig().cameras == original.rig().cameras
    assert project.program is not None and project.nominal is not None
    found = verify(project.path)
    assert len(found.viewpoints) == 4 and found.whole


def test_a_table_alone_is_calibrated_before_known_stationary_cameras(demo: Demo, truth: Truth, tmp_path: Path) -> None:
    chosen = Chosen(STATION, AT_STATION[:2], axes=("table_deg",), rig=False, known_cameras=True)
    learnt = learn(imported(demo, tmp_path, chosen), NoProgress())
    assert learnt.failed == {} and set(learnt.links) == {"axis"}
    assert learnt.rig is not None and learnt.rig.hand_eye.method == STATIONARY
    readback = demo.project.frames.readback("view01")
    true = truth.calibration
    camera_from_guide = true.guide_from_camera(readback).inverse()
    found = learnt.links["axis"]
    direction, point = camera_from_guide.rotate(true.axis.direction), camera_from_guide.apply(true.axis.point_mm[None])[0]
    beside = np.linalg.norm(np.cross(found.point_mm - point, direction))
    # The true cameras stand off the robot's read-back by its accuracy: 0.3 mm and 0.02°, the latter over a distance of 550 mm.
    robot_rad = np.deg2rad(0.02)
    assert _angle_rad(found.direction, direction) < 4 * np.hypot(found.direction_sigma_rad, robot_rad)
    assert beside < 4 * np.sqrt(found.point_sigma_mm**2 + 0.3**2 + (550 * robot_rad) ** 2)


def test_links_are_solved_one_by_one_where_no_view_of_the_table_moves_the_robot(demo: Demo, truth: Truth, tmp_path: Path) -> None:
    path = write_recording(demo.project, tmp_path / "recording", Chosen((*POSES, *SLIDE, *STATION), (), known_cameras=True))
    text = path.read_text(encoding="utf-8")
    entries = text.split("[[board_view]]")
    standing = [
        entry.replace("on_table = true", "on_table = false") if "board/pose" in entry or "board/guide" in entry else entry
        for entry in entries
    ]
    path.write_text("[[board_view]]".join(standing), encoding="utf-8")
    project = import_recording(path, tmp_path / "project", NoProgress()).project
    learnt = learn(project, NoProgress())
    assert learnt.failed == {} and set(learnt.links) == {"hand_eye", "guide", "axis"}
    assert learnt.rig is not None
    _check_near(learnt.rig, truth.calibration)


def _check_near(found: RigCalibration, true: RigCalibration) -> None:
    """Four standard deviations, as each link states them."""
    gap = found.hand_eye.flange_from_camera.inverse() @ true.hand_eye.flange_from_camera
    assert np.linalg.norm(gap.translation_mm) < 4 * found.hand_eye.translation_sigma_mm
    assert gap.angle_rad < 4 * found.hand_eye.rotation_sigma_rad
    assert _angle_rad(found.guide.direction, true.guide.direction) < 4 * found.guide.direction_sigma_rad
    assert found.guide.scale == pytest.approx(true.guide.scale, abs=4 * found.guide.scale_sigma)
    assert _angle_rad(found.axis.direction, true.axis.direction) < 4 * found.axis.direction_sigma_rad
    beside = np.cross(found.axis.point_mm - true.axis.point_mm, true.axis.direction)
    assert np.linalg.norm(beside) < 4 * found.axis.point_sigma_mm


def _angle_rad(one: FloatArray, other: FloatArray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))


def test_known_cameras_and_fringes_alone_yield_clouds_in_their_camera_frames(demo: Demo, tmp_path: Path) -> None:
    project = imported(demo, tmp_path, Chosen((), ("view01", "view02"), axes=(), rig=False, known_cameras=True))
    outcome = process_recording(project, silent, NoProgress())
    assert outcome.whole is None and outcome.failed == {}
    assert {"hand_eye", "guide", "axis", "stitch", "dimensions"} == set(outcome.missing)
    for view in outcome.document["views"]:
        cloud = read_point_cloud(Path(view["file"]))
        known = read_point_cloud(demo.project.results / "clouds" / f"{view['name']}.ply")
        assert cloud.frame == "camera" and len(cloud) == view["points"]
        assert len(cloud) == pytest.approx(len(known), rel=0.1)  # a cameras.json in the foreign format does not state the blur
        np.testing.assert_allclose(np.median(cloud.points_mm, axis=0), np.median(known.points_mm, axis=0), atol=1.5)
    with pytest.raises(CalibrationError, match="no read-backs"):
        process_project(project, silent, NoProgress())


def test_board_views_alone_calibrate_the_cameras(demo: Demo, truth: Truth, tmp_path: Path) -> None:
    project = imported(demo, tmp_path, Chosen(POSES, (), axes=(), part=False))
    outcome = process_recording(project, silent, NoProgress())
    assert outcome.whole is None and set(outcome.document["calibration"]) == {"cameras", "pair_rms_px"}
    for name, camera in outcome.document["calibration"]["cameras"].items():
        off = camera["matrix"][0][0] - truth.calibration.cameras.cameras[name].pinhole.matrix[0, 0]
        assert abs(off) < 5 * camera["standard_deviations"]["fx"]
    assert "clouds" in outcome.missing


@pytest.mark.slow
def test_a_whole_recording_yields_what_the_rig_itself_yielded(demo: Demo, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same images and read-backs: only the decimal digits of the file separate the results."""
    project = imported(demo, tmp_path, Chosen())
    assert main(["process", str(project.path), "--json"]) == demo.code
    calibration, measured = project.calibration(), project.measurement()
    direct, known = demo.project.calibration(), demo.project.measurement()
    assert calibration is not None and direct is not None and measured is not None and known is not None
    np.testing.assert_allclose(calibration.hand_eye.flange_from_camera.matrix, direct.hand_eye.flange_from_camera.matrix, atol=1e-6)
    np.testing.assert_allclose(calibration.axis.point_mm, direct.axis.point_mm, atol=1e-6)
    np.testing.assert_allclose(calibration.guide.direction, direct.guide.direction, atol=1e-9)
    for name, camera in direct.cameras.cameras.items():
        np.testing.assert_allclose(calibration.cameras.cameras[name].pinhole.matrix, camera.pinhole.matrix, atol=1e-6)
    assert measured.inspection is not None and known.inspection is not None
    for one, other in zip(measured.inspection.dimensions, known.inspection.dimensions, strict=True):
        assert one.measured == pytest.approx(other.measured, abs=1e-6), one.name
        assert one.verdict == other.verdict


@pytest.mark.slow
def test_a_table_before_stationary_cameras_measures_the_part(demo: Demo, tmp_path: Path) -> None:
    """Four views from one station and five table positions of the board: less than the whole rig sees, and no robot at all."""
    project = imported(demo, tmp_path, Chosen(STATION, AT_STATION, axes=("table_deg",), known_cameras=True))
    outcome = process_recording(project, silent, NoProgress())
    assert outcome.whole is not None and outcome.failed == {} and set(outcome.missing) == {"hand_eye", "guide"}
    placements = outcome.whole.measurement.stitched.placements
    assert all(placement.used for placement in placements)
    assert max(placement.correction_mm for placement in placements) < 0.3


@pytest.mark.slow
def test_views_of_a_board_held_by_hand_serve_the_cameras_beside_those_on_the_table(demo: Demo, tmp_path: Path) -> None:
    """Five views lose their read-backs; the rig is solved from the others, within what these state."""
    path = write_recording(demo.project, tmp_path / "recording", Chosen(viewpoints=()))
    entries = path.read_text(encoding="utf-8").split("[[board_view]]")
    held = [_held_by_hand(entry) if any(f"board/pose0{number}_" in entry for number in range(1, 6)) else entry for entry in entries]
    path.write_text("[[board_view]]".join(held), encoding="utf-8")
    learnt = learn(import_recording(path, tmp_path / "project", NoProgress()).project, NoProgress())
    direct = demo.project.require_calibration()
    assert learnt.rig is not None and learnt.uncertainty is not None and learnt.failed == {}
    gap = direct.hand_eye.flange_from_camera.inverse() @ learnt.rig.hand_eye.flange_from_camera
    assert np.linalg.norm(gap.translation_mm) < 2 * direct.hand_eye.translation_sigma_mm
    assert _angle_rad(learnt.rig.axis.direction, direct.axis.direction) < 2 * direct.axis.direction_sigma_rad


def _held_by_hand(entry: str) -> str:
    kept = [line for line in entry.splitlines() if not line.startswith(("base_from_flange", "guide_mm", "table_deg"))]
    return "\n".join(kept).replace("on_table = true", "on_table = false") + "\n"
