"""Datum systems: the motions they fix, those they leave free, and the precedence of the primary datum."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.inspection.tolerances.datums import datum_system

A = Feature("A", "plane", np.array([10.0, 20.0, 5.0]), np.array([0.0, 0.0, 1.0]))
B = Feature("B", "plane", np.array([0.0, -40.0, 15.0]), np.array([0.0, -1.0, 0.0]))
C = Feature("C", "plane", np.array([-60.0, 0.0, 15.0]), np.array([-1.0, 0.0, 0.0]))
AXIS = Feature("axis", "cylinder", np.array([30.0, 10.0, 50.0]), np.array([0.0, 0.0, 1.0]), 20.0)
HOLE = Feature("hole", "cylinder", np.array([90.0, 10.0, 50.0]), np.array([0.0, 0.0, 1.0]), 5.0)
CONE = Feature("cone", "cone", np.array([30.0, 10.0, 50.0]), np.array([0.0, 0.0, 1.0]), 20.0, 0.3)
BALLS = [Feature(f"ball {k}", "sphere", np.array(p), None, 10.0) for k, p in enumerate(([0.0, 0, 0], [100.0, 0, 0], [0.0, 80, 0]))]


def moved(feature: Feature, rotation: np.ndarray, shift: np.ndarray) -> Feature:
    direction = None if feature.direction is None else rotation @ feature.direction
    return Feature(feature.name, feature.shape, rotation @ feature.point_mm + shift, direction, feature.radius_mm, feature.half_angle_rad)


@pytest.mark.parametrize("datums", [[A, B, C], [A, AXIS, B], [AXIS, A, HOLE], [A, AXIS, HOLE], BALLS, [A, BALLS[0], BALLS[1]]])
def test_a_whole_system_aligns_a_part_to_its_nominal(datums):
    rotation, shift = Rotation.from_rotvec([0.02, -0.03, 0.05]).as_matrix(), np.array([0.7, -1.1, 0.4])
    system = datum_system(datums, [moved(datum, rotation, shift) for datum in datums])
    assert system.free.shape[1] == 0
    corners = np.random.default_rng(0).uniform(-100, 100, (8, 3))
    assert np.allclose(system.apply(corners @ rotation.T + shift), corners, atol=1e-9)


@pytest.mark.parametrize(
    ("datums", "open_motions"), [([A], 3), ([A, B], 1), ([AXIS], 2), ([AXIS, A], 1), ([CONE], 2), ([BALLS[0]], 3), (BALLS[:2], 1)]
)
def test_a_system_knows_how_many_motions_it_leaves_open(datums, open_motions):
    assert datum_system(datums, datums).free.shape[1] == open_motions


def test_features_not_moved_by_free_motions_have_a_position():
    by_axis = datum_system([AXIS, A], [AXIS, A])
    by_axis.require_location(CONE, "cone")  # about the same axis
    with pytest.raises(InspectionError, match="do not fix the location of hole: free are"):
        by_axis.require_location(HOLE, "hole")
    by_axis.require_direction(HOLE, "hole")
    with pytest.raises(InspectionError, match="do not fix the orientation of B"):
        by_axis.require_direction(B, "B")
    with pytest.raises(InspectionError, match="translation along x"):
        datum_system([A, B], [A, B]).require_location(HOLE, "hole")


def test_the_first_datum_wins_where_they_contradict_each_other():
    """B leans by 0.01 rad: A keeps its direction, and B's middle lies in its plane."""
    leaning = moved(B, Rotation.from_rotvec([0.01, 0, 0]).as_matrix(), np.array([0.0, 0.3, 0.0]))
    system = datum_system([A, B, C], [A, leaning, C])
    assert np.allclose(system.rotate(A.direction), A.direction, atol=1e-12)
    assert system.apply(A.point_mm)[2] == pytest.approx(5.0, abs=1e-12)
    assert system.apply(leaning.point_mm)[1] == pytest.approx(-40.0, abs=1e-9)


@pytest.mark.parametrize("datums", [[A, A], [AXIS, CONE], [A, B, A]])
def test_a_datum_that_fixes_nothing_more_is_refused(datums):
    with pytest.raises(InspectionError, match="constrains nothing"):
        datum_system(datums, datums)
