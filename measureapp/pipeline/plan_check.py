"""Everything that is wrong with a scan plan on a rig, viewpoint by viewpoint, and what its scan costs; needs no device."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal

from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import MeasureError
from measureapp.fringe.exposures.bracket import READOUT_MS
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.keep_out import check_keep_out
from measureapp.planning.reach import limit_violations
from measureapp.progress import NoProgress, Progress

Kind = Literal["patterns", "limits", "keep-out", "collision", "path"]


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
    moves_s: float | None = None  # predicted time of all moves; None: not predicted

    @property
    def time_s(self) -> float:
        """Least time of the scan."""
        return self.images_s + (self.moves_s or 0.0)

    def of(self, viewpoint_id: str) -> tuple[PlanProblem, ...]:
        """Return the problems of one viewpoint, and of the move to it."""
        return tuple(problem for problem in self.problems if problem.viewpoint_id == viewpoint_id)


def check_plan_on_rig(plan: ScanPlan, rig: RigDescription, arm: ArmModel | None, progress: Progress | None = None) -> PlanCheck:
    """Check a plan against the rig's limits, the robot's joints and singularities, keep-out boxes and the moves between viewpoints.

    Parameters
    ----------
    arm : of the rig's robot; None: its joints are not checked, only its reach
    progress : cancels between viewpoints
    """
    told = NoProgress() if progress is None else progress
    viewpoints = tuple(plan)
    problems = [*_patterns(plan, rig)]
    before: Viewpoint | None = None
    for number, viewpoint in enumerate(viewpoints):
        told.report(number, len(viewpoints), viewpoint.id)
        problems += [PlanProblem(viewpoint.id, "limits", _sentence(reason)) for reason in limit_violations(viewpoint, rig, arm)]
        problems += _keep_out(viewpoint, before, rig)
        before = viewpoint
    told.report(1, 1)
    return PlanCheck(tuple(problems), images_time_s(plan, viewpoints, rig), stack_bytes_of(plan, viewpoints, rig))


def with_moves(check: PlanCheck, moves_s: float, problems: Iterable[PlanProblem]) -> PlanCheck:
    """Return a check with what was found about the moves."""
    return replace(check, moves_s=moves_s, problems=(*check.problems, *problems))


def images_time_s(plan: ScanPlan, viewpoints: Iterable[Viewpoint], rig: RigDescription) -> float:
    """Return the least time for the images of viewpoints, with the wait before them; cameras read out as the paper's."""
    total_s = 0.0
    for viewpoint in viewpoints:
        settle_s = plan.settle_of(viewpoint)
        exposures_s = sum(max(exposure_us * 1e-6, READOUT_MS * 1e-3) for exposure_us in plan.exposures_of(viewpoint))
        total_s += plan.patterns.count * exposures_s + (rig.motion.settle_s if settle_s is None else settle_s)
    return total_s


def stack_bytes_of(plan: ScanPlan, viewpoints: Iterable[Viewpoint], rig: RigDescription) -> int:
    """Return the size of the images of viewpoints."""
    image = sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) for camera in rig.cameras)
    return sum(image * plan.patterns.count * len(plan.exposures_of(viewpoint)) for viewpoint in viewpoints)


def _patterns(plan: ScanPlan, rig: RigDescription) -> list[PlanProblem]:
    found = []
    try:
        check_determines_phase(plan.patterns)
    except MeasureError as error:
        found.append(PlanProblem("", "patterns", error.message))
    if plan.patterns.projector_px > rig.projector.width_px:
        found.append(
            PlanProblem(
                "",
                "patterns",
                f"The patterns span {plan.patterns.projector_px} columns, {rig.projector.name} has {rig.projector.width_px}.",
            )
        )
    return found


def _keep_out(viewpoint: Viewpoint, before: Viewpoint | None, rig: RigDescription) -> list[PlanProblem]:
    """Return whether the head enters a keep-out box at a viewpoint, or on the straight way to it."""
    try:
        check_keep_out((viewpoint,), rig)
        if before is not None:
            check_keep_out((before, viewpoint), rig)
    except MeasureError as error:
        return [PlanProblem(viewpoint.id, "keep-out", error.message)]
    return []


def _sentence(reason: str) -> str:
    return f"{reason[:1].upper()}{reason[1:]}{'' if reason.endswith('.') else '.'}"
