"""Points of a clean depth map, written into the arrays of a cloud."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import LOOP

ONE = np.float32(1)


class CloudArrays(NamedTuple):
    """Arrays of a cloud of N points."""

    points: Any  # (N, 3) float64
    normals: Any  # (N, 3) float32
    sigma: Any  # (N,) float32, standard deviation along the viewing ray
    grey: Any  # (N,) float32
    pixel: Any  # (N, 2) int32
    cameras: Any  # (N,) uint8


@njit(**LOOP)
def gather_points(
    inverse: Any,  # (H + 2 r, W + 2 r) float32, inverse depth with a border, 0 for no point
    depth: Any,  # (H, W) float32
    sigma: Any,
    rays: Any,  # (H, 2 W) float32
    normals: Any,  # (3, H, W) float32
    grey: Any,  # (H, W) uint16
    per_grey: Any,  # float32
    cameras: Any,  # (H, W) uint8
    masks: Any,  # (2^M,) uint8, cameras of a point in the order of the calibration, by `cameras`
    pose: Any,  # (3, 4) float64, cloud from camera
    starts: Any,  # (H,) int64, index of the first point of every row
    row_start: int,
    row_stop: int,
    cloud: CloudArrays,  # out
) -> None:
    """Transform the points of some rows into the frame of the cloud."""
    border = (inverse.shape[0] - depth.shape[0]) // 2
    for y in range(row_start, row_stop):
        k = starts[y]
        left, z_row, noise, ray, level = inverse[y + border, border:], depth[y], sigma[y], rays[y], grey[y]
        normal_x, normal_y, normal_z = normals[0, y], normals[1, y], normals[2, y]
        for x in range(depth.shape[1]):
            if left[x] <= 0:
                continue
            ray_x, ray_y, z = ray[2 * x], ray[2 * x + 1], float(z_row[x])
            point_x, point_y = float(ray_x) * z, float(ray_y) * z
            for axis in range(3):
                a, b, c, shift = pose[axis, 0], pose[axis, 1], pose[axis, 2], pose[axis, 3]
                cloud.points[k, axis] = a * point_x + b * point_y + c * z + shift
                cloud.normals[k, axis] = np.float32(a) * normal_x[x] + np.float32(b) * normal_y[x] + np.float32(c) * normal_z[x]
            cloud.sigma[k] = noise[x] * np.sqrt(ONE + ray_x * ray_x + ray_y * ray_y)
            cloud.grey[k] = min(np.float32(level[x]) * per_grey, ONE)
            cloud.pixel[k, 0], cloud.pixel[k, 1] = y, x
            cloud.cameras[k] = masks[cameras[y, x]]
            k += 1
