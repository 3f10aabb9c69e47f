"""Forward kinematics: published numbers, links, vectors of poses, impossible models."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from measureapp.errors import InputError
from measureapp.geometry.kinematics.jacobian import inverse_condition, jacobian
from tests.geometry.kinematics.arms import IRB_DEG_MM, LIMITS_DEG, arm, irb1200, random_joints

CHECKS = [  # joints in °, flange in mm, quaternion w x y z
    ((0, 0, 0, 0, 0, 0), (433.0, 0, 791.1), (0.707107, 0, 0.707107, 0)),
    ((0, 0, 0, 0, 30, 0), (422.014083, 0, 750.1), (0.5, 0, 0.866025, 0)),
    ((30, 20, -10, 40, 50, 60), (426.870850, 293.077480, 651.862552), (0.047210, -0.374542, -0.839334, -0.391161)),
    ((-45, 45, 30, -120, -70, 200), (293.928233, -199.555768, 281.356165), (0.317295, -0.723646, -0.449802, -0.416339)),
]


@pytest.mark.parametrize(("joints_deg", "position_mm", "quaternion_wxyz"), CHECKS)
def test_the_irb_1200_reaches_the_published_poses(joints_deg, position_mm, quaternion_wxyz):
    base_from_flange = irb1200().forward(np.deg2rad(joints_deg))
    assert np.abs(base_from_flange.translation_mm - position_mm).max() < 1e-6
    assert abs(base_from_flange.quaternion_wxyz @ quaternion_wxyz) == pytest.approx(1.0, abs=2e-6)  # given to six digits


def test_many_poses_at_once_are_the_poses_one_by_one():
    model = irb1200()
    joints_rad = random_joints(model, 50, seed=1)
    single = [model.forward(one).matrix for one in joints_rad]
    assert np.abs(model.forward_matrices(joints_rad) - single).max() < 1e-12
    assert model.link_frames(joints_rad.reshape(5, 10, 6)).shape == (5, 10, 6, 4, 4)


def test_forward_kinematics_of_many_poses_is_fast():
    """A tenth of what one processor does alone, since others may keep it busy."""
    model = irb1200()
    joints_rad = random_joints(model, 20_000, seed=2)
    times_s = []
    for _ in range(5):
        start = time.perf_counter()
        model.forward_matrices(joints_rad)
        times_s.append(time.perf_counter() - start)
    assert len(joints_rad) / min(times_s) > 40_000


def test_each_link_has_its_origin_on_its_joint_and_is_moved_by_the_joints_before_it_only():
    model = irb1200()
    before, after = model.link_frames(np.zeros(6)), model.link_frames([0, 0, 0.3, 0, 0, 0])
    assert np.allclose(before[:, :3, 3], [[0, 0, 0], [0, 0, 399.1], [0, 0, 749.1], [0, 0, 791.1], [351, 0, 791.1], [351, 0, 791.1]])
    assert np.allclose(after[:2], before[:2])
    assert np.allclose(after[2, :3, 3], before[2, :3, 3])
    assert not np.allclose(after[3, :3, 3], before[3, :3, 3])


def test_the_jacobian_is_the_derivative_of_the_pose():
    model, step = irb1200(), 1e-6
    joints_rad = random_joints(model, 20, seed=3)
    rates = jacobian(model, joints_rad)
    for joint, nudge in enumerate(step * np.eye(6)):
        later, earlier = model.forward_matrices(joints_rad + nudge), model.forward_matrices(joints_rad - nudge)
        change = (later - earlier) / (2 * step)
        spin = change[:, :3, :3] @ model.forward_matrices(joints_rad)[:, :3, :3].swapaxes(1, 2)
        numerical = np.hstack([change[:, :3, 3], spin[:, [2, 0, 1], [1, 2, 0]]])
        assert np.abs(rates[:, :, joint] - numerical).max() < 1e-5  # rounding of 1e-13 · 1000 mm over the step


@pytest.mark.parametrize("singular_deg", [(10, 20, -10, 40, 0, 60), (10, 20, -83.17600, 40, 50, 60)], ids=["wrist", "elbow"])
def test_the_condition_is_zero_at_a_singularity_only(singular_deg):
    model = irb1200()
    assert inverse_condition(model, np.deg2rad([10, 20, -10, 40, 50, 60])) > 0.05
    assert inverse_condition(model, np.deg2rad(singular_deg)) < 1e-4


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"axes": np.zeros((6, 3))}, "Joint 1 of ABB IRB 1200-7/0.7 has an axis that is not a unit vector"),
        ({"speeds_rad_s": [1, 1, 0, 1, 1, 1]}, "Joint 3 .* no positive speed"),
        ({"parent_from_joint": np.full((6, 4, 4), np.nan)}, "Joint 1 .* no rigid transform"),
        ({"last_from_flange": np.diag([1.0, 1.0, -1.0, 1.0])}, "The flange .* no rigid transform"),
    ],
)
def test_an_impossible_model_is_refused_by_its_joint(change: dict[str, Any], message: str):
    model = irb1200()
    values = {
        name: getattr(model, name) for name in ("name", "parent_from_joint", "axes", "last_from_flange", "limits_rad", "speeds_rad_s")
    }
    with pytest.raises(InputError, match=message):
        type(model)(**values | change)


@pytest.mark.parametrize("limit", [(10, 10), (10, -10), (float("nan"), 10), (-10, float("inf"))])
def test_limits_that_enclose_nothing_are_refused(limit):
    with pytest.raises(InputError, match=r"Joint 4 .* no lower limit below its upper limit"):
        arm(IRB_DEG_MM, [*LIMITS_DEG[:3], limit, *LIMITS_DEG[4:]])


def test_limits_of_endless_turns_are_refused_before_their_solutions_are_counted():
    with pytest.raises(InputError, match="equivalent positions") as refused:
        arm(IRB_DEG_MM, [(-3600, 3600)] * 6)
    assert "Narrow the limits" in refused.value.hint


def test_a_model_cannot_be_changed():
    model = irb1200()
    with pytest.raises(ValueError, match="read-only"):
        model.limits_rad[0, 0] = -10.0
    with pytest.raises(AttributeError):
        replace(model).name = "other"
