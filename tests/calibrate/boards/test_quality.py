"""Images that would spoil a calibration are refused by name, whatever the board."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.quality import require_plain
from measureapp.data.board import CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.errors import CalibrationError
from tests.calibrate.virtual_board import BOARDS, CHARUCO, CHECKER, CIRCLES, FULL, HALF, QUARTER, shot

every_kind = pytest.mark.parametrize("kind", list(BOARDS))


def refusal(image, board):
    with pytest.raises(CalibrationError) as caught:
        find_board(image, board)
    assert caught.value.hint
    return caught.value.message


def smeared(image, length_px):
    kernel = np.zeros((length_px, length_px), np.float32)
    kernel[length_px // 2] = 1 / length_px
    return cv2.filter2D(image, -1, kernel)


@every_kind
@pytest.mark.parametrize("sigma_px", [4, pytest.param(8, marks=pytest.mark.slow), 16])
def test_a_board_out_of_focus_is_called_blurred(kind, sigma_px):
    image = cv2.GaussianBlur(shot(BOARDS[kind]).image, (0, 0), sigma_px)
    assert any(word in refusal(image, BOARDS[kind]) for word in ("blurred", "nothing in the image is sharp"))


@every_kind
def test_a_board_that_moved_during_the_exposure_is_called_blurred(kind):
    assert any(word in refusal(smeared(shot(BOARDS[kind]).image, 25), BOARDS[kind]) for word in ("blurred", "is sharp"))


@every_kind
@pytest.mark.parametrize("factor", [8, 20])
def test_a_board_too_bright_is_called_over_exposed(kind, factor):
    assert "over-exposed" in refusal(shot(BOARDS[kind], exposure_us=100_000 * factor).image, BOARDS[kind])


@every_kind
def test_a_board_too_dark_is_called_so(kind):
    assert "too dark" in refusal(shot(BOARDS[kind], exposure_us=5_000).image, BOARDS[kind])


@every_kind
def test_brightness_within_reason_is_no_reason_to_refuse(kind):
    for exposure_us in (30_000, 130_000):
        find_board(shot(BOARDS[kind], exposure_us=exposure_us).image, BOARDS[kind])


def test_a_hidden_part_of_a_charuco_board_only_costs_its_corners():
    seen = shot(CHARUCO, 35)
    image = seen.image.copy()
    image[300:600, 500:700] = 60
    found = find_board(image, CHARUCO)
    covered = np.all((seen.marks_px[found.ids] > [500, 300]) & (seen.marks_px[found.ids] < [700, 600]), axis=1)
    assert not covered.any()
    assert len(found.ids) > 90
    assert np.abs(found.corners_px - seen.marks_px[found.ids]).max() < 0.3


@pytest.mark.parametrize("size", [(9, 6), (13, 11), (14, 10), (11, 8)])
@pytest.mark.parametrize("pixels", [HALF, FULL])
def test_a_checkerboard_larger_than_the_expected_one_is_reported_with_its_size(size, pixels):
    asked = CheckerboardDescription(columns=size[0], rows=size[1], square_mm=15.0)
    assert "looks like one of 14 × 11 corners" in refusal(shot(CHECKER, 35, size=pixels).image, asked)


def test_a_smaller_checkerboard_seen_whole_is_reported_with_its_size():
    smaller = CheckerboardDescription(columns=9, rows=6, square_mm=20.0)
    assert "looks like one of 9 × 6 corners" in refusal(shot(smaller, 30, 10, 70).image, CHECKER)


def test_a_circle_grid_of_another_size_is_reported_with_its_size():
    asked = CirclesDescription(kind="circles", columns=4, rows=11, spacing_mm=12, diameter_mm=11)
    assert "looks like one of 7 × 15 circles" in refusal(shot(CIRCLES).image, asked)


@pytest.mark.parametrize(("columns", "rows", "words"), [(9, 6, "does not have"), (14, 9, "does not have"), (15, 12, "not placed as on")])
def test_a_charuco_board_of_another_size_is_named(columns, rows, words):
    asked = CharucoDescription(kind="charuco", columns=columns, rows=rows, square_mm=15.0, marker_mm=11.0)
    assert words in refusal(shot(CHARUCO).image, asked)


def test_a_mirrored_charuco_image_is_named():
    assert "mirrored" in refusal(np.ascontiguousarray(shot(CHARUCO).image[:, ::-1]), CHARUCO)


def test_a_charuco_board_described_as_a_checkerboard_is_named():
    assert "markers are printed" in refusal(shot(CHARUCO, size=FULL).image, CHECKER)


@every_kind
def test_an_image_of_nothing_gives_no_board(kind):
    noise = np.random.default_rng(3).integers(90, 130, (972, 1296)).astype(np.uint8)
    assert "was not found" in refusal(noise, BOARDS[kind])


def test_every_recorded_image_of_a_board_is_good_enough():
    folder = recorded("opencv_stereo")
    board = CheckerboardDescription(columns=9, rows=6, square_mm=1.0)
    images = sorted(folder.glob("*[0-9].jpg"))
    found = [find_board(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), board) for path in images]
    assert len(found) == 26
    assert max(np.median(one.sigma_px) for one in found) < 0.15


SHORT_SIDES = [(15.0, 0), (15.0, 50), (15.0, 62), (9.0, 0), (9.0, 50), (7.0, 0), (7.0, 45)]  # mm, degrees: 28 down to 9 px at 1.86 px/mm


@pytest.mark.parametrize(("square_mm", "tilt_deg"), SHORT_SIDES)
@pytest.mark.parametrize("towards_deg", [pytest.param(10.0, marks=pytest.mark.slow), 100.0])
def test_small_tilted_squares_are_plain_unless_markers_are_printed_in_them(square_mm, tilt_deg, towards_deg):
    """Blur of 1 px and the mean of 3 × 3 px reach 2 to 3 px into a square, so that its middle half stays plain down to some 9 px."""
    plain = CheckerboardDescription(columns=14, rows=11, square_mm=square_mm)
    printed = CharucoDescription(kind="charuco", columns=14, rows=11, square_mm=square_mm, marker_mm=0.7 * square_mm)
    seen = shot(plain, tilt_deg, towards_deg, 20, QUARTER)
    require_plain(seen.image, seen.marks_px.reshape(11, 14, 2))
    other = shot(printed, tilt_deg, towards_deg, 20, QUARTER)
    with pytest.raises(CalibrationError, match="not plain"):
        require_plain(other.image, other.marks_px.reshape(11, 14, 2))
    with pytest.raises(CalibrationError):
        find_board(other.image, plain)


@pytest.mark.parametrize("roll_deg", [5, 20, 110])
def test_a_board_at_62_degrees_is_found_except_for_corners_that_drifted_to_the_next_edge(roll_deg):
    seen = shot(CHECKER, 62, 100, roll_deg, QUARTER)
    found = find_board(seen.image, CHECKER)
    assert len(found.ids) >= CHECKER.count - 2
    off = np.abs(found.corners_px - seen.marks_px[found.ids])
    assert off.max() < 5 * found.sigma_px.max() + 0.1  # another corner is 9 px away
