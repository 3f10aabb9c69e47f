"""Task: one plain image of the board per camera, well exposed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.arrays import ImageArray, read_only
from measureapp.data.board import BoardView
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.progress import Progress

BOARD_SATURATED_SHARE = 0.002  # of the pixels of an image; more would hide corners


class BoardTask:
    """Takes an image of each camera in uniform light, at its longest exposure without significant saturation.

    Parameters
    ----------
    keep : receives each view once it is complete
    """

    def __init__(self, keep: Callable[[BoardView], None]) -> None:
        self._keep = keep

    def prepare(self, session: RigSession) -> None:
        """Ask for the board on the table."""
        session.place_on_table("board")

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> BoardView:
        """Take the images, with shorter exposures for the cameras that need them."""
        progress.report(0, 1, f"Images of the board from {visit.viewpoint_id}")
        images = take_well_exposed(session)
        for name, (exposure_us, pixels) in images.items():
            on_event(ImageTaken(visit.viewpoint_id, name, exposure_us, pixels))
        pixels_only = {name: pixels for name, (_, pixels) in images.items()}
        return BoardView(visit.viewpoint_id, pixels_only, visit.readback, session.conditions())

    def check(self, result: BoardView) -> None:
        """Nothing to compare: the task evaluates its images while it takes them."""

    def keep(self, result: BoardView) -> None:
        """Pass the view on."""
        self._keep(result)

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was passed on."""


def take_well_exposed(session: RigSession) -> dict[str, tuple[int, ImageArray]]:
    """Return for every camera the longest exposure in µs without significant saturation in uniform light, and its image."""
    rig, found = session.rig, {}
    unexposed = set(rig.cameras)
    for exposure_us in rig.description.exposures_us:
        for shot in session.shots((PLAIN_LIGHT,), (exposure_us,), unexposed):
            for name, frame in shot.frames.items():
                found[name] = (exposure_us, read_only(frame.pixels))
                if np.mean(frame.pixels >= rig.description.camera(name).saturation) <= BOARD_SATURATED_SHARE:
                    unexposed.discard(name)
        if not unexposed:
            break
    return {name: found[name] for name in rig.cameras}
