"""Light without fringes is found by the mean grey level and the modulation: evenly over the image, or where a bright neighbour lights a wall."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.reconstruct.projector_light import LightLine, fit_light_line, projector_light

HEIGHT, WIDTH, AMBIENT, CONTRAST, VARIANCE_PX2, NOISE = 400, 600, 12.0, 0.9, 0.6, 0.7
SLOPE = 0.3
HUNDREDTH = 2.5  # grey levels: a hundredth of the mean light
SCALE = (1.0, 2.0, 4.0)
EXPOSURES_US = tuple(8000.0 / scale for scale in SCALE)
ROWS, COLUMNS = np.mgrid[:HEIGHT, :WIDTH].astype(float)
LIGHT = 60 + 400 * COLUMNS / WIDTH + 40 * np.sin(ROWS / 40)  # of the projector
# A wall lit by a bright floor beside it, at whose foot more than half of its light has no fringes; half a grey level per pixel.
WALL = COLUMNS < WIDTH // 4
FROM_FLOOR = np.where(WALL, 100.0 * COLUMNS / (WIDTH // 4), 0.0)
INSIDE = np.s_[20:-20, 20 : WIDTH // 4 - 20]


def taken(ambient: FloatArray | float = AMBIENT) -> PhaseMap:
    """8-bit images of a part lit unevenly, in three exposures, by fringes of a projector and by light without fringes, with noise."""
    rng = np.random.default_rng(3)
    exposure = np.digitize(LIGHT, [110, 220]).astype(np.int8)
    left_by_blur = np.exp(-VARIANCE_PX2 * SLOPE**2 / 2)
    modulation = np.rint(left_by_blur * CONTRAST * LIGHT / np.array(SCALE)[exposure] + rng.normal(0, NOISE, LIGHT.shape))
    grey = np.rint(LIGHT + ambient + rng.normal(0, NOISE, LIGHT.shape)).astype(np.uint16)
    sigma, state = np.full(LIGHT.shape, 0.02, np.float32), np.zeros(LIGHT.shape, np.uint8)
    phase = (SLOPE * COLUMNS).astype(np.float32)
    return PhaseMap("one", "v", phase, sigma, modulation.astype(np.uint8), grey, state, exposure, 16.0, 1024, exposures_us=EXPOSURES_US)


@pytest.fixture
def seen() -> PhaseMap:
    return taken()


def ambient_of(phase_map: PhaseMap, variance_px2: float = VARIANCE_PX2) -> float:
    return fit_light_line(phase_map, variance_px2).ambient


def test_even_light_is_determined_to_a_hundredth_whatever_the_exposures(seen: PhaseMap) -> None:
    """Differences of the modulation over 16 px are 11 grey levels, with a noise of 0.9, which makes the line too flat by a hundredth."""
    line = fit_light_line(seen, VARIANCE_PX2)
    assert line.per_modulation == pytest.approx(1 / CONTRAST, rel=0.01)
    assert line.ambient == pytest.approx(AMBIENT, abs=HUNDREDTH)


def test_fringes_that_are_steeper_where_the_part_is_dim_do_not_spoil_it(seen: PhaseMap) -> None:
    """As on walls that turn away from the projector: blur takes more of their modulation."""
    steep = np.where(np.arange(WIDTH) < WIDTH // 3, 1.2, SLOPE)
    phase = np.broadcast_to(np.cumsum(steep), seen.state.shape).astype(np.float32)
    lost = np.exp(-VARIANCE_PX2 * (steep**2 - SLOPE**2) / 2)
    dim = replace(seen, phase_rad=phase, modulation=np.rint(seen.modulation * lost).astype(np.uint8))
    assert ambient_of(dim) == pytest.approx(AMBIENT, abs=HUNDREDTH)
    assert abs(ambient_of(dim, 0.0) - AMBIENT) > 4.0


def test_a_single_dark_pixel_does_not_limit_it(seen: PhaseMap) -> None:
    grey = np.array(seen.grey)
    grey[::19, ::19] = 3
    assert ambient_of(replace(seen, grey=grey)) == pytest.approx(AMBIENT, abs=HUNDREDTH)


def test_pixels_at_edges_and_without_a_phase_do_not_spoil_it(seen: PhaseMap) -> None:
    modulation, state = np.array(seen.modulation), np.array(seen.state)
    modulation[::90] = modulation[::90] // 2  # fringes out of step take from the modulation
    state[:, 40:60], modulation[:, 40:60] = PixelState.SHADOW, 0
    assert ambient_of(replace(seen, modulation=modulation, state=state)) == pytest.approx(AMBIENT, abs=2 * HUNDREDTH)


def test_where_it_cannot_be_determined_it_is_none(seen: PhaseMap) -> None:
    evenly = replace(seen, modulation=np.full_like(seen.modulation, 100), exposure_index=np.zeros_like(seen.exposure_index))
    nowhere = replace(seen, state=np.full_like(seen.state, PixelState.SHADOW))
    less_than_none = replace(seen, grey=np.maximum(np.array(seen.grey, int) - 30, 0).astype(np.uint16))
    assert [ambient_of(each) for each in (evenly, nowhere, less_than_none)] == [0.0, 0.0, 0.0]


def test_the_light_of_a_bright_neighbour_is_found_where_it_falls() -> None:
    """But for a factor, which the wall itself spoils. The modulation's noise, up to four times as large at a short exposure, is averaged."""
    relative = projector_light(taken(AMBIENT + FROM_FLOOR), VARIANCE_PX2)[INSIDE] / LIGHT[INSIDE]
    assert np.mean(relative) == pytest.approx(1.0, abs=0.1)
    assert relative.std() < 0.03


