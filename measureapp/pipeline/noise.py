"""Measurement of the camera noise by the rig, and its use in decoding."""

from __future__ import annotations

import numpy as np

from measureapp.acquire.capture import PLAIN_LIGHT, SHOW_TIMEOUT_S, grab_checked, move_to, set_exposure
from measureapp.arrays import ImageArray
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError
from measureapp.fringe.noise.photon_transfer import NoiseEstimate, estimate_noise
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import NoProgress, Progress
from measureapp.project.folder import ProjectFolder

LEVELS = (1.0, 0.7, 0.5, 0.35, 0.2, 0.1, 0.05)  # relative to the longest exposure that is not mostly saturated
LIT, LEAST_LIT = 0.02, 0.001  # least grey level of a lit pixel relative to saturation; least fraction of lit pixels
MOST_SATURATED, DIMMER, TRIES = 0.5, 2, 8


def measure_noise(
    rig: Rig, viewpoint: Viewpoint | None = None, repeats: int = 2, progress: Progress | None = None
) -> dict[str, NoiseEstimate]:
    """Estimate the noise of every camera from images in uniform light at several exposures (photon transfer).

    Any stationary scene can be used; its bright and dark areas provide further grey levels. The longest exposure is one at which at
    most half of the lit pixels of a camera are saturated.

    Parameters
    ----------
    viewpoint : where to take the images; None: at the present position
    repeats : images of every exposure

    Raises
    ------
    CalibrationError
        The images of a camera are dark, or saturated at any exposure; names the camera.
    DeviceError
        From the rig.
    """
    progress = progress or NoProgress()
    if viewpoint is not None:
        move_to(rig, viewpoint)
    rig.projector.show(PLAIN_LIGHT, timeout_s=SHOW_TIMEOUT_S)
    estimates = {}
    for number, name in enumerate(rig.cameras):
        progress.report(number, len(rig.cameras), f"noise of camera {name}")
        estimates[name] = _measure_camera(rig, name, repeats)
    progress.report(1, 1, "noise measured")
    return estimates


def decode_settings_of(project: ProjectFolder) -> DecodeSettings:
    """Return the decode settings of a project, with the measured noise of its cameras. Raises InputError."""
    return DecodeSettings(camera_noise=project.noise())


def describe_noise(project: ProjectFolder) -> dict[str, str]:
    """Describe the noise model of every camera of a project, and whether it was measured. Raises InputError."""
    settings = decode_settings_of(project)
    words = {}
    for camera in project.rig().cameras:
        model = settings.noise_of(camera.name)
        source = "measured" if camera.name in settings.camera_noise else "assumed"
        words[camera.name] = f"{source}: full well {model.full_well_e:.0f} e, read noise {model.read_noise_e:.1f} e"
    return words


def _measure_camera(rig: Rig, name: str, repeats: int) -> NoiseEstimate:
    saturation = rig.description.camera(name).saturation
    longest_us = _longest_us(rig, name, saturation)
    exposures = sorted({max(1, round(longest_us * level)) for level in LEVELS}, reverse=True)
    return estimate_noise([_grab_repeatedly(rig, name, exposure, repeats) for exposure in exposures], saturation, name)


def _grab_repeatedly(rig: Rig, name: str, exposure_us: int, repeats: int) -> ImageArray:
    camera = rig.cameras[name]
    set_exposure({name: camera}, exposure_us)
    return np.stack([grab_checked(camera, exposure_us, PLAIN_LIGHT) for _ in range(repeats)])


def _longest_us(rig: Rig, name: str, saturation: int) -> int:
    exposure = max(rig.description.exposures_us)
    for _ in range(TRIES):
        pixels = _grab_repeatedly(rig, name, exposure, 1)
        lit = int((pixels > LIT * saturation).sum())
        if lit < LEAST_LIT * pixels.size:
            raise CalibrationError(
                f"The image of camera {name!r} is dark at {exposure} µs.",
                "Point the cameras at a stationary surface (--plan), and check the projector.",
            )
        if (pixels >= saturation).sum() <= MOST_SATURATED * lit:
            return exposure
        exposure = max(1, exposure // DIMMER)
    raise CalibrationError(f"Camera {name!r} is saturated even at {exposure} µs.", "Reduce the light, or close the aperture.")
