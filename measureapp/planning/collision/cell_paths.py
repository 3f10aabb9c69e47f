"""Free ways for a session: from where the axes really are, checked before each move."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import AxisReadback
from measureapp.data.leg import Leg
from measureapp.data.plan import Viewpoint
from measureapp.errors import LimitError, PlanError
from measureapp.geometry.kinematics.choice import by_preference
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.cell import REST_RAD, Cell
from measureapp.planning.collision.motion import Placement
from measureapp.planning.collision.routes import find_route

MODEL_HINT = "Name the model of this arm in the rig description (model_file), and check tool0 in the controller; nothing was moved."
MODEL_MM = 1.0  # largest difference of a pose read back and that of the joints


class CellPaths:
    """Ways in one cell; keeps the joint angles of robots that do not tell them."""

    def __init__(self, cell: Cell) -> None:
        self.cell = cell
        self._joints_rad = REST_RAD

    def legs_to(self, viewpoint: Viewpoint, here: AxisReadback, joints_rad: FloatArray | None) -> tuple[Leg, ...]:
        """Return the moves to a viewpoint; see `measureapp.devices.paths.Paths`."""
        route = find_route(self.cell, self.placement(here, joints_rad), viewpoint)
        if route.end.joints_rad is not None:
            self._joints_rad = route.end.joints_rad
        return tuple(Leg(leg.axis, _readback(leg.goal), leg.goal.joints_rad) for leg in route.legs)

    def placement(self, here: AxisReadback, joints_rad: FloatArray | None) -> Placement:
        """Return where the axes are; of a robot that does not tell its joints, those nearest to where it was sent last.

        Raises
        ------
        LimitError
            The kinematic model does not have this pose.
        """
        return placement_of(self.cell, here, joints_rad, self._joints_rad)


def placement_of(cell: Cell, here: AxisReadback, joints_rad: FloatArray | None, before_rad: FloatArray = REST_RAD) -> Placement:
    """Return where the axes are, as `CellPaths.placement`; ``before_rad`` (6,) are joint angles before."""
    pose = here.base_from_flange
    if cell.arm is None:
        return Placement(pose.matrix, None, here.guide_mm, here.table_rad)
    if joints_rad is None:
        try:
            joints_rad = by_preference(cell.arm, pose, before_rad)[0].joints_rad
        except LimitError as error:
            raise LimitError(
                f"The kinematic model does not have the pose read back, so collisions cannot be checked. {error.message}", MODEL_HINT
            ) from error
    off_mm = float(np.linalg.norm(cell.arm.forward(joints_rad).translation_mm - pose.translation_mm))
    if not off_mm <= MODEL_MM:
        raise LimitError(
            f"The pose read back is {off_mm:.1f} mm off the one of {cell.arm.name} for the same joints: collisions cannot be checked.",
            MODEL_HINT,
        )
    return Placement(pose.matrix, joints_rad, here.guide_mm, here.table_rad)


def check_step(cell: Cell, start: AxisReadback, goal: AxisReadback, joints_rad: FloatArray | None) -> None:
    """Refuse a step by hand that brings bodies too close to each other; those that are already may move apart.

    Raises
    ------
    PlanError
        Naming them.
    """
    try:
        here = placement_of(cell, start, joints_rad)
        there = placement_of(cell, goal, None, here.joints_from(REST_RAD))
    except LimitError:  # the model of the arm does not have these poses, so that its driver refuses them; the head can be checked
        cell = Cell.of(cell.rig, None)
        here, there = placement_of(cell, start, None), placement_of(cell, goal, None)
    if met := cell.encounter_between(here, there, leaving=True):
        raise PlanError(f"At this step {met.words()}.", "Move another way; nothing was moved.")


def _readback(placement: Placement) -> AxisReadback:
    return AxisReadback(RigidTransform(placement.base_from_flange, "base", "flange"), placement.guide_mm, placement.table_rad)
