"""Whole runs: calibrate a rig, scan into a project, process a project."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measureapp.acquire.control import RunControl
from measureapp.calibration_session.detection import DETECTION_THREADS
from measureapp.data.board import AnyBoard
from measureapp.data.calibration import RigCalibration
from measureapp.data.identification import Identification
from measureapp.data.measurement import Measurement
from measureapp.data.part_program import PartProgram
from measureapp.data.plan import ScanPlan
from measureapp.data.raw_policy import RawPolicy
from measureapp.data.rig import RigDescription
from measureapp.data.storage_rules import StorageRules
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, InputError
from measureapp.language.languages import ENGLISH
from measureapp.pipeline.assemble import Revision, assemble
from measureapp.pipeline.connecting import connected
from measureapp.pipeline.documents import outcome_document, write_reports
from measureapp.pipeline.events import CalibrationReady, Event, ResultKept
from measureapp.pipeline.kept_results import kept_calibration
from measureapp.pipeline.kept_views import kept_views
from measureapp.pipeline.measure import compute_clouds
from measureapp.pipeline.memory_need import detection_threads
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.part_on_table import solid_of
from measureapp.pipeline.part_program import nominal_of, store_part_program
from measureapp.pipeline.preflight import Preflight, check_connected, check_plan
from measureapp.pipeline.recording.learn import calibrate_recording
from measureapp.pipeline.recording.stages import is_recording
from measureapp.pipeline.rig_calibration import calibrate_rig, solve_calibration
from measureapp.pipeline.scan import ScanOptions, scan
from measureapp.pipeline.validity import check_stored_images
from measureapp.pipeline.watch import Stopwatch
from measureapp.pipeline.worker import Worker
from measureapp.planning.collision.build import PartSolid
from measureapp.progress import Cancelled, NoProgress, PartOf, Progress
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder, ProjectSettings
from measureapp.project.geometry.files import read_mesh
from measureapp.project.identification_file import read_identification, save_identification
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
class NewProject:
    """What a project is created with."""

    name: str
    part: str
    program: Path | None = None
    nominal: Path | None = None
    board: AnyBoard = DEFAULT_BOARD


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
    part_program: PartProgram | None = None  # whose inspection program, nominal and report template become the project's
    created: NewProject | None = None  # an existing project must have been created with the same; None: after the plan, or as it is
    raw: RawPolicy | None = None  # what becomes of raw images; None: as the part program, else the project states
    stated: Identification | None = None  # what is stated about the part with this scan; its empty fields change nothing
    language: str = ENGLISH  # of the report
    calibrate: bool = False  # calibrate first where there is no calibration; only a rig that places board and part itself can do both

    def options(self, control: RunControl | None) -> ScanOptions:
        """Return how the plan is run."""
        return ScanOptions(self.bracket_s, self.per_viewpoint, self.retake, control)


def scan_into_project(
    request: ScanRequest, on_event: OnEvent, progress: Progress, control: RunControl | None = None, held: Rig | None = None
) -> Outcome | None:
    """Connect the rig, run the plan into the project and process the images.

    Parameters
    ----------
    on_event : receives events one at a time, from several threads
    control : pauses, resumes, skips and retakes from other threads; a calibration that comes first ignores it
    held : the connected rig; it stays connected. None: it is connected for the scan, and released after it

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
    part = _part_of(request, project)
    check_plan(request.plan, request.rig, project, part, progress=progress).refuse()
    calibrated = _calibrated_for(request, project)
    calibration, watch = calibrated.calibration(), Stopwatch()
    with ExitStack() as locked, watch.stage("total"), RegistrationCache(background=Worker("registration-cache")) as registration_cache:
        with connected(request.rig, held) as rig:
            check_connected(request.plan, rig, project, calibration, part, progress).refuse()
            project = ProjectFolder.create(request.folder, project.settings)
            locked.enter_context(project.lock())
            _fill(project, request, calibrated, calibration)
            if calibration is None and request.calibrate:
                calibration = calibrate_rig(rig, project, on_event, PartOf(progress, 0.0, 0.3), watch).solved.solution.calibration
            scanning, options = PartOf(progress, 0.3 if request.calibrate else 0.0, 0.8), request.options(control)
            views = scan(rig, project, calibration, on_event, scanning, watch, options, registration_cache)
        if calibration is None:
            return None
        measurement = assemble(project, calibration, views, on_event, PartOf(progress, 0.8, 0.95), watch, registration_cache)
    return finish(project, measurement, watch, request.language, PartOf(progress, 0.95, 1.0))


def _fill(project: ProjectFolder, request: ScanRequest, calibrated: ProjectFolder, calibration: RigCalibration | None) -> None:
    """Store plan, inspection program, nominal, part program and a calibration of another project in the project."""
    if calibration is not None and project.calibration() is None:
        project.save_calibration(calibration, calibrated.rig_uncertainty())
        project.copy_noise_from(calibrated)
    project.save_plan(_plan_of(request, project))
    if request.created is not None and project.program is None and project.nominal is None:
        project.save_inspection(request.created.program, request.created.nominal)
    if request.part_program is not None:
        store_part_program(project, request.part_program)
    if request.stated is not None:
        save_identification(project.path, request.stated.with_defaults(read_identification(project.path)))
    if request.raw is not None and request.raw != project.storage_rules().raw:
        project.save_storage_rules(StorageRules(raw=request.raw))


