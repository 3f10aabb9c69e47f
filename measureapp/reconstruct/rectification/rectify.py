"""Rectified pairs: both cameras rotated until rows of one are the epipolar lines of the other. Built once per calibration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RectBivariateSpline

from measureapp.arrays import FloatArray, read_only
from measureapp.data.calibration import CameraCalibration
from measureapp.errors import ReconstructError
from measureapp.geometry.pinhole import PinholeCamera

RAY_NODE_PX = 16
MOST_OBLIQUE = 0.1
LARGEST_GROWTH = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedView:
    """One camera of a pair: x_px = focal · X/Z − x0 and y_px = focal · Y/Z − y0 in axes rotated by `rectified_from_camera`."""

    rectified_from_camera: FloatArray  # (3, 3)
    frame: FloatArray  # (focal, x0, y0)
    width_px: int
    grid: FloatArray  # (rows, columns, 2) float32, native pixel (x, y) at every `stride`-th rectified pixel


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedPair:
    """Two cameras whose rows are common epipolar lines; the other camera's centre lies `baseline_mm` along +x of the first."""

    baseline_mm: float
    rows: int
    stride: float
    here: RectifiedView
    there: RectifiedView


def pixel_rays(pinhole: PinholeCamera) -> FloatArray:
    """Undistort every pixel: exactly at nodes 16 px apart, by cubic splines between (error far below 1e-4 px)."""
    ys = _nodes(pinhole.height_px)
    xs = _nodes(pinhole.width_px)
    u, v = np.meshgrid(xs, ys)
    exact = pinhole.normalise(np.column_stack([u.ravel(), v.ravel()])).reshape(len(ys), len(xs), 2)
    rows, columns = np.arange(pinhole.height_px), np.arange(pinhole.width_px)
    rays = [RectBivariateSpline(ys, xs, exact[..., axis], s=0)(rows, columns) for axis in range(2)]
    return np.asarray(read_only(np.stack(rays, axis=-1), np.float32))


def _nodes(length: int) -> FloatArray:
    return np.linspace(0, length - 1, max(5, int(np.ceil(length / RAY_NODE_PX)) + 1))


def rectify(here: CameraCalibration, there: CameraCalibration) -> RectifiedPair:
    """Rotate two cameras about their centres until their rows coincide: x along the baseline, z nearest to both optical axes.

    Raises
    ------
    ReconstructError
        The cameras are at one place, or look along their baseline.

    References
    ----------
    .. [1] A. Fusiello, E. Trucco, A. Verri, Machine Vision and Applications 12, 16-22, 2000.
    """
    axes, baseline_mm = _rectified_axes(here, there)
    turns = [axes @ camera.reference_from_camera.rotation for camera in (here, there)]
    focal = float(np.mean([camera.pinhole.matrix[[0, 1], [0, 1]].mean() for camera in (here, there)]))
    boxes = [_box(camera.pinhole, turn) for camera, turn in zip((here, there), turns, strict=True)]
    top = max(box[1] for box in boxes)
    bottom = min(box[3] for box in boxes)
    rows = int(np.ceil(focal * (bottom - top))) + 1
    if rows < 2:
        raise ReconstructError(f"Cameras {here.name!r} and {there.name!r} have no epipolar line in common.", "Check the calibration.")
    stride = float(np.clip(round(focal / 1000), 1, 4))
    views = [
        _view(camera.pinhole, turn, focal, (box[0], top, box[2]), rows, stride)
        for camera, turn, box in zip((here, there), turns, boxes, strict=True)
    ]
    return RectifiedPair(baseline_mm, rows, stride, views[0], views[1])


def _rectified_axes(here: CameraCalibration, there: CameraCalibration) -> tuple[FloatArray, float]:
    step = there.reference_from_camera.translation_mm - here.reference_from_camera.translation_mm
    baseline_mm = float(np.linalg.norm(step))
    forward = here.reference_from_camera.rotation[:, 2] + there.reference_from_camera.rotation[:, 2]
    if baseline_mm < 1e-6:
        raise ReconstructError(f"Cameras {here.name!r} and {there.name!r} are at one place.", "Check the calibration.")
    x = step / baseline_mm
    z = forward - x * float(x @ forward)
    if float(np.linalg.norm(z)) < MOST_OBLIQUE:
        raise ReconstructError(f"Cameras {here.name!r} and {there.name!r} look along their baseline.", "Exclude one of them.")
    z /= np.linalg.norm(z)
    return np.stack([x, np.cross(z, x), z]), baseline_mm


def _box(pinhole: PinholeCamera, turn: FloatArray) -> tuple[float, float, float, float]:
    """Return the left, top, right and bottom of the turned image in normalised coordinates."""
    xs, ys = np.linspace(0, pinhole.width_px - 1, 33), np.linspace(0, pinhole.height_px - 1, 33)
    u, v = np.meshgrid(xs, ys)
    rays = pinhole.rays(np.column_stack([u.ravel(), v.ravel()])) @ turn.T
    ahead = rays[rays[:, 2] > MOST_OBLIQUE]
    if len(ahead) == 0:
        raise ReconstructError("A camera of the pair looks along the baseline.", "Exclude one of the cameras.")
    flat = ahead[:, :2] / ahead[:, 2:]
    return float(flat[:, 0].min()), float(flat[:, 1].min()), float(flat[:, 0].max()), float(flat[:, 1].max())


def _view(
    pinhole: PinholeCamera, turn: FloatArray, focal: float, corner: tuple[float, float, float], rows: int, stride: float
) -> RectifiedView:
    left, top, right = corner
    width = min(int(np.ceil(focal * (right - left))) + 1, int(LARGEST_GROWTH * pinhole.width_px))
    ys = np.arange(0, rows + stride, stride)
    xs = np.arange(0, width + stride, stride)
    x, y = np.meshgrid(xs / focal + left, ys / focal + top)
    points = np.column_stack([x.ravel(), y.ravel(), np.ones(x.size)]) @ turn
    native = np.full((len(points), 2), -1.0)
    ahead = _inside(pinhole, points)
    native[ahead] = pinhole.project(points[ahead])
    grid = read_only(native.reshape(len(ys), len(xs), 2), np.float32)
    return RectifiedView(turn, np.array([focal, focal * left, focal * top]), width, grid)


def _inside(pinhole: PinholeCamera, points: FloatArray) -> FloatArray:
    """Return which points lie ahead and not far outside the image, where lens models fold back."""
    border = _box(pinhole, np.eye(3))
    margin = 0.1 * (border[2] - border[0])
    ahead = points[:, 2] > MOST_OBLIQUE * np.linalg.norm(points, axis=1)
    flat = points[:, :2] / np.where(ahead, points[:, 2], 1.0)[:, None]
    x_in = (flat[:, 0] > border[0] - margin) & (flat[:, 0] < border[2] + margin)
    return np.asarray(ahead & x_in & (flat[:, 1] > border[1] - margin) & (flat[:, 1] < border[3] + margin))
