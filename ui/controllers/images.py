"""Images of a viewpoint and what they decode to, read and computed on a separate thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.controllers.jobs import JobRunner
from ui.controllers.view_work import ViewWorkController
from ui.images.layers import Layer, layers_of
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.fringe import FringeStack
    from measureapp.data.phase import PhaseMap
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


class ImagesController(ViewWorkController[ViewImages]):
    """Loads and decodes the images of viewpoints of the open project."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(session, runner, "Decoding {viewpoint_id}", load_images, parent)


def load_images(folder: Path, viewpoint_id: str, job: Job) -> ViewImages:
    """Read a stored viewpoint, and decode it by both rules; runs on a job's thread. Raises MeasureError."""
    job.report(0, 1, tr("Reading the images of {viewpoint_id}", viewpoint_id=viewpoint_id))
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
