"""Everything that would stop a scan, checked before anything moves and told at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from measureapp.acquire.motion import joints_of
from measureapp.acquire.states import read_states
from measureapp.arrays import FloatArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import stack_bytes
from measureapp.devices.head_timing import check_timing, period_us
from measureapp.devices.link_budget import OnLink, check_link
from measureapp.devices.projector import TriggeringProjector
from measureapp.devices.rig import Rig
from measureapp.devices.robot import JointRobot
from measureapp.errors import DeviceError, LimitError, MeasureError, PlanError
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.pipeline.measure import check_space
from measureapp.pipeline.validity import check_before_scan
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.cell_paths import placement_of
from measureapp.planning.collision.check import check_in
from measureapp.planning.reach import check_reach, limit_violations
from measureapp.progress import Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.robot_file import arm_of

Start = tuple[AxisReadback, FloatArray | None]
"""Where the axes are, and the joint angles (6,) where they can be read."""

OWN_PATH = "The robot chooses its path between two poses itself: moves were checked as if all its joints moved in proportion."


@dataclass(frozen=True, slots=True, eq=False)
class Preflight:
    """What was found before a scan."""

    problems: tuple[MeasureError, ...]  # each would stop the scan
    warnings: tuple[str, ...]  # of the calibration, and of links that slow the cameras down
    bytes: int  # of all images of the plan
    images_s: float | None  # least time for all images of the plan, without moves; None without a connected rig

    def refuse(self) -> None:
        """Raise the problem found; several are told in one error."""
        if len(self.problems) == 1:
            raise self.problems[0]
        if self.problems:
            kind = DeviceError if any(isinstance(problem, DeviceError) for problem in self.problems) else PlanError
            numbered = " ".join(f"({number}) {problem}" for number, problem in enumerate(self.problems, 1))
            raise kind(f"{len(self.problems)} things prevent the scan: {numbered}")


def check_plan(
    plan: ScanPlan,
    rig: RigDescription,
    project: ProjectFolder,
    part: PartSolid | None = None,
    start: Start | None = None,
    progress: Progress | None = None,
) -> Preflight:
    """Check what needs no device: ambiguity of the patterns, limits, reach, collisions, disk space.

    Parameters
    ----------
    part : what will stand on the table; None: it is not known, and not checked
    start : where the axes are; None: at the park pose of the rig, else at the first viewpoint
    progress : raises Cancelled between two viewpoints
    """
    notes: list[str] = []
    problems = _gather(
        lambda: check_determines_phase(plan.patterns),
        lambda: check_reach(plan, rig, arm_of(rig)),
        lambda: notes.extend(_check_collisions(plan, rig, part, start, progress)),
        lambda: check_space(project, rig, plan),
    )
    return Preflight(problems, tuple(notes), sum(stack_bytes(plan, viewpoint, rig) for viewpoint in plan), None)


def check_connected(
    plan: ScanPlan,
    rig: Rig,
    project: ProjectFolder,
    calibration: RigCalibration | None,
    part: PartSolid | None = None,
    progress: Progress | None = None,
) -> Preflight:
    """Check plan and connected devices: also the state of each, the move from where the axes are, exposures and shutters, the calibration."""
    offline = check_plan(plan, rig.description, project, part, _start(rig), progress)
    warnings = [*offline.warnings, *(() if isinstance(rig.robot, JointRobot) else (OWN_PATH,))]

    def validity() -> None:
        if calibration is not None:
            warnings.extend(check_before_scan(rig, calibration).warnings)

    unready = [
        DeviceError(f"{state.name} ({state.kind}) is not ready: {state.status.text}", state.status.remedy)
        for state in read_states(rig)
        if not state.status.ready
    ]
    used_us = [exposure_us for viewpoint in plan for exposure_us in plan.exposures_of(viewpoint)]
    exposures = [_exposure_check(rig, exposure_us) for exposure_us in sorted(set(used_us), reverse=True)]
    linked = [camera.link for camera in rig.cameras.values() if isinstance(camera, OnLink) and camera.transfer_s]
    overloads = check_link(linked)
    problems = (
        *_gather(rig.latch.check),
        *offline.problems,
        *unready,
        *_gather(validity, *exposures, lambda: _check_sequence(rig)),
        *(DeviceError(sentence) for sentence in overloads),
    )
    shortest_s = period_us(rig.cameras, min(used_us)) * 1e-6
    warnings += [sentence for sentence in check_link(linked, shortest_s) if sentence not in overloads]
    images_s = sum(period_us(rig.cameras, exposure_us) for exposure_us in used_us) * plan.patterns.count * 1e-6
    return Preflight(problems, tuple(warnings), offline.bytes, images_s)


def _start(rig: Rig) -> Start | None:
    """Read back where the axes are; None where one does not answer, which its state says."""
    try:
        return rig.readback(), joints_of(rig)
    except DeviceError:
        return None


def _check_collisions(
    plan: ScanPlan, rig: RigDescription, part: PartSolid | None, start: Start | None, progress: Progress | None
) -> tuple[str, ...]:
    """Refuse collisions of the viewpoints within reach; return what could not be checked."""
    arm = arm_of(rig)
    within = [viewpoint for viewpoint in plan if not limit_violations(viewpoint, rig, arm)]
    cell = Cell.of(rig, arm, part)
    report = check_in(cell, within, None if start is None else placement_of(cell, *start), progress)
    report.refuse()
    return report.notes


def _exposure_check(rig: Rig, exposure_us: int) -> Callable[[], None]:
    def check() -> None:
        for name, camera in rig.cameras.items():
            low, high = camera.exposure_limits_us
            if not low <= exposure_us <= high:
                raise LimitError(f"Camera {name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        projector = rig.projector
        gated = rig.description.head.sequence == "hardware" and isinstance(projector, TriggeringProjector) and projector.gated
        check_timing(rig.cameras, projector, exposure_us, gated=gated)

    return check


def _check_sequence(rig: Rig) -> None:
    if rig.description.head.sequence == "hardware" and not isinstance(rig.projector, TriggeringProjector):
        raise DeviceError(
            f"{rig.projector.name} cannot trigger cameras, as the hardware sequence of {rig.description.name} needs.",
            'Set sequence = "software" in [head] of the rig description.',
        )


def _gather(*checks: Callable[[], None]) -> tuple[MeasureError, ...]:
    """Run every check and return the errors raised, each different one once."""
    found: dict[str, MeasureError] = {}
    for check in checks:
        try:
            check()
        except MeasureError as error:
            found.setdefault(str(error), error)
    return tuple(found.values())


def preflight_lines(found: Preflight, plan: ScanPlan) -> list[str]:
    """Return what was found, as lines for a person."""
    size = f"{found.bytes / 1e9:.2f} GB of images"
    time = "" if found.images_s is None else f", at least {found.images_s:.0f} s for taking them"
    lines = [f"{len(plan)} viewpoints, {size}{time}."]
    lines += [f"Warning: {warning}" for warning in found.warnings]
    return [*lines, *(f"Prevents the scan: {problem}" for problem in found.problems)]
