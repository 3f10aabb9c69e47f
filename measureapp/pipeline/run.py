"""Whole runs: calibrate a rig, scan into a project, process a project."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measureapp.acquire.control import RunControl
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import ImageTaken, ViewpointFailed
from measureapp.acquire.tasks.board import BoardTask
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of
from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import Measurement
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, InputError
from measureapp.pipeline.assemble import assemble
from measureapp.pipeline.calibrate import calibrate_from_views
from measureapp.pipeline.documents import outcome_document, write_reports
from measureapp.pipeline.events import CalibrationReady, Event
from measureapp.pipeline.measure import compute_clouds
from measureapp.pipeline.preflight import Preflight, check_connected, check_plan
from measureapp.pipeline.recording.learn import calibrate_recording
from measureapp.pipeline.recording.stages import is_recording
from measureapp.pipeline.scan import ScanOptions, scan
from measureapp.pipeline.validity import check_stored_images
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry.robot_file import arm_of
from measureapp.register.clouds.filter_chain import FilterChain
from measureapp.register.joint.registration_cache import RegistrationCache

OnEvent = Callable[[Event], None]


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """Result of a run: measurement, JSON document and files."""

    measurement: Measurement
    document: dict[str, Any]
    files: dict[str, Path]
    filters: FilterChain | None = None  # of the stitched cloud, as stored in the project


@dataclass(frozen=True, slots=True)
class ScanRequest:
    """Plan, rig and project of a scan."""

    plan: ScanPlan
    rig: RigDescription
    folder: Path
    resume: bool = False  # keep stored viewpoints
    calibrated: Path | None = None  # another project whose calibration is copied into a new one
    bracket_s: float | None = None  # time budget per viewpoint for exposures chosen by a probe; None: exposures of the plan
    per_viewpoint: bool = False  # probe at every viewpoint, instead of once at the first
    retake: tuple[str, ...] = ()  # viewpoints taken again although their images are stored


def calibrate_rig(rig: Rig, project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch) -> RigSolution:
    """Take images of the board from all sides, keep them, and solve the whole rig from them."""
    viewpoints = calibration_viewpoints(rig.description, project.plan(), arm=arm_of(rig.description))
    stored = {view.viewpoint_id for view in project.board_views()}
    with watch.stage("calibration images"):
        waiting = [viewpoint for viewpoint in viewpoints if viewpoint.id not in stored]
        Engine(rig).run("calibration", waiting, BoardTask(project.save_board_view), _of_images(on_event), PartOf(progress, 0.0, 0.6))
    return solve_calibration(project, on_event, PartOf(progress, 0.6, 1.0), watch)


def _of_images(on_event: OnEvent) -> OnEvent:
    """Pass on images and failures only: the viewpoints of a calibration are none of a scan."""

    def receive(event: Event) -> None:
        if isinstance(event, (ImageTaken, ViewpointFailed)):
            on_event(event)

    return receive


def solve_calibration(project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch) -> RigSolution:
    """Calibrate the rig from the stored images of the board; raises CalibrationError when they do not suffice."""
    with watch.stage("calibration"):
        calibrated = calibrate_from_views(project.board_views(), project.settings.board, project.rig(), progress)
        project.save_calibration(calibrated.calibration, uncertainty_of(calibrated))
    on_event(CalibrationReady(calibrated.calibration))
    return calibrated


def scan_into_project(request: ScanRequest, on_event: OnEvent, progress: Progress, control: RunControl | None = None) -> Outcome | None:
    """Connect the rig, run the plan into the project and process the images.

    Parameters
    ----------
    on_event : receives events one at a time, from several threads
    control : pauses, resumes, skips and retakes from other threads

    Returns
    -------
    outcome : None if the project has no calibration; the images are stored, and `process` can use them later

    Raises
    ------
    InputError, DecodeError, CalibrationError, PlanError, StorageError
        Before anything moves.
    DeviceError
        From the rig.
    """
    project = _project_of(request)
    check_plan(request.plan, request.rig, project).refuse()
    calibrated = _calibrated_for(request, project)
    calibration = calibrated.calibration()
    watch = Stopwatch()
    with ExitStack() as held, RegistrationCache() as registration_cache:
        rig = connect_rig(request.rig)
        try:
            check_connected(request.plan, rig, project, calibration).refuse()
            project = ProjectFolder.create(request.folder, project.settings)
            held.enter_context(project.lock())
            if calibration is not None and project.calibration() is None:
                project.save_calibration(calibration, calibrated.rig_uncertainty())
                project.copy_noise_from(calibrated)
            project.save_plan(_plan_of(request, project))
            options = ScanOptions(request.bracket_s, request.per_viewpoint, request.retake, control)
            views = scan(rig, project, calibration, on_event, PartOf(progress, 0.0, 0.8), watch, options, registration_cache)
        finally:
            rig.close()
        if calibration is None:
            return None
        measurement = assemble(project, calibration, views, on_event, PartOf(progress, 0.8, 1.0), watch, registration_cache)
        return finish(project, measurement, watch)


def rehearse(request: ScanRequest) -> Preflight:
    """Connect the rig and check everything that would stop the scan; nothing moves and nothing is written."""
    project = _project_of(request)
    calibration = _calibrated_for(request, project).calibration()
    rig = connect_rig(request.rig)
    try:
        return check_connected(request.plan, rig, project, calibration)
    finally:
        rig.close()


def _project_of(request: ScanRequest) -> ProjectFolder:
    """Open the project, or prepare a new one without writing anything."""
    if not (request.folder / "project.json").exists():
        return ProjectFolder(request.folder, ProjectSettings(name=request.plan.name, part=request.plan.name, rig=request.rig))
    project = ProjectFolder.open(request.folder)
    if project.stored_viewpoints() and not request.resume and not request.retake:
        raise InputError(
            f"{request.folder} contains images already.", "Use --resume to take only the missing viewpoints, or scan into a new project."
        )
    return project


def _plan_of(request: ScanRequest, project: ProjectFolder) -> ScanPlan:
    """Return the plan requested; that of the project where a scan with chosen exposures is continued, which differs in these only."""
    found = project.plan()
    if request.bracket_s is None or found is None or not project.stored_viewpoints():
        return request.plan
    return found if found.model_copy(update={"bracket": request.plan.bracket}) == request.plan else request.plan


def _calibrated_for(request: ScanRequest, project: ProjectFolder) -> ProjectFolder:
    """Return the project whose calibration is used: the project itself or, if it has none, the requested one."""
    if project.calibration() is not None or request.calibrated is None:
        return project
    other = ProjectFolder.open(request.calibrated)
    other.require_calibration()
    return other


def process_project(project: ProjectFolder, on_event: OnEvent, progress: Progress) -> Outcome:
    """Recompute everything from the stored images: calibration (if its images are stored), clouds, stitching, dimensions, report."""
    watch = Stopwatch()
    with project.lock():
        calibration = _calibration_of(project, on_event, PartOf(progress, 0.0, 0.2), watch)
        check_stored_images(project, calibration)
        views = compute_clouds(project, calibration, on_event, PartOf(progress, 0.2, 0.7), watch)
        return finish(project, assemble(project, calibration, views, on_event, PartOf(progress, 0.7, 1.0), watch), watch)


def process(project: ProjectFolder, on_event: OnEvent, progress: Progress) -> Measurement:
    """Recompute everything from the stored images and return the measurement."""
    return process_project(project, on_event, progress).measurement


def _calibration_of(project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch) -> RigCalibration:
    if is_recording(project):
        return calibrate_recording(project, on_event, progress, watch)
    if project.board_views():
        return solve_calibration(project, on_event, progress, watch).calibration
    calibration = project.calibration()
    if calibration is None:
        raise CalibrationError(f"{project.path} has neither a calibration nor images of the board.", "Calibrate the rig first.")
    on_event(CalibrationReady(calibration))
    return calibration


def finish(project: ProjectFolder, measurement: Measurement, watch: Stopwatch) -> Outcome:
    """Write the reports and the JSON document of a measurement."""
    with watch.stage("report"):
        files = {"project": project.path, **write_reports(project, measurement)}
    document = outcome_document(measurement, files, watch.seconds)
    return Outcome(measurement, document, files, project.filters(measurement.stitched))
