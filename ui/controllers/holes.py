"""Analysis of the holes of a view, recomputed from its stored images on a separate thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.view_work import ViewWorkController
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.pipeline.why import ExplainedView
    from measureapp.pipeline.why_pictures import LegendEntry
    from ui.workers.job import Job

Kind = Literal["grey", "reasons", "exposure", "snr"]


@dataclass(frozen=True, eq=False)
class Explanation:
    """An analysed view, and the shares of all reasons by camera."""

    view: ExplainedView
    shares: Mapping[str, Mapping[str, float]]

    @property
    def viewpoint_id(self) -> str:
        """Viewpoint of the images."""
        return self.view.viewpoint_id


@dataclass(frozen=True, eq=False)
class DrawnImage:
    """The image of one camera in the chosen colours."""

    view: ExplainedView
    camera: str
    kind: Kind
    pixels: np.ndarray  # (H, W, 3) uint8
    legend: tuple[LegendEntry, ...]


class HolesController(ViewWorkController[Explanation]):
    """Analyses views of the open project, and draws the last one; another calibration makes it void."""

    drawn = Signal(object)  # DrawnImage

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(session, runner, "Analysing {viewpoint_id}", explain, parent)
        session.calibrationChanged.connect(self._forget)

    @Slot(str, str)
    def draw(self, camera: str, kind: Kind) -> None:
        """Render one camera of the last analysed view."""
        last = self._last
        if last is not None:
            self._runner.run("Drawing", lambda _job: render_image(last.view, camera, kind), self._tell_drawn, quiet=True)

    @Slot(object)
    def _tell_drawn(self, image: DrawnImage) -> None:
        if self._last is not None and image.view is self._last.view:
            self.drawn.emit(image)


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
