"""Files of six-axis arms: TOML with Denavit-Hartenberg rows, URDF, or the name of one shipped with the program."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np
from pydantic import Field, ValidationError

from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError
from measureapp.geometry.kinematics.arm import ArmModel
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


class RobotFile(Model):
    """A six-axis arm; the flange is the frame after the last row, z out of the flange."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1)
    joints: tuple[JointRow, ...] = Field(min_length=6, max_length=6)

    def model(self) -> ArmModel:
        """Return the arm; raises InputError when limits are impossible."""
        limits_deg = [joint.limits_deg for joint in self.joints]
        speeds_deg_s = [joint.speed_deg_s for joint in self.joints]
        return arm_from_dh(self.name, [joint.row() for joint in self.joints], np.deg2rad(limits_deg), np.deg2rad(speeds_deg_s))


def read_robot(name_or_path: str | Path) -> ArmModel:
    """Read the arm of this name in `resources/robots`, a TOML file, or a URDF with a link `tool0`.

    Raises
    ------
    InputError
        Naming the file and the invalid field.
    """
    path = Path(name_or_path)
    if not path.suffix:
        path = _named(path.name)
    if path.suffix.lower() in (".urdf", ".xml"):
        return read_urdf(path)
    document = read_toml(path, "Name the file of an arm (TOML or URDF).")
    try:
        return RobotFile.model_validate(document).model()
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the robot')}.", "Correct this field.") from error
    except InputError as error:
        raise InputError(f"{path}: {error.message}", error.hint) from error


def _named(name: str) -> Path:
    known = {path.stem: path for path in sorted(resource("robots").glob("*.toml"))}
    if name not in known:
        raise InputError(f"There is no robot {name!r}.", f"Give the file of an arm (TOML or URDF), or one of: {', '.join(known)}.")
    return known[name]