def rehearse(request: ScanRequest, held: Rig | None = None, progress: Progress | None = None) -> Preflight:
    """Connect the rig, unless it is ``held``, and check everything that would stop the scan; nothing moves and nothing is written."""
    project = _project_of(request)
    calibration = _calibrated_for(request, project).calibration()
    with connected(request.rig, held) as rig:
        return check_connected(request.plan, rig, project, calibration, _part_of(request, project), progress)


def _part_of(request: ScanRequest, project: ProjectFolder) -> PartSolid | None:
    """Return the nominal that the project has, or will have with this scan, as it stands on the table; None without one. Raises InputError."""
    pose = request.plan.part_pose
    if request.part_program is not None and request.part_program.nominal is not None:
        with nominal_of(request.part_program) as found:
            return None if found is None else solid_of(found[1], pose)
    chosen = None if request.created is None or project.program is not None else request.created.nominal
    nominal = project.nominal or chosen
    return None if nominal is None else solid_of(read_mesh(nominal), pose)


def _project_of(request: ScanRequest) -> ProjectFolder:
    """Open the project, or prepare a new one without writing anything."""
    part = request.plan.name if request.part_program is None else request.part_program.facts.name
    new = request.created or NewProject(request.plan.name, part)
    settings = ProjectSettings(name=new.name, part=new.part, rig=request.rig, board=new.board)
    if not (request.folder / "project.json").exists():
        return ProjectFolder(request.folder, settings)
    project = ProjectFolder.open(request.folder)
    if request.created is not None and not project.settings.same_job(settings):
        raise InputError(f"{request.folder} contains another project ({project.name}).", "Choose another folder, or delete that one first.")
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


def process_project(
    project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch | None = None, language: str = ENGLISH
) -> Outcome:
    """Recompute everything from the stored images: calibration (if its images are stored), clouds, stitching, dimensions, report.

    A project that is joined from several set-ups is joined again from their stored clouds. ``watch`` notes the stages; a `Profile` notes
    what they use, too.
    """
    from measureapp.pipeline.setups import is_joined, process_joined  # they finish a measurement as all runs do

    watch = watch or Stopwatch()
    if is_joined(project):
        return process_joined(project, on_event, progress, watch, language)
    with project.lock():
        threads = detection_threads(project, on_event)
        calibration = calibrate_stored(project, on_event, PartOf(progress, 0.0, 0.2), watch, threads)
        check_stored_images(project, calibration)
        with watch.stage("clouds"):
            kept = kept_views(project, calibration, decode_settings_of(project))
        views = compute_clouds(project, calibration, on_event, PartOf(progress, 0.2, 0.7), watch, kept)
        former = None if kept.former is None else Revision(kept.former)
        measurement = assemble(project, calibration, views, on_event, PartOf(progress, 0.7, 0.95), watch, revision=former)
        return finish(project, measurement, watch, language, PartOf(progress, 0.95, 1.0))


def process(project: ProjectFolder, on_event: OnEvent, progress: Progress) -> Measurement:
    """Recompute everything from the stored images and return the measurement."""
    return process_project(project, on_event, progress).measurement


def calibrate_stored(
    project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch, threads: int = DETECTION_THREADS
) -> RigCalibration:
    """Return the calibration from the stored images of the board, solved anew unless it would come out as it is; without such images the stored one.

    Raises
    ------
    CalibrationError
    """
    if is_recording(project):
        return calibrate_recording(project, on_event, progress, watch)
    if project.board_view_count():
        with watch.stage("calibration"):
            kept = kept_calibration(project)
        if kept is not None:
            on_event(ResultKept("calibration"))
            on_event(CalibrationReady(kept))
            return kept
        return solve_calibration(project, on_event, progress, watch, threads).solution.calibration
    calibration = project.calibration()
    if calibration is None:
        raise CalibrationError(f"{project.path} has neither a calibration nor images of the board.", "Calibrate the rig first.")
    on_event(CalibrationReady(calibration))
    return calibration


def finish(
    project: ProjectFolder,
    measurement: Measurement,
    watch: Stopwatch,
    language: str = ENGLISH,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Outcome:
    """Write the reports in a language, and the JSON document of a measurement.

    Cancelled meanwhile, no report is left: that of the results before would contradict those that are stored now.
    """
    with watch.stage("report"):
        try:
            files = {"project": project.path, **write_reports(project, measurement, language, progress)}
        except Cancelled:
            for report in (project.report_pdf, project.report_csv, project.report_json):
                report.unlink(missing_ok=True)
            raise
    document = outcome_document(measurement, files, watch.seconds)
    return Outcome(measurement, document, files, project.filters(measurement.stitched))
