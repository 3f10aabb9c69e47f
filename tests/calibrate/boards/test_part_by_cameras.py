"""A part of the board that one camera cannot tell is told by another one that sees the whole."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.predicted_part import find_part_by_cameras
from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.sightings import AmbiguousPart
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.geometry.transform import RigidTransform
from tests.calibrate.virtual_board import CHECKER, CIRCLES, middle_of, photographed, shot


@dataclass(frozen=True, eq=False)
class Sights:
    board: BoardDescription
    whole: np.ndarray  # by camera left
    part: np.ndarray  # by camera right
    marks_px: np.ndarray  # in camera right
    cameras: CameraArrayCalibration


@pytest.fixture(params=[CHECKER, CIRCLES], ids=["checkerboard", "circles"])
def sights(request):
    """The board as seen whole, and as the upper left of it is seen by another camera; both cameras calibrated."""
    whole, other = shot(request.param, 15, 60, 0), shot(request.param, 15, 60, 20)
    reference_from_other = whole.camera_from_board @ other.camera_from_board.inverse()
    place = RigidTransform(reference_from_other.matrix, "camera", "right")
    cameras = {
        "left": CameraCalibration("left", whole.camera, RigidTransform.identity("camera", "left")),
        "right": CameraCalibration("right", other.camera, place),
    }
    part = middle_of(other.image, other.marks_px)
    return Sights(request.param, whole.image, part, other.marks_px, CameraArrayCalibration("left", cameras))


def test_the_other_camera_determines_which_part_it_is(sights):
    with pytest.raises(AmbiguousPart):
        find_board(sights.part, sights.board)
    found = find_part_by_cameras(sights.part, "right", {"left": find_board(sights.whole, sights.board)}, sights.cameras, sights.board)
    assert 12 <= len(found.ids) < sights.board.count
    assert np.abs(found.corners_px - sights.marks_px[found.ids]).max() < 0.3  # a wrong identity is off by a whole square


def test_a_collection_with_calibrated_cameras_uses_such_a_part(sights, tmp_path):
    for known in (None, sights.cameras):
        kind = "cameras" if known is None else "axis"
        session = CalibrationSession.create(tmp_path / kind, Setup(KINDS[kind], sights.board, ("left", "right"), known))
        flange = RigidTransform.identity("base", "flange")
        one = session.add({"left": sights.whole, "right": sights.part}, AxisReadback(flange, 0.0, 0.0))
        assert len(one.seen["left"].ids) == sights.board.count
        assert ("right" in one.seen) is (known is not None)
        assert ("right" in one.refused) is (known is None)


def test_cameras_that_are_being_calibrated_determine_each_other_s_parts_once_they_are_solved(tmp_path):
    right_from_left = RigidTransform.from_vector([0.02, 0.1, 0.01], [-60.0, 3.0, 5.0], "right", "camera")
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], CHECKER, ("left", "right")))
    for number, towards in enumerate((70, 140, 210, 280, 0)):
        start = shot(CHECKER, 30, towards, 10)
        pose = RigidTransform((right_from_left @ start.camera_from_board).matrix, "camera", "board")
        marks = start.camera.project(pose.apply(CHECKER.corners_mm))
        right = photographed(CHECKER, start.camera, pose, number)
        session.add({"left": start.image, "right": middle_of(right, marks) if number == 0 else right})
    assert "right" not in session.observation("01").seen  # nothing tells it yet
    assert session.identify_parts() == ()
    before = session.solve()
    assert session.identify_parts() == ("01",)
    assert not session.draft.is_solved  # more is seen than was solved
    found = session.observation("01").seen["right"]
    truth = RigidTransform((right_from_left @ shot(CHECKER, 30, 70, 10).camera_from_board).matrix, "camera", "board")
    off = found.corners_px - shot(CHECKER, 30, 70, 10).camera.project(truth.apply(CHECKER.corners_mm[found.ids]))
    assert np.abs(off).max() < 0.3  # a wrong identity is off by a whole square
    after = session.solve_with_parts()
    assert session.draft.is_solved
    assert after.residuals_px["01"].keys() == {"left", "right"} > before.residuals_px["01"].keys()


def test_an_expectation_that_fits_no_part_better_than_the_next_is_not_trusted(sights):
    spacing = np.linalg.norm(sights.marks_px[1] - sights.marks_px[0])
    with pytest.raises(AmbiguousPart):
        find_board(sights.part, sights.board, sights.marks_px + np.array([0.5, 0.1]) * spacing)
