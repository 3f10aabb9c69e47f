"""Datums at their material size: the part is judged where it lies best within what they leave, found here by other means."""

from __future__ import annotations

import numpy as np
import pytest
from inspection.machined_part import BALL_MM, BORE_AT, BORE_MM, LENGTH_MM, RADIUS_MM, Part, cylinder, plane
from scipy.optimize import linprog

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.session.session import InspectionSession
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

ONLY_NOISE = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
NOISE_MM, TILT_RAD, OFF_MM, HALF_MM = 0.02, 0.001, 0.05, 30.0
BORE_OFF_MM = np.array([0.06, 0.08])
# a mean over one of so many cells about a shaft or bore lies inside it by no more than this
LOST_MM = 2 * RADIUS_MM * (1 - np.cos(np.pi / 50))
FEATURES = [
    plane("base", [0, 0, 0], [0, 0, 1]),
    plane("side", [-80, 0, 40], [-1, 0, 0]),
    cylinder("shaft", [0, 0, 130], RADIUS_MM, cut={"along_mm": [-31, 31]}),
    cylinder("collar", [0, 0, 220], RADIUS_MM, cut={"along_mm": [-31, 31]}),
    cylinder("bore", [*BORE_AT, 130], BORE_MM, hole=True),
    {"name": "ball", "shape": "sphere", "point_mm": [0, 0, 400], "radius_mm": BALL_MM},
    plane("flank", [0, -120, 0], [0, -1, 0]),
]
ASKED = {"kind": "position", "features": ["bore"], "datums": ["base", "shaft", "side"], "upper_tolerance": 0.5}


def part(seed: int, noise_mm: float = NOISE_MM, shaft_tilt_rad: float = 0.0) -> Part:
    made = Part(np.random.default_rng(seed), noise_mm)
    made.square([0, 0, 0], [0, 0, 1], [1, 0, 0])
    made.square([-80, 0, 40], [-1, 0, 0], [0, 0, 1])
    made.round([0, 0, 130], RADIUS_MM, tilt_rad=shaft_tilt_rad)
    made.round([OFF_MM, 0, 220], RADIUS_MM)
    made.round([BORE_AT[0] + BORE_OFF_MM[0], BORE_AT[1] + BORE_OFF_MM[1], 130], BORE_MM, tilt_rad=TILT_RAD, hole=True)
    made.ball([0, 0, 400])
    made.square([0, -120, 0], [0, -1, 0], [1, 0, 0])
    return made


def session_of(points: Part) -> InspectionSession:
    """A session about the part as it lies, which finds each feature once whatever is asked of it."""
    return InspectionSession(points.displaced(), settings=ONLY_NOISE)


@pytest.fixture(scope="module")
def without_noise() -> InspectionSession:
    return session_of(part(0, 0.0))


def measured(points: Part | InspectionSession, *asked: dict) -> list[Dimension]:
    dimensions = [{"name": str(number), **one} for number, one in enumerate(asked)]
    document = {"name": "p", "alignment": "none", "features": FEATURES, "dimensions": dimensions}
    session = points if isinstance(points, InspectionSession) else session_of(points)
    return list(session.measure(InspectionProgram.model_validate(document)).inspection.dimensions)


def loose(play_mm: float, datum: str = "shaft", condition: str = "maximum") -> dict:
    """A shaft that is as the drawing has it, and a virtual size by which it is loose: larger at maximum material, smaller at least."""
    size = 2 * RADIUS_MM
    limits = [size - 0.3, size + play_mm] if condition == "maximum" else [size - play_mm, size + 0.3]
    return {"datum_material": [{"datum": datum, "condition": condition, "size_limits_mm": limits}]}


def best_of_bore(play_mm: float) -> float:
    """The bore's axis leans along x; the part may move by half the play in any direction across the shaft: all directions are tried."""
    ends = BORE_OFF_MM + np.array([[-1, 0], [1, 0]]) * TILT_RAD * LENGTH_MM / 2
    turn, share = np.meshgrid(np.linspace(0, 2 * np.pi, 721), np.linspace(0, 1, 201))
    moves = play_mm / 2 * np.stack([share * np.cos(turn), share * np.sin(turn)], axis=-1).reshape(-1, 1, 2)
    return 2 * float(np.linalg.norm(ends - moves, axis=2).max(axis=1).min())


@pytest.mark.parametrize("play_mm", [0.0, 0.06, 0.12, 0.28])
@pytest.mark.parametrize("condition", ["maximum", "least"])
def test_the_part_shifts_to_where_its_bore_lies_best_within_the_play_of_its_shaft(play_mm, condition, without_noise):
    (found,) = measured(without_noise, {**ASKED, **loose(play_mm, condition=condition)})
    assert found.measured == pytest.approx(best_of_bore(play_mm), abs=LOST_MM + 1e-3), found.reason
    assert "datum shift: shaft play " in found.traceability and found.upper_tolerance == 0.5


