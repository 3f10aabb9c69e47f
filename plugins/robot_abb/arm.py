"""Kinematics of an arm with a spherical wrist: pose of the flange for joint angles, and back to the joint angles nearest to the present ones."""

from __future__ import annotations

import tomllib
from itertools import product
from pathlib import Path

import numpy as np
from pydantic import Field, ValidationError

from measureapp.arrays import FloatArray
from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError, LimitError
from measureapp.geometry.transform import RigidTransform, rotation_about

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
FLANGE_FROM_WRIST = rotation_about(Y, -np.pi / 2)  # x of the last joint is z of the flange
SIGNS = (1.0, -1.0)
NEAR_AXIS_1_MM = 5.0
NEAR_STRAIGHT_DEG = 0.5  # of wrist and elbow
NOTHING_MOVED = "Choose another pose; nothing was moved."
Pair = tuple[float, float]


class ArmDescription(Model):
    """Lengths, limits and speeds of an arm; axes 1 z, 2 y, 3 y, 4 x, 5 y, 6 x with all joints at zero."""

    name: str
    shoulder_height_mm: float = Field(gt=0)
    upper_arm_mm: float = Field(gt=0)
    elbow_offset_mm: float
    forearm_mm: float = Field(gt=0)
    wrist_to_flange_mm: float = Field(ge=0)
    limits_deg: tuple[Pair, Pair, Pair, Pair, Pair, Pair]
    speeds_deg_per_s: tuple[float, float, float, float, float, float]


