"""A part of the board that nothing else tells is told by where the table turned it from, and refused where that is too uncertain."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.boards.predicted_part import find_part_by_table, predict_marks
from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.sightings import AmbiguousPart
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, RotationAxis
from measureapp.data.fringe import Readback
from measureapp.geometry.transform import RigidTransform
from tests.calibrate.virtual_board import CHECKER, CIRCLES, middle_of, photographed, shot

AXIS = RotationAxis(np.array([12.0, 25.0, 590.0]), np.array([0.1, -0.8, 0.6]), "camera")  # near the board, as a table's is
WHOLE_DEG, PART_DEG = (0.0, 12.0), 24.0
NOISE_PX = 0.1


@dataclass(frozen=True, eq=False)
class Turned:
    """The board before one camera, seen whole at two angles of the table and in part at a third."""

    cameras: CameraArrayCalibration
    whole: dict[float, ImageArray]
    part: ImageArray
    marks_px: np.ndarray  # at the third angle


def posed(first, angle_deg):
    return AXIS.turned(np.deg2rad(angle_deg)) @ first


@pytest.fixture(params=[CHECKER, CIRCLES], ids=["checkerboard", "circles"], scope="module")
def turned(request):
    board = request.param
    start = shot(board, 25, 100, 5)
    camera, first = start.camera, start.camera_from_board
    cameras = CameraArrayCalibration("left", {"left": CameraCalibration("left", camera, RigidTransform.identity("camera", "left"))})
    whole = {angle: photographed(board, camera, posed(first, angle), int(angle) + 1) for angle in WHOLE_DEG}
    image, pose = photographed(board, camera, posed(first, PART_DEG), 99), posed(first, PART_DEG)
    marks = camera.project(pose.apply(board.corners_mm))
    return board, Turned(cameras, whole, middle_of(image, marks), marks)


def seen_at(board, turned, angles):
    poses = {
        a: board_pose({"left": (f := find_board(turned.whole[a], board)).corners_px}, turned.cameras, board, ids={"left": f.ids})
        for a in angles
    }
    return [Observation("", Readback(table_rad=float(np.deg2rad(angle))), pose) for angle, pose in poses.items()]


def test_two_whole_sightings_determine_which_part_is_seen_at_a_third_angle(turned):
    board, sights = turned
    with pytest.raises(AmbiguousPart):
        find_board(sights.part, board)
    seen = seen_at(board, sights, WHOLE_DEG)
    found = find_part_by_table(sights.part, "left", seen, np.deg2rad(PART_DEG), sights.cameras, board)
    assert 12 <= len(found.ids) < board.count
    assert np.abs(found.corners_px - sights.marks_px[found.ids]).max() < 0.3  # a wrong identity is off by a whole square


def test_one_sighting_at_another_angle_determines_nothing_and_at_the_same_angle_everything(turned):
    board, sights = turned
    seen = seen_at(board, sights, WHOLE_DEG[:1])
    with pytest.raises(AmbiguousPart):
        find_part_by_table(sights.part, "left", seen, np.deg2rad(PART_DEG), sights.cameras, board)
    same = [replace(one, readback=Readback(table_rad=np.deg2rad(PART_DEG))) for one in seen]
    expected = predict_marks(same, np.deg2rad(PART_DEG), sights.cameras.cameras["left"], board)
    np.testing.assert_allclose(
        expected, sights.cameras.cameras["left"].pinhole.project(seen[0].pose.camera_from_board.apply(board.corners_mm))
    )


def test_angles_that_the_board_did_not_follow_determine_nothing(turned):
    board, sights = turned
    first, second = seen_at(board, sights, WHOLE_DEG)
    other = replace(second, readback=Readback(table_rad=second.readback.table_rad * 57.3))  # degrees given as radians
    with pytest.raises(AmbiguousPart):
        find_part_by_table(sights.part, "left", [first, other], np.deg2rad(PART_DEG), sights.cameras, board)


def test_the_prediction_errs_as_it_says_and_is_refused_beyond_half_a_square():
    start = shot(CHECKER, 25, 100, 5)
    lens = CameraCalibration("left", start.camera, RigidTransform.identity("camera", "left"))
    array = CameraArrayCalibration("left", {"left": lens})
    generator, goal = np.random.default_rng(4), np.deg2rad(60.0)
    truth = start.camera.project(posed(start.camera_from_board, 60.0).apply(CHECKER.corners_mm))

    def drawn(sigma_px, angles):
        for angle in angles:
            pixels = start.camera.project(posed(start.camera_from_board, angle).apply(CHECKER.corners_mm))
            pose = board_pose({"left": pixels + generator.normal(0, sigma_px, pixels.shape)}, array, CHECKER, sigma_px)
            yield Observation("", Readback(table_rad=float(np.deg2rad(angle))), pose)

    near = [predict_marks(list(drawn(NOISE_PX, (0.0, 15.0))), goal, lens, CHECKER) for _ in range(20)]
    spacing = np.linalg.norm(truth[1] - truth[0])
    assert all(one is not None and np.abs(one - truth).max() < spacing / 2 for one in near)
    assert predict_marks(list(drawn(40 * NOISE_PX, (0.0, 3.0))), goal, lens, CHECKER) is None


def test_a_session_for_the_axis_determines_the_part_also_when_it_comes_first(turned, tmp_path):
    board, sights = turned
    session = CalibrationSession.create(tmp_path / "axis", Setup(KINDS["axis"], board, ("left",), sights.cameras))
    part = session.add({"left": sights.part}, Readback(table_rad=np.deg2rad(PART_DEG)))
    assert part.refused["left"].cause == "part"
    for angle, image in sights.whole.items():
        session.add({"left": image}, Readback(table_rad=np.deg2rad(angle)))
    assert session.observation(part.id).status == "no board"
    assert session.identify_parts() == (part.id,)
    for one in (session, CalibrationSession.open(session.folder)):
        assert 12 <= len(one.observation(part.id).seen["left"].ids) < board.count
        assert one.observation(part.id).refused == {}
    assert session.identify_parts() == ()
    moved = Readback(RigidTransform.identity("base", "flange"), 0.0, np.deg2rad(PART_DEG + 0.5))
    other = np.array(sights.part)
    other[0, 0] += 1
    assert session.add({"left": other}, moved).refused["left"].cause == "part"  # other cameras: not those of a held head
