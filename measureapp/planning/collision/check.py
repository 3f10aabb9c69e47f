"""Collisions of a whole plan: at its viewpoints, and on the moves between them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError, PlanError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.motion import Placement
from measureapp.planning.collision.routes import NoRoute, Route, find_route, start_of
from measureapp.progress import NoProgress, Progress

SHOWN = 5
NO_ARM = "The rig names no kinematic model of its robot: only the head was checked for collisions, on straight ways, not the robot's arm."
NO_SHAPE = "The kinematic model states no bodies of the links: thick capsules along them were checked for collisions instead."
NO_PART = "The part is not known: it was not checked for collisions."


@dataclass(frozen=True, slots=True, eq=False)
class Move:
    """The move from one viewpoint of a plan, or from where the scan begins, to the next."""

    start_id: str  # empty: where the scan begins
    end_id: str
    route: Route | None  # None: there is no free one
    problem: str  # a sentence; empty if there is none


@dataclass(frozen=True, slots=True, eq=False)
class CollisionReport:
    """What was found for a plan."""

    at: dict[str, str]  # id of a viewpoint -> what would touch there
    moves: tuple[Move, ...]  # between viewpoints at which nothing touches
    notes: tuple[str, ...]  # what could not be checked

    @property
    def problems(self) -> tuple[str, ...]:
        """All problems, each a sentence."""
        return (*(f"{name}: {what}." for name, what in self.at.items()), *(move.problem for move in self.moves if move.problem))

    def refuse(self) -> None:
        """Raise PlanError if there are problems."""
        if problems := self.problems:
            shown = " ".join(problems[:SHOWN]) + (f" And {len(problems) - SHOWN} more." if len(problems) > SHOWN else "")
            raise PlanError(f"The plan is not free of collisions. {shown}", "Change these viewpoints or their order; nothing was moved.")


def check_collisions(
    plan: Iterable[Viewpoint], rig: RigDescription, arm: ArmModel | None, part: PartSolid | None, start: Placement | None = None
) -> CollisionReport:
    """Check every viewpoint of a plan, and every move from one to the next as a session drives it.

    Parameters
    ----------
    arm : of the rig's robot; None: only the head is checked
    part : on the table; None: it is not known
    start : where the axes are; None: at the park pose of the rig, else at the first viewpoint

    Raises
    ------
    PlanError
        The part is larger than the table.
    InputError
        Bodies touch whatever the joint angles.
    """
    return check_in(Cell.of(rig, arm, part), tuple(plan), start)


def check_in(
    cell: Cell, viewpoints: Sequence[Viewpoint], start: Placement | None = None, progress: Progress | None = None
) -> CollisionReport:
    """Check viewpoints in a cell that is built already; as `check_collisions`. Raises InputError where bodies always touch."""
    told = NoProgress() if progress is None else progress
    at: dict[str, str] = {}
    for viewpoint in viewpoints:
        told.check()
        if problem := cell.problem_at(viewpoint):
            at[viewpoint.id] = problem
    if at and (names := cell.always_touching()):
        raise InputError(
            f"The bodies {names} touch whatever the joint angles: the model of the cell is wrong.",
            "Correct them: links in the robot's file, other bodies in [cell], keep-out boxes in [motion] of the rig description.",
        )
    free = [viewpoint for viewpoint in viewpoints if viewpoint.id not in at]
    here = start if start is not None else start_of(cell, free)
    moves: list[Move] = []
    name = ""
    for viewpoint in free:
        told.check()
        if here is None:
            break
        try:
            route = find_route(cell, here, viewpoint)
        except NoRoute as error:
            moves.append(Move(name, viewpoint.id, None, error.message))
            continue
        moves.append(Move(name, viewpoint.id, route, ""))
        here, name = route.end, viewpoint.id
    return CollisionReport(at, tuple(moves), _notes(cell))


def _notes(cell: Cell) -> tuple[str, ...]:
    arm = () if cell.arm is not None and cell.arm.bodies else (NO_ARM if cell.arm is None else NO_SHAPE,)
    return (*arm, *(() if cell.has_part else (NO_PART,)))
