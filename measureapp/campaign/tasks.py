"""What workers do: each function needs nothing but its arguments and the shared storage, and can be repeated at any time."""

from __future__ import annotations

import hashlib
import pickle
import shutil
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import ParamSpec, TypeVar
from uuid import uuid4

from measureapp.campaign.jobs import DemoJob, Finished, Job
from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import ViewResult
from measureapp.data.verdicts import has_passed
from measureapp.demo import run_demo
from measureapp.errors import MeasureError, StorageError
from measureapp.pipeline.assemble import assemble
from measureapp.pipeline.events import Event, ViewFailed
from measureapp.pipeline.kept_views import views_without_images
from measureapp.pipeline.measure import compute_stored, require_stored
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.run import Outcome, calibrate_stored, finish, process_project
from measureapp.pipeline.validity import check_stored_images
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.reconstruct.rectification.rectifier import Rectifier

P = ParamSpec("P")
R = TypeVar("R")
SCRATCH = ".clouds-of-workers"  # in a project, while its views are computed one by one
PICKLE = 5


@dataclass(frozen=True, slots=True)
class StoredView:
    """A cloud that a worker computed, by reference: its file in the project and the checksum of that."""

    path: Path
    sha256: str


def _with_plain_errors(task: Callable[P, R]) -> Callable[P, R]:
    """Let errors of a task travel between computers: those of special kinds need more than their words to be made again."""

    @wraps(task)
    def plain(*arguments: P.args, **named: P.kwargs) -> R:
        try:
            return task(*arguments, **named)
        except MeasureError as error:
            raise MeasureError(error.message, error.hint) from None

    return plain


def do_alone(job: Job) -> Finished:
    """Do a whole job in this process. An error of the job is its answer, and ends no other job."""
    started = time.monotonic()
    failed: list[ViewFailed] = []
    try:
        if isinstance(job, DemoJob):
            outcome = run_demo(job.request, _keep_failures(failed), NoProgress())
        else:
            outcome = process_project(ProjectFolder.open(job.folder), _keep_failures(failed), NoProgress())
    except (MeasureError, OSError) as error:
        return Finished.failed(job, error, time.monotonic() - started)
    return _answer(job, outcome, failed, time.monotonic() - started)


def views_to_compute(folder: Path) -> tuple[str, ...]:
    """Return the viewpoints of a project whose images are stored. Raises InputError when there is none."""
    project = ProjectFolder.open(folder)
    kept = views_without_images(project)
    return tuple(one for one in require_stored(project) if one not in kept)


@_with_plain_errors
def prepare(folder: Path) -> RigCalibration:
    """Calibrate a project from its images of the board. Raises MeasureError as `process_project`."""
    project = ProjectFolder.open(folder)
    with project.lock():
        calibration = calibrate_stored(project, _ignore, NoProgress(), Stopwatch())
        check_stored_images(project, calibration)
        shutil.rmtree(project.path / SCRATCH, ignore_errors=True)
    return calibration


@_with_plain_errors
def compute_view(folder: Path, viewpoint_id: str, calibration: RigCalibration) -> StoredView | ViewFailed:
    """Compute the cloud of a viewpoint and store it in the project for `complete`; where that fails, return why."""
    project = ProjectFolder.open(folder)
    settings, rectifier = decode_settings_of(project), Rectifier(calibration.cameras)
    view = compute_stored(project, viewpoint_id, calibration, NoProgress(), rectifier, settings=settings)
    if isinstance(view, ViewFailed):
        return view
    scratch = project.path / SCRATCH
    scratch.mkdir(exist_ok=True)
    content = pickle.dumps(view, PICKLE)
    path = scratch / f"{hashlib.sha256(viewpoint_id.encode()).hexdigest()[:16]}.view"
    part = path.with_name(f"{path.name}.{uuid4().hex}.part")  # of this worker: another may do the same after a failure
    part.write_bytes(content)
    part.replace(path)
    return StoredView(path, hashlib.sha256(content).hexdigest())


@_with_plain_errors
def complete(job: Job, calibration: RigCalibration, views: Mapping[str, StoredView | ViewFailed], started: float) -> Finished:
    """Stitch the clouds that were stored, measure and report.

    Parameters
    ----------
    started : time of the system's clock (s since 1970) at which the job was begun

    Raises
    ------
    MeasureError
        A cloud is gone or damaged, or as `process_project`.
    """
    project, watch = ProjectFolder.open(job.folder), Stopwatch()
    with project.lock():
        found = {**{name: _load(view) for name, view in views.items()}, **views_without_images(project)}
        usable = tuple(view for name in require_stored(project) if isinstance(view := found[name], ViewResult))
        measurement = assemble(project, calibration, usable, _ignore, NoProgress(), watch)
        outcome = finish(project, measurement, watch)
        shutil.rmtree(project.path / SCRATCH, ignore_errors=True)
    return _answer(job, outcome, [view for view in found.values() if isinstance(view, ViewFailed)], time.time() - started)


def _load(view: StoredView | ViewFailed) -> ViewResult | ViewFailed:
    if isinstance(view, ViewFailed):
        return view
    try:
        content = view.path.read_bytes()
    except OSError as error:
        raise StorageError(f"The cloud {view.path} cannot be read: {error.strerror or error}.", "Start the job again.") from error
    if hashlib.sha256(content).hexdigest() != view.sha256:
        raise StorageError(f"The cloud {view.path} is damaged.", "Check the shared storage, then start the job again.")
    found: ViewResult = pickle.loads(content)  # written by a worker of this very job: the checksum says so
    return found


def _answer(job: Job, outcome: Outcome, failed: Sequence[ViewFailed], seconds: float) -> Finished:
    damaged = {one.viewpoint_id: one.reason for one in failed if one.damaged}
    document = {**outcome.document, **({"damaged": damaged} if damaged else {})}
    return Finished(job.name, job.folder, has_passed(outcome.measurement) and not damaged, document, seconds=seconds)


def _keep_failures(failed: list[ViewFailed]) -> Callable[[Event], None]:
    def receive(event: Event) -> None:
        if isinstance(event, ViewFailed):
            failed.append(event)

    return receive


def _ignore(event: Event) -> None:
    """What happens within a job is part of its answer."""
