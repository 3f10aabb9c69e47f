"""How late a projector shows an image, measured with a camera of its rig."""

from __future__ import annotations

import time

import numpy as np

from measureapp.acquire.session import READ_TIMEOUT_S, RigSession, rendering_s
from measureapp.devices.head_timing import frame_timeout_s
from measureapp.devices.latency import USUAL_FLIPS, ProjectorLatency, measure_latency
from measureapp.devices.rig import Rig
from measureapp.progress import Progress

SHOW_TIMEOUT_S = 2.0
EVERY = 4  # pixels, in rows and columns


def measure_projector_latency(rig: Rig, progress: Progress, *, flips: int = USUAL_FLIPS, hold_s: float = 0.6) -> ProjectorLatency:
    """Flip the projector between black and white and take images with the reference camera all the while; nothing moves.

    The result is too large by at most the time between two images, which is exposure and read-out of the camera.

    Parameters
    ----------
    hold_s : how long each level is shown

    Raises
    ------
    DeviceError
        The levels do not differ in the image, or did not settle before the next flip; and from the devices.
    """
    camera, exposure_us = rig.cameras[rig.description.reference], min(rig.description.exposures_us)
    late_s = frame_timeout_s(camera, exposure_us)
    within_s = late_s + rendering_s([camera])
    flip_times, image_times, greys = [], [], []
    with RigSession(rig, progress) as session:
        size = (rig.projector.height_px, rig.projector.width_px)
        session.load(np.stack([np.zeros(size, np.uint8), np.full(size, 255, np.uint8)]))
        session.call("A camera", lambda: camera.set_exposure_us(exposure_us), READ_TIMEOUT_S)
        session.call("A camera", lambda: camera.arm(flips * (2 + int(hold_s / (exposure_us * 1e-6))), "software"), READ_TIMEOUT_S)
        for flip in range(flips):
            progress.report(flip, flips, "Black and white by turns")
            flip_times.append(time.monotonic())
            session.call("The projector", lambda level=flip % 2: rig.projector.show(level, timeout_s=SHOW_TIMEOUT_S), SHOW_TIMEOUT_S)  # type: ignore[misc]
            while time.monotonic() < flip_times[-1] + hold_s:
                session.call("A camera", camera.trigger, within_s)
                image_times.append(time.monotonic())  # no earlier than the exposure, so that no latency is stated too small
                session.call("A camera", lambda: camera.wait_ready(timeout_s=late_s), within_s)
                frame = session.call("A camera", lambda: camera.next_frame(timeout_s=late_s), within_s)
                greys.append(float(frame.pixels[::EVERY, ::EVERY].mean()))
        session.call("A camera", camera.disarm, READ_TIMEOUT_S)
    return measure_latency(
        np.array(flip_times),
        np.arange(flips) % 2 == 1,
        np.array(image_times),
        np.array(greys),
        exposure_s=exposure_us * 1e-6,
        frame_s=rig.projector.frame_us * 1e-6,
    )
