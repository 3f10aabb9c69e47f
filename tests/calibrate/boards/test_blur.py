"""How much images are blurred is told by the edges of the board in them."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.quality import blur_px
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


@pytest.mark.parametrize("more_px", [0.0, 0.7, 1.2, 2.0])
@pytest.mark.parametrize("kind", ["checkerboard", "circles", "charuco"])
def test_the_blur_of_lens_and_pixel_is_found(kind: str, more_px: float) -> None:
    assert found_blur(kind, more_px) == pytest.approx((LENS + PIXEL + more_px**2) ** 0.5, rel=0.015)


def test_the_usual_image_counts_and_no_image_determines_nothing() -> None:
    assert blur_px([0.0, 2.0, 2.1, 9.0]) == blur_px([2.1])
    assert blur_px([]) == blur_px([0.0]) == 0.0
