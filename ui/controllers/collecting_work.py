"""What collecting does on a job's thread: take images with the rig, read recorded ones, open what was kept, solve."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QImage

from measureapp.errors import CalibrationError, DecodeError, InputError, MeasureError
from measureapp.progress import PartOf, Progress
from ui.controllers.collecting_nouns import Kind, LiveImage
from ui.workers.mailbox import Mailboxes

if TYPE_CHECKING:
    from measureapp.data.board import BoardDescription
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration
    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.devices.rig import Rig
    from measureapp.pipeline.collecting.coaching import Advice
    from measureapp.pipeline.collecting.collection import Collection
    from measureapp.pipeline.collecting.observation import Observation
    from measureapp.pipeline.collecting.recorded import RecordedView
    from measureapp.pipeline.collecting.setup import Setup
    from measureapp.pipeline.collecting.solved import Solved
    from measureapp.pipeline.collecting.suggested import Suggestion
    from measureapp.pipeline.collecting.verdict import Verdict
    from ui.controllers.rig_connection import RigConnection
    from ui.workers.job import Job

THUMBNAIL_PX = 256
PREFIXES: Mapping[Kind, tuple[str, ...]] = {
    "cameras": ("pose",),
    "projector": ("pose",),
    "hand-eye": ("pose",),
    "axis": ("axis",),
    "guide": ("guide",),
    "rig": ("",),
}
BEYOND_PLAN = "more"  # names of viewpoints begin so
RIG_FILE = "rig.json"  # beside a session whose images a rig takes


@dataclass(frozen=True, eq=False)
class Added:
    """An observation was added to the collection."""

    id: str
    name: str
    images: Mapping[str, np.ndarray]
    thumbnails: Mapping[str, QImage]


@dataclass(frozen=True, eq=False)
class Known:
    """What is calibrated already."""

    cameras: CameraArrayCalibration | None
    rig: RigCalibration | None


@dataclass(frozen=True)
class Skipped:
    """An image could not be used at all."""

    error: MeasureError


@dataclass(frozen=True, eq=False)
class Thought:
    """What was made of the observations: a solution or why there is none, and what to show next."""

    solved: Solved | None
    error: MeasureError | None
    advice: Advice
    verdict: Verdict | None
    suggestion: Suggestion | None  # from where the rig should look next, after the planned viewpoints


Taker = Callable[["Viewpoint", "Progress"], "Observation"]
Change = Callable[[], object]
Changes = SimpleQueue[Change]
Work = Callable[["Job"], object]


def thumbnail(pixels: np.ndarray) -> QImage:
    """Return a small picture of an image (H, W) of 8 or 16 bits."""
    step = max(1, -(-max(pixels.shape) // THUMBNAIL_PX))
    thin = np.ascontiguousarray(pixels[::step, ::step])
    if thin.dtype != np.uint8:
        thin = (thin.astype(np.float32) * (255.0 / max(1.0, float(thin.max())))).astype(np.uint8)
    return QImage(thin.data, thin.shape[1], thin.shape[0], thin.strides[0], QImage.Format.Format_Grayscale8).copy()


def make_changes(changes: Changes) -> None:
    """Make the changes that were asked for meanwhile: a collection is not for two threads at once."""
    while True:
        try:
            change = changes.get_nowait()
        except Empty:
            return
        change()


def viewpoints_of(kind: Kind, rig: RigDescription, plan: ScanPlan | None) -> tuple[Viewpoint, ...]:
    """Return from where the rig looks at the board for one kind of calibration."""
    from measureapp.planning.calibration_views import calibration_viewpoints

    chosen = (viewpoint for viewpoint in calibration_viewpoints(rig, plan) if viewpoint.id.startswith(PREFIXES[kind]))
    return tuple(_without_slide(chosen, rig) if kind == "hand-eye" else chosen)


def _without_slide(viewpoints: Iterable[Viewpoint], rig: RigDescription) -> Iterator[Viewpoint]:
    """The same looks with the slide at 0, where they can be reached: hand-eye takes the robot's base to stand still."""
    from measureapp.data.plan import FlangePose
    from measureapp.geometry.transform import RigidTransform
    from measureapp.planning.reach import limit_violations

    for viewpoint in viewpoints:
        slid = RigidTransform.from_parts(np.eye(3), np.array([0.0, viewpoint.guide_mm, 0.0]), "base", "base")
        flange = FlangePose.of(slid @ viewpoint.flange.transform())
        still = viewpoint.model_copy(update={"flange": flange, "guide_mm": 0.0})
        if not limit_violations(still, rig):
            yield still


