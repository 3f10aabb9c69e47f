"""The curves of sections lie on the part they were measured on."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.alignment.best_fit import no_alignment
from measureapp.inspection.blades.section_frame import SectionFrame
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.section_curves import find_section_curves
from measureapp.inspection.surface.cutting_surface import CuttingCylinder, CuttingPlane
from measureapp.inspection.surface.deviation import compute_deviation
from measureapp.inspection.surface.nominal import NominalSurface
from tests.inspection.blade_shapes import RoundBlade
from tests.inspection.blades.test_blades import (
    COUNT,
    DENSE,
    HEIGHTS,
    INNER_MM,
    NOISE_MM,
    PITCH_OFF_DEG,
    QUICK,
    STAGGER_DEG,
    turned,
    wheel,
    wheel_section,
)
from tests.inspection.surface.test_deviation import box

HALF = np.array([50.0, 30.0, 20.0])
EVERYWHERE = tuple((number, height) for number in range(COUNT) for height in HEIGHTS)
FIT_MM = 3 * NOISE_MM / np.sqrt(10)  # a side of some 1700 points has 9 unknowns: its curve is at least ten times better than a point
EDGE_MM = 3 * NOISE_MM * np.sqrt(9 / 50)  # an edge has some 50 points for 3 unknowns; at the ends of the half circle they weigh threefold


def program(features: list[dict], dimensions: list[dict]) -> InspectionProgram:
    return InspectionProgram.model_validate({"name": "test", "features": features, "dimensions": dimensions})


def of_wheel():
    blade = {"name": "t", "kind": "max_thickness", "features": ["low.1"], "nominal": 1.0}
    surface = box(np.array([200.0, 200.0, 100.0]))
    found = compute_deviation(wheel(count=DENSE, places=EVERYWHERE), surface, no_alignment())
    settings = QUICK.model_copy(update={"blade_points": DENSE})
    return find_section_curves(found, NominalSurface(surface), program([wheel_section("low", HEIGHTS[0])], [blade]), settings)


def test_outline_mean_line_and_chord_of_every_blade_lie_where_its_form_has_them():
    drawn, blade = of_wheel(), RoundBlade()
    assert sorted(drawn.blades) == [f"low.{number + 1}" for number in range(COUNT)]
    contour = blade.contour()
    for number, off in enumerate(PITCH_OFF_DEG):
        curves = drawn.blades[f"low.{number + 1}"]
        standing = turned(contour, STAGGER_DEG) + np.array([INNER_MM, 0.0])
        truth = cKDTree(turned(standing, 360 / COUNT * number + off))
        for curve in curves.outline:
            assert np.allclose(curve[:, 2], HEIGHTS[0])
        assert max(truth.query(curve[:, :2])[0].max() for curve in curves.sides) < FIT_MM
        assert max(truth.query(curve[:, :2])[0].max() for curve in curves.edges.values()) < EDGE_MM
        assert curves.chord is not None
        assert np.linalg.norm(curves.chord[1] - curves.chord[0]) == pytest.approx(blade.chord_mm, abs=2 * FIT_MM)
        assert np.linalg.norm(curves.thickest[1] - curves.thickest[0]) == pytest.approx(blade.thickness_mm, abs=2 * FIT_MM)
        assert np.allclose(curves.mean_line[[0, -1]], curves.chord, atol=FIT_MM)
        assert sorted(curves.edges) == ["leading", "trailing"]


def test_a_blade_without_points_has_no_curves_and_the_others_keep_theirs():
    points = wheel().points_mm
    kept = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360 < 250
    surface = box(np.array([200.0, 200.0, 100.0]))
    found = compute_deviation(MeasuredPoints(points[kept]), surface, no_alignment())
    drawn = find_section_curves(found, NominalSurface(surface), program([wheel_section("low", HEIGHTS[0])], []), QUICK)
    assert sorted(drawn.blades) == ["low.1", "low.2", "low.3"]


def test_a_line_profile_has_the_curve_of_the_nominal_and_the_points_beside_it_with_their_deviations():
    surface, lift = box(HALF), 0.03
    points = sample_mesh(surface, 60_000)
    top = points.points_mm[points.points_mm[:, 2] > HALF[2] - 1e-6] + [0, 0, lift]
    found = compute_deviation(MeasuredPoints(top), surface, no_alignment())
    feature = {"name": "top", "shape": "plane", "point_mm": [0, 0, HALF[2]], "direction": [0, 0, 1]}
    line = {
        "name": "ridge", "kind": "line_profile", "features": ["top"], "upper_tolerance": 0.1,
        "section": {"point_mm": [5, 0, 0], "normal": [1, 0, 0]},
    }  # fmt: skip
    drawn = find_section_curves(found, NominalSurface(surface), program([feature], [line]))
    found_line = drawn.profiles["ridge"]
    (curve,) = found_line.nominal
    assert np.allclose(curve[:, 0], 5.0)
    assert np.allclose(found_line.measured_mm[:, 0], 5.0)
    assert np.allclose(found_line.deviations_mm, lift, atol=1e-6)
    inner = np.abs(found_line.measured_mm[:, 1]) < HALF[1] - 1.0  # on the edge the nominal's normal is between both faces
    assert np.allclose(found_line.nominal_normals[inner], [0, 0, 1], atol=1e-6)


@pytest.mark.parametrize(
    "surface",
    [
        CuttingPlane.through(np.array([3.0, -2.0, 7.0]), np.array([0.2, -0.5, 1.0])),
        CuttingCylinder.about(np.array([3.0, -2.0, 7.0]), np.array([0.2, -0.5, 1.0]), 40.0),
    ],
)
def test_what_is_laid_flat_and_lifted_again_is_where_it_was(surface):
    flat = np.random.default_rng(2).uniform(-60, 60, (50, 2))
    lifted = surface.lift(flat)
    assert np.allclose(surface.offsets_mm(lifted), 0, atol=1e-9)
    assert np.allclose(surface.flatten(lifted), flat, atol=1e-9)


def test_the_nominal_section_of_a_turned_blade_is_the_first_one_turned():
    surface = box(np.array([60.0, 12.0, 30.0]))
    described = program([wheel_section("low", HEIGHTS[0])], []).features[0]
    found = compute_deviation(sample_mesh(surface, 20_000), surface, no_alignment())
    drawn = find_section_curves(found, NominalSurface(surface), program([wheel_section("low", HEIGHTS[0])], []), QUICK)
    frame = SectionFrame.of(described)
    first, third = drawn.nominal_blades["low.1"], drawn.nominal_blades["low.3"]
    assert len(first) == len(third) > 0
    assert frame.rotate(np.vstack(first), np.pi) == pytest.approx(np.vstack(third), abs=1e-6)