def test_beside_a_bright_neighbour_the_relative_slope_of_the_light_is_that_of_the_projector() -> None:
    """The slope is what the correction of blur needs; that of all light is less than half of it there."""

    def slope(light: FloatArray) -> float:
        columns = light[INSIDE].mean(axis=0)
        return float((columns[-1] - columns[0]) / columns.mean() / (len(columns) - 1))

    lit = taken(AMBIENT + FROM_FLOOR * (1 - COLUMNS / WIDTH * 4) * 4)  # brightest in the middle of the wall
    true = slope(LIGHT)
    assert slope(projector_light(lit, VARIANCE_PX2).astype(float)) == pytest.approx(true, rel=0.1)
    assert slope(lit.grey.astype(float)) < 0.7 * true


def test_an_error_of_the_line_does_not_change_the_relative_slope(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where an evenly bright image does not determine it: all light with fringes is scaled by nearly the same factor."""
    even = taken(0.0)
    right = projector_light(even, VARIANCE_PX2)[20:-20, 20:-20]
    monkeypatch.setattr("measureapp.reconstruct.projector_light._fit_line", lambda _: LightLine(0.9 / CONTRAST, 0.0))
    ratio = projector_light(even, VARIANCE_PX2)[20:-20, 20:-20] / right
    assert np.median(ratio) == pytest.approx(0.9, abs=0.02)
    assert ratio.std() < 0.02


@pytest.mark.parametrize("state", [PixelState.SHADOW, PixelState.SATURATED])
def test_where_no_phase_shows_it_the_places_around_do(state: PixelState) -> None:
    seen = taken(AMBIENT + FROM_FLOOR)
    states = np.array(seen.state)
    states[100:110], states[:, 30:36] = state, state
    found = projector_light(replace(seen, state=states), VARIANCE_PX2)
    np.testing.assert_allclose(found[INSIDE], LIGHT[INSIDE], atol=9.0)


def test_an_image_without_any_phase_stays_as_it_is(seen: PhaseMap) -> None:
    nowhere = replace(seen, state=np.full_like(seen.state, PixelState.SHADOW))
    np.testing.assert_array_equal(projector_light(nowhere, VARIANCE_PX2), seen.grey)
