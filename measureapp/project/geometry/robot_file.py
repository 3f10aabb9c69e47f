"""Files of six-axis arms: TOML with Denavit-Hartenberg rows, URDF, or the name of one shipped with the program."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Literal

import numpy as np
from pydantic import Field, ValidationError, model_validator

from measureapp.data.model import Model, first_problem
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.geometry.kinematics.arm import ArmModel, LinkBody, Point
from measureapp.geometry.kinematics.dh import DhRow, arm_from_dh
from measureapp.project.geometry.urdf import read_urdf
from measureapp.project.text_document import read_toml
from measureapp.resources import resource

LONGEST_MM = 1e5
LARGEST_DEG = 1e5


class JointRow(Model):
    """One joint: a standard Denavit-Hartenberg row, its limits and its largest speed."""

    theta_offset_deg: float = Field(ge=-LARGEST_DEG, le=LARGEST_DEG, description="added to the angle that the controller shows")
    d_mm: float = Field(ge=-LONGEST_MM, le=LONGEST_MM)
    a_mm: float = Field(ge=-LONGEST_MM, le=LONGEST_MM)
    alpha_deg: float = Field(ge=-LARGEST_DEG, le=LARGEST_DEG)
    limits_deg: tuple[float, float]
    speed_deg_s: float = Field(gt=0)

    def row(self) -> DhRow:
        """Return the parameters in radians."""
        return DhRow(float(np.deg2rad(self.theta_offset_deg)), self.d_mm, self.a_mm, float(np.deg2rad(self.alpha_deg)))


class BodyRow(Model):
    """A box or a capsule around a part of a link, in the base frame while all joints are at 0."""

    link: int = Field(ge=0, le=6, description="0: the base, 6: the flange")
    ends_mm: tuple[Point, Point] = Field(
        description="opposite corners of a box, lower one first; with a radius, ends of the axis of a capsule"
    )
    radius_mm: float = Field(default=0.0, ge=0, le=LONGEST_MM, description="of a capsule; 0: a box")
    margin_mm: float = Field(default=10.0, ge=0, le=LONGEST_MM, description="added all around: hoses, covers, tolerances")

    @model_validator(mode="after")
    def _has_a_volume(self) -> BodyRow:
        if self.radius_mm == 0.0 and any(low >= high for low, high in zip(*self.ends_mm, strict=True)):
            raise ValueError("the first corner of a box must be below the second one in x, y and z")
        return self

    def body(self) -> LinkBody:
        """Return the body as the arm model holds it."""
        return LinkBody(self.link, self.ends_mm, self.radius_mm, self.margin_mm)


class RobotFile(Model):
    """A six-axis arm; the flange is the frame after the last row, z out of the flange."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1)
    joints: tuple[JointRow, ...] = Field(min_length=6, max_length=6)
    bodies: tuple[BodyRow, ...] = Field(
        default=(), description="bodies of the links, for collision checks; none given: capsules are assumed"
    )

    def model(self) -> ArmModel:
        """Return the arm; raises InputError when limits are impossible."""
        limits_deg = [joint.limits_deg for joint in self.joints]
        speeds_deg_s = [joint.speed_deg_s for joint in self.joints]
        arm = arm_from_dh(self.name, [joint.row() for joint in self.joints], np.deg2rad(limits_deg), np.deg2rad(speeds_deg_s))
        return replace(arm, bodies=tuple(row.body() for row in self.bodies))


def read_robot(name_or_path: str | Path) -> ArmModel:
    """Read the arm of this name in `resources/robots`, a TOML file, or a URDF with a link `tool0`.

    Raises
    ------
    InputError
        Naming the file and the invalid field.
    """
    path = _path(name_or_path)
    if path.suffix.lower() in (".urdf", ".xml"):
        return read_urdf(path)
    document = read_toml(path, "Name the file of an arm (TOML or URDF).")
    try:
        return RobotFile.model_validate(document).model()
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the robot')}.", "Correct this field.") from error
    except InputError as error:
        raise InputError(f"{path}: {error.message}", error.hint) from error


def arm_of(rig: RigDescription) -> ArmModel | None:
    """Return the arm that the rig description names; None where it names none. Raises InputError as `read_robot`.

    The same file gives the same object until it is changed, so that what is calculated from an arm can be kept.
    """
    if not rig.robot.model_file:
        return None
    path = _path(rig.robot.model_file)
    return _unchanged(path, path.stat().st_mtime_ns if path.exists() else 0)


@lru_cache(maxsize=8)
def _unchanged(path: Path, _modified_ns: int) -> ArmModel:
    return read_robot(path)


def _path(name_or_path: str | Path) -> Path:
    path = Path(name_or_path)
    return path if path.suffix else _named(path.name)


def _named(name: str) -> Path:
    known = {path.stem: path for path in sorted(resource("robots").glob("*.toml"))}
    if name not in known:
        raise InputError(f"There is no robot {name!r}.", f"Give the file of an arm (TOML or URDF), or one of: {', '.join(known)}.")
    return known[name]
