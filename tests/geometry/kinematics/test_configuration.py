"""ABB configuration data from joint angles."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.errors import InputError
from measureapp.geometry.kinematics.configuration import abb_configuration
from measureapp.geometry.kinematics.inverse import inverse
from tests.geometry.kinematics.arms import irb1200, offset_wrist


@pytest.mark.parametrize(
    ("joints_deg", "expected"),
    [
        ((0, 0, 0, 0, 0, 0), (0, 0, 0, 0)),
        ((30, 20, -10, 40, 50, 60), (0, 0, 0, 0)),
        ((-45, 45, 30, -120, -70, 200), (-1, -2, 2, 1)),
        ((30, 93.6002, -156.3531, 32.0045, 111.7067, 101.3562), (0, 0, 1, 2)),
        ((30, 93.6002, -156.3531, -147.9955, -111.7067, -78.6438), (0, -2, -1, 3)),
        ((-150, -93.6002, -10, -144.0254, 123.0453, 109.9352), (-2, -2, 1, 4)),
        ((-150, -93.6002, -10, 35.9746, -123.0453, -70.0648), (-2, 0, -1, 5)),
        ((-150, -20, -156.3531, -145.7029, 60.9098, 69.9943), (-2, -2, 0, 6)),
        ((-150, -20, -156.3531, 34.2971, -60.9098, -110.0057), (-2, 0, -2, 7)),
    ],
)
def test_quadrants_and_branch_are_those_of_the_joints(joints_deg, expected):
    assert abb_configuration(irb1200(), np.deg2rad(joints_deg)) == expected


def test_rounding_does_not_change_a_quadrant():
    assert abb_configuration(irb1200(), [-1e-16, 0, 0, np.pi / 2 - 1e-12, -1e-16, -1e-15]) == (0, 1, 0, 0)


def test_configuration_data_distinguish_all_solutions_of_a_pose():
    model = irb1200()
    solutions = inverse(model, model.forward(np.deg2rad([30, 20, -10, 40, 50, 60])))
    assert len({abb_configuration(model, one.joints_rad) for one in solutions}) == len(solutions)


def test_an_arm_without_a_spherical_wrist_has_none():
    with pytest.raises(InputError, match="no spherical wrist"):
        abb_configuration(offset_wrist(), np.zeros(6))
