"""Configuration data of ABB controllers, which choose one of the solutions for a pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from measureapp.errors import InputError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.ortho_parallel import ortho_parallel
from measureapp.geometry.kinematics.posture import posture_of

QUADRANT_RAD = float(np.pi) / 2.0
ROUNDING = 1e-9  # of a quadrant: an angle of -1e-16 is in quadrant 0, not -1


class AbbConfiguration(NamedTuple):
    """The four numbers of RAPID's `confdata`: quadrants of joints 1, 4 and 6, and the branch."""

    cf1: int
    cf4: int
    cf6: int
    cfx: int


def abb_configuration(model: ArmModel, joints_rad: npt.ArrayLike) -> AbbConfiguration:
    """Return the configuration data for joint angles (6,).

    A quadrant is the angle over 90°, rounded down. `cfx` adds 4 if the wrist centre is behind axis 1, 2 if it is behind the lower arm (the one
    from axis 2 to axis 3), and 1 if joint 5 is negative.

    Raises
    ------
    InputError
        The arm has no spherical wrist, for which these numbers are defined.
    """
    arm = ortho_parallel(model)
    if arm is None:
        raise InputError(f"{model.name} has no spherical wrist, so its poses have no configuration data.", "Move it by joint angles.")
    joints = np.asarray(joints_rad, float)
    cf1, cf4, cf6 = (int(quadrant) for quadrant in np.floor(joints[[0, 3, 5]] / QUADRANT_RAD + ROUNDING))
    posture = posture_of(arm, joints)
    return AbbConfiguration(cf1, cf4, cf6, 4 * posture.is_behind + 2 * posture.is_folded_back + posture.is_flipped)
