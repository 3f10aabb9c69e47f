"""Structures and constants that the kernels of reconstruction share; arrays are C-contiguous.

A rectified pair has common rows, the epipolar lines. A camera of it is described by its rotation to the rectified axes and its ``frame``
(focal, x0, y0): rectified x = focal · X/Z − x0 and y = focal · Y/Z − y0.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.data.point_state import PointState

LANES = 16  # pixels of a row in one vector; as float32 they fill a cache line

# Fields of a pixel record: phase, its slope along x and y in rad/px ((0, 0) where unknown), its standard deviation.
PHASE, SLOPE_X, SLOPE_Y, SIGMA = range(4)
RECORD = 4
# State of four neighbouring pixels: all valid on one surface; all valid with a depth discontinuity between; some without a phase; nearly all.
NO_QUAD, CONTINUOUS, DISCONTINUOUS, PARTIAL = (np.uint8(state) for state in range(4))
VALID = np.uint8(PointState.VALID)
# Result of matching a pixel with one camera.
UNMATCHED, MATCHED, AMBIGUOUS = (np.uint8(result) for result in range(3))
# Result of interpolating the phase at a place of an image: no pixel around it has one; interpolated; at a discontinuity or hole.
ABSENT, INTERPOLATED, INCOMPLETE = range(3)
MIN_SLOPE = 1e-6  # rad/px along the epipolar line, below which a phase does not determine a place


class PhaseImage(NamedTuple):
    """Phase map of a camera for interpolation; also flat."""

    state: Any  # (H, W) uint8, 0 valid
    records: Any  # (H, W, 4) float32
    quads: Any  # (H, W) uint8, of every pixel with its right, lower and lower right neighbours


class Pair(NamedTuple):
    """Rectified geometry of a camera and another one."""

    rotation: Any  # (3, 3) float64, rectified axes from the camera's
    frame: Any  # (3,) float64
    other_frame: Any  # (3,) float64
    other_grid: Any  # (rows, columns, 2) float32, native pixel (x, y) of the other camera at every `stride`-th rectified pixel
    stride: float
    baseline: float  # mm, along the rectified x axis


class Observer(NamedTuple):
    """Another camera that points of a camera are projected into."""

    image: PhaseImage
    pair: Pair


class Table(NamedTuple):
    """Pixels of a camera by epipolar line and phase, see `table.fill_table`."""

    cells: Any  # (rows + 2, bins + 2) int32, also flat
    lowest: Any  # float32, phase of bin 1
    per_rad: Any  # float32, bins per radian


class Partner(NamedTuple):
    """Camera that another one is matched with; its images are flat."""

    shape: Any  # (H, W)
    phase: Any  # float32
    quads: Any  # uint8
    records: Any  # float32
    rectified: Any  # float32, rectified (x, y) of its pixels
    jacobian: Any  # four cubic polynomials: ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v of these, see `cubic`
    unit: Any
    table: Table  # of this camera, flat, with what is repeated in the matched camera's
    table_shape: Any
    own_rectified: Any  # (H, 2 W) float32, rectified (x, y) of the pixels of the camera that is matched
    depth_axis: Any  # (3,) float32: rectified depth of its ray (x, y, 1)
    focal: Any  # float32
    offset: Any  # float32, x0 of the matched camera less that of this one
    baseline: Any  # float32, mm


class Candidates(NamedTuple):
    """Matches of pixels with another camera, (rows, columns)."""

    depth: Any  # float32, z in the camera's frame in mm, 0 for none
    gain: Any  # float32, change of the other camera's phase with z, rad/mm
    variance: Any  # float32, of the other camera's phase
    pixel: Any  # int32, index of the nearest pixel of the other camera
    reason: Any  # uint8, MATCHED | UNMATCHED | AMBIGUOUS


class DepthArrays(NamedTuple):
    """Depth map of a camera, (H, W)."""

    depth: Any  # float32, z in mm, 0 for none
    sigma: Any  # float32, standard deviation of it
    cameras: Any  # uint8, bit i: the i-th other camera takes part
    state: Any  # uint8 of PointState
    pair_gain: Any  # float32, with one other camera only: change of its phase with z, rad/mm; (0, 0) with more


class Limits(NamedTuple):
    """Largest phase difference between cameras that agree: standard deviations, plus a distance along the epipolar line."""

    sigmas: Any  # float32
    px: Any  # float32


class Surface(NamedTuple):
    """Depth map on the pixel grid as cleaning needs it."""

    inverse: Any  # (H + 2 r, W + 2 r) float32, inverse depth with a border of zeros, 0 for no point
    sigma: Any  # (H, W) float32, of the depth
    rays: Any  # (H, 2 W) float32, normalised image coordinates
    jacobian: Any  # four cubic polynomials: their derivatives
    unit: Any
    step_per_px: Any  # float32, largest depth step between neighbours of one surface, relative to the depth
    radius: int  # r of the window, px


@njit(**INLINE)
def cubic(c: Any, s: Any, t: Any) -> Any:
    """Evaluate a cubic polynomial of two variables; ``s`` = (u − u0) · per u and ``t`` = (v − v0) · per v, ``unit`` = (u0, per u, v0, per v)."""
    return c[0] + s * (c[1] + s * (c[3] + s * c[6])) + t * (c[2] + s * (c[4] + s * c[7]) + t * (c[5] + s * c[8] + t * c[9]))


@njit(**INLINE)
def read(image: Any, at: int) -> Any:
    """Return an element of a flat array; the check for Python's negative indices would keep a loop from becoming SIMD code."""
    return image[np.uint64(at)]


@njit(**INLINE)
def write(image: Any, at: int, value: Any) -> None:
    """Set an element of a flat array, as `read` reads it."""
    image[np.uint64(at)] = value
