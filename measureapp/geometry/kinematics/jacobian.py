"""Geometric Jacobian of an arm and the measure of its singularity."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import ArmModel

LENGTH_MM = 500.0  # about the distance between flange and working point of a measuring head


def jacobian(model: ArmModel, joints_rad: npt.ArrayLike) -> FloatArray:
    """Return the geometric Jacobian of the flange in the base frame, (..., 6, 6), for joint angles (..., 6).

    Rows 0…2: velocity of the flange's origin in mm/rad; rows 3…5: angular velocity; one column per joint.
    """
    links = model.link_frames(joints_rad)
    axes = np.einsum("...jab,jb->...ja", links[..., :3, :3], model.axes)
    flange_mm = (links[..., -1, :, :] @ model.last_from_flange)[..., :3, 3]
    levers_mm = flange_mm[..., None, :] - links[..., :3, 3]
    return np.concatenate([np.cross(axes, levers_mm), axes], axis=-1).swapaxes(-1, -2)


def inverse_condition(model: ArmModel, joints_rad: npt.ArrayLike, length_mm: float = LENGTH_MM) -> FloatArray:
    """Return the smallest over the largest singular value of the Jacobian: 0 at a singularity, at most 1.

    Parameters
    ----------
    joints_rad : (..., 6)
    length_mm : translation that counts as much as a rotation by 1 rad

    Returns
    -------
    (...) float
    """
    scale = np.repeat([1.0 / length_mm, 1.0], 3)[:, None]
    values = np.linalg.svd(jacobian(model, joints_rad) * scale, compute_uv=False)
    return values[..., -1] / values[..., 0]
