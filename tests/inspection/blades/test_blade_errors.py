"""Blades are as uncertain as the views they are measured in: where these turn blades or move their sides, values follow."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.view_errors import ViewErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from tests.inspection.blades.test_blades import ALL_LOW, COUNT, INNER_MM, SECTIONS, dimension, measured, wheel

SHIFT_MM, TURN_RAD = 0.03, 3e-4
# Trials give the scatter, which no value here depends on.
SETTINGS = InspectionSettings(blade_points=1000).model_copy(update={"blade_trials": 2})
ASKED = (dimension("pitch", "low.1", "low.2", nominal=90), dimension("stagger", "low.1"))


def in_views() -> MeasuredPoints:
    """Two neighbouring blades of a wheel, each seen by a view of its own, which errs by itself."""
    plain = wheel(count=1000, places=ALL_LOW[:2])
    blade = np.round(np.arctan2(plain.points_mm[:, 1], plain.points_mm[:, 0]) / (2 * np.pi) * COUNT - 0.15).astype(int) % COUNT
    turn = 2 * np.pi / COUNT * blade
    back = np.column_stack([np.cos(turn), np.sin(turn)])
    radial = np.einsum("nd,nd->n", back, plain.points_mm[:, :2]) - INNER_MM
    side = np.einsum("nd,nd->n", np.column_stack([-back[:, 1], back[:, 0]]), plain.points_mm[:, :2])
    above = np.sign(side - np.tan(np.radians(20.5)) * radial - 3.0)  # of the mean line, which rises by 6 mm, at most places
    leaning = turn + np.radians(20.5) + np.pi / 2
    normals = above[:, None] * np.column_stack([np.cos(leaning), np.sin(leaning), np.zeros(len(turn))])
    centres = np.array([plain.points_mm[blade == number].mean(axis=0) for number in range(2)])
    poses = (RigidTransform.identity("part", "camera"),) * 2
    motions = np.diag(2 * ([SHIFT_MM] * 3 + [TURN_RAD] * 3))
    return MeasuredPoints(plain.points_mm, normals, None, blade, ViewErrors(poses, centres, motions, np.zeros((12, 0))))


def moved(points: MeasuredPoints, number: int) -> MeasuredPoints:
    """Move the views by one of their errors."""
    assert points.errors is not None and points.view is not None
    ways = (np.tile(way, (len(points), 1)) for way in np.eye(3))
    away = np.column_stack([points.errors.along(points.points_mm, way, points.view)["stitching"][:, number] for way in ways])
    return replace(points, points_mm=points.points_mm + away)


def test_angles_of_blades_change_with_view_errors_as_predicted() -> None:
    points, section = in_views(), SECTIONS[:1]
    found = measured(points, section, *ASKED, settings=SETTINGS)
    said = [one.budget["stitching"] / 2 for one in found]
    changes = [  # by every error of the views of both blades
        np.subtract(
            [one.measured for one in measured(moved(points, number), section, *ASKED, settings=SETTINGS)], [one.measured for one in found]
        )
        for number in range(12)
    ]
    assert np.linalg.norm(changes, axis=0) == pytest.approx(said, rel=0.2)  # normals are those of the chord, not of each place


def test_without_normals_what_views_do_to_a_blade_is_assumed_and_said() -> None:
    (thick,) = measured(replace(in_views(), normals=None), SECTIONS[:1], dimension("max_thickness", "low.1"), settings=SETTINGS)
    assert thick.budget["stitching"] > 0 and "assumed: position of each view" in thick.traceability
