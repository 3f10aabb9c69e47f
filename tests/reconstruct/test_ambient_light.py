"""Light that is not the projector's is told by how the mean grey level grows with the modulation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.phase import PhaseMap, PixelState
from measureapp.reconstruct.blur import estimate_ambient_light

HEIGHT, WIDTH, OTHER, CONTRAST, VARIANCE_PX2 = 200, 300, 12.0, 0.9, 0.6
SLOPE = 0.3
SCALE = (1.0, 2.0, 4.0)
EXPOSURES_US = tuple(8000.0 / scale for scale in SCALE)


@pytest.fixture
def seen() -> PhaseMap:
    """8-bit images of a part lit unevenly, in three exposures, by fringes of a projector and the light of the room, with noise."""
    rng = np.random.default_rng(3)
    rows, columns = np.mgrid[:HEIGHT, :WIDTH].astype(float)
    light = 60 + 400 * columns / WIDTH + 40 * np.sin(rows / 20)
    exposure = np.digitize(light, [110, 220]).astype(np.int8)
    left_by_blur = np.exp(-VARIANCE_PX2 * SLOPE**2 / 2)
    modulation = np.clip(
        np.rint(left_by_blur * CONTRAST * light / np.array(SCALE)[exposure] + rng.normal(0, 0.7, light.shape)), 0, 255
    ).astype(np.uint8)
    grey = np.rint(light + OTHER + rng.normal(0, 0.7, light.shape)).astype(np.uint16)
    phase = (SLOPE * columns).astype(np.float32)
    sigma, state = np.full(light.shape, 0.02, np.float32), np.zeros(light.shape, np.uint8)
    return PhaseMap("one", "v", phase, sigma, modulation, grey, state, exposure, 16.0, 1024, exposures_us=EXPOSURES_US)


def test_it_is_determined_to_half_a_grey_level_whatever_the_exposures(seen: PhaseMap) -> None:
    assert estimate_ambient_light(seen, VARIANCE_PX2) == pytest.approx(OTHER, abs=0.5)


def test_fringes_that_are_steeper_where_the_part_is_dim_do_not_spoil_it(seen: PhaseMap) -> None:
    """As on walls that turn away from the projector: blur takes more of their modulation."""
    columns = np.arange(WIDTH)
    steep = np.where(columns < WIDTH // 3, 1.2, SLOPE)
    phase = np.broadcast_to(np.cumsum(steep), seen.state.shape).astype(np.float32)
    lost = np.exp(-VARIANCE_PX2 * (steep**2 - SLOPE**2) / 2)
    dim = replace(seen, phase_rad=phase, modulation=np.rint(seen.modulation * lost).astype(np.uint8))
    assert estimate_ambient_light(dim, VARIANCE_PX2) == pytest.approx(OTHER, abs=1.0)
    assert abs(estimate_ambient_light(dim, 0.0) - OTHER) > 5.0


def test_a_single_dark_pixel_does_not_limit_it(seen: PhaseMap) -> None:
    grey = np.array(seen.grey)
    grey[::20, ::20] = 3
    assert estimate_ambient_light(replace(seen, grey=grey), VARIANCE_PX2) == pytest.approx(OTHER, abs=0.5)


def test_pixels_at_edges_and_without_a_phase_do_not_spoil_it(seen: PhaseMap) -> None:
    modulation, state = np.array(seen.modulation), np.array(seen.state)
    modulation[::12] = modulation[::12] // 2  # fringes out of step take from the modulation
    state[:, 40:60], modulation[:, 40:60] = PixelState.SHADOW, 0
    assert estimate_ambient_light(replace(seen, modulation=modulation, state=state), VARIANCE_PX2) == pytest.approx(OTHER, abs=1.0)


def test_where_it_cannot_be_determined_it_is_none(seen: PhaseMap) -> None:
    evenly = replace(seen, modulation=np.full_like(seen.modulation, 100), exposure_index=np.zeros_like(seen.exposure_index))
    nowhere = replace(seen, state=np.full_like(seen.state, PixelState.SHADOW))
    less_than_none = replace(seen, grey=np.maximum(np.array(seen.grey, int) - 30, 0).astype(np.uint16))
    assert [estimate_ambient_light(each, VARIANCE_PX2) for each in (evenly, nowhere, less_than_none)] == [0.0, 0.0, 0.0]
