"""The projector as an inverse camera: a camera's ray meets the surface that one projector column (or row) illuminates."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.data.calibration import CameraCalibration, ProjectorCalibration
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.projector import Fringes, Output, Projector
from measureapp.reconstruct.projector.state import ProjectorState
from measureapp.reconstruct.rectification.rectify import pixel_rays
from measureapp.reconstruct.settings import ReconstructSettings

MIN_SINE = 0.02  # between the ray and the illuminated surface: there a depth error is 50 times that of perpendicular ones
MARGIN_PX = 3.0  # beyond the projector's image in the direction that the phase measures: blur of its outermost pixels
MARGIN_SHARE = 0.1  # of the image in the other one, which follows from the calibration alone: its error there does not affect the depth
DISTORTION_TERMS, TILTED = 12, 14


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorDepth:
    """What one camera sees together with the projector, on its pixel grid."""

    depth_mm: FloatArray  # (H, W) float32, z in the camera's frame, 0 for none
    sigma_mm: FloatArray  # (H, W) float32, standard deviation of it
    state: IntArray  # (H, W) uint8 of ProjectorState
    residual_px: FloatArray | None  # (H, W) float32, off the epipolar line, where both directions were decoded

    @property
    def rejected(self) -> dict[str, int]:
        """How many pixels with a phase gave no point, by reason."""
        counts = np.bincount(self.state.ravel(), minlength=len(ProjectorState))
        return {state.words: int(counts[state]) for state in list(ProjectorState)[2:]}

    @property
    def residual_rms_px(self) -> float | None:
        """Root mean square of the residuals of all points; None for fringes of one direction, which have none."""
        if self.residual_px is None:
            return None
        of_points = self.residual_px[(self.state == ProjectorState.POINT) & (self.residual_px != 0)]
        return float(np.sqrt(np.mean(of_points.astype(np.float64) ** 2))) if of_points.size else None


def triangulate_with_projector(
    phase_map: PhaseMap,
    camera: CameraCalibration,
    projector: ProjectorCalibration,
    settings: ReconstructSettings | None = None,
    rays: FloatArray | None = None,
) -> ProjectorDepth:
    """Intersect every pixel's ray with the surface its projector column illuminates; with both directions by least squares [1]_.

    With distortion a column illuminates a curved surface: the depth solves *projected column = column of the phase*, by Gauss-Newton steps
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
    inputs = (rays, _fringes(vertical), _fringes(horizontal))
    inverse_camera = _projector(camera, projector, _bounds(projector.pinhole, vertical, horizontal), settings or ReconstructSettings())
    shape, both = phase_map.phase_rad.shape, vertical is not None and horizontal is not None
    residual = np.empty(shape if both else (1, 1), np.float32)
    out = Output(np.empty(shape, np.float32), np.empty(shape, np.float32), residual, np.empty(shape, np.uint8))
    in_bands(lambda start, stop: kernels.triangulate(*inputs, inverse_camera, start, stop, out), shape[0])
    return ProjectorDepth(read_only(out.depth), read_only(out.sigma), read_only(out.state), read_only(residual) if both else None)


def lens_of(pinhole: PinholeCamera) -> tuple[FloatArray, FloatArray]:
    """Return the 12 distortion coefficients and the (3, 3) matrix from distorted normalised coordinates to pixels.

    The tilt of an imager (coefficients 13 and 14) is a homography and part of the matrix.
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


def _projector(
    camera: CameraCalibration, projector: ProjectorCalibration, bounds: tuple[float, ...], settings: ReconstructSettings
) -> Projector:
    """Return the projector in the camera's frame, and the limits of its points."""
    projector_from_camera = projector.reference_from_projector.inverse() @ camera.reference_from_camera
    rotation, centre = np.array(projector_from_camera.rotation), np.array(projector_from_camera.translation_mm)
    distortion, image = lens_of(projector.pinhole)
    sigmas, px = settings.agreement_sigmas, settings.agreement_px
    return Projector(rotation, centre, distortion, image, MIN_SINE, np.array(bounds), sigmas, px)


def _by_direction(phase_map: PhaseMap) -> tuple[PhaseMap | None, PhaseMap | None]:
    """Return the map of the vertical fringes, and of the horizontal ones."""
    return (phase_map, phase_map.orthogonal) if phase_map.direction == "vertical" else (phase_map.orthogonal, phase_map)


def _fringes(phase_map: PhaseMap | None) -> Fringes:
    """Return the phases of one direction, (1, 1) where there are none."""
    if phase_map is None:
        nothing = read_only(np.zeros((1, 1), np.float32))
        return Fringes(nothing, nothing, read_only(np.ones((1, 1), np.uint8)), np.array([1.0, 0.0]), False)
    phase, sigma = read_only(phase_map.phase_rad, np.float32), read_only(phase_map.sigma_rad, np.float32)
    return Fringes(phase, sigma, read_only(phase_map.state, np.uint8), np.array(phase_map.pixel_of_phase()), True)
