"""Stored images of a viewpoint."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.acquire.events import ImageTaken
    from ui.workers.job import Job


class StoredImagesController(QObject):
    """Shows the first stored image of every camera."""

    imagesReady = Signal(object)  # tuple of ImageTaken

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner = runner

    @Slot(str)
    def show(self, viewpoint_id: str) -> None:
        """Read the images of one viewpoint."""
        folder = self._session.folder
        if folder is not None and (folder / "project.json").exists():
            self._runner.run("Reading images", lambda job: first_images(folder, viewpoint_id, job), self._show, quiet=True)

    @Slot(object)
    def _show(self, images: tuple[ImageTaken, ...]) -> None:
        self.imagesReady.emit(images)


def first_images(folder: Path, viewpoint_id: str, _job: Job) -> tuple[ImageTaken, ...]:
    """Read the first pattern at the longest exposure of every camera; empty if nothing is stored. Runs on a job's thread."""
    from measureapp.acquire.events import ImageTaken
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    if viewpoint_id not in project.stored_viewpoints():
        return ()
    stack = project.frames.load(viewpoint_id, checked=False)  # to be looked at: computing compares every byte
    return tuple(
        ImageTaken(viewpoint_id, camera, stack.exposures_us[0], np.array(images[0, 0])) for camera, images in sorted(stack.images.items())
    )
