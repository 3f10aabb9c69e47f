"""The blur of an image is found from single edges, at pixels as they are, also where these are larger than the blur."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.geometry.edge_blur import STRAIGHT, EdgeShape, edge_blurs

PIXEL = 1 / 12  # px², a pixel's own width
SIZE, FINER = 80, 10
MIDDLE = (SIZE / 2 + 0.2, SIZE / 2 - 0.3)
REACH = (5.0, 3.0)


def image_of(bright: np.ndarray, lens_px: float, noise: float = 1.5) -> np.ndarray:
    """Return what square pixels see of a drawing ten times as fine through a lens, with noise and in whole grey levels."""
    blurred = cv2.GaussianBlur(bright.astype(np.float32), (0, 0), lens_px * FINER)
    seen = 20 + 200 * blurred.reshape(SIZE, FINER, SIZE, FINER).mean(axis=(1, 3))
    return np.clip(np.rint(seen + noise * np.random.default_rng(4).standard_normal(seen.shape)), 0, 255).astype(np.uint8)


def finely() -> tuple[np.ndarray, np.ndarray]:
    """Return distances of the fine drawing's points from the middle, px, to the right and down."""
    rows, columns = (np.mgrid[: SIZE * FINER, : SIZE * FINER] + 0.5) / FINER - 0.5
    return columns - MIDDLE[0], rows - MIDDLE[1]


def edges(angle: float) -> tuple[np.ndarray, np.ndarray]:
    """Return places up to 0.7 px beside a straight edge through the middle, and its normals."""
    along = np.arange(-20.0, 21.0, 2.0)
    normals = np.tile([np.cos(angle), -np.sin(angle)], (len(along), 1))
    off = np.random.default_rng(2).uniform(-0.7, 0.7, len(along))
    places = np.array(MIDDLE) + along[:, None] * [np.sin(angle), np.cos(angle)] + off[:, None] * normals
    return places, normals


@pytest.mark.parametrize("lens_px", [0.2, 0.3, 0.5, 1.0, 1.5])
@pytest.mark.parametrize("angle_deg", [3.0, 20.0, 40.0])
def test_straight_edges(lens_px: float, angle_deg: float) -> None:
    right, down = finely()
    angle = np.deg2rad(angle_deg)
    image = image_of(right * np.cos(angle) - down * np.sin(angle) > 0, lens_px)
    found = float(np.median(edge_blurs(image, *edges(angle), REACH)))
    assert found == pytest.approx((lens_px**2 + PIXEL) ** 0.5, rel=0.06 if lens_px < 0.3 else 0.03)  # a square pixel is no Gaussian


@pytest.mark.parametrize("turned", [1.0, -1.0])
def test_outlines_of_circles(turned: float) -> None:
    right, down = finely()
    radius = 9.0
    image = image_of(np.hypot(right, down) < radius, 0.4)
    outward = np.column_stack([np.cos(np.arange(24) / 3.8), np.sin(np.arange(24) / 3.8)])
    places = np.array(MIDDLE) + radius * outward
    found = edge_blurs(image, places, turned * outward, (5.0, 3.0), EdgeShape(bend=-turned / radius))
    assert float(np.median(found)) == pytest.approx((0.4**2 + PIXEL) ** 0.5, rel=0.05)
    straight = edge_blurs(image, places, turned * outward, (5.0, 3.0), STRAIGHT)
    assert np.median(straight) > 1.05 * np.median(found)


@pytest.mark.parametrize("lens_px", [0.7, 1.5])
def test_bright_sides_that_end(lens_px: float) -> None:
    """As beside the markers of a ChArUco board, of which the white margin is 4 px wide here."""
    right, down = finely()
    angle = 0.2
    across = right * np.cos(angle) - down * np.sin(angle)
    image = image_of((across > 0) & (across < 4.0), lens_px)
    found = edge_blurs(image, *edges(angle), (5.0, 3.0), EdgeShape(bright_px=4.0))
    assert float(np.median(found)) == pytest.approx((lens_px**2 + PIXEL) ** 0.5, rel=0.03)


def test_edges_at_the_border_of_the_image_are_left_out() -> None:
    right, _ = finely()
    image = image_of(right > 0, 0.5)
    places, normals = edges(0.0)
    outside = np.vstack([places, [[MIDDLE[0], 1.0]]])
    assert len(edge_blurs(image, outside, np.vstack([normals, normals[:1]]), REACH)) == len(places)
    assert len(edge_blurs(image, outside[-1:], normals[:1], REACH)) == 0
