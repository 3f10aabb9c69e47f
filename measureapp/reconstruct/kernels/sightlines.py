"""Compiled loop that asks whether a surface measured from one camera hides points from it that two others see."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.fusing import native_pixel
from measureapp.reconstruct.kernels.options import LOOP

VALID = int(PointState.VALID)
STEEPEST = 3.0  # px of disparity that a surface changes by per pixel along an epipolar line, where it is one surface
BEHIND_PX = 4.0  # and what the borders of surfaces are uncertain by


@njit(**LOOP)
def hidden_points(
    rays: Any,  # (H, W, 2) float32 of the camera whose points they are
    depth: Any,  # (H, W) float32 of its points
    places: Any,  # (N, 2) int64 row, column of the points to ask about
    geometry: Any,  # of the pair, with the earlier camera as the other one: (turn, frame, frame there, grid, stride, baseline)
    there_axis: Any,  # (3,) depth in the pair's axes of a point at depth 1 of the earlier camera's ray, by (x, y, 1)
    there_rays: Any,
    there_depth: Any,
    there_fate: Any,
    start: int,
    stop: int,
    hidden: Any,  # out (N,) bool
) -> None:
    """Follow the line of sight from a point that lies behind the surface which the earlier camera measured, towards its own camera.

    In the earlier camera's rectified image the line of sight runs along a row, nearer by a pixel of disparity with every pixel. Where it comes
    out from behind the surface at a border, far before the surface beyond, the point is hidden from the earlier camera alone. Where it would
    have to pierce the surface, whose disparity changes little from pixel to pixel, or leaves the image unseen, the point is not
    believed.
    """
    turn, frame, there_frame, grid, stride, baseline = geometry
    height, width = there_depth.shape
    focal = there_frame[0]
    for n in range(start, stop):
        hidden[n] = False
        y, x = places[n, 0], places[n, 1]
        nx, ny = rays[y, x, 0], rays[y, x, 1]
        rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
        line = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
        disparity = focal * baseline / (rz * depth[y, x])
        at = focal * (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz - disparity - there_frame[1]
        before, since = 0.0, 0.0  # how far behind the surface it was when the surface was last seen, and how many pixels ago
        for step in range(width + height):
            u, v, _to_u, _to_v = native_pixel(grid, stride, at - step, line)
            j, i = int(u + 0.5), int(v + 0.5)
            if u < 0 or v < 0 or j >= width or i >= height:
                break
            since += 1.0
            if there_depth[i, j] <= 0 or there_fate[i, j] != VALID:
                if step == 0:
                    break
                continue
            rectified = there_depth[i, j] * (there_axis[0] * there_rays[i, j, 0] + there_axis[1] * there_rays[i, j, 1] + there_axis[2])
            behind = focal * baseline / rectified - disparity - step
            if step == 0 and behind <= BEHIND_PX:
                break
            if behind <= 0:
                hidden[n] = before - behind > STEEPEST * since + BEHIND_PX and before > STEEPEST * since + BEHIND_PX
                break
            before, since = behind, 0.0
