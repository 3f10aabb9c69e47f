"""Moving single axes by hand: small steps, finding the reference, and a live image."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import radians
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.motion import joints_of
from measureapp.acquire.session import RigSession
from measureapp.arrays import read_only
from measureapp.data.fringe import AxisReadback
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.devices.rig import Rig
from measureapp.errors import LimitError
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.cell_paths import check_step
from measureapp.progress import Progress
from measureapp.project.geometry.robot_file import arm_of

Axis = Literal["x", "y", "z", "rx", "ry", "rz", "guide", "table"]
"""Robot: position in the base, and rotation about the base's axes through the flange; guide; table."""

LARGEST_STEP_MM, LARGEST_STEP_DEG = 50.0, 10.0
LIVE = "live"


def jog(rig: Rig, axis: Axis, step: float, progress: Progress, part: PartSolid | None = None) -> AxisReadback:
    """Move one axis by ``step`` (mm, or degrees for rotations and the table) from where it is, and return the read-back.

    While a key is held, one step follows the other; releasing it ends the motion with the step under way.

    Parameters
    ----------
    part : what stands on the table, such as `pipeline.part_on_table.part_on_table` of the open project; None: it is not known

    Raises
    ------
    LimitError
        The step is larger than one by hand may be, or its goal lies outside the limits; nothing moved.
    PlanError
        Head or arm would come too close to something, or enter a keep-out box; nothing moved.
    DeviceError, Cancelled
        As `RigSession`; everything was stopped.
    """
    turns = axis in ("rx", "ry", "rz", "table")
    largest, unit = (LARGEST_STEP_DEG, "°") if turns else (LARGEST_STEP_MM, " mm")
    if not abs(step) <= largest:
        raise LimitError(f"A step of {step:g}{unit} by hand is too large.", f"Choose at most {largest:g}{unit}.")
    with RigSession(rig, progress) as session:
        here = session.readback()
        goal = _goal(here, axis, step)
        check_step(Cell.of(rig.description, arm_of(rig.description), part), here, goal, joints_of(rig))
        if axis == "guide":
            session.move_guide(goal.guide_mm)
        elif axis == "table":
            session.move_table(goal.table_rad)
        else:
            session.move_robot(goal.base_from_flange)
        return session.readback()


def find_references(rig: Rig, progress: Progress) -> AxisReadback:
    """Let guide and table find their reference positions, one after the other, and return the read-back."""
    with RigSession(rig, progress) as session:
        session.home()
        return session.readback()


def show_live(
    rig: Rig,
    exposure_us_of: Callable[[], int],
    goes_on: Callable[[], bool],
    on_event: Callable[[AcquisitionEvent], None],
    progress: Progress,
) -> None:
    """Take images of all cameras in uniform light, one after the other while ``goes_on`` says so; nothing moves.

    ``exposure_us_of`` is asked before every image.
    """
    with RigSession(rig, progress) as session:
        while goes_on():
            exposure_us = exposure_us_of()
            for shot in session.shots((PLAIN_LIGHT,), (exposure_us,)):
                for name, frame in shot.frames.items():
                    on_event(ImageTaken(LIVE, name, exposure_us, read_only(frame.pixels)))


def _goal(here: AxisReadback, axis: Axis, step: float) -> AxisReadback:
    if axis == "guide":
        return replace(here, guide_mm=here.guide_mm + step)
    if axis == "table":
        return replace(here, table_rad=here.table_rad + radians(step))
    return replace(here, base_from_flange=_stepped(here.base_from_flange, axis, step))


def _stepped(pose: RigidTransform, axis: Axis, step: float) -> RigidTransform:
    direction = np.eye(3)["xyz".index(axis[-1])]
    if axis.startswith("r"):
        turned = Rotation.from_rotvec(radians(step) * direction).as_matrix() @ pose.rotation
        return RigidTransform.from_parts(turned, pose.translation_mm, "base", "flange")
    return RigidTransform.from_parts(pose.rotation, pose.translation_mm + step * direction, "base", "flange")
