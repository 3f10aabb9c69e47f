"""Images of a viewpoint and what they decode to, read and computed on a separate thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.images.layers import Layer, layers_of
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.fringe import FringeStack
    from measureapp.data.phase import PhaseMap
    from measureapp.errors import MeasureError
    from measureapp.pipeline.exposures import CameraExposures
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class ViewImages:
    """The stored images of a viewpoint, its phase maps, and the valid pixels of its exposures."""

    stack: FringeStack
    maps: Mapping[str, PhaseMap]  # by camera, decoded as the program measures
    layers: Mapping[str, Mapping[str, Layer]]  # by camera and kind of map
    exposures: Mapping[str, CameraExposures]

    @property
    def viewpoint_id(self) -> str:
        """Viewpoint of the images."""
        return self.stack.viewpoint_id


class ImagesController(QObject):
    """Loads the images of viewpoints of the open project; the last one is kept until another project is opened."""

    progressed = Signal(float, str)
    loaded = Signal(object)  # ViewImages
    stopped = Signal(str)  # reason of the failure; empty when cancelled
    forgotten = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._last: ViewImages | None = None
        self._job: Job | None = None
        runner.progressed.connect(self.progressed)
        session.projectChanged.connect(self._forget)

    @Slot(str)
    def load(self, viewpoint_id: str) -> None:
        """Load and decode a viewpoint, or return it at once if it was the last one."""
        folder = self._session.folder
        self.cancel()
        if self._last is not None and self._last.viewpoint_id == viewpoint_id:
            self.loaded.emit(self._last)
        elif folder is not None and (folder / "project.json").exists():
            self._job = self._runner.run(
                f"Decoding {viewpoint_id}",
                lambda job: load_images(folder, viewpoint_id, job),
                self._keep,
                on_failed=self._tell_failure,
                quiet=True,
            )
            self._job.cancelled.connect(self._tell_cancelled)
        else:
            self.stopped.emit("The images of this view are not on disk. Open the project that contains them.")

    @Slot()
    def cancel(self) -> None:
        """Cancel loading."""
        self._runner.cancel()

    @Slot()
    def _forget(self) -> None:
        self.cancel()
        self._last = None
        self.forgotten.emit()

    @Slot(object)
    def _keep(self, found: ViewImages) -> None:
        self._last, self._job = found, None
        self.loaded.emit(found)

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        if self.sender() is self._job:
            self.stopped.emit(str(error))

    @Slot()
    def _tell_cancelled(self) -> None:
        if self.sender() is self._job:  # another view may be requested already
            self.stopped.emit("")


def load_images(folder: Path, viewpoint_id: str, job: Job) -> ViewImages:
    """Read a stored viewpoint, and decode it by both rules; runs on a job's thread. Raises MeasureError."""
    job.report(0, 1, f"Reading the images of {viewpoint_id}")
    from measureapp.pipeline.exposures import decode_by_rules, ratios_of
    from measureapp.pipeline.noise import decode_settings_of
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    stack = project.frames.load(viewpoint_id)
    job.check()
    maps = decode_by_rules(stack, decode_settings_of(project), job)
    layers = {}
    for camera, phase_map in maps["combined"].items():
        job.check()
        layers[camera] = layers_of(phase_map)
    return ViewImages(stack, maps["combined"], layers, ratios_of(stack, maps))
