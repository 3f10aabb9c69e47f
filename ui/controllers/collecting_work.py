"""Tasks of collecting on a job's thread: take images with the rig, read recorded ones, open a stored session, solve."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QImage

from measureapp.errors import CalibrationError, DecodeError, InputError, MeasureError
from measureapp.progress import PartOf
from ui.controllers.collecting_nouns import LiveImage
from ui.look.language.words import tr
from ui.workers.mailbox import Mailboxes

if TYPE_CHECKING:
    from measureapp.calibrate.draft.advice import Advice
    from measureapp.calibrate.draft.draft import Solved
    from measureapp.calibrate.draft.verdict import Verdict
    from measureapp.calibration_session.observation import CollectedObservation
    from measureapp.calibration_session.recorded import RecordedView
    from measureapp.calibration_session.session import CalibrationSession
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.calibration_session.suggestion import Suggestion
    from measureapp.data.board import BoardDescription
    from measureapp.data.plan import Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.devices.rig import Rig
    from ui.controllers.rig_connection import RigConnection
    from ui.workers.job import Job

THUMBNAIL_PX = 256
BEYOND_PLAN = "more"  # names of viewpoints beyond those planned begin so
RIG_FILE = "rig.json"  # next to a session whose images a rig takes
Work = Callable[["Job"], object]


@dataclass(frozen=True, eq=False)
class Added:
    """An observation was added to the session."""

    id: str
    name: str
    images: Mapping[str, np.ndarray]
    thumbnails: Mapping[str, QImage]


@dataclass(frozen=True)
class Skipped:
    """An image could not be used at all."""

    error: MeasureError


@dataclass(frozen=True, eq=False)
class InterimResult:
    """Solution of the observations so far or the reason for its failure, verdict and guidance."""

    solved: Solved | None
    error: MeasureError | None
    advice: Advice
    verdict: Verdict | None
    suggestion: Suggestion | None  # next viewpoint of the rig, after the planned ones


def thumbnail(pixels: np.ndarray) -> QImage:
    """Return a small picture of an image (H, W) of 8 or 16 bits."""
    step = max(1, -(-max(pixels.shape) // THUMBNAIL_PX))
    thin = np.ascontiguousarray(pixels[::step, ::step])
    if thin.dtype != np.uint8:
        thin = (thin.astype(np.float32) * (255.0 / max(1.0, float(thin.max())))).astype(np.uint8)
    return QImage(thin.data, thin.shape[1], thin.shape[0], thin.strides[0], QImage.Format.Format_Grayscale8).copy()


def take(job: Job, rig: Rig, viewpoints: Sequence[Viewpoint], session: CalibrationSession, live: Mailboxes[LiveImage]) -> None:
    """Take the board from these viewpoints; every view is stored before the next one begins."""
    from measureapp.calibration_session.capturing import capture_views

    def show(view: str, camera: str, pixels: np.ndarray) -> None:
        live.put(camera, LiveImage(view, pixels))

    def tell(viewpoint_id: str, found: CollectedObservation) -> None:
        job.emit_event(_describe_added(found, viewpoint_id))

    capture_views(rig, viewpoints, session, show, tell, job)


def read(job: Job, recorded: Sequence[RecordedView], session: CalibrationSession) -> None:
    """Add recorded views; one that cannot be read is reported and skipped."""
    for done, view in enumerate(recorded):
        job.report(done, len(recorded), tr("Detecting the board in {name}", name=view.name))
        try:
            found = view.add_to(session, PartOf(job, done / len(recorded), (done + 1) / len(recorded)))
        except (InputError, DecodeError) as error:
            job.emit_event(Skipped(error))
            continue
        job.emit_event(_describe_added(found, view.name))
    session.identify_parts()


def _describe_added(found: CollectedObservation, name: str) -> Added:
    images = {camera: image.pixels() for camera, image in found.images.items()}
    return Added(found.id, name, images, {camera: thumbnail(pixels) for camera, pixels in images.items()})


def open_session(job: Job, folder: Path) -> tuple[CalibrationSession, RigDescription | None, dict[tuple[str, str], QImage]]:
    """Open a stored session, with the rig that took its images and small pictures of them: (observation, camera) -> picture."""
    from measureapp.calibration_session.session import CalibrationSession
    from measureapp.data.rig import RigDescription

    session = CalibrationSession.open(folder)
    rig_file = folder / RIG_FILE
    rig = RigDescription.model_validate_json(rig_file.read_text(encoding="utf-8")) if rig_file.is_file() else None
    return session, rig, _thumbnails_of(job, session.snapshot())


def _thumbnails_of(job: Job, snapshot: Snapshot) -> dict[tuple[str, str], QImage]:
    observations = snapshot.observations
    pictures: dict[tuple[str, str], QImage] = {}
    for done, observation in enumerate(observations):
        job.report(done, len(observations), tr("Reading view {id}", id=observation.id))
        for camera, image in observation.images.items():
            try:
                pictures[observation.id, camera] = thumbnail(image.pixels())
            except InputError as error:
                job.emit_event(Skipped(error))
    return pictures


def evaluate_snapshot(job: Job, snapshot: Snapshot, rig: RigDescription | None) -> InterimResult:
    """Solve a snapshot, evaluate it and determine guidance; with a rig, also its next viewpoint."""
    from measureapp.calibrate.draft.verdict import evaluate
    from measureapp.calibrate.guidance.advise import advise
    from measureapp.calibration_session.suggestion import suggest_viewpoint

    error: MeasureError | None = None
    if snapshot.usable and not snapshot.is_solved:
        try:
            snapshot = snapshot.solve(job)
        except CalibrationError as problem:
            error, snapshot = problem, snapshot.without_solution()
    job.check()
    draft = snapshot.draft
    verdict = None if draft.solved is None else evaluate(draft)
    suggestion = None if rig is None else suggest_viewpoint(draft, rig, f"{BEYOND_PLAN}{len(snapshot.kept) + 1:02d}")
    return InterimResult(draft.solved, error, advise(draft), verdict, suggestion)


def connect_rig(job: Job, rig: RigDescription, board: BoardDescription, held: Rig | None) -> RigConnection:
    """Connect the rig, or borrow the connection ``held`` by the Rig page, and report it to the window, which keeps it."""
    from ui.controllers.rig_connection import connect

    connection = connect(rig, board, held)
    job.emit_event(connection)
    return connection
