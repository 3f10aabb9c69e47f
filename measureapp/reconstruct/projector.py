"""The projector as an inverse camera: a camera's ray meets the surface that one projector column (or row) lights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from math import cos, sin

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands, read_only
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.cloud import PROJECTOR_BIT, PointCloud
from measureapp.data.fringe import Direction
from measureapp.data.phase import PhaseMap
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.reconstruct.clean import CleanDepth, Partner, clean
from measureapp.reconstruct.kernels import projector as kernel
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings

UNUSUAL = 3.0  # times the median standard deviation
LEAST_SINE = 0.02  # between the ray and the lit surface: there a depth error is 50 times that of a crosswise look
MARGIN_PX = 3.0  # beyond the projector's image in the direction that the phase measures: blur of its outermost pixels
MARGIN_SHARE = 0.1  # of the image in the other one, which only the calibration tells: its error there does not touch the depth
DISTORTION_TERMS, TILTED = 12, 14


class ProjectorFate(IntEnum):
    """What became of a pixel."""

    POINT = kernel.POINT
    NO_PHASE = kernel.NO_PHASE
    PARALLEL = kernel.PARALLEL  # the ray runs nearly along the lit surface
    BEHIND = kernel.BEHIND  # they meet behind the camera or the projector
    OUTSIDE = kernel.OUTSIDE  # they meet outside the projector's image
    UNSOLVED = kernel.UNSOLVED  # the distortion has no inverse there
    CONTRADICTED = kernel.CONTRADICTED  # column and row belong to no point of the ray

    @property
    def words(self) -> str:
        """How it is called among the reasons of rejection."""
        return REASONS[self]


REASONS = {
    ProjectorFate.POINT: "point of the projector",
    ProjectorFate.NO_PHASE: "no phase",
    ProjectorFate.PARALLEL: "parallel to the projector's fringe",
    ProjectorFate.BEHIND: "behind the camera or the projector",
    ProjectorFate.OUTSIDE: "outside the projector's image",
    ProjectorFate.UNSOLVED: "distortion of the projector has no inverse",
    ProjectorFate.CONTRADICTED: "projector's column and row contradict each other",
}


OF_POINT = {
    ProjectorFate.POINT: PointState.VALID,
    ProjectorFate.NO_PHASE: PointState.NO_PHASE,
    ProjectorFate.PARALLEL: PointState.AMBIGUOUS,
    ProjectorFate.BEHIND: PointState.UNMATCHED,
    ProjectorFate.OUTSIDE: PointState.UNMATCHED,
    ProjectorFate.UNSOLVED: PointState.UNMATCHED,
    ProjectorFate.CONTRADICTED: PointState.CONTRADICTED,
}


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


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorReconstruction:
    """The cloud of a single camera and the projector, in frame ``camera``, and how it came about."""

    cloud: PointCloud
    rejected: Mapping[str, int]  # reason -> count
    residual_rms_px: float | None
    fate: IntArray  # (H, W) uint8 of PointState


def triangulate_with_projector(
    phase_map: PhaseMap,
    camera: CameraCalibration,
    projector: ProjectorCalibration,
    settings: ReconstructSettings | None = None,
    rays: FloatArray | None = None,
    direction: Direction = "vertical",
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
    direction : of the fringes of ``phase_map`` itself

    Raises
    ------
    ReconstructError
        The images have another size than the camera is calibrated for.

    References
    ----------
    .. [1] S. Zhang, P. S. Huang, Optical Engineering 45(8), 083601, 2006 (projector as an inverse camera).
    """
    settings = settings or ReconstructSettings()
    shape = phase_map.phase_rad.shape
    _check_size(phase_map, camera.pinhole)
    if rays is None:
        rays = Rectifier(CameraArrayCalibration(camera.name, {camera.name: camera})).rays(camera.name)
    vertical, horizontal = _by_direction(phase_map, direction)
    projector_from_camera = projector.reference_from_projector.inverse() @ camera.reference_from_camera
    lens, image = lens_of(projector.pinhole)
    limits = np.array([LEAST_SINE, *_bounds(projector.pinhole, vertical, horizontal), settings.agreement_sigmas, settings.agreement_px])
    depth, sigma, fate = np.empty(shape, np.float32), np.empty(shape, np.float32), np.empty(shape, np.uint8)
    both = vertical is not None and horizontal is not None
    residual = np.empty(shape if both else (1, 1), np.float32)
    in_bands(
        lambda start, stop: kernel.triangulate(
            rays,
            *_arrays(vertical),
            *_arrays(horizontal),
            np.array([(1.0, 0.0) if each is None else each.pixel_of_phase() for each in (vertical, horizontal)]),
            np.array([vertical is not None, horizontal is not None]),
            np.array(projector_from_camera.rotation),
            np.array(projector_from_camera.translation_mm),
            lens,
            image,
            limits,
            start,
            stop,
            depth,
            sigma,
            residual,
            fate,
        ),
        shape[0],
    )
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


def reconstruct_with_projector(
    phase_map: PhaseMap,
    cameras: CameraArrayCalibration,
    settings: ReconstructSettings | None = None,
    rectifier: Rectifier | None = None,
    direction: Direction = "vertical",
) -> ProjectorReconstruction:
    """Measure with one camera and the projector alone; cleaned as the points of camera pairs are.

    Raises
    ------
    ReconstructError
        The projector or the camera is not calibrated, the images have another size, or no ray meets its column.
    """
    made = measured_with_projector(phase_map, cameras, settings, rectifier, direction)
    lost = {state.words: made.rejected[state.words] for state in list(ProjectorFate)[2:]}
    if sum(lost.values()) == np.count_nonzero(made.fate != PointState.NO_PHASE):
        most = max(lost, key=lambda reason: lost[reason])
        raise ReconstructError(
            f"Camera {phase_map.camera!r} and the projector give no points: {lost[most]} pixels are {most}."
            if lost[most]
            else f"Camera {phase_map.camera!r} has no pixel with a phase.",
            "Check shift_sign, the pitches and that the calibration belongs to these images.",
        )
    return made