def take(job: Job, rig: Rig, viewpoints: Sequence[Viewpoint], collection: Collection, live: Mailboxes[LiveImage], changes: Changes) -> None:
    """Take the board from these viewpoints; every view is kept before the next one begins."""
    rig.place_on_table("board")
    take_one = _fringe_taker(rig, collection, live) if collection.setup.kind == "projector" else _image_taker(rig, collection, live)
    for done, viewpoint in enumerate(viewpoints):
        job.report(done, len(viewpoints), f"Taking {viewpoint.id}")
        found = take_one(viewpoint, PartOf(job, done / len(viewpoints), (done + 1) / len(viewpoints)))
        make_changes(changes)
        job.emit_event(_added(found, viewpoint.id))
    collection.look_again()


def _image_taker(rig: Rig, collection: Collection, live: Mailboxes[LiveImage]) -> Taker:
    """One plain image of each camera."""
    from measureapp.acquire.capture import capture_board

    def take_one(viewpoint: Viewpoint, progress: Progress) -> Observation:
        view = capture_board(rig, viewpoint)
        for camera, pixels in view.images.items():
            live.put(camera, LiveImage(viewpoint.id, pixels))
        progress.report(0.5, 1, f"Looking for the board in {viewpoint.id}")
        warm = None if view.conditions is None else view.conditions.temperature_c
        return collection.add(view.images, view.readback, dict.fromkeys(view.images, viewpoint.id), warm)

    return take_one


def _fringe_taker(rig: Rig, collection: Collection, live: Mailboxes[LiveImage]) -> Taker:
    """Fringes of both directions, which the projector gets once."""
    from measureapp.acquire.board_fringes import capture_board_fringes
    from measureapp.acquire.events import Event, ImageTaken
    from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
    from measureapp.data.pattern_sets import BOTH_DIRECTIONS, make_pattern_sets
    from measureapp.fringe.patterns.draw import pattern_images

    size_px = rig.projector.width_px, rig.projector.height_px
    patterns = make_pattern_sets(*size_px)[BOTH_DIRECTIONS]
    shown = pattern_images(patterns, *size_px)
    rig.projector.load(shown)
    names = dict.fromkeys(collection.setup.seeing)

    def take_one(viewpoint: Viewpoint, progress: Progress) -> Observation:
        def happened(event: Event) -> None:
            if isinstance(event, ImageTaken):
                live.put(event.camera, LiveImage(viewpoint.id, event.pixels))
                live.put(PROJECTOR, LiveImage(viewpoint.id, shown[0]))

        stack = capture_board_fringes(rig, viewpoint, patterns, happened, PartOf(progress, 0.0, 0.6))
        return collection.add_fringes(stack, names=dict.fromkeys(names, viewpoint.id), progress=PartOf(progress, 0.6, 1.0))

    return take_one


def read(job: Job, recorded: Sequence[RecordedView], collection: Collection, changes: Changes) -> None:
    """Add recorded views; one that cannot be read is told and left out."""
    for done, view in enumerate(recorded):
        job.report(done, len(recorded), f"Looking for the board in {view.name}")
        try:
            found = view.add_to(collection, PartOf(job, done / len(recorded), (done + 1) / len(recorded)))
        except (InputError, DecodeError) as error:
            job.emit_event(Skipped(error))
            continue
        make_changes(changes)
        job.emit_event(_added(found, view.name))
    collection.look_again()


