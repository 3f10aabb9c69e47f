"""Propagation of the covariance of the cameras to pixels over the images and millimetres over the working volume.

Method of [1]_: the covariance of all parameters that the bundle adjustment gives is carried on by the first derivatives of what is
asked for. Board poses and the board's bow are already part of that covariance (they were estimated together with the cameras).

References
----------
.. [1] D. Kogan, mrcal: projection uncertainty and triangulation uncertainty, documentation of mrcal 2, 2020-2024.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.projection import cross_matrices, intrinsic_names, project_with_derivatives
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.uncertainty import ProjectionUncertainty, UncertaintyMap, VolumeUncertainty
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera

POSE_NAMES = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")
MOST_PAIRS = 20000
TINY = 1e-30
LEAST_DEPTH_SHARE = 0.1  # depth of a volume over its distance
LENGTH_TOLERANCE = 0.1  # pairs of points with the required length within this fraction; the error is scaled to it


@dataclass(frozen=True, slots=True)
class WorkingVolume:
    """Where parts are measured: a box before the head, its depth along the mean viewing direction of the cameras."""

    standoff_mm: float  # from the middle between the cameras to the middle of the box
    field_mm: tuple[float, float]
    depth_mm: float  # the box reaches half of it to either side of the standoff
    steps: tuple[int, int, int] = (9, 7, 5)  # points of the grid across, down and in depth


def uncertainty_map(
    calibration: CameraArrayCalibration,
    parameters: Sequence[str],
    covariance: FloatArray,
    volume: WorkingVolume,
    *,
    length_mm: float = 300.0,
    scale_sigma: float = 0.0,
) -> UncertaintyMap:
    """Return the uncertainty of projections and triangulated points.

    Parameters
    ----------
    parameters, covariance : labels ("left.fx", …) and covariance (P, P), as `CameraArraySolution` has them
    volume : where points are measured
    length_mm : the length whose uncertainty is stated
    scale_sigma : relative standard deviation of the board's own lengths, which no image shows; scales everything measured

    Raises
    ------
    CalibrationError
        Fewer than four points of the volume are seen by two cameras.
    """
    projection = {
        name: projection_uncertainty(camera, parameters, covariance, volume.standoff_mm) for name, camera in calibration.cameras.items()
    }
    if len(calibration.cameras) < 2:
        return UncertaintyMap(projection, None)
    return UncertaintyMap(projection, volume_uncertainty(calibration, parameters, covariance, volume, length_mm, scale_sigma))


def projection_uncertainty(
    camera: CameraCalibration, parameters: Sequence[str], covariance: FloatArray, range_mm: float, steps: tuple[int, int] = (24, 18)
) -> ProjectionUncertainty:
    """Return the expected pixel error over the image of one camera, for points ``range_mm`` away.

    What is held fixed: nothing of the world is. Two calibrations of one camera differ by a small motion of the camera's frame (a
    principal point 1 px further right looks almost like a camera turned a little), and that motion moves all cameras and boards with
    it without changing anything measured. As in mrcal's comparison of two models, the motion (rotation and translation) that
    explains most of the change over the image is therefore taken out; what is left is the covariance of what no motion explains.
    The motion is fitted where the camera is certain (weights: the inverse of the uncertainty itself), so that corners of the image
    in which the board was never shown do not spoil its middle.
    """
    pinhole = camera.pinhole
    x, y = np.linspace(0, pinhole.width_px - 1, steps[0]), np.linspace(0, pinhole.height_px - 1, steps[1])
    pixels = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    rough = np.trace(projection_covariance(camera, parameters, covariance, pixels, range_mm), axis1=1, axis2=2)
    weights = 1.0 / np.sqrt(np.maximum(rough, TINY))
    values = np.linalg.eigvalsh(projection_covariance(camera, parameters, covariance, pixels, range_mm, weights))
    shape = (steps[1], steps[0])
    return ProjectionUncertainty(
        camera.name, range_mm, x, y, np.sqrt(values[:, -1]).reshape(shape), np.sqrt(values.sum(axis=1)).reshape(shape)
    )


def projection_covariance(
    camera: CameraCalibration,
    parameters: Sequence[str],
    covariance: FloatArray,
    pixels: FloatArray,
    range_mm: float,
    weights: FloatArray | None = None,
) -> FloatArray:
    """Return the covariance (N, 2, 2) of the projections at ``pixels`` (N, 2); ``weights`` (N,) are those of the removed rigid motion."""
    points = camera.pinhole.rays(pixels) * range_mm
    _, by_point, by_lens = project_with_derivatives(camera.pinhole, points)
    own = _columns(camera.name, intrinsic_names(len(camera.pinhole.distortion)), parameters)
    rows = None if weights is None else np.repeat(weights, 2)
    left = _without(_motions(by_point, points), by_lens.reshape(2 * len(points), -1), rows).reshape(len(points), 2, -1)
    return np.asarray(left @ covariance[np.ix_(own, own)] @ np.swapaxes(left, 1, 2))


def projection_difference(one: PinholeCamera, other: PinholeCamera, pixels: FloatArray, range_mm: float) -> FloatArray:
    """Return the difference (N, 2), px, of the projections by two lenses at ``pixels``, after removal of a rigid motion of the camera's frame."""
    points = one.rays(pixels) * range_mm
    seen, by_point, _ = project_with_derivatives(one, points)
    return _without(_motions(by_point, points), (other.project(points) - seen).reshape(-1, 1)).reshape(-1, 2)


