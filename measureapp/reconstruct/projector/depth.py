"""The projector as an inverse camera: a camera's ray meets the surface that one projector column (or row) lights."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands, read_only
from measureapp.data.calibration import CameraCalibration, ProjectorCalibration
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.reconstruct.kernels import projector as kernel
from measureapp.reconstruct.projector.fate import ProjectorFate
from measureapp.reconstruct.rectification.rectify import pixel_rays
from measureapp.reconstruct.settings import ReconstructSettings

LEAST_SINE = 0.02  # between the ray and the lit surface: there a depth error is 50 times that of a crosswise look
MARGIN_PX = 3.0  # beyond the projector's image in the direction that the phase measures: blur of its outermost pixels
MARGIN_SHARE = 0.1  # of the image in the other one, which only the calibration tells: its error there does not touch the depth
DISTORTION_TERMS, TILTED = 12, 14


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorDepth:
    """What one camera sees with the help of the projector, on its pixel grid."""

    depth_mm: FloatArray  # (H, W) float32, z in the camera's frame, 0 for none
    sigma_mm: FloatArray  # (H, W) float32, standard deviation of it
    fate: IntArray  # (H, W) uint8 of ProjectorFate
    residual_px: FloatArray | None  # (H, W) float32, off the epipolar line, where both directions were decoded

    @property
    def rejected(self) -> dict[str, int]:
        """How many pixels with a phase gave no point, by reason."""
        counts = np.bincount(self.fate.ravel(), minlength=len(ProjectorFate))
        return {fate.words: int(counts[fate]) for fate in list(ProjectorFate)[2:]}

    @property
    def residual_rms_px(self) -> float | None:
        """Root mean square of the residuals of all points; None for fringes of one direction, which have none."""
        if self.residual_px is None:
            return None
        of_points = self.residual_px[(self.fate == ProjectorFate.POINT) & (self.residual_px != 0)]
        return float(np.sqrt(np.mean(of_points.astype(np.float64) ** 2))) if of_points.size else None


def triangulate_with_projector(
    phase_map: PhaseMap,
    camera: CameraCalibration,
    projector: ProjectorCalibration,
    settings: ReconstructSettings | None = None,
    rays: FloatArray | None = None,
) -> ProjectorDepth:
    """Intersect every pixel's ray with the surface its projector column lights; with both directions by least squares [1]_.

    With distortion a column lights a curved surface: the depth solves *projected column = column of the phase*, by Gauss-Newton steps
    with the exact distortion. The column of a phase is (phase - origin) · pitch / 2π, its origin as the decoder found it; column 0 is
    the centre of the projector's first column. The standard deviation holds the phase noise and the geometry, not the calibration's.

    Parameters
    ----------
    phase_map : of ``camera``; its ``across`` is used where there is one
    settings : `agreement_sigmas` and `agreement_px` limit how far column and row may contradict each other; None for the defaults
    rays : of `Rectifier.rays`, to share them between calls

    Raises
    ------
    ReconstructError
        The images have another size than the camera is calibrated for.

    References
    ----------
    .. [1] S. Zhang, P. S. Huang, Optical Engineering 45(8), 083601, 2006 (projector as an inverse camera).
    """
    _check_size(phase_map, camera.pinhole)
    rays = pixel_rays(camera.pinhole) if rays is None else rays
    vertical, horizontal = _by_direction(phase_map)
    seen = (*_arrays(vertical), *_arrays(horizontal), *_scales(vertical, horizontal))
    geometry = _geometry(camera, projector, vertical, horizontal, settings or ReconstructSettings())
    given: tuple[Any, ...] = (rays, *seen, *geometry)
    shape, both = phase_map.phase_rad.shape, vertical is not None and horizontal is not None
    depth, sigma, fate = np.empty(shape, np.float32), np.empty(shape, np.float32), np.empty(shape, np.uint8)
    residual = np.empty(shape if both else (1, 1), np.float32)
    out: tuple[Any, ...] = (depth, sigma, residual, fate)
    in_bands(lambda start, stop: kernel.triangulate(*(*given, start, stop, *out)), shape[0])
    return ProjectorDepth(read_only(depth), read_only(sigma), read_only(fate), read_only(residual) if both else None)


def lens_of(pinhole: PinholeCamera) -> tuple[FloatArray, FloatArray]:
    """Return the 12 distortion coefficients and the (3, 3) matrix from distorted normalised coordinates to pixels.

    The tilt of an imager (coefficients 13 and 14) is a homography and stands in the matrix.
    """
    lens = np.zeros(DISTORTION_TERMS)
    given = np.asarray(pinhole.distortion)
    lens[: min(len(given), DISTORTION_TERMS)] = given[:DISTORTION_TERMS]
    matrix = np.array(pinhole.matrix)
    if len(given) < TILTED:
        return lens, matrix
    x, y = given[DISTORTION_TERMS:TILTED]
    about_x = np.array([[1, 0, 0], [0, cos(x), sin(x)], [0, -sin(x), cos(x)]])
    about_y = np.array([[cos(y), 0, -sin(y)], [0, 1, 0], [sin(y), 0, cos(y)]])
    turn = about_y @ about_x
    back = np.array([[turn[2, 2], 0, -turn[0, 2]], [0, turn[2, 2], -turn[1, 2]], [0, 0, 1]])
    return lens, np.asarray(matrix @ back @ turn)


def _check_size(phase_map: PhaseMap, pinhole: PinholeCamera) -> None:
    height, width = phase_map.phase_rad.shape
    if (width, height) != (pinhole.width_px, pinhole.height_px):
        raise ReconstructError(
            f"Camera {phase_map.camera!r} is calibrated for {pinhole.width_px} × {pinhole.height_px} px, "
            f"its images have {width} × {height} px.",
            "Use the calibration of the camera and resolution that took the images.",
        )


def _bounds(pinhole: PinholeCamera, vertical: PhaseMap | None, horizontal: PhaseMap | None) -> tuple[float, float, float, float]:
    """Return the lowest and highest column and row that count as inside the projector's image."""
    columns, rows = pinhole.width_px, pinhole.height_px
    over = [MARGIN_PX if seen is not None else MARGIN_SHARE * size for seen, size in ((vertical, columns), (horizontal, rows))]
    return -over[0], columns - 1 + over[0], -over[1], rows - 1 + over[1]