def _added(found: Observation, name: str) -> Added:
    images = {camera: image.pixels() for camera, image in found.images.items()}
    return Added(found.id, name, images, {camera: thumbnail(pixels) for camera, pixels in images.items()})


def thumbnails_of(job: Job, collection: Collection) -> dict[tuple[str, str], QImage]:
    """Return small pictures of all images of a collection; (observation, camera) -> picture."""
    observations = collection.observations
    pictures: dict[tuple[str, str], QImage] = {}
    for done, observation in enumerate(observations):
        job.report(done, len(observations), f"Reading view {observation.id}")
        for camera, image in observation.images.items():
            try:
                pictures[observation.id, camera] = thumbnail(image.pixels())
            except InputError as error:
                job.emit_event(Skipped(error))
    return pictures


def opened(job: Job, folder: Path) -> tuple[Collection, RigDescription | None, dict[tuple[str, str], QImage]]:
    """Open a session that was kept, with the rig that took its images."""
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.collecting.collection import Collection

    collection = Collection.open(folder)
    rig_file = folder / RIG_FILE
    rig = RigDescription.model_validate_json(rig_file.read_text(encoding="utf-8")) if rig_file.is_file() else None
    return collection, rig, thumbnails_of(job, collection)


def thought(job: Job, collection: Collection, rig: RigDescription | None) -> Thought:
    """Solve a snapshot and ask the coach, so that collecting goes on meanwhile; with a rig, ask from where it should look next."""
    from measureapp.pipeline.collecting.coaching import coach
    from measureapp.pipeline.collecting.suggested import suggest_viewpoint
    from measureapp.pipeline.collecting.verdict import judge

    error: MeasureError | None = None
    verdict: Verdict | None = None
    if collection.usable and not collection.is_solved:
        try:
            collection.solve(job)
        except CalibrationError as problem:
            error = problem
            collection.adopt(None)
    job.check()
    if collection.solved is not None:
        verdict = judge(collection)
    suggestion = None if rig is None else suggest_viewpoint(collection, rig, f"{BEYOND_PLAN}{len(collection.observations) + 1:02d}")
    return Thought(collection.solved, error, coach(collection), verdict, suggestion)


def connected(job: Job, rig: RigDescription, board: BoardDescription) -> RigConnection:
    """Connect the rig and tell the window, which keeps the connection."""
    from ui.controllers.rig_connection import connect

    connection = connect(rig, board)
    job.emit_event(connection)
    return connection


def setup_for(
    kind: Kind,
    board: BoardDescription,
    names: tuple[str, ...],
    rig: RigDescription | None,
    known: Known,
    projector_px: tuple[int, int] | None = None,
) -> Setup:
    """Return what a collection of this kind is told beforehand. Raises InputError, CalibrationError where something is missing.

    Parameters
    ----------
    names : of the cameras, the reference first
    projector_px : size of the projector's image; None for that of the rig
    """
    from measureapp.calibrate.motions.axis_noise import AxisNoise
    from measureapp.pipeline.calibrate import expected_noise
    from measureapp.pipeline.collecting.setup import Setup

    needs_cameras = kind not in {"cameras", "rig"}
    return Setup(
        kind=kind,
        board=board,
        camera_names=names,
        cameras=known.cameras if needs_cameras else None,
        hand_eye=known.rig.hand_eye if kind in {"guide", "axis"} and known.rig is not None else None,
        noise=AxisNoise() if rig is None else expected_noise(rig),
        standoff_mm=None if rig is None else rig.standoff_mm,
        serials={} if rig is None else {camera.name: camera.serial for camera in rig.cameras},
        projector_px=projector_px if rig is None else (rig.projector.width_px, rig.projector.height_px),
    )
