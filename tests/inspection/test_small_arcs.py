"""Radii of small pieces of cylinders: what simulated noise says against what the curvature's normal errors demand."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.dimension import Dimension
from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.find_all import find_all
from measureapp.inspection.measured import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from measureapp.inspection.small_arcs import NONLINEAR, needs_draws, simulated_radius_sigma

RADIUS_MM, LENGTH_MM, ARC_DEG, COUNT = 40.0, 30.0, 5.0, 3000
ONLY_NOISE = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
PROGRAM = InspectionProgram.model_validate(
    {
        "name": "p",
        "alignment": "none",
        "features": [
            {
                "name": "c",
                "shape": "cylinder",
                "point_mm": [0, 0, 0],
                "direction": [0, 0, 1],
                "radius_mm": RADIUS_MM,
                "cut": {"band_mm": RADIUS_MM / 2},
            }
        ],
        "dimensions": [{"name": "d", "kind": "diameter", "features": ["c"], "nominal": 2 * RADIUS_MM}],
    }
)


def arc(seed: int, noise_mm: float, arc_deg: float = ARC_DEG) -> MeasuredPoints:
    rng = np.random.default_rng(seed)
    turn = np.radians(rng.uniform(-arc_deg / 2, arc_deg / 2, COUNT))
    outward = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(COUNT)])
    along = rng.uniform(-LENGTH_MM / 2, LENGTH_MM / 2, COUNT)[:, None] * np.array([0, 0, 1.0])
    return MeasuredPoints(RADIUS_MM * outward + along + noise_mm * rng.standard_normal((COUNT, 1)) * outward, outward)


def measured(seed: int, noise_mm: float, arc_deg: float = ARC_DEG) -> Dimension:
    return inspect(arc(seed, noise_mm, arc_deg), PROGRAM, settings=ONLY_NOISE).dimensions[0]


def curvature_sigma(noise_mm: float) -> float:
    """Of a parabola over a strip of width w whose axis may turn: the variance of x² over it is w⁴/180, curvature twice its factor."""
    width = RADIUS_MM * np.radians(ARC_DEG)
    return float(2 * noise_mm / np.sqrt(COUNT * width**4 / 180))


@pytest.mark.parametrize("noise_mm", [0.08, 0.12])
def test_draws_give_the_quantile_that_normal_errors_of_the_curvature_demand(noise_mm: float) -> None:
    found = find_all(arc(2, noise_mm), PROGRAM, None, ONLY_NOISE)["c"]
    assert found.feature is not None and found.feature.radius_mm is not None and needs_draws(found)
    radius = found.feature.radius_mm
    curvature = 1 / radius + curvature_sigma(noise_mm) * np.random.default_rng(0).standard_normal(100_000)
    demanded = np.quantile(np.abs(1 / np.abs(curvature) - radius), 0.95)
    # 400 draws leave the place of a quantile open by √(0.95·0.05/400) = 1.1 %, of which a step costs at most 5 % of the value
    # here; 200 of the points stand for all, their spread to 4 %, its square to 8 %; the scatter is known to 1 %
    assert 2 * simulated_radius_sigma(found, found.feature, 400) == pytest.approx(demanded, rel=0.2)


def test_the_linear_uncertainty_stays_where_it_is_enough_and_the_origin_tells_which() -> None:
    wide, small = measured(1, 0.02, arc_deg=90.0), measured(1, 0.1)
    assert "Monte Carlo" not in wide.origin
    assert "small piece: Monte Carlo, 400 draws" in small.origin
    assert measured(1, 0.1).uncertainty == small.uncertainty  # the draws are the same every time


def test_a_piece_whose_curvature_drowns_in_noise_has_no_radius() -> None:
    """Here the curvature is known to ± 48 %: radii without end are as likely as any."""
    refused = measured(3, 0.3)
    assert refused.measured is None and "too small a piece to determine a radius" in refused.reason, refused


def test_the_linear_interval_holds_less_and_less_as_the_text_says() -> None:
    """The figures of `needs_draws`, from normal errors of a curvature 1 with the standard deviation u."""
    errors = np.random.default_rng(1).standard_normal(400_000)
    for relative, share in ((0.03, 0.954), (NONLINEAR, 0.953), (0.2, 0.937), (0.3, 0.920)):
        radius = 1 / (1 + relative * errors)
        holds = np.abs(radius - 1) <= 2 * relative * radius**2
        assert holds.mean() == pytest.approx(share, abs=0.002)


@pytest.mark.slow
@pytest.mark.parametrize("noise_mm", [0.01, 0.12])
def test_intervals_on_5_degree_arcs_hold_the_truth_in_93_to_97_of_100_cases(noise_mm: float) -> None:
    times = 120
    made = [measured(seed, noise_mm) for seed in range(times)]
    held = sum(one.error is not None and one.uncertainty is not None and abs(one.error) <= one.uncertainty for one in made)
    low, high = (share * times + sign * 2.5 * np.sqrt(share * (1 - share) * times) for share, sign in ((0.93, -1), (0.97, 1)))
    assert low <= held <= high
    assert (noise_mm > 0.05) == any("Monte Carlo" in one.origin for one in made)
