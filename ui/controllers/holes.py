"""Analysis of the holes of a view, recomputed from its stored images on a separate thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.errors import MeasureError
    from measureapp.pipeline.why import ExplainedView
    from measureapp.pipeline.why_pictures import LegendEntry
    from ui.workers.job import Job

Kind = Literal["grey", "reasons", "exposure", "snr"]


@dataclass(frozen=True, eq=False)
class Explanation:
    """An analysed view, and the shares of all reasons by camera."""

    view: ExplainedView
    shares: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True, eq=False)
class DrawnImage:
    """The image of one camera in the chosen colours."""

    view: ExplainedView
    camera: str
    kind: Kind
    pixels: np.ndarray  # (H, W, 3) uint8
    legend: tuple[LegendEntry, ...]


class HolesController(QObject):
    """Analyses views of the open project; the last one is cached."""

    progressed = Signal(float, str)
    explained = Signal(object)  # Explanation
    drawn = Signal(object)  # DrawnImage
    stopped = Signal(str)  # reason of the failure; empty when cancelled

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._last: Explanation | None = None
        self._job: Job | None = None
        runner.progressed.connect(self.progressed)
        for changed in (session.projectChanged, session.calibrationChanged):
            changed.connect(self._forget)

    @property
    def can_explain(self) -> bool:
        """Whether there is a project with images on disk."""
        folder = self._session.folder
        return folder is not None and (folder / "project.json").exists()

    @Slot(str)
    def explain(self, viewpoint_id: str) -> None:
        """Analyse a view, or return the cached one."""
        folder = self._session.folder
        self.cancel()
        if self._last is not None and self._last.view.viewpoint_id == viewpoint_id:
            self.explained.emit(self._last)
        elif folder is not None and self.can_explain:
            self._job = self._runner.run(
                tr("Analysing {viewpoint_id}", viewpoint_id=viewpoint_id),
                lambda job: explain(folder, viewpoint_id, job),
                self._keep,
                on_failed=self._tell_failure,
                quiet=True,
            )
            self._job.cancelled.connect(self._tell_cancelled)
        else:
            self.stopped.emit("The images of this view are not on disk. Open the project that contains them.")

    @Slot(str, str)
    def draw(self, camera: str, kind: Kind) -> None:
        """Render one camera of the last analysed view."""
        last = self._last
        if last is not None:
            self._runner.run("Drawing", lambda _job: render_image(last.view, camera, kind), self._tell_drawn, quiet=True)

    @Slot()
    def cancel(self) -> None:
        """Cancel analysis and rendering."""
        self._runner.cancel()

    @Slot()
    def _forget(self) -> None:
        self.cancel()
        self._last = None

    @Slot(object)
    def _keep(self, found: Explanation) -> None:
        self._last, self._job = found, None
        self.explained.emit(found)

    @Slot(object)
    def _tell_drawn(self, image: DrawnImage) -> None:
        if self._last is not None and image.view is self._last.view:
            self.drawn.emit(image)

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        if self.sender() is self._job:
            self.stopped.emit(str(error))

    @Slot()
    def _tell_cancelled(self) -> None:
        if self.sender() is self._job:  # another view may be requested already
            self.stopped.emit("")


def explain(folder: Path, viewpoint_id: str, job: Job) -> Explanation:
    """Decode and reconstruct one stored view; runs on a job's thread."""
    job.report(0, 1, tr("Reading the images of {viewpoint_id}", viewpoint_id=viewpoint_id))
    from measureapp.pipeline.why import explain_view
    from measureapp.project.folder import ProjectFolder

    view = explain_view(ProjectFolder.open(folder), viewpoint_id, job)
    job.check()
    return Explanation(view, view.shares())


def render_image(view: ExplainedView, camera: str, kind: Kind) -> DrawnImage:
    """Render one camera's image; runs on a job's thread."""
    from measureapp.pipeline.why_pictures import grey_picture, picture

    if kind == "grey":
        grey = grey_picture(view.phase_maps[camera])
        return DrawnImage(view, camera, kind, np.repeat(grey[..., None], 3, axis=2), ())
    drawn = picture(view, camera, kind)
    return DrawnImage(view, camera, kind, drawn.pixels, drawn.legend)
