"""How much images are blurred is told by the edges of the board in them."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.quality import _align, _profile_width, _profiles, blur_px
from tests.calibrate.virtual_board import BOARDS, shot

LENS = cv2.getGaussianKernel(5, 0.7).ravel() @ (np.arange(5) - 2.0) ** 2  # px², what the virtual lens does
PIXEL = 1 / 12  # px², a pixel's own width
TURNS = ((30, 100, 40), (10, 0, 5), (40, 45, 80))


def found_blur(kind: str, more_px: float) -> float:
    edges = []
    for turn in TURNS:
        image = shot(BOARDS[kind], *turn).image
        edges.append(find_board(cv2.GaussianBlur(image, (0, 0), more_px) if more_px else image, BOARDS[kind]).edge_px)
    return blur_px(edges)


@pytest.mark.parametrize("more_px", [0.0, 0.7, 1.2])
@pytest.mark.parametrize("kind", ["checkerboard", "circles"])
def test_the_blur_of_lens_and_pixel_is_found(kind: str, more_px: float) -> None:
    assert found_blur(kind, more_px) == pytest.approx((LENS + PIXEL + more_px**2) ** 0.5, rel=0.015)


def test_markers_beside_the_edges_hide_a_part_of_the_blur_and_add_none() -> None:
    true = (LENS + PIXEL) ** 0.5
    assert 0.95 * true < found_blur("charuco", 0.0) < 1.02 * true
    assert 0.85 * (true**2 + 4) ** 0.5 < found_blur("charuco", 2.0) < 1.02 * (true**2 + 4) ** 0.5


def test_the_usual_image_counts_and_no_image_determines_nothing() -> None:
    assert blur_px([0.0, 2.0, 2.1, 9.0]) == blur_px([2.1])
    assert blur_px([]) == blur_px([0.0]) == 0.0


@pytest.mark.parametrize("lens_px", [0.2, 0.3, 0.4, 0.5])
@pytest.mark.parametrize("angle_deg", [3.0, 20.0, 40.0])
def test_the_blur_of_sharp_cameras_is_not_that_of_reading_between_pixels(lens_px: float, angle_deg: float) -> None:
    true = (lens_px**2 + PIXEL) ** 0.5
    worst = 0.2 if lens_px < 0.35 else 0.1  # the sharper, the more it depends on the angle
    assert blur_px([shown_width(lens_px, np.deg2rad(angle_deg))]) == pytest.approx(true, rel=worst)


def shown_width(lens_px: float, angle: float) -> float:
    """Width in px of a straight edge as the camera's image shows it, with the edge's places known to a fraction of a pixel."""
    size, finer = 80, 10
    rows, columns = (np.mgrid[: size * finer, : size * finer] + 0.5) / finer - 0.5
    apart = (columns - size / 2 - 0.2) * np.cos(angle) - (rows - size / 2) * np.sin(angle)
    blurred = cv2.GaussianBlur((apart > 0).astype(np.float32), (0, 0), lens_px * finer)
    image = np.rint(20 + 200 * blurred.reshape(size, finer, size, finer).mean(axis=(1, 3))).astype(np.uint8)
    along = np.arange(-20.0, 20.0)
    places = np.column_stack([size / 2 + 0.2 + along * np.sin(angle), size / 2 + along * np.cos(angle)])
    normals = np.tile([np.cos(angle), -np.sin(angle)], (len(places), 1))
    return _profile_width(_align(_profiles(image, places, normals, 5.0)))
