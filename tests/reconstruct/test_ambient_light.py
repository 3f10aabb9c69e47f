"""Light that is not the projector's is told by how the mean grey level grows with the modulation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.phase import PhaseMap, PixelState
from measureapp.reconstruct.blur import estimate_ambient_light

HEIGHT, WIDTH, OTHER, CONTRAST = 200, 300, 12.0, 0.9
SCALE = (1.0, 2.0, 4.0)
EXPOSURES_US = tuple(8000.0 / scale for scale in SCALE)


@pytest.fixture
def seen() -> PhaseMap:
    """8-bit images of a part lit unevenly, in three exposures, by fringes of a projector and the light of the room, with noise."""
    rng = np.random.default_rng(3)
    rows, columns = np.mgrid[:HEIGHT, :WIDTH].astype(float)
    light = 60 + 400 * columns / WIDTH + 40 * np.sin(rows / 20)
    exposure = np.digitize(light, [110, 220]).astype(np.int8)
    modulation = np.clip(np.rint(CONTRAST * light / np.array(SCALE)[exposure] + rng.normal(0, 0.7, light.shape)), 0, 255).astype(np.uint8)
    grey = np.rint(light + OTHER + rng.normal(0, 0.7, light.shape)).astype(np.uint16)
    phase = (0.3 * columns).astype(np.float32)
    sigma, state = np.full(light.shape, 0.02, np.float32), np.zeros(light.shape, np.uint8)
    return PhaseMap("one", "v", phase, sigma, modulation, grey, state, exposure, 16.0, 1024, exposures_us=EXPOSURES_US)


def test_it_is_determined_to_half_a_grey_level_whatever_the_exposures(seen: PhaseMap) -> None:
    assert estimate_ambient_light(seen) == pytest.approx(OTHER, abs=0.5)


def test_pixels_at_edges_and_without_a_phase_do_not_spoil_it(seen: PhaseMap) -> None:
    modulation, state = np.array(seen.modulation), np.array(seen.state)
    modulation[::12] = modulation[::12] // 2  # fringes out of step take from the modulation
    state[:, 40:60], modulation[:, 40:60] = PixelState.SHADOW, 0
    assert estimate_ambient_light(replace(seen, modulation=modulation, state=state)) == pytest.approx(OTHER, abs=1.0)


def test_where_it_cannot_be_determined_it_is_none(seen: PhaseMap) -> None:
    evenly = replace(seen, modulation=np.full_like(seen.modulation, 100), exposure_index=np.zeros_like(seen.exposure_index))
    nowhere = replace(seen, state=np.full_like(seen.state, PixelState.SHADOW))
    less_than_none = replace(seen, grey=np.maximum(np.array(seen.grey, int) - 30, 0).astype(np.uint16))
    assert estimate_ambient_light(evenly) == estimate_ambient_light(nowhere) == estimate_ambient_light(less_than_none) == 0.0
