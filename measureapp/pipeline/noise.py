"""Measurement of the camera noise by the rig, and its use in decoding."""

from __future__ import annotations

from measureapp.acquire.engine import run_once
from measureapp.acquire.tasks.uniform import UniformImages, UniformTask
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.fringe.noise.photon_transfer import NoiseEstimate, estimate_noise
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import NoProgress, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.decode_limits_file import read_decode_limits

MEASURED = "measured: full well {full_well} e, read noise {read_noise} e"
ASSUMED = "assumed: full well {full_well} e, read noise {read_noise} e"


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


def describe_noise(project: ProjectFolder) -> dict[str, str]:
    """Describe the noise model of every camera of a project, and whether it was measured. Raises InputError."""
    settings = decode_settings_of(project)
    words = {}
    for camera in project.rig().cameras:
        model = settings.noise_of(camera.name)
        said = MEASURED if camera.name in settings.camera_noise else ASSUMED
        words[camera.name] = said.format(full_well=f"{model.full_well_e:.0f}", read_noise=f"{model.read_noise_e:.1f}")
    return words
