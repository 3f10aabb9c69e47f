"""Standard Denavit-Hartenberg parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel, homogeneous
from measureapp.geometry.transform import rotation_about

X, Z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True)
class DhRow:
    """One joint in the standard convention [1]_: ``Rot z(θ + q) · Trans z(d) · Trans x(a) · Rot x(α)``.

    References
    ----------
    .. [1] J. Denavit, R. S. Hartenberg, J. Applied Mechanics 22, 215-221, 1955.
    """

    theta_rad: float  # offset added to the joint angle
    d_mm: float
    a_mm: float
    alpha_rad: float

    def after_rotation(self) -> FloatArray:
        """Return what follows the rotation of the joint: the next frame in that of the link, (4, 4)."""
        return homogeneous(rotation_about(X, self.alpha_rad), (self.a_mm, 0.0, self.d_mm))


def arm_from_dh(name: str, rows: Sequence[DhRow], limits_rad: npt.ArrayLike, speeds_rad_s: npt.ArrayLike) -> ArmModel:
    """Build an arm from six rows; the flange is the frame after the last one, the axis of each joint is z of its frame.

    Parameters
    ----------
    rows : six rows, from the base to the flange
    limits_rad : (6, 2)
    speeds_rad_s : (6,)

    Raises
    ------
    InputError
        Naming the joint whose numbers are impossible.
    """
    offsets = [homogeneous(rotation_about(Z, row.theta_rad)) for row in rows]
    links = [row.after_rotation() for row in rows]
    frames = [offsets[0], *(before @ offset for before, offset in zip(links[:-1], offsets[1:], strict=True))]
    return ArmModel(name, np.array(frames), np.tile(Z, (JOINTS, 1)), links[-1], np.asarray(limits_rad), np.asarray(speeds_rad_s))