def _motions(by_point: FloatArray, points: FloatArray) -> FloatArray:
    """Derivatives (2N, 6) of pixels by a small rotation and translation of the points."""
    return np.asarray(np.concatenate([-by_point @ cross_matrices(points), by_point], axis=2).reshape(-1, 6))


def volume_uncertainty(
    calibration: CameraArrayCalibration,
    parameters: Sequence[str],
    covariance: FloatArray,
    volume: WorkingVolume,
    length_mm: float = 300.0,
    scale_sigma: float = 0.0,
) -> VolumeUncertainty:
    """Return the covariance of triangulated points and of lengths over the working volume.

    A point is the least-squares intersection, in pixels, of all rays that see it: with parameters wrong by dc it moves by
    dX = -(Σ Jᵀ J)⁻¹ Σ Jᵀ C dc (J: pixel by point, C: pixel by parameters, summed over the cameras). The rigid motion that fits the
    moved grid best is taken out of dX; lengths do not change by it.

    Raises
    ------
    CalibrationError
        Fewer than four points of the volume are seen by two cameras.
    """
    points = volume_points(calibration, volume)
    by_parameters, seeing = point_jacobian(calibration, points, parameters)
    points, by_parameters, seeing = points[seeing >= 2], by_parameters[seeing >= 2], seeing[seeing >= 2]
    if len(points) < 4:
        raise CalibrationError(
            f"Only {len(points)} points of the working volume {volume.standoff_mm:.0f} mm in front of the cameras are seen by two of them.",
            "Give the distance at which parts are measured.",
        )
    columns = np.concatenate([by_parameters, points[:, :, None]], axis=2)  # the board's scale is one parameter more
    centred = points - points.mean(axis=0)
    motion = np.concatenate([-cross_matrices(centred), np.broadcast_to(np.eye(3), (len(points), 3, 3))], axis=2)
    shape = _without(motion.reshape(-1, 6), columns.reshape(3 * len(points), -1)).reshape(columns.shape)
    spread = np.zeros((len(parameters) + 1,) * 2)
    spread[:-1, :-1], spread[-1, -1] = covariance, scale_sigma**2
    ends, sigma = _lengths(points, columns, spread, length_mm)
    worst = int(np.argmax(sigma))
    return VolumeUncertainty(
        points,
        shape @ spread @ np.swapaxes(shape, 1, 2),
        seeing,
        length_mm,
        float(np.sqrt(np.mean(sigma**2))),
        float(sigma[worst]),
        points[ends[worst]],
    )


def observed_volume(calibration: CameraArrayCalibration, places_mm: FloatArray, standoff_mm: float | None = None) -> WorkingVolume:
    """Return the volume in which the board was shown: the reference camera's field there, as deep as the board's places.

    Parameters
    ----------
    places_mm : (N, 3), middles of the board in the frame of the reference camera
    standoff_mm : where parts are measured; None: the median distance of the board
    """
    centre, axes = _head_frame(calibration)
    away = (places_mm - centre) @ axes[2]
    standoff = float(np.median(away)) if standoff_mm is None else standoff_mm
    lens = calibration.cameras[calibration.reference].pinhole
    field = (standoff * lens.width_px / lens.matrix[0, 0], standoff * lens.height_px / lens.matrix[1, 1])
    return WorkingVolume(standoff, field, max(float(np.ptp(away)), LEAST_DEPTH_SHARE * standoff))


def volume_points(calibration: CameraArrayCalibration, volume: WorkingVolume) -> FloatArray:
    """Return the grid of the volume (N, 3) in the frame of the reference camera.

    z is the mean of the viewing directions, from the middle between the cameras; x is the reference camera's, made square to z.
    """
    centre, axes = _head_frame(calibration)
    sides = [
        np.linspace(-0.5, 0.5, count) * side if count > 1 else np.zeros(1) for count, side in zip(volume.steps, _sides(volume), strict=True)
    ]
    grid = np.stack(np.meshgrid(*sides, indexing="ij"), -1).reshape(-1, 3)
    return np.asarray(centre + volume.standoff_mm * axes[2] + grid @ axes)


