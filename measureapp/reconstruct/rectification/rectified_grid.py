"""Rectified grid of a pair: with two cameras the cloud is sampled on it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectify import rectify


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedGrid:
    """The rectified images of one camera."""

    camera: CameraCalibration  # a pinhole without distortion at the same place
    native: FloatArray  # (rows, columns, 2) float32, pixel (x, y) of the real camera


def rectified_grid(cameras: CameraArrayCalibration, here: str, there: str) -> RectifiedGrid:
    """Describe camera ``here`` as rectified with camera ``there``."""
    real = cameras.cameras[here]
    pair = rectify(real, cameras.cameras[there])
    focal, x0, y0 = pair.here.frame
    matrix = np.array([[focal, 0, -x0], [0, focal, -y0], [0, 0, 1]])
    pinhole = PinholeCamera(pair.here.width_px, pair.rows, matrix, np.zeros(5))
    turn = RigidTransform.from_parts(pair.here.rectified_from_camera, np.zeros(3), "rectified", real.reference_from_camera.from_frame)
    camera = replace(real, pinhole=pinhole, reference_from_camera=real.reference_from_camera @ turn.inverse())
    shape = (pair.here.width_px, pair.rows)
    coarse = cv2.initUndistortRectifyMap(
        np.asarray(real.pinhole.matrix), np.asarray(real.pinhole.distortion), turn.rotation, matrix, shape, cv2.CV_32FC1
    )
    return RectifiedGrid(camera, read_only(np.stack(coarse, axis=-1), np.float32))


def resample_on_grid(phase_map: PhaseMap, grid: RectifiedGrid, step_rad: float) -> PhaseMap:
    """Resample the phase map of a camera on its rectified grid; the standard deviations are those of the interpolated phases."""
    view = PhaseView.of(phase_map, step_rad)
    shape = grid.native.shape[:2]
    phase, sigma = np.empty(shape, np.float32), np.empty(shape, np.float32)
    state = np.empty(shape, np.uint8)
    hole = int(PixelState.EDGE)
    source = view.kernel_image
    in_bands(lambda start, stop: kernels.resample_phase(source, grid.native, start, stop, phase, sigma, state, hole), shape[0])
    return replace(
        phase_map,
        phase_rad=read_only(phase),
        sigma_rad=read_only(sigma),
        state=read_only(state),
        modulation=_remap(phase_map.modulation, grid),
        grey=_remap(phase_map.grey, grid),
        exposure_index=read_only(_remap(phase_map.exposure_index, grid, cv2.INTER_NEAREST), np.int8),
        orthogonal=None if phase_map.orthogonal is None else resample_on_grid(phase_map.orthogonal, grid, step_rad),
    )


def _remap(image: FloatArray | IntArray, grid: RectifiedGrid, how: int = cv2.INTER_LINEAR) -> FloatArray:
    return np.asarray(read_only(cv2.remap(np.asarray(image, np.float32), grid.native[..., 0].copy(), grid.native[..., 1].copy(), how)))
