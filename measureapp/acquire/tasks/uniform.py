"""Task: images in uniform light at several exposures, for the noise of the cameras."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.arrays import ImageArray, read_only
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.errors import CalibrationError
from measureapp.progress import Progress

LEVELS = (1.0, 0.7, 0.5, 0.35, 0.2, 0.1, 0.05)  # relative to the longest exposure that is not mostly saturated
LIT, LEAST_LIT = 0.02, 0.001  # least grey level of a lit pixel relative to saturation; least fraction of lit pixels
MOST_SATURATED, DIMMER, TRIES = 0.5, 2, 8

UniformImages = dict[str, list[ImageArray]]  # camera -> for every exposure, long to short: (repeats, height, width)


class UniformTask:
    """Takes every camera's images of a stationary scene at exposures of its own.

    The longest exposure is one at which at most half of the lit pixels of a camera are saturated.

    Parameters
    ----------
    repeats : images of every exposure
    keep : receives the images of all cameras once they are complete
    """

    def __init__(self, repeats: int, keep: Callable[[UniformImages], None]) -> None:
        self._repeats, self._keep = repeats, keep

    def prepare(self, session: RigSession) -> None:
        """Nothing to prepare."""

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> UniformImages:
        """Take the images. Raises CalibrationError for a camera whose images are dark, or saturated at any exposure."""
        taken = {}
        for number, camera in enumerate(session.rig.cameras):
            progress.report(number, len(session.rig.cameras), f"noise of camera {camera}")
            longest_us = _longest_us(session, camera)
            exposures = sorted({max(1, round(longest_us * level)) for level in LEVELS}, reverse=True)
            taken[camera] = [_repeat(session, camera, exposure_us, self._repeats) for exposure_us in exposures]
            on_event(ImageTaken(visit.viewpoint_id, camera, exposures[0], read_only(taken[camera][0][0])))
        return taken

    def check(self, result: UniformImages) -> None:
        """Nothing to compare: the task evaluates its images while it takes them."""

    def keep(self, result: UniformImages) -> None:
        """Pass the images on."""
        self._keep(result)

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was passed on."""


def _repeat(session: RigSession, camera: str, exposure_us: int, repeats: int) -> ImageArray:
    shots = session.shots((PLAIN_LIGHT,) * repeats, (exposure_us,), (camera,))
    return np.stack([shot.frames[camera].pixels for shot in shots])


def _longest_us(session: RigSession, camera: str) -> int:
    saturation = session.rig.description.camera(camera).saturation
    exposure_us = max(session.rig.description.exposures_us)
    for _ in range(TRIES):
        pixels = _repeat(session, camera, exposure_us, 1)
        lit = int((pixels > LIT * saturation).sum())
        if lit < LEAST_LIT * pixels.size:
            raise CalibrationError(
                f"The image of camera {camera!r} is dark at {exposure_us} µs.",
                "Point the cameras at a stationary surface (--plan), and check the projector.",
            )
        if (pixels >= saturation).sum() <= MOST_SATURATED * lit:
            return exposure_us
        exposure_us = max(1, exposure_us // DIMMER)
    raise CalibrationError(f"Camera {camera!r} is saturated even at {exposure_us} µs.", "Reduce the light, or close the aperture.")