def _sides(volume: WorkingVolume) -> tuple[float, float, float]:
    return (*volume.field_mm, volume.depth_mm)


def _head_frame(calibration: CameraArrayCalibration) -> tuple[FloatArray, FloatArray]:
    """The middle between the cameras (3,) and the rows x, y, z (3, 3) of the frame of `volume_points`."""
    places = [calibration.cameras[name].reference_from_camera for name in calibration.names]
    z = np.mean([place.rotation[:, 2] for place in places], axis=0)
    z /= np.linalg.norm(z)
    x = np.array([1.0, 0.0, 0.0]) - z[0] * z
    x /= np.linalg.norm(x)
    return np.mean([place.translation_mm for place in places], axis=0), np.stack([x, np.cross(z, x), z])


def point_jacobian(calibration: CameraArrayCalibration, points: FloatArray, parameters: Sequence[str]) -> tuple[FloatArray, IntArray]:
    """Return the derivatives (N, 3, P) of triangulated points by the parameters, and how many cameras see each, (N,).

    Points that fewer than two see do not move with anything: they are not measured.
    """
    normal, mixed = np.zeros((len(points), 3, 3)), np.zeros((len(points), 3, len(parameters)))
    seeing = np.zeros(len(points), int)
    for camera in calibration.cameras.values():
        place = camera.reference_from_camera
        from_centre = points - place.translation_mm
        in_camera = from_centre @ place.rotation
        pixels, by_point, by_lens = project_with_derivatives(camera.pinhole, in_camera)
        size = np.array([camera.pinhole.width_px, camera.pinhole.height_px])
        seen = (in_camera[:, 2] > 0) & np.all((pixels >= -0.5) & (pixels <= size - 0.5), axis=1)
        by_reference = by_point @ place.rotation.T * seen[:, None, None]
        by_pose = np.concatenate([by_reference @ cross_matrices(from_centre), -by_reference], axis=2)
        names = (*intrinsic_names(len(camera.pinhole.distortion)), *POSE_NAMES)
        own = np.concatenate([by_lens, by_pose], axis=2)
        known = [index for index, name in enumerate(names) if f"{camera.name}.{name}" in parameters]
        columns = _columns(camera.name, [names[index] for index in known], parameters)
        mixed[:, :, columns] += np.swapaxes(by_reference, 1, 2) @ own[:, :, known]
        normal += np.swapaxes(by_reference, 1, 2) @ by_reference
        seeing += seen
    normal[seeing < 2], mixed[seeing < 2] = np.eye(3), 0.0
    return -np.linalg.solve(normal, mixed), seeing


def _columns(camera: str, names: Sequence[str], parameters: Sequence[str]) -> list[int]:
    place = {label: index for index, label in enumerate(parameters)}
    return [place[f"{camera}.{name}"] for name in names]


def _without(motion: FloatArray, change: FloatArray, weights: FloatArray | None = None) -> FloatArray:
    """Subtract from the changes (M, K) their weighted least-squares projection on the motions (M, 6)."""
    scaled = motion / np.linalg.norm(motion, axis=0)
    rows = np.ones((len(motion), 1)) if weights is None else weights[:, None]
    return np.asarray(change - scaled @ np.linalg.lstsq(scaled * rows, change * rows, rcond=None)[0])


def _lengths(points: FloatArray, moved_by: FloatArray, spread: FloatArray, length_mm: float) -> tuple[IntArray, FloatArray]:
    """The pairs of points (M, 2) about ``length_mm`` apart and the standard deviation (M,) of that length in their place.

    Where the volume is smaller than the length, its longest pairs are taken and their errors scaled up.
    """
    first, second = np.triu_indices(len(points), 1)
    apart = np.linalg.norm(points[second] - points[first], axis=1)
    wanted = min(length_mm, float(apart.max()) / (1 + LENGTH_TOLERANCE))
    chosen = np.flatnonzero(np.abs(apart / wanted - 1) <= LENGTH_TOLERANCE + 1e-9)
    chosen = chosen[:: max(1, len(chosen) // MOST_PAIRS)]
    first, second, apart = first[chosen], second[chosen], apart[chosen]
    along = (points[second] - points[first]) / apart[:, None]
    change = np.einsum("ni,nip->np", along, moved_by[second] - moved_by[first])
    sigma = np.sqrt(np.maximum(np.einsum("np,pq,nq->n", change, spread, change, optimize=True), 0.0))
    return np.column_stack([first, second]), sigma * length_mm / apart
