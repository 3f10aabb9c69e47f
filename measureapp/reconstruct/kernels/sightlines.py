"""Compiled loop that asks of the points of two cameras whether an earlier one sees them, or what it measured hides them from it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.looking import native_pixel, see
from measureapp.reconstruct.kernels.seen import BLANK, SEEN

VALID = int(PointState.VALID)
CONTRADICTED, SEEN_BY_ANOTHER = np.uint8(PointState.CONTRADICTED), np.uint8(PointState.SEEN_BY_ANOTHER)
ZERO = np.float32(0)
STEEPEST = 3.0  # px of disparity that a surface changes by per pixel along an epipolar line, where it is one surface
BEHIND_PX = 4.0  # and what the borders of surfaces are uncertain by


@njit(**INLINE)
def is_hidden(nx: Any, ny: Any, z: Any, geometry: Any, there_axis: Any, there_rays: Any, there_depth: Any, there_fate: Any) -> bool:
    """Whether a surface that the earlier camera measured hides the point at depth ``z`` of the ray (nx, ny) from it.

    The line of sight is followed from the point, which lies behind that surface, towards its own camera. In the earlier camera's
    rectified image the line runs along a row, nearer by a pixel of disparity with every pixel. Where it comes out from behind the
    surface at a border, far before the surface beyond, the point is hidden from the earlier camera alone. Where it would have to pierce
    the surface, whose disparity changes little from pixel to pixel, or leaves the image unseen, the point is not believed.
    """
    turn, frame, there_frame, grid, stride, baseline = geometry
    height, width = there_depth.shape
    focal = there_frame[0]
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    line = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
    disparity = focal * baseline / (rz * z)
    at = focal * (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz - disparity - there_frame[1]
    hidden = False
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
            hidden = before - behind > STEEPEST * since + BEHIND_PX and before > STEEPEST * since + BEHIND_PX
            break
        before, since = behind, 0.0
    return hidden


@njit(**LOOP)
def keep_new(
    rays: Any,  # (H, W, 2) float32
    phase: Any,
    sigma: Any,
    z_sigma: Any,  # (H, W) float32, of the points
    pair_gain: Any,  # (H, W) float32, of the points, see `fuse`; (0, 0) for points of more than two cameras
    other: Any,  # what `see` needs of the earlier camera
    geometry: Any,  # of the pair, with the earlier camera as the other one: (turn, frame, frame there, grid, stride, baseline)
    there_axis: Any,  # (3,) depth in the pair's axes of a point at depth 1 of the earlier camera's ray, by (x, y, 1)
    there_rays: Any,
    there_depth: Any,  # what the earlier camera measured; (0, 0) for nothing
    there_fate: Any,
    sigmas: Any,
    tolerance_px: Any,
    sample: int,  # every so many pixels the shift of a point is noted
    row_start: int,
    row_stop: int,
    depth: Any,  # in and out (H, W) float32, 0 for none
    fate: Any,  # in and out (H, W) uint8 of PointState
    shifts: Any,  # out (rows of samples, columns of samples, 2) float32, shift in the earlier camera in px and its variance; 0, 0 for none
) -> None:
    """Leave only points around which an earlier camera has no phase, or that something hides from it.

    The depth of a point has the noise of the pixel's own phase in it, as the excess that the earlier camera sees has: they are not
    independent. Of a point of two cameras it is known by how much.
    """
    known_gain = len(pair_gain) > 0
    for y in range(row_start, row_stop):
        z_row = depth[y]
        highest = ZERO
        for x in range(len(z_row)):
            highest = max(highest, z_row[x])
        if highest == ZERO:
            continue
        for x in range(len(z_row)):
            z = z_row[x]
            if z <= 0:
                continue
            nx, ny = rays[y, x, 0], rays[y, x, 1]
            sight, excess, along, gain, noise, _here, _xt, _yt = see(phase[y, x], nx, ny, z, other)
            if sight == BLANK:
                continue
            own = float(sigma[y, x]) ** 2
            common = 2 * own * gain / pair_gain[y, x] if known_gain else 0.0
            variance = noise + own + (gain * z_sigma[y, x]) ** 2 - common
            differs = sight == SEEN and abs(excess) > sigmas * np.sqrt(variance) + tolerance_px * abs(along)
            asked = differs or sight != SEEN
            if asked and is_hidden(nx, ny, z, geometry, there_axis, there_rays, there_depth, there_fate):
                continue
            fate[y, x] = CONTRADICTED if differs else SEEN_BY_ANOTHER
            z_row[x] = ZERO
            if sight == SEEN and y % sample == 0 and x % sample == 0:
                shifts[y // sample, x // sample, 0] = excess / along
                shifts[y // sample, x // sample, 1] = variance / along**2
