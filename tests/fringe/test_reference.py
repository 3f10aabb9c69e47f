"""The compiled kernels against their NumPy statements, selected at run time as a user would."""

from __future__ import annotations

from math import tau

import numpy as np
import pytest
from numba import njit

from measureapp.arrays import FloatArray
from measureapp.compiled.selection import VARIABLE
from measureapp.data.fringe import PatternSet
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.data.phase import PhaseMap
from measureapp.fringe.decode import decode
from measureapp.fringe.kernels import reference
from measureapp.fringe.kernels import vote as compiled_vote
from measureapp.fringe.kernels.structures import MOST_ORDERS, PixelMaps, VoteLimits
from measureapp.fringe.kernels.wrap import atan2_cycles
from measureapp.fringe.settings import DecodeSettings
from tests.fringe.conftest import EXPOSURES_US, images_of, ramp, stack_of

NAMES = ("find_doubtful", "vote", "apply_verdicts", "find_edges")
HANDFUL = 1e-4  # of the pixels, which rounding puts on either side of a limit
SETTINGS = {
    "combined": DecodeSettings(),
    "paper's rule": DecodeSettings(rule="paper"),
    "each pitch for itself": DecodeSettings(joint=False),
    "guard against blooming": DecodeSettings(blooming_radius_px=2),
    "no vote": DecodeSettings(vote_radius=0),
}


@njit
def arctangents(sine: FloatArray, cosine: FloatArray, cycles: FloatArray) -> None:
    for j in range(len(sine)):
        cycles[j] = atan2_cycles(sine[j], cosine[j])


def difficult_images(patterns: PatternSet) -> np.ndarray:
    """A ramp with a highlight, dark bands, black pixels and a depth step, 90 × 400 px: several chunks, not a whole number of them."""
    column = ramp(90, 400)
    column[:, 220:] = np.clip(column[:, 220:] + 120, 0, 1018)
    mean, modulation = np.full(column.shape, 110.0), np.full(column.shape, 80.0)
    mean[20:30, 50:90], modulation[20:30, 50:90] = 400, 300
    mean[35:37, 100:120], modulation[35:37, 100:120] = 3000, 2500
    mean[60:65], modulation[60:65] = 30, 15
    mean[65:70], modulation[65:70] = 14, 3
    mean[70:72], modulation[70:72] = 0, 0
    return images_of(column, patterns, EXPOSURES_US, mean, modulation, seed=4)


def decoded_both_ways(
    patterns: PatternSet, settings: DecodeSettings, monkeypatch: pytest.MonkeyPatch, images: np.ndarray
) -> tuple[PhaseMap, PhaseMap]:
    stack = stack_of(images, patterns, EXPOSURES_US, saturation=255 if images.dtype == np.uint8 else 4095)
    settings = settings.model_copy(update={"noise_from_images": False})  # medians over few pixels, which need not be the same ones
    compiled = decode(stack, settings)["left"]
    monkeypatch.setenv(VARIABLE, "reference")
    return compiled, decode(stack, settings)["left"]


def assert_agree(compiled: PhaseMap, statement: PhaseMap) -> None:
    for name in ("state", "exposure_index"):
        assert np.mean(getattr(compiled, name) != getattr(statement, name)) < HANDFUL, name
    both = compiled.valid & statement.valid
    assert np.abs(compiled.phase_rad - statement.phase_rad)[both].max() <= 2 * np.spacing(compiled.phase_rad.max())
    assert compiled.sigma_rad[both] == pytest.approx(statement.sigma_rad[both], rel=1e-6)
    for name in ("modulation", "grey"):
        assert np.abs(getattr(compiled, name).astype(int) - getattr(statement, name)).max() <= 1, name
    assert compiled.valid_ratio_exposures == statement.valid_ratio_exposures
    assert compiled.valid_ratio_composite == statement.valid_ratio_composite
    assert compiled.origin_rad == statement.origin_rad


@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS)
def test_the_compiled_kernels_agree_with_the_numpy_statements(settings: DecodeSettings, monkeypatch: pytest.MonkeyPatch) -> None:
    images = difficult_images(PAPER_PATTERNS)
    compiled, statement = decoded_both_ways(PAPER_PATTERNS, settings, monkeypatch, images)
    assert 0.6 < compiled.valid.mean() < 0.98
    assert_agree(compiled, statement)


def test_they_agree_for_every_kind_of_pattern_set(sets: dict[str, PatternSet], monkeypatch: pytest.MonkeyPatch) -> None:
    for patterns in sets.values():
        monkeypatch.delenv(VARIABLE, raising=False)
        assert_agree(*decoded_both_ways(patterns, DecodeSettings(), monkeypatch, difficult_images(patterns)))


def test_they_agree_for_images_of_twelve_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    images = difficult_images(PAPER_PATTERNS).astype(np.uint16) * 16
    assert_agree(*decoded_both_ways(PAPER_PATTERNS, DecodeSettings(), monkeypatch, images))


def test_they_agree_about_the_response_of_the_projector(monkeypatch: pytest.MonkeyPatch) -> None:
    settings = DecodeSettings(phase_correction=(((4, 0.05, np.pi),),) * 2)
    assert_agree(*decoded_both_ways(PAPER_PATTERNS, settings, monkeypatch, difficult_images(PAPER_PATTERNS)))


def test_the_votes_agree_pixel_by_pixel() -> None:
    random, shape = np.random.default_rng(6), (60, 90)
    orders = np.where(random.random(shape) < 0.2, random.integers(-6, 7, shape), 0)
    state = random.choice(np.array([0, 2, 4, 5], np.uint8), shape, p=[0.8, 0.05, 0.1, 0.05])
    phase = (0.01 * np.arange(shape[1]) + tau * orders).astype(np.float32)
    sigma, flat = np.full(shape, 0.02, np.float32), np.zeros(shape, np.uint8)
    residual = random.integers(-120, 121, shape).astype(np.int8)
    steps = np.float32(tau) * np.arange(-MOST_ORDERS, MOST_ORDERS + 1, dtype=np.float32)
    limits = VoteLimits(2, np.float32(3), np.float32(0.353), np.float32(8), np.float32(0.5), np.float32(-1), np.float32(30), steps)
    results = []
    for module in (compiled_vote, reference):
        find, decide, apply, mark_edges = (getattr(module, name) for name in NAMES)
        maps = PixelMaps(phase.copy(), sigma, flat, flat, state.copy(), flat, residual)
        doubtful = np.zeros(shape, np.uint8)
        find(maps, limits.edge_step, limits.radius, 0, shape[0], doubtful)
        places = np.flatnonzero(doubtful)
        verdicts, edge = np.zeros(len(places), np.int8), np.zeros(len(places), np.bool_)
        decide(places, maps, limits, 0, len(places), verdicts)
        repaired = apply(places, verdicts, limits, 0, len(places), maps)
        mark_edges(places, maps, limits.edge_step, 0, len(places), edge)
        results.append((doubtful, verdicts, maps.phase, maps.state, edge, repaired))
    assert results[0][-1] > 50
    for compiled, statement in zip(*results, strict=True):
        np.testing.assert_array_equal(compiled, statement)


def test_the_polynomial_arc_tangent_is_exact_to_float_precision() -> None:
    angle = np.linspace(-np.pi, np.pi, 20_002)[1:-1].astype(np.float32)
    found = np.empty_like(angle)
    arctangents(np.sin(angle), np.cos(angle), found)
    assert np.abs(tau * found - angle).max() < 7e-7
