"""The blur of a part is told by its own edges, and only where they are steps."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from measureapp.reconstruct.part_blur import KNOWN, edge_blur_px, with_blur_of_part
from tests.reconstruct.test_discontinuities import cameras, phase_map

SHAPE = (480, 640)
FULL_SCALE, WELL_E = 1023.0, 6000.0


def blocks(blur_px: float, seed: int = 3) -> np.ndarray:
    """Return an image (H, W) float32 of turned bright blocks on black, as a camera with this blur and shot noise sees them."""
    finer = 4
    image = np.full((finer * SHAPE[0], finer * SHAPE[1]), 8.0, np.float32)
    rng = np.random.default_rng(seed)
    for row in range(3):
        for column in range(4):
            centre = (finer * (80 + 160 * column), finer * (80 + 160 * row))
            corners = cv2.boxPoints((centre, (finer * 90.0, finer * 70.0), float(rng.uniform(0, 90))))
            cv2.fillPoly(image, [np.round(corners).astype(np.int32)], float(rng.uniform(250, 900)))
    aperture = 1 / 12 - 1 / 12 / finer**2  # of the mean over finer pixels
    seen = cv2.GaussianBlur(image, (0, 0), finer * float(np.sqrt(blur_px**2 - aperture)))
    seen = cv2.resize(seen, SHAPE[::-1], interpolation=cv2.INTER_AREA)
    return np.round(seen + rng.standard_normal(SHAPE) * np.sqrt(seen * FULL_SCALE / WELL_E)).astype(np.float32)


@pytest.mark.parametrize("blur_px", [0.4, 0.6, 0.757, 1.04, 1.4])
def test_the_blur_of_steps_is_found(blur_px: float) -> None:
    assert edge_blur_px(blocks(blur_px)) == pytest.approx(blur_px, rel=0.02)


def test_large_images_are_examined_in_bands_with_the_same_result() -> None:
    large = np.tile(blocks(0.9), (3, 4))
    assert edge_blur_px(large) == pytest.approx(0.9, rel=0.04)


def test_the_horizons_of_round_bodies_determine_no_blur() -> None:
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    ball = 900.0 * np.sqrt(np.clip(1.0 - ((x - 320) ** 2 + (y - 240) ** 2) / 150.0**2, 0.0, 1.0))
    assert edge_blur_px(cv2.GaussianBlur(ball.astype(np.float32), (0, 0), 0.757)) is None
    assert edge_blur_px(np.full(SHAPE, 12.0, np.float32)) is None


def test_the_blur_of_the_part_replaces_that_of_the_board_where_they_differ() -> None:
    for board_px, part_px, wanted in ((0.757, 1.04, 1.04), (1.04 * (1 + 0.3 * KNOWN), 1.04, None), (0.0, 1.04, None)):
        seen = replace(phase_map(np.zeros(SHAPE, np.uint8)), grey=blocks(part_px).astype(np.uint16))
        found = with_blur_of_part({"one": seen}, cameras(board_px)).cameras["one"].blur_px
        assert found == (board_px if wanted is None else pytest.approx(wanted, rel=0.04))
