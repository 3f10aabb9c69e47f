"""Blades in an inspection program: whole wheels with known twist, pitch and form, and the sample impeller."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.settings import InspectionSettings
from tests.inspection.blade_shapes import RoundBlade, scattered

NOISE_MM = 0.02
COUNT, INNER_MM = 4, 50.0
BLADE = RoundBlade()
STAGGER_DEG, TWIST_DEG_PER_MM = 20.0, 0.05
PITCH_OFF_DEG = (0.0, 0.15, -0.1, 0.05)
HEIGHTS = (10.0, 30.0)
COUNT_OF_POINTS = 3000  # of a section: about 28 of them on its trailing edge, of which 20 are needed
DENSE = 4000
QUICK = InspectionSettings(blade_trials=12, blade_points=COUNT_OF_POINTS)
VALUES_ALONE = QUICK.model_copy(update={"blade_trials": 2})  # where no uncertainty is asked for, trials are for nothing


def turned(points: np.ndarray, degrees: np.ndarray | float) -> np.ndarray:
    angle = np.radians(degrees)
    x, y = points.T
    return np.column_stack([np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y])


ALL_LOW = tuple((number, HEIGHTS[0]) for number in range(COUNT))


def wheel(
    bump_mm: float = 0.0, seed: int = 1, count: int = COUNT_OF_POINTS, places: Sequence[tuple[int, float]] = ALL_LOW
) -> MeasuredPoints:
    """Four blades standing outwards, twisted along z, each off its even place; one side of blade 2 may bulge.

    They are measured at ``places``: number of the blade, from 0, and height.
    """
    rng, points = np.random.default_rng(seed), []
    for number, height in places:
        flat = scattered(BLADE.contour(), count, NOISE_MM, rng)
        if number == 1:
            flat[:, 1] += np.where(flat[:, 1] > BLADE.camber_mm, bump_mm * np.exp(-(((flat[:, 0] - 30) / 8) ** 2)), 0.0)
        z = height + rng.uniform(-0.5, 0.5, len(flat))
        standing = turned(flat, STAGGER_DEG + TWIST_DEG_PER_MM * (z - HEIGHTS[0])) + np.array([INNER_MM, 0.0])
        points.append(np.column_stack([turned(standing, 360 / COUNT * number + PITCH_OFF_DEG[number]), z]))
    return MeasuredPoints(np.vstack(points))


def wheel_section(name: str, height: float) -> dict:
    end = turned(np.array([[BLADE.chord_mm, 0.0]]), STAGGER_DEG + TWIST_DEG_PER_MM * (height - HEIGHTS[0]))[0] + [INNER_MM, 0]
    return {
        "name": name, "shape": "blade_section", "plane_point_mm": [0, 0, height], "plane_normal": [0, 0, 1], "count": COUNT,
        "leading_mm": [INNER_MM, 0, height], "trailing_mm": [*end, height], "beside_mm": 14,
    }  # fmt: skip


SECTIONS = [wheel_section("low", HEIGHTS[0]), wheel_section("high", HEIGHTS[1])]


def dimension(kind: str, *features: str, nominal: float = 0.0, **more) -> dict:
    return {"name": f"{kind} {features}", "kind": kind, "features": list(features), "nominal": nominal, "upper_tolerance": 0.1, **more}


def measured(points, sections: list[dict], *dimensions: dict, settings: InspectionSettings = QUICK, **more) -> list[Dimension]:
    document = {"name": "wheel", "alignment": "none", "features": sections, "dimensions": dimensions}
    return list(inspect(points, InspectionProgram.model_validate(document), settings=settings, **more).dimensions)


def test_the_values_of_a_wheel_lie_within_their_stated_uncertainties() -> None:
    wanted = {
        ("chord", ("low.1",)): BLADE.chord_mm,
        ("max_thickness", ("low.2",)): BLADE.thickness_mm,
        ("camber", ("low.3",)): BLADE.camber_mm,
        ("leading_radius", ("low.4",)): BLADE.leading_mm,
        ("trailing_radius", ("low.1",)): BLADE.trailing_mm,
        ("stagger", ("low.1",)): STAGGER_DEG,
        ("twist", ("low.3", "high.3")): TWIST_DEG_PER_MM * (HEIGHTS[1] - HEIGHTS[0]),
    }
    points = wheel(places=(*ALL_LOW, (2, HEIGHTS[1])))  # the one blade whose twist is asked for
    found = measured(points, SECTIONS, *(dimension(kind, *names, nominal=value) for (kind, names), value in wanted.items()))
    for one in found:
        assert one.deviation is not None and one.uncertainty is not None, one.reason
        assert abs(one.deviation) < 1.5 * one.uncertainty, one.name  # three standard uncertainties
        assert one.uncertainty < 0.15
        assert "Monte Carlo" in one.traceability and "points" in one.traceability
    assert [one.unit for one in found[-2:]] == ["°", "°"]


def test_the_pitch_of_neighbouring_blades_is_determined_to_a_hundredth_of_a_degree() -> None:
    found = measured(
        wheel(),
        SECTIONS[:1],
        *(dimension("pitch", f"low.{k}", f"low.{k % COUNT + 1}", nominal=90) for k in range(1, COUNT + 1)),
        settings=VALUES_ALONE,  # what a pitch is known to is told by the comparison of the blades, not by trials
    )
    truth = np.roll(PITCH_OFF_DEG, -1) - np.array(PITCH_OFF_DEG)
    # 3000 points on a lever of about 80 mm: 0.02 / sqrt(3000) / 80 rad is far less than the 0.01 mm a view may stand off
    assert [one.deviation for one in found] == pytest.approx(list(truth), abs=0.005)
    assert sum(one.measured for one in found) == pytest.approx(360)
    assert all(0.005 < one.uncertainty < 0.05 for one in found)


def test_a_bulge_is_found_against_the_average_of_the_other_blades() -> None:
    """0.2 mm on one of four blades: it stands 0.15 above the average, the others 0.05 below it."""
    low, dense = SECTIONS[:1], VALUES_ALONE.model_copy(update={"blade_points": DENSE})  # medians of fewer points lie too near the bounds
    found = measured(wheel(bump_mm=0.2, count=DENSE), low, *(dimension("blade_form", f"low.{k}") for k in (1, 2)), settings=dense)
    good, bulged = (one.measured for one in found)
    assert bulged == pytest.approx(0.3, abs=0.05) and good == pytest.approx(0.1, abs=0.05)
    even = measured(wheel(count=DENSE), low, dimension("blade_form", "low.2"), settings=dense)[0]
    assert even.measured < 0.03  # though the blade stands 0.15° off: it is turned onto the average first


def test_a_single_stray_point_is_no_form() -> None:
    clean = wheel(count=600)
    stray = np.array(clean.points_mm)
    middle = (stray[:600].min(axis=0) + stray[:600].max(axis=0)) / 2
    stray[np.argmin(np.linalg.norm(stray[:600] - middle, axis=1)), 1] += 1.5
    asked = dimension("blade_form", "low.1")
    (without,), (beside,) = (measured(points, SECTIONS[:1], asked, settings=VALUES_ALONE) for points in (clean, MeasuredPoints(stray)))
    assert without.measured is not None and beside.measured is not None
    assert abs(beside.measured - without.measured) < NOISE_MM  # about 20 points a piece: their median moves by a rank, their mean by 0.07


def test_a_cylinder_about_the_axis_cuts_the_blades_of_an_axial_wheel() -> None:
    radius, rng, points = 120.0, np.random.default_rng(2), []
    for number in range(3):
        flat = turned(scattered(BLADE.contour(), COUNT_OF_POINTS, NOISE_MM, rng), 60.0)  # 30° from the axis
        angle, r = flat[:, 0] / radius + 2 * np.pi * number / 3 + np.pi, radius + rng.uniform(-0.5, 0.5, len(flat))
        points.append(np.column_stack([r * np.cos(angle), r * np.sin(angle), flat[:, 1]]))
    end = turned(np.array([[BLADE.chord_mm, 0.0]]), 60.0)[0]
    angle = end[0] / radius + np.pi
    section = {
        "name": "c", "shape": "blade_section", "radius_mm": radius, "count": 3, "leading_mm": [-radius, 0, 0],
        "trailing_mm": [radius * np.cos(angle), radius * np.sin(angle), end[1]], "beside_mm": 14,
    }  # fmt: skip
    kinds = {"chord": BLADE.chord_mm, "stagger": -30.0, "leading_radius": BLADE.leading_mm}
    found = measured(
        MeasuredPoints(np.vstack(points)), [section], *(dimension(kind, "c.2", nominal=value) for kind, value in kinds.items())
    )
    for one in found:
        assert abs(one.deviation) < 1.5 * one.uncertainty, one.name


def test_the_stated_uncertainty_is_the_scatter_of_repeated_scans() -> None:
    settings = QUICK.model_copy(
        update={"uncertainty": QUICK.uncertainty.model_copy(update={"placement_mm": 0.0, "systematic_mm": 0.0, "systematic_relative": 0.0})}
    )
    kinds = {"max_thickness": BLADE.thickness_mm, "leading_radius": BLADE.leading_mm, "stagger": STAGGER_DEG}
    single = {**SECTIONS[0], "count": 1}
    scans = [
        measured(
            wheel(seed=seed, places=ALL_LOW[:1]), [single], *(dimension(k, "low", nominal=v) for k, v in kinds.items()), settings=settings
        )
        for seed in range(10)
    ]
    for number, kind in enumerate(kinds):
        scatter = np.std([one[number].measured for one in scans], ddof=1)
        stated = np.median([one[number].uncertainty for one in scans]) / 2
        # ten scans and twelve trials: each standard deviation is known to about a quarter; shared-error factors only widen
        assert 0.5 < stated / scatter < 3.0, kind


IMPELLER = {
    "name": "blade", "shape": "blade_section", "plane_point_mm": [0, 0, 40], "plane_normal": [0, 0, 1], "count": 7,
    "open_ends": ["leading", "trailing"], "beside_mm": 16,
}  # fmt: skip


def on_mid_line(rho: float) -> list[float]:
    polar = np.arccos((rho**2 + 90**2 - 110**2) / (2 * 90 * rho))
    return [rho * np.cos(polar), rho * np.sin(polar), 40.0]


def test_the_blades_of_the_sample_impeller_have_their_thickness_pitch_and_form(samples) -> None:
    nominal, rng = samples("impeller").nominal, np.random.default_rng(3)
    points = sample_mesh(nominal, 800_000)
    noisy = MeasuredPoints(points.points_mm + NOISE_MM * rng.standard_normal((len(points), 1)) * points.normals, points.normals)
    section = {**IMPELLER, "leading_mm": on_mid_line(55.0), "trailing_mm": on_mid_line(120.0)}
    found = measured(
        noisy,
        [section],
        dimension("max_thickness", "blade.{k}", nominal=5, count=7),
        dimension("pitch", "blade.{k}", "blade.{k+1}", nominal=360 / 7, count=7, statistic="max"),
        dimension("blade_form", "blade.{k}", count=7, statistic="max"),
        dimension("blade_profile", "blade.{k}", count=7, statistic="max"),
        dimension("chord", "blade.1", nominal=80),
        dimension("trailing_radius", "blade.1", nominal=2.5),
        nominal=nominal,
    )
    thickness, pitch, form, outline, chord, trailing = found
    assert abs(thickness.deviation) < thickness.uncertainty
    assert abs(pitch.deviation) < pitch.uncertainty
    assert form.measured < form.uncertainty and outline.measured < outline.uncertainty  # the zones of a true part are noise alone
    assert chord.verdict is Verdict.NOT_MEASURED and "as the blade continues there (leading end)" in chord.reason
    assert trailing.verdict is Verdict.NOT_MEASURED and "(trailing end)" in trailing.reason


def test_what_a_single_blade_or_a_part_without_nominal_cannot_determine_is_refused() -> None:
    single = {**SECTIONS[0], "count": 1}
    other = {**SECTIONS[1], "count": 1}
    found = measured(
        wheel(places=((0, HEIGHTS[0]), (0, HEIGHTS[1]))),
        [single, other],
        dimension("blade_form", "low"),
        dimension("blade_profile", "low"),
        dimension("pitch", "low", "high", nominal=90),
    )
    assert [one.verdict for one in found] == [Verdict.NOT_MEASURED] * 3
    assert "at least two measured blades" in found[0].reason
    assert "needs a nominal mesh" in found[1].reason
    assert "at least two measured blades" in found[2].reason


def test_a_blade_that_was_not_measured_is_named() -> None:
    points = wheel()
    angle = np.degrees(np.arctan2(points.points_mm[:, 1], points.points_mm[:, 0]))
    without = points.where(np.abs(angle - 110) > 45)
    asked = (dimension("chord", f"low.{k}", nominal=60) for k in (2, 3))
    found = measured(without, SECTIONS[:1], *asked, settings=VALUES_ALONE)
    assert found[0].verdict is Verdict.NOT_MEASURED and "low.2: only" in found[0].reason
    assert found[1].measured is not None


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"radius_mm": 80.0}, "either `plane_point_mm`"),
        ({"plane_normal": None}, "either `plane_point_mm`"),
        ({"trailing_mm": [INNER_MM, 0, HEIGHTS[0]]}, "the same point"),
        ({"axis": [0, 0, 0]}, "`axis` has length 0"),
    ],
)
def test_an_invalid_section_is_refused_when_the_program_is_read(change: dict, reason: str) -> None:
    with pytest.raises(ValidationError, match=reason):
        measured(wheel(), [{**SECTIONS[0], **change}])


def test_blade_values_are_taken_of_blades_and_of_nothing_else() -> None:
    plane = {"name": "top", "shape": "plane", "point_mm": [0, 0, 0], "direction": [0, 0, 1]}
    with pytest.raises(ValidationError, match="'top' is not a blade_section"):
        measured(wheel(), [plane], dimension("chord", "top", nominal=1))
    with pytest.raises(ValidationError, match=r"'low\.1' is a blade_section"):
        measured(wheel(), SECTIONS, dimension("diameter", "low.1", nominal=1))