def _geometry(
    camera: CameraCalibration,
    projector: ProjectorCalibration,
    vertical: PhaseMap | None,
    horizontal: PhaseMap | None,
    settings: ReconstructSettings,
) -> tuple[FloatArray, ...]:
    """Return rotation and translation from the camera to the projector, the projector's lens, and the limits, as the kernel wants them."""
    projector_from_camera = projector.reference_from_projector.inverse() @ camera.reference_from_camera
    bounds = _bounds(projector.pinhole, vertical, horizontal)
    limits = np.array([LEAST_SINE, *bounds, settings.agreement_sigmas, settings.agreement_px])
    return np.array(projector_from_camera.rotation), np.array(projector_from_camera.translation_mm), *lens_of(projector.pinhole), limits


def _by_direction(phase_map: PhaseMap) -> tuple[PhaseMap | None, PhaseMap | None]:
    """Return the map of the vertical fringes, and of the horizontal ones."""
    return (phase_map, phase_map.orthogonal) if phase_map.direction == "vertical" else (phase_map.orthogonal, phase_map)


def _arrays(phase_map: PhaseMap | None) -> tuple[FloatArray, FloatArray, IntArray]:
    """Return phase, its standard deviation and state; (1, 1) where there are none."""
    if phase_map is None:
        return read_only(np.zeros((1, 1), np.float32)), read_only(np.zeros((1, 1), np.float32)), read_only(np.ones((1, 1), np.uint8))
    return (
        read_only(phase_map.phase_rad, np.float32),
        read_only(phase_map.sigma_rad, np.float32),
        read_only(phase_map.state, np.uint8),
    )


def _scales(vertical: PhaseMap | None, horizontal: PhaseMap | None) -> tuple[FloatArray, BoolArray]:
    """Return projector pixels per radian and at phase 0 of both directions, (2, 2), and which of them there are, (2,)."""
    maps = (vertical, horizontal)
    return np.array([(1.0, 0.0) if each is None else each.pixel_of_phase() for each in maps]), np.array([each is not None for each in maps])
