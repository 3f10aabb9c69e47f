"""A part of the board that one camera cannot tell is told by another one that sees the whole."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.board import find_board
from measureapp.calibrate.board_together import find_beside
from measureapp.calibrate.sightings import AmbiguousPart
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.transform import RigidTransform
from tests.calibrate.virtual_board import CHECKER, CIRCLES, shot


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
    image = np.full_like(other.image, 70)
    middle = other.marks_px.mean(axis=0).astype(int)
    image[middle[1] - 180 : middle[1] + 180, middle[0] - 220 : middle[0] + 220] = other.image[
        middle[1] - 180 : middle[1] + 180, middle[0] - 220 : middle[0] + 220
    ]
    return request.param, find_board(whole.image, request.param), image, other.marks_px, CameraArrayCalibration("left", cameras)


def test_the_other_camera_tells_which_part_it_is(sights):
    board, whole, image, marks_px, cameras = sights
    with pytest.raises(AmbiguousPart):
        find_board(image, board)
    found = find_beside(image, "right", {"left": whole}, cameras, board)
    assert 12 <= len(found.ids) < board.count
    assert np.abs(found.corners_px - marks_px[found.ids]).max() < 0.3  # a wrong identity is off by a whole square


def test_an_expectation_that_fits_no_part_better_than_the_next_is_not_trusted(sights):
    board, _, image, marks_px, _ = sights
    spacing = np.linalg.norm(marks_px[1] - marks_px[0])
    with pytest.raises(AmbiguousPart):
        find_board(image, board, marks_px + np.array([0.5, 0.1]) * spacing)