class Arm:
    """An arm. Angles are degrees, as the controller has them.

    Parameters
    ----------
    margin_deg : distance that every joint keeps from its limits
    """

    def __init__(self, description: ArmDescription, margin_deg: float) -> None:
        self.description = description
        self.speeds_deg_per_s = np.array(description.speeds_deg_per_s)
        self._limits_deg = np.array(description.limits_deg) + np.array([margin_deg, -margin_deg])
        self._forearm_mm = float(np.hypot(description.elbow_offset_mm, description.forearm_mm))  # from elbow to wrist
        self._bend_rad = float(np.arctan2(description.elbow_offset_mm, description.forearm_mm))

    @classmethod
    def read(cls, name_or_path: str, margin_deg: float) -> Arm:
        """Read the arm of this name from the plugin's folder `arms`, or a TOML file.

        Raises
        ------
        InputError
            Naming the file and the invalid field.
        """
        path = Path(name_or_path)
        if not path.suffix:
            path = Path(__file__).parent / "arms" / f"{path.name}.toml"
        try:
            return cls(ArmDescription.model_validate(tomllib.loads(path.read_text(encoding="utf-8"))), margin_deg)
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise InputError(
                f"The kinematic model {path} cannot be read: {error}.", "Name a model in the driver's folder, or a file."
            ) from error
        except ValidationError as error:
            raise InputError(f"{path}: {first_problem(error, 'the kinematic model')}.", "Correct this field.") from error

    def pose(self, joints_deg: FloatArray) -> RigidTransform:
        """Return base_from_flange for joint angles (6,)."""
        arm = self.description
        q1, q2, q3, q4, q5, q6 = np.deg2rad(joints_deg)
        shoulder = rotation_about(Z, q1) @ rotation_about(Y, q2)
        elbow = shoulder @ rotation_about(Y, q3)
        last = elbow @ rotation_about(X, q4) @ rotation_about(Y, q5) @ rotation_about(X, q6)
        position = arm.shoulder_height_mm * np.array(Z) + shoulder @ [0.0, 0.0, arm.upper_arm_mm]
        position = position + elbow @ [arm.forearm_mm, 0.0, arm.elbow_offset_mm] + last @ [arm.wrist_to_flange_mm, 0.0, 0.0]
        return RigidTransform.from_parts(last @ FLANGE_FROM_WRIST.T, position, "base", "flange")

    def joints_for(self, base_from_flange: RigidTransform, present_deg: FloatArray) -> FloatArray:
        """Return the joint angles (6,) for a pose that are reached first from the present ones.

        Raises
        ------
        LimitError
            Out of reach, at a singularity, or beyond a joint's limit in every configuration; names the nearest one.
        """
        found = [self._nearest_turns(joints, present_deg) for joints in self._configurations(base_from_flange, present_deg)]
        inside = [joints for joints in found if self._outside(joints) is None]
        if not inside:
            joints = min(found, key=self._excess)
            axis = self._outside(joints)
            assert axis is not None
            low, high = self._limits_deg[axis]
            raise LimitError(
                f"{self.description.name}: the pose needs joint {axis + 1} at {joints[axis]:.1f}°, outside {low:g}…{high:g}°.",
                NOTHING_MOVED,
            )
        return min(inside, key=lambda one: float(np.max(np.abs(one - present_deg) / self.speeds_deg_per_s)))

    def _configurations(self, goal: RigidTransform, present_deg: FloatArray) -> list[FloatArray]:
        """Return the angles of the eight configurations without those at a singularity of the wrist; closed form for a spherical wrist."""
        arm = self.description
        last = goal.rotation @ FLANGE_FROM_WRIST
        wrist = goal.translation_mm - last @ [arm.wrist_to_flange_mm, 0.0, 0.0]
        out, up = float(np.hypot(wrist[0], wrist[1])), float(wrist[2]) - arm.shoulder_height_mm
        cosine = (out**2 + up**2 - arm.upper_arm_mm**2 - self._forearm_mm**2) / (2.0 * arm.upper_arm_mm * self._forearm_mm)
        if abs(cosine) > np.cos(np.deg2rad(NEAR_STRAIGHT_DEG)):
            reach = float(np.hypot(out, up))
            raise LimitError(
                f"{arm.name}: the wrist would be {reach:.0f} mm from the shoulder; the arm reaches "
                f"{abs(arm.upper_arm_mm - self._forearm_mm):.0f}…{arm.upper_arm_mm + self._forearm_mm:.0f} mm.",
                NOTHING_MOVED,
            )
        if out < NEAR_AXIS_1_MM:
            raise LimitError(f"{arm.name}: the wrist would be {out:.1f} mm from axis 1, where joint 1 is not determined.", NOTHING_MOVED)
        found, singular = [], None
        for side, elbow, flip in product(SIGNS, SIGNS, SIGNS):
            q1 = np.arctan2(side * wrist[1], side * wrist[0])
            angle = elbow * np.arccos(cosine)
            q3 = angle + self._bend_rad - np.pi / 2
            q2 = np.arctan2(side * out, up) - np.arctan2(
                self._forearm_mm * np.sin(angle), arm.upper_arm_mm + self._forearm_mm * np.cos(angle)
            )
            remaining = (rotation_about(Z, q1) @ rotation_about(Y, q2 + q3)).T @ last
            try:
                found.append(np.rad2deg([q1, q2, q3, *self._wrist(remaining, flip, float(np.deg2rad(present_deg[3])))]))
            except LimitError as error:
                singular = error
        if singular is not None and not found:
            raise singular
        return found

    def _wrist(self, remaining: FloatArray, flip: float, present_q4: float) -> tuple[float, float, float]:
        """Return joints 4, 5 and 6 for the rotation that is left to them, Rx·Ry·Rx."""
        q5 = float(flip * np.arctan2(np.hypot(remaining[0, 1], remaining[0, 2]), remaining[0, 0]))
        if abs(np.sin(q5)) < np.sin(np.deg2rad(NEAR_STRAIGHT_DEG)):
            raise LimitError(
                f"{self.description.name}: the pose has joint 5 at {np.rad2deg(q5):.2f}°, a singularity of the wrist "
                f"(axes 4 and 6 in line; joint 4 is now at {np.rad2deg(present_q4):.1f}°).",
                "Tilt the pose by a degree or more; nothing was moved.",
            )
        q4 = float(np.arctan2(flip * remaining[1, 0], -flip * remaining[2, 0]))
        q6 = float(np.arctan2(flip * remaining[0, 1], flip * remaining[0, 2]))
        return q4, q5, q6

    def _nearest_turns(self, joints_deg: FloatArray, present_deg: FloatArray) -> FloatArray:
        """Return the same angles, each turned by whole turns: inside its limits if possible, there nearest to the present angle."""
        turned = joints_deg[:, None] + np.array([-720.0, -360.0, 0.0, 360.0, 720.0])
        low, high = self._limits_deg.T[:, :, None]
        beyond = np.maximum(np.maximum(low - turned, turned - high), 0.0)
        best = np.argmin(beyond * 1e3 + np.abs(turned - present_deg[:, None]), axis=1)
        return turned[np.arange(len(joints_deg)), best]

    def _excess(self, joints_deg: FloatArray) -> float:
        low, high = self._limits_deg.T
        return float(np.max(np.maximum(low - joints_deg, joints_deg - high)))

    def _outside(self, joints_deg: FloatArray) -> int | None:
        """Return the axis farthest outside its limits; None if all are inside."""
        low, high = self._limits_deg.T
        excess = np.maximum(low - joints_deg, joints_deg - high)
        return int(np.argmax(excess)) if float(np.max(excess)) > 0.0 else None
