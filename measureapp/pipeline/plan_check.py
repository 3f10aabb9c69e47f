"""Everything that is wrong with a scan plan on a rig, viewpoint by viewpoint, and what its scan costs; needs no device."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import stack_bytes, viewpoint_time_s
from measureapp.errors import LimitError, MeasureError
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.motion import Placement
from measureapp.planning.collision.routes import Route, find_route
from measureapp.planning.order import path_time_s
from measureapp.planning.reach import limit_violations
from measureapp.planning.travel import speeds_note, travel_times_s
from measureapp.progress import NoProgress, PartOf, Progress

Kind = Literal["patterns", "part", "limits", "collision", "move"]
Key = tuple[FlangePose, float, float]
MOST_TIMED = 600  # viewpoints whose moves are timed; all pairs of them are
CHECKING, TIMING = 0.95, 1.0  # shares of the progress


@dataclass(frozen=True, slots=True)
class PlanProblem:
    """One thing that prevents a scan."""

    viewpoint_id: str  # empty: of the whole plan
    kind: Kind
    sentence: str

    def __str__(self) -> str:
        return f"{self.viewpoint_id}: {self.sentence}" if self.viewpoint_id else self.sentence


@dataclass(frozen=True, slots=True, eq=False)
class PlanCheck:
    """What a plan costs, and what prevents its scan."""

    problems: tuple[PlanProblem, ...]
    images_s: float  # least time for all images, and the waiting before them
    bytes: int  # of all images
    moves_s: float | None  # predicted time of all moves; None: too many to predict
    note: str = ""  # speeds that the time assumes, in a sentence

    @property
    def time_s(self) -> float:
        """Least time of the scan."""
        return self.images_s + (self.moves_s or 0.0)

    def sentences(self) -> dict[str, list[str]]:
        """Return the problems by viewpoint; those of the whole plan under an empty name."""
        found: dict[str, list[str]] = {}
        for problem in self.problems:
            found.setdefault(problem.viewpoint_id, []).append(problem.sentence)
        return found


class PlanChecker:
    """Checks plans on one rig with one part; what was found about a viewpoint or a move is kept for the next version of the plan.

    Parameters
    ----------
    arm : of the rig's robot; None: only the head is checked, and its reach
    part : what stands on the table; None: it is not known
    """

    def __init__(self, rig: RigDescription, arm: ArmModel | None, part: PartSolid | None = None) -> None:
        self._rig, self._arm = rig, arm
        self._part_problem: PlanProblem | None = None
        try:
            self.cell = Cell.of(rig, arm, part)
        except MeasureError as error:  # a part that is too large
            self._part_problem = PlanProblem("", "part", error.message)
            self.cell = Cell.of(rig, arm)
        self._at: dict[Key, tuple[PlanProblem, ...]] = {}
        self._moves: dict[tuple[object, Key], Route | str] = {}

    def check(self, plan: ScanPlan, progress: Progress | None = None) -> PlanCheck:
        """Check limits, joints, singularities and collisions at every viewpoint, and every move from one to the next.

        ``progress`` is also the cancellation point.
        """
        told = NoProgress() if progress is None else progress
        viewpoints = tuple(plan)
        problems = [*_patterns(plan, self._rig), *([] if self._part_problem is None else [self._part_problem])]
        here: Placement | None = None
        for number, viewpoint in enumerate(viewpoints):
            told.report(CHECKING * number, len(viewpoints), viewpoint.id)
            found = self._problems_at(viewpoint)
            if not found:
                here, found = self._move(here, viewpoint)
            problems += found
        moves_s = self._moves_s(viewpoints, PartOf(told, CHECKING, TIMING))
        told.report(1, 1)
        images_s = sum(viewpoint_time_s(plan, viewpoint, self._rig) for viewpoint in viewpoints)
        size = sum(stack_bytes(plan, viewpoint, self._rig) for viewpoint in viewpoints)
        return PlanCheck(tuple(problems), images_s, size, moves_s, speeds_note(self._rig, self._arm))

    def _problems_at(self, viewpoint: Viewpoint) -> tuple[PlanProblem, ...]:
        key = _key(viewpoint)
        if key not in self._at:
            reasons = limit_violations(viewpoint, self._rig, self._arm)
            found = tuple(PlanProblem("", "limits", _sentence(reason)) for reason in reasons)
            if not found and (touching := self.cell.problem_at(viewpoint)):
                found = (PlanProblem("", "collision", _sentence(touching)),)
            self._at[key] = found
        return tuple(PlanProblem(viewpoint.id, one.kind, one.sentence) for one in self._at[key])

    def _move(self, here: Placement | None, viewpoint: Viewpoint) -> tuple[Placement | None, tuple[PlanProblem, ...]]:
        """Return where the axes are after the move to a viewpoint, and why there is no free way to it."""
        if here is None:
            return self.cell.free_at(viewpoint)[0], ()
        joints = None if here.joints_rad is None else here.joints_rad.tobytes()
        key = ((here.base_from_flange.tobytes(), joints, here.guide_mm, here.table_rad), _key(viewpoint))
        if key not in self._moves:
            try:
                self._moves[key] = find_route(self.cell, here, viewpoint)
            except LimitError as error:
                self._moves[key] = error.message.replace(viewpoint.id, "this viewpoint")
        route = self._moves[key]
        if isinstance(route, Route):
            return route.end, ()
        return here, (PlanProblem(viewpoint.id, "move", route),)

    def _moves_s(self, viewpoints: tuple[Viewpoint, ...], progress: Progress) -> float | None:
        """Return the time of all moves between viewpoints that can be reached, at the speeds that are assumed."""
        reached = [viewpoint for viewpoint in viewpoints if not self._at.get(_key(viewpoint))]
        if len(reached) > MOST_TIMED:
            return None
        progress.check()
        times = travel_times_s(reached, self._rig, self._arm)
        return path_time_s(range(len(reached)), times) if len(reached) > 1 else 0.0


def _patterns(plan: ScanPlan, rig: RigDescription) -> list[PlanProblem]:
    found = []
    try:
        check_determines_phase(plan.patterns)
    except MeasureError as error:
        found.append(PlanProblem("", "patterns", error.message))
    patterns, projector = plan.patterns, rig.projector
    if patterns.projector_px > projector.width_px:
        words = f"The patterns span {patterns.projector_px} columns, {projector.name} has {projector.width_px}."
        found.append(PlanProblem("", "patterns", words))
    return found


def _key(viewpoint: Viewpoint) -> Key:
    return viewpoint.flange, viewpoint.guide_mm, viewpoint.table_deg


def _sentence(reason: str) -> str:
    return f"{reason[:1].upper()}{reason[1:]}{'' if reason.endswith('.') else '.'}"
