"""Measurement of the camera noise by the rig, and its use in decoding."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

from measureapp.acquire.engine import run_once
from measureapp.acquire.tasks.uniform import UniformImages, UniformTask
from measureapp.data.measurement import ViewResult
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.fringe.noise.photon_transfer import NoiseEstimate, estimate_noise
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import NoProgress, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.decode_limits_file import read_decode_limits

MEASURED = "measured: full well {full_well} e, read noise {read_noise} e"
FROM_IMAGES = "from the fringe images: full well {full_well} e, read noise {read_noise} e"
FROM_COARSE_IMAGES = "from the fringe images: full well {full_well} e, read noise less than their grey levels show"
ASSUMED = "assumed: full well {full_well} e, read noise {read_noise} e"
LEAST_SHOWN_E = 0.05  # of the read noise, as it is rounded


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
    taken: list[UniformImages] = []
    run_once(rig, "noise", viewpoint, UniformTask(repeats, taken.append), progress)
    progress.report(1, 1, "noise measured")
    return {name: estimate_noise(images, rig.description.camera(name).saturation, name) for name, images in taken[0].items()}


def decode_settings_of(project: ProjectFolder) -> DecodeSettings:
    """Return the decode settings of a project: the measured noise of its cameras, and its limits. Raises InputError, StorageError."""
    limits = read_decode_limits(project.path)
    return DecodeSettings(camera_noise=project.noise()).limited(limits.min_modulation, limits.max_phase_sigma_rad)


def describe_noise(project: ProjectFolder, views: Sequence[ViewResult]) -> dict[str, str]:
    """Describe the noise model with which every camera was decoded, and where it comes from; of fringe images the median over the views.

    Raises InputError.
    """
    settings = decode_settings_of(project)
    words = {}
    for camera in project.rig().cameras:
        model, said = settings.noise_of(camera.name), MEASURED if camera.name in settings.camera_noise else ASSUMED
        full_well_e, read_noise_e = model.full_well_e, model.read_noise_e
        seen = [noise for view in views if (noise := view.decode.get(camera.name, {}).get("noise")) and noise["from_images"]]
        if said is ASSUMED and seen:
            full_well_e, read_noise_e = (median(noise[name] for noise in seen) for name in ("full_well_e", "read_noise_e"))
            said = FROM_IMAGES if read_noise_e >= LEAST_SHOWN_E else FROM_COARSE_IMAGES
        words[camera.name] = said.format(full_well=f"{full_well_e:.0f}", read_noise=f"{read_noise_e:.1f}")
    return words
