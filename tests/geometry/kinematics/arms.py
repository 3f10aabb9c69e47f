"""Arms the tests solve: the IRB 1200, arms of any lengths, and ones whose wrist is not spherical."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.dh import DhRow, arm_from_dh

LIMITS_DEG = [(-170, 170), (-100, 135), (-200, 70), (-270, 270), (-130, 130), (-360, 360)]
SPEEDS_DEG_S = [288, 240, 300, 400, 405, 600]
IRB_DEG_MM = [(0, 399.1, 0, -90), (-90, 0, 350, 0), (0, 0, 42, -90), (0, 351, 0, 90), (0, 0, 0, -90), (180, 82, 0, 0)]


def arm(rows_deg_mm: list[tuple[float, ...]], limits_deg: list[tuple[float, float]] = LIMITS_DEG, name: str = "test arm") -> ArmModel:
    """Return an arm of rows (θ in °, d, a in mm, α in °)."""
    rows = [DhRow(float(np.deg2rad(theta)), d, a, float(np.deg2rad(alpha))) for theta, d, a, alpha in rows_deg_mm]
    return arm_from_dh(name, rows, np.deg2rad(limits_deg), np.deg2rad(SPEEDS_DEG_S))


def irb1200() -> ArmModel:
    return arm(IRB_DEG_MM, name="ABB IRB 1200-7/0.7")


def offset_wrist() -> ArmModel:
    """The IRB 1200 with axis 6 60 mm beside axis 5: no spherical wrist."""
    return arm([*IRB_DEG_MM[:4], (0, 0, 60, -90), IRB_DEG_MM[5]], name="offset wrist")


def random_joints(model: ArmModel, count: int, seed: int) -> FloatArray:
    return np.random.default_rng(seed).uniform(model.limits_rad[:, 0], model.limits_rad[:, 1], (count, 6))


lengths_mm, offsets_mm, right_angles = st.floats(100, 1500), st.floats(-200, 200), st.sampled_from([-90.0, 90.0])


@st.composite
def ortho_parallel_arms(draw: st.DrawFn) -> ArmModel:
    """Arms with any lengths, offsets (also beside axis 1), joint zeros and senses of axes 1, 3 and 5."""
    second, third, fifth = draw(right_angles), draw(st.sampled_from([0.0, 180.0])), draw(right_angles)
    zeros = [draw(st.floats(-180, 180)) for _ in range(6)]
    rows = [
        (zeros[0], draw(offsets_mm), draw(offsets_mm), second),
        (zeros[1], draw(offsets_mm), draw(lengths_mm), third),
        (zeros[2], draw(offsets_mm), draw(offsets_mm), draw(right_angles)),
        (zeros[3], draw(lengths_mm), 0.0, fifth),
        (zeros[4], 0.0, 0.0, draw(right_angles)),
        (zeros[5], draw(offsets_mm), draw(offsets_mm), draw(st.floats(-180, 180))),
    ]
    return arm(rows)
