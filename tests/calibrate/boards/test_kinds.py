"""Every kind of board is found to sub-pixel at the paper's rig, with honest standard deviations, whole or in part."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.circles import centre_bias
from measureapp.calibrate.boards.find import detect, find_board, require_unambiguous
from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.boards.refine import off_the_grid, smooth_grid
from measureapp.data.board import CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform
from tests.calibrate.mark_noise import mark_sigma
from tests.calibrate.virtual_board import BOARDS, CHARUCO, CHECKER, CIRCLES, FULL, HALF, LENS, QUARTER, shot

DIRECTIONS = ((10.0, 5.0), (100.0, 40.0), (250.0, 130.0), (320.0, 200.0))


def errors_of(board, tilt_deg, size):
    """Find the board from all directions in full images, from two in small ones: some 600 coordinates."""
    found, off = [], []
    for towards, roll in DIRECTIONS if size == FULL else DIRECTIONS[::2]:
        seen = shot(board, tilt_deg, towards, roll, size)
        one = find_board(seen.image, board)
        found.append(one)
        off.append(one.corners_px - seen.marks_px[one.ids])
    return found, off


further_views = [pytest.param(HALF, 35, id="half-35", marks=pytest.mark.slow)]  # between the ends
further_views += [pytest.param(FULL, tilt, id=f"full-{tilt}", marks=pytest.mark.slow) for tilt in (0, 35, 50)]


@pytest.mark.parametrize(("size", "tilt_deg"), [(HALF, 0), (HALF, 50), *further_views])
@pytest.mark.parametrize("kind", list(BOARDS))
def test_marks_are_found_where_they_are_at_any_tilt(kind, size, tilt_deg):
    board = BOARDS[kind]
    found, off = errors_of(board, tilt_deg, size)
    assert min(len(one.ids) for one in found) >= 0.95 * board.count
    towards, roll = DIRECTIONS[0]
    seen, clean = (shot(board, tilt_deg, towards, roll, size, noise=noise) for noise in (True, False))
    expected = mark_sigma(seen.image, clean.image, seen.marks_px, board)
    for one in off:
        assert np.linalg.norm(one.mean(axis=0)) < 4 * expected * np.sqrt(2 / len(one))
    assert np.sqrt(np.mean(np.concatenate(off) ** 2)) < expected


@pytest.mark.parametrize("kind", ["checkerboard", "charuco"])
def test_stated_standard_deviations_are_those_of_the_errors(kind):
    found, off = errors_of(BOARDS[kind], 30, HALF)
    normed = np.concatenate([error / one.sigma_px[:, None] for error, one in zip(off, found, strict=True)])
    assert 0.7 < np.sqrt(np.mean(normed**2)) < 1.3


def test_the_centre_of_a_circle_is_not_the_centre_of_its_image_and_the_difference_is_taken_off():
    """Noise-free and without distortion; the bias at 50° is some ten times what is left."""
    seen = shot(CIRCLES, 50, 100, 40, FULL, noise=False, lens=(0.0,) * 5)
    found = find_board(seen.image, CIRCLES)
    bias = centre_bias(smooth_grid(CIRCLES, found.ids, seen.marks_px), CIRCLES, found.ids)
    left = found.corners_px - seen.marks_px
    assert np.linalg.norm(bias.mean(axis=0)) > 0.1
    assert np.abs(left.mean(axis=0)).max() < 0.005
    assert np.sqrt(np.mean(left**2)) < 0.1 * np.sqrt(np.mean(bias**2))


@pytest.mark.parametrize("lens", [(0.0,) * 5, LENS], ids=["pinhole", "distorted"])
def test_circle_centres_agree_with_the_exact_ellipse_of_a_cone(lens):
    """The bias of one circle from sampled points of its projected outline, fitted by an ellipse; the lens itself is not known to the code."""
    seen = shot(CIRCLES, 40, 60, 0, HALF, lens=lens)
    angles = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    bias = centre_bias(smooth_grid(CIRCLES, np.arange(CIRCLES.count), seen.marks_px), CIRCLES, np.arange(CIRCLES.count))
    for mark in (3, 50):
        outline = CIRCLES.flat_corners_mm[mark] + CIRCLES.diameter_mm / 2 * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(720)])
        pixels = seen.camera.project(seen.camera_from_board.apply(outline))
        x, y = (pixels - seen.marks_px[mark]).T
        a, b, c, d, e = np.linalg.lstsq(np.column_stack([x * x, x * y, y * y, x, y]), np.ones(720), rcond=None)[0]
        ellipse_centre = np.linalg.solve([[2 * a, b], [b, 2 * c]], [-d, -e])
        np.testing.assert_allclose(bias[mark], ellipse_centre, atol=1e-4 if lens == (0.0,) * 5 else 1e-3)


@pytest.mark.parametrize("aside_mm", [(90.0, 0.0), (-80.0, 60.0)])
def test_a_charuco_board_half_out_of_the_image_gives_its_corners_with_their_ids(aside_mm):
    seen = shot(CHARUCO, 35, 100, 40, aside_mm=aside_mm)
    inside = np.all((seen.marks_px > 20) & (seen.marks_px < np.array([1276, 952])), axis=1)
    found = find_board(seen.image, CHARUCO)
    assert 40 < inside.sum() < CHARUCO.count
    assert set(found.ids) <= set(range(CHARUCO.count))
    assert len(found.ids) > 0.85 * inside.sum()
    assert np.abs(found.corners_px - seen.marks_px[found.ids]).max() < 0.3
    with pytest.raises(CalibrationError, match=f"Only {len(found.ids)} of the 154 marks"):
        detect(seen.image, CHARUCO)


def test_the_pose_follows_from_a_part_of_the_board():
    seen = shot(CHARUCO, 35, 100, 40, aside_mm=(90.0, 0.0))
    camera = CameraCalibration("left", seen.camera, RigidTransform.identity("camera", "left"))
    found = find_board(seen.image, CHARUCO)
    pose = board_pose({"left": found.corners_px}, CameraArrayCalibration("left", {"left": camera}), CHARUCO, 0.03, {"left": found.ids})
    sigma = np.sqrt(np.diag(np.linalg.inv(pose.information)))[3:]
    off = pose.camera_from_board.apply(CHARUCO.middle_mm[None]) - seen.camera_from_board.apply(CHARUCO.middle_mm[None])
    assert np.all(np.abs(off) < 5 * np.maximum(sigma, 0.005))
    assert pose.rms_px < 0.08


@pytest.mark.parametrize("roll_deg", [0, 90, 180, 270])
@pytest.mark.parametrize("kind", list(BOARDS))
def test_mark_0_is_the_same_mark_whatever_way_the_board_lies(kind, roll_deg):
    seen = shot(BOARDS[kind], 20, 60, roll_deg, QUARTER)
    found = find_board(seen.image, BOARDS[kind])
    assert np.linalg.norm(found.corners_px[0] - seen.marks_px[found.ids[0]]) < 0.3


@pytest.mark.parametrize(
    ("board", "remedy"),
    [
        (CheckerboardDescription(columns=8, rows=6, square_mm=10), "14 × 11"),
        (CheckerboardDescription(columns=9, rows=7, square_mm=10), "14 × 11"),
        (CirclesDescription(kind="circles", columns=4, rows=10, spacing_mm=10, diameter_mm=7), "4 × 11"),
    ],
)
def test_boards_that_look_the_same_after_half_a_turn_are_refused_with_a_remedy(board, remedy):
    turned = 2 * board.middle_mm - board.flat_corners_mm
    assert {tuple(mark) for mark in np.round(turned, 6).tolist()} == {tuple(mark) for mark in np.round(board.flat_corners_mm, 6).tolist()}
    with pytest.raises(CalibrationError, match="half a turn") as refusal:
        require_unambiguous(board, "the hand-eye calibration")
    assert remedy in refusal.value.hint


@pytest.mark.parametrize("board", [CHECKER, CIRCLES, CharucoDescription(kind="charuco", columns=8, rows=6, square_mm=10, marker_mm=7)])
def test_boards_of_which_only_one_lie_is_possible_are_accepted(board):
    require_unambiguous(board, "the hand-eye calibration")


def test_a_board_drawn_by_opencv_is_found_where_it_was_drawn():
    markers = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_6X6_250)
    drawn = cv2.aruco.CharucoBoard((10, 8), 10.0, 7.0, markers).generateImage((1000, 800), marginSize=0)
    image = cv2.GaussianBlur(np.pad(drawn, 60, constant_values=255) // 2 + 40, (0, 0), 1.0)
    board = CharucoDescription(kind="charuco", columns=9, rows=7, square_mm=10.0, marker_mm=7.0, dictionary="6X6_250")
    found = find_board(image, board)
    expected = board.corners_mm[found.ids, :2] * 10 + 100 + 60 - 0.5
    assert len(found.ids) == board.count
    assert np.abs(found.corners_px - expected).max() < 0.1


def test_a_mark_that_left_the_grid_is_distinguished_from_those_that_only_scatter(generator):
    seen = shot(CHARUCO, 40)
    marks = seen.marks_px + generator.normal(scale=0.03, size=seen.marks_px.shape)
    marks[17] += [1.2, -0.6]
    assert np.flatnonzero(off_the_grid(CHARUCO, np.arange(CHARUCO.count), marks)).tolist() == [17]