def measured_with_projector(
    phase_map: PhaseMap,
    cameras: CameraArrayCalibration,
    settings: ReconstructSettings | None = None,
    rectifier: Rectifier | None = None,
    direction: Direction = "vertical",
) -> ProjectorReconstruction:
    """Do what `reconstruct_with_projector` does, but return an empty cloud with the fate of every pixel where no ray meets its column.

    Raises
    ------
    ReconstructError
        The projector or the camera is not calibrated, or the images have another size.
    """
    settings = settings or ReconstructSettings()
    camera, projector = calibrated(phase_map, cameras)
    rays = (rectifier or Rectifier(cameras)).rays(camera.name)
    made = triangulate_with_projector(phase_map, camera, projector, settings, rays, direction)
    cleaned = clean_with_projector(made.depth_mm, made.sigma_mm, made.depth_mm > 0, (camera, projector), rays, settings)
    cloud = projector_points(cleaned, made.sigma_mm, np.asarray(cleaned.depth_mm > 0), phase_map, cameras, rays)
    met = np.array([OF_POINT[state] for state in ProjectorFate], np.uint8)[made.fate]
    fate = read_only(np.where(made.depth_mm > 0, cleaned.fate, met))
    return ProjectorReconstruction(cloud, made.rejected | cleaned.rejected, made.residual_rms_px, fate)


def calibrated(phase_map: PhaseMap, cameras: CameraArrayCalibration) -> tuple[CameraCalibration, ProjectorCalibration]:
    """Return the calibrations of the map's camera and of the projector; raises ReconstructError where one is missing."""
    if cameras.projector is None:
        raise ReconstructError("The projector is not calibrated.", "Give cameras.json a projector, or use two cameras.")
    if phase_map.camera not in cameras.cameras:
        raise ReconstructError(
            f"Camera {phase_map.camera!r} is not in the calibration, which knows {', '.join(cameras.names)}.",
            "Use the calibration of the cameras that took the images.",
        )
    return cameras.cameras[phase_map.camera], cameras.projector


def clean_with_projector(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    of_projector: BoolArray,
    devices: tuple[CameraCalibration, ProjectorCalibration],
    rays: FloatArray,
    settings: ReconstructSettings,
) -> CleanDepth:
    """Clean a depth map whose pixels ``of_projector`` the projector took part in.

    A projector beside its camera knows depth less well than two cameras far apart: a point is too uncertain beyond three times the
    median of the view, where that is more than the settings allow.
    """
    usual = float(np.median(sigma_mm[depth_mm > 0])) if (depth_mm > 0).any() else 0.0
    settings = settings.model_copy(update={"max_sigma_mm": max(settings.max_sigma_mm, UNUSUAL * usual)})
    camera, projector = devices
    camera_from_reference = camera.reference_from_camera.inverse()
    centre = camera_from_reference.apply(np.array(projector.reference_from_projector.translation_mm))
    spacing = 1.0 / float(camera.pinhole.matrix[0, 0])
    return clean(depth_mm, sigma_mm, rays, spacing, [Partner(centre, of_projector)], settings)


def projector_points(
    cleaned: CleanDepth, sigma_mm: FloatArray, keep: BoolArray, phase_map: PhaseMap, cameras: CameraArrayCalibration, rays: FloatArray
) -> PointCloud:
    """Return the pixels ``keep`` (H, W) of a cleaned depth map as a cloud in frame ``camera``, marked as the projector's."""
    reference_from_camera = cameras.cameras[phase_map.camera].reference_from_camera
    flat = np.column_stack([rays[keep].astype(np.float64), np.ones(int(keep.sum()))])
    depth = cleaned.depth_mm[keep].astype(np.float64)
    bits = (1 << cameras.names.index(phase_map.camera)) | PROJECTOR_BIT
    return PointCloud(
        points_mm=reference_from_camera.apply(flat * depth[:, None]),
        normals=reference_from_camera.rotate(cleaned.normals[keep]),
        sigma_mm=sigma_mm[keep] * np.linalg.norm(flat, axis=1),
        grey=np.clip(phase_map.grey[keep] / phase_map.saturation, 0.0, 1.0),
        pixel=np.argwhere(keep),
        cameras=np.full(len(flat), bits, np.uint8),
        frame="camera",
        viewpoint_id=phase_map.viewpoint_id,
    )


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


def _by_direction(phase_map: PhaseMap, direction: Direction) -> tuple[PhaseMap | None, PhaseMap | None]:
    if direction == "vertical":
        return phase_map, phase_map.across
    return phase_map.across, phase_map


def _arrays(phase_map: PhaseMap | None) -> tuple[FloatArray, FloatArray, IntArray]:
    if phase_map is None:
        return read_only(np.zeros((1, 1), np.float32)), read_only(np.zeros((1, 1), np.float32)), read_only(np.ones((1, 1), np.uint8))
    return (
        read_only(phase_map.phase_rad, np.float32),
        read_only(phase_map.sigma_rad, np.float32),
        read_only(phase_map.state, np.uint8),
    )