def best_of_collar(play_mm: float) -> float:
    """Shift and turn of the whole part in the x–z plane: the shaft's ends within the play, both ends of the collar as near as can be."""
    shaft, collar = np.array([-HALF_MM, HALF_MM]), 90 + np.array([-HALF_MM, HALF_MM])
    rows, limits = [], []
    for sign in (1, -1):
        rows += [[sign, sign * z, 0] for z in shaft] + [[sign, sign * z, -1] for z in collar]
        limits += [play_mm / 2] * 2 + [sign * OFF_MM] * 2
    return 2 * float(linprog([0, 0, 1], rows, limits, bounds=[(None, None), (None, None), (0, None)]).fun)


@pytest.mark.parametrize("play_mm", [0.01, 0.03, 0.1])
def test_a_primary_datum_lets_the_part_tilt_too(play_mm, without_noise):
    (found,) = measured(
        without_noise, {"kind": "position", "features": ["collar"], "datums": ["shaft"], "upper_tolerance": 0.5, **loose(play_mm)}
    )
    # a cell less of play counts twice at four times the lever
    assert found.measured == pytest.approx(best_of_collar(play_mm), abs=6 * LOST_MM + 1e-3), found.reason


def test_a_tilted_datum_uses_up_its_play_and_is_not_shifted_beyond_it():
    tilt = 0.002
    plain, tight, wide = measured(
        part(0, 0.0, shaft_tilt_rad=tilt), ASKED, {**ASKED, **loose(0.5 * tilt * LENGTH_MM)}, {**ASKED, **loose(2 * tilt * LENGTH_MM)}
    )
    assert tight.measured == pytest.approx(plain.measured, abs=1e-9)
    assert wide.measured < plain.measured - 0.1 * tilt * LENGTH_MM


def test_its_own_material_size_and_that_of_its_datum_both_count():
    own = {"material_condition": "maximum", "size_limits_mm": [2 * BORE_MM - 0.2, 2 * BORE_MM + 0.2]}
    limit = {"upper_tolerance": best_of_bore(0.12) - 0.05}
    plain, shifted, both = measured(
        part(2), {**ASKED, **limit}, {**ASKED, **limit, **loose(0.12)}, {**ASKED, **limit, **loose(0.12), **own}
    )
    assert plain.verdict is Verdict.FAIL and shifted.verdict is not Verdict.PASS and both.verdict is Verdict.PASS
    assert both.measured == pytest.approx(shifted.measured)
    assert "maximum material" in both.traceability and "datum shift" in both.traceability


@pytest.mark.parametrize("times", [3, pytest.param(40, marks=pytest.mark.slow)])
def test_what_a_shift_leaves_of_a_position_is_known_within_its_uncertainty(times):
    made = [measured(part(seed), {**ASKED, **loose(0.06)})[0] for seed in range(times)]
    held = [abs(one.measured - best_of_bore(0.06)) <= one.uncertainty + LOST_MM for one in made]
    assert np.count_nonzero(held) >= 0.95 * times - 2.5 * np.sqrt(0.05 * 0.95 * times)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"datums": ["base", "ball", "side"], **loose(0.1, "ball")}, "requires a measured cylinder"),
        (loose(0.1, "base"), "requires a measured cylinder"),
        ({"features": ["flank"], **loose(0.1)}, "axes and centres where a datum has a material condition"),
    ],
)
def test_features_without_play_are_refused_with_the_reason(change, said, without_noise):
    (found,) = measured(without_noise, {**ASKED, **change})
    assert found.verdict is Verdict.NOT_MEASURED and said in found.reason


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (loose(0.1, "collar"), "not one of the `datums`"),
        ({"datum_material": 2 * loose(0.1)["datum_material"]}, "twice: remove one"),
        ({"datum_material": [{"datum": "shaft", "condition": "maximum", "size_limits_mm": [80.1, 80.0]}]}, "smaller to the greater"),
        ({"datum_material": [{"datum": "shaft", "condition": "regardless", "size_limits_mm": [80.0, 80.1]}]}, "maximum"),
        ({"kind": "coaxiality", "features": ["collar"], "datums": ["shaft"], **loose(0.1)}, "to a position only"),
        ({"features": ["bore.{k}"], "count": 3, **loose(0.1)}, "is meaningless"),
    ],
)
def test_meaningless_material_conditions_of_datums_are_refused(change, said):
    with pytest.raises(ValueError, match=said):
        InspectionProgram.model_validate(
            {"name": "p", "alignment": "none", "features": FEATURES, "dimensions": [{"name": "d", **ASKED, **change}]}
        )
