"""A scan: the plan of a project on a rig, every stack stored and processed as it is taken."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass

from measureapp.acquire.control import RunControl
from measureapp.acquire.engine import Engine
from measureapp.acquire.motion import checked
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import ViewResult
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, InputError, StorageError
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.pipeline.bracket import choose_at, limits_of, propose_bracket
from measureapp.pipeline.events import Event, ExposuresChosen, ValidityKnown
from measureapp.pipeline.first_cloud import watch_part
from measureapp.pipeline.kept_views import views_without_images
from measureapp.pipeline.measure import check_space
from measureapp.pipeline.part_on_table import part_on_table
from measureapp.pipeline.processing import Processing
from measureapp.pipeline.validity import check_before_scan
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.reach import check_reach
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.frame_store import DESCRIPTION
from measureapp.project.geometry.robot_file import arm_of
from measureapp.register.joint.registration_cache import RegistrationCache

OnEvent = Callable[[Event], None]
SCAN_SHARE = 0.95  # of the progress; the rest is for clouds that are not computed yet when the last image is stored


@dataclass(frozen=True, slots=True)
class ScanOptions:
    """How a plan is run.

    Parameters
    ----------
    bracket_s : time budget per viewpoint for exposures chosen by a probe; None: those of the plan
    per_viewpoint : probe at every viewpoint, instead of once at the first
    retake : viewpoints to be taken although their images are stored; these are replaced only when the new ones are stored
    control : pauses, resumes, skips and retakes from other threads
    """

    bracket_s: float | None = None
    per_viewpoint: bool = False
    retake: tuple[str, ...] = ()
    control: RunControl | None = None


def scan(
    rig: Rig,
    project: ProjectFolder,
    calibration: RigCalibration | None,
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    options: ScanOptions | None = None,
    registration_cache: RegistrationCache | None = None,
) -> tuple[ViewResult, ...]:
    """Run the project's plan on the rig and process every stack while the next ones are taken; stored viewpoints are not taken again.

    With ``registration_cache``, every view is registered with the earlier ones during the scan. Without a calibration the images are stored
    and no views are returned. Exposures chosen by one probe are those of the first viewpoint, unless some viewpoints are stored already.

    Parameters
    ----------
    on_event : receives events of acquisition and processing, one at a time, from several threads

    Raises
    ------
    CalibrationError
        The calibration is of other cameras or other lens settings; or it has expired, or was made at another temperature, and the
        rig's rules refuse that.
    PlanError
        A viewpoint is out of reach, or the part is larger than the table; nothing was moved.
    StorageError
        There is not enough disk space, and nothing was moved; or stored images are gone.
    """
    options = options or ScanOptions()
    plan = project.plan()
    if plan is None:
        raise CalibrationError(f"{project.path} has no scan plan.", "Plan the scan first.")
    check_reach(plan, rig.description, arm_of(rig.description))
    rig = checked(rig, part_on_table(project))
    on_event = _one_at_a_time(on_event)
    if calibration is not None:
        on_event(ValidityKnown(check_before_scan(rig, calibration)))
    before = set(project.stored_viewpoints())
    check_space(project, rig.description, plan, options.retake)
    heard = watch_part(project, calibration, rig.description, on_event)
    with Processing(project, calibration, heard, watch, registration_cache) as sink:
        kept = views_without_images(project) if before and calibration is not None else {}
        for viewpoint_id in before.difference(options.retake):
            if viewpoint_id in kept:
                sink.keep(kept[viewpoint_id])
            else:
                sink.compute_stored(viewpoint_id)
        images = pattern_images(plan.patterns, rig.projector.width_px, rig.projector.height_px)
        rig.place_on_table("part")
        if options.bracket_s is not None and not options.per_viewpoint and not before:
            plan = _choose_exposures(rig, project, plan, options.bracket_s, on_event)
        choose = None
        if options.bracket_s is not None and options.per_viewpoint:
            choose = choose_at(rig, plan, options.bracket_s, project.noise(), on_event)
        waiting = _waiting(plan, before, options.retake)
        stored = [viewpoint for viewpoint in plan if viewpoint.id in before]
        with watch.stage("scan with storing and clouds"):
            task = FringeTask(plan.patterns, plan.bracket.exposures_us, images, sink, choose)
            Engine(rig).run(plan.name, waiting, task, on_event, PartOf(progress, 0.0, SCAN_SHARE), options.control, stored)
            _check_kept(project, before | sink.stored)
            sink.finish(PartOf(progress, SCAN_SHARE, 1.0))
    return tuple(sink.views[viewpoint.id] for viewpoint in plan if viewpoint.id in sink.views)


def _waiting(plan: ScanPlan, stored: set[str], retake: tuple[str, ...]) -> tuple[Viewpoint, ...]:
    """Return the viewpoints to be taken, with the settling time of the plan. Raises InputError where one to be retaken is not planned."""
    unknown = set(retake) - {viewpoint.id for viewpoint in plan}
    if unknown:
        raise InputError(f"The plan has no viewpoint {min(unknown)!r}.", "Name a viewpoint of the plan.")
    return tuple(
        viewpoint.model_copy(update={"settle_s": plan.settle_of(viewpoint)})
        for viewpoint in plan
        if viewpoint.id not in stored or viewpoint.id in retake
    )


def _check_kept(project: ProjectFolder, expected: set[str]) -> None:
    """Raise StorageError where images that were stored are not there any more: somebody removed the folder, or its disk is gone."""
    here = {name for name in project.stored_viewpoints() if (project.path / "stacks" / name / DESCRIPTION).is_file()}
    missing = sorted(expected - here)
    if missing:
        raise StorageError(
            f"The images of {', '.join(missing[:8])}{', …' if len(missing) > 8 else ''} were stored in {project.path} and are gone.",
            "Connect its disk again or restore the folder, then continue the scan.",
        )


def _choose_exposures(rig: Rig, project: ProjectFolder, plan: ScanPlan, bracket_s: float, on_event: OnEvent) -> ScanPlan:
    """Choose the exposures by a probe at the first viewpoint, and store the plan with them."""
    planned = plan.bracket.exposures_us
    proposal = propose_bracket(rig, plan.patterns, limits_of(rig, bracket_s, planned), plan[0], project.noise(), compare={"plan": planned})
    chosen = plan.model_copy(update={"bracket": proposal.bracket})
    project.save_plan(chosen)
    planned_share = proposal.compared["plan"].decodable_share
    on_event(ExposuresChosen(proposal.exposures_us, proposal.figures.decodable_share, planned_share, proposal.note))
    return chosen


def _one_at_a_time(on_event: OnEvent) -> OnEvent:
    """Let a receiver get the events of acquisition and of processing one after the other."""
    lock = threading.RLock()

    def receive(event: Event) -> None:
        with lock:
            on_event(event)

    return receive
