"""Singularities: which one is near, and how near."""

from __future__ import annotations

import re

import numpy as np
import pytest

from measureapp.geometry.kinematics.choice import by_preference
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.kinematics.jacobian import inverse_condition
from measureapp.geometry.kinematics.singularity import GOAL_MARGINS, SingularityMargins, singularity_near
from tests.geometry.kinematics.arms import irb1200, offset_wrist, random_joints

NO_MARGINS = SingularityMargins(0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("joints_deg", "words"),
    [
        ((10, 20, -10, 40, 3, 60), r"^joint 5 at 3\.00°, a singularity of the wrist"),
        ((10, 20, -81.176, 40, 50, 60), r"^the elbow 2\.00° from the straight arm"),
        ((10, -34, -16, 40, 50, 60), r"mm from axis 1, where joint 1 is not determined"),
        ((30, 20, -10, 40, 50, 60), r"^$"),
    ],
    ids=["wrist", "elbow", "shoulder", "none"],
)
def test_the_singularity_that_is_near_is_named_with_its_distance(joints_deg: tuple[float, ...], words: str) -> None:
    model, joints_rad = irb1200(), np.deg2rad(joints_deg)
    solution = by_preference(model, model.forward(joints_rad), joints_rad)[0]
    assert np.abs(solution.joints_rad - joints_rad).max() < 1e-6
    assert re.search(words, singularity_near(solution))
    assert singularity_near(solution, NO_MARGINS) == ""


def test_solutions_carry_the_condition_of_their_jacobian() -> None:
    model = irb1200()
    for joints_rad in random_joints(model, 20, seed=8):
        for solution in inverse(model, model.forward(joints_rad)):
            assert solution.condition == pytest.approx(float(inverse_condition(model, solution.joints_rad)), rel=1e-6, abs=1e-9)


def test_an_arm_without_a_spherical_wrist_is_judged_by_this_condition() -> None:
    model = offset_wrist()
    solutions = inverse(model, model.forward(np.deg2rad([10, 20, -10, 40, 50, 60])))
    worst = min(solutions, key=lambda one: one.condition)
    above = SingularityMargins(0.0, 0.0, 0.0, worst.condition + 1e-6)
    assert "a singularity (condition" in singularity_near(worst, above)
    assert singularity_near(max(solutions, key=lambda one: one.condition), GOAL_MARGINS) == ""
