"""NumPy statements of what is computed on single images: blur, depth discontinuities, gradients."""

from __future__ import annotations

from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.blur import (
    CURVATURE_SIGMAS,
    EVEN,
    FAR,
    FAR_PER_NEAR,
    HALVES_SIGMAS,
    HORIZON_CURVATURE,
    MAX_LIGHT_SLOPE,
    NEAR,
    RIM_PX,
    SLOPE_REACH,
    SURE_OF_SLOPE,
    Blur,
)
from measureapp.reconstruct.kernels.gradients import CURVATURE_SIGMAS as SMOOTH_SIGMAS
from measureapp.reconstruct.kernels.gradients import MAX_CURVATURE, REACH_PX
from measureapp.reconstruct.kernels.structures import CONTINUOUS, DISCONTINUOUS, NO_QUAD, PARTIAL, RECORD

DIRECTIONS = ((0, 1), (1, 0))  # (dy, dx) of x and y


def shifted(image: FloatArray | IntArray | BoolArray, dy: int, dx: int, margin: int, rows: slice) -> Any:
    """Return some rows of an image shifted by (dy, dx); beyond its border, by at most ``margin``, it is continued by its border."""
    padded = np.pad(image, margin, "edge")
    height, width = image.shape
    begin, end = rows.start + margin + dy, min(rows.stop, height) + margin + dy
    return padded[begin:end, margin + dx : margin + dx + width]


def correct_blur(blur: Blur, row_start: int, row_stop: int, phase: FloatArray, sigma: FloatArray) -> None:
    """Correct the phase of some rows for blur; FAR pixels at every border stay."""
    rows, shape = slice(row_start, row_stop), (blur.height, blur.width)
    blur = blur._replace(**{name: getattr(blur, name).reshape(shape) for name in ("phase", "sigma", "light", "state")})
    phase, sigma = phase.reshape(shape), sigma.reshape(shape)
    phase[rows], sigma[rows] = blur.phase[rows], blur.sigma[rows]
    height, width = shape
    inner = slice(max(row_start, FAR), min(row_stop, height - FAR))
    if width <= 2 * FAR or inner.stop <= inner.start:
        return
    terms = [term for dy, dx in DIRECTIONS for term in (_slope_term(blur, dy, dx, inner), _curvature_term(blur, dy, dx, inner))]
    shift, variance = (np.sum(parts, axis=0) for parts in zip(*terms, strict=True))
    scale = np.where(blur.state[inner] == 0, blur.variance, np.float32(0))
    columns = (inner, slice(FAR, width - FAR))
    phase[columns] = (blur.phase[inner] - scale * shift)[:, FAR:-FAR]
    sigma[columns] = np.sqrt(blur.sigma[inner] ** 2 + scale**2 * variance)[:, FAR:-FAR]


def _slope_term(blur: Blur, dy: int, dx: int, rows: slice) -> tuple[FloatArray, FloatArray]:
    """Return ∇φ · ∇ ln I along one direction, and the square of its uncertainty."""

    def at(image: Any, distance: int) -> Any:
        return shifted(image, distance * dy, distance * dx, FAR, rows)

    missing = blur.state != 0
    runs, holes = [], []
    for side in (-SLOPE_REACH, SLOPE_REACH):
        first, second = at(blur.phase, side) - blur.phase[rows], at(blur.phase, 2 * side) - at(blur.phase, side)
        second = np.where(at(missing, 2 * side), first, second)
        holes.append(at(missing, side))
        runs.append([np.where(holes[-1], 0, np.sign(side) * run) for run in (first, second)])
    one_sided = holes[0] | holes[1]
    inner, further = (runs[0][order] + runs[1][order] for order in range(2))
    run = np.where(one_sided, 3 * inner - further, inner)
    slope = np.where(np.abs(run) < blur.max_step * 2 * SLOPE_REACH, run / (2 * SLOPE_REACH), 0)
    fourth_order = (8 * (at(blur.light, 1) - at(blur.light, -1)) - (at(blur.light, 2) - at(blur.light, -2))) / 12
    light = fourth_order / np.maximum(blur.light[rows], 1)
    taken = np.clip(light, -MAX_LIGHT_SLOPE, MAX_LIGHT_SLOPE)
    unknown = one_sided | at(missing, -NEAR) | at(missing, NEAR) | (np.abs(light) > MAX_LIGHT_SLOPE)
    doubt = np.minimum(np.abs(light), 1) - SURE_OF_SLOPE * np.abs(taken) + HORIZON_CURVATURE / 2 * (1 + blur.interpolation)
    return slope * taken, np.where(unknown, slope * doubt, 0) ** 2


def _curvature_term(blur: Blur, dy: int, dx: int, rows: slice) -> tuple[FloatArray, FloatArray]:
    """Return φ'' (1 - s² φ'²) / 2 along one direction where it is even, and the square of its uncertainty."""

    def at(image: Any, distance: int) -> Any:
        return shifted(image, distance * dy, distance * dx, FAR, rows)

    missing, own = blur.state != 0, 2 * blur.phase[rows]
    far, near = at(blur.phase, -FAR) + at(blur.phase, FAR) - own, FAR_PER_NEAR * (at(blur.phase, -NEAR) + at(blur.phase, NEAR) - own)
    far_run, near_run = at(blur.phase, FAR) - at(blur.phase, -FAR), FAR / NEAR * (at(blur.phase, NEAR) - at(blur.phase, -NEAR))
    allowed = EVEN * np.abs(far)
    even = np.abs(far - near) <= allowed + CURVATURE_SIGMAS * blur.sigma[rows]
    even &= np.abs(far_run - near_run) <= allowed + HALVES_SIGMAS * blur.sigma[rows]
    cut, hidden = at(missing, -FAR) | at(missing, FAR), at(missing, -NEAR) | at(missing, NEAR)
    slope = np.where(cut, near_run, far_run) / (2 * FAR)
    weight = np.maximum(1 - blur.variance * slope**2, 0) + blur.interpolation
    curvature = np.where(cut, near, np.where(even, far, 0))
    uncertainty = np.where(hidden | cut | even, 0, near / FAR**2 * weight)
    return np.where(hidden, 0, curvature / (2 * FAR**2) * weight), uncertainty**2


def mark_discontinuities(state: IntArray, height: int, width: int, row_start: int, row_stop: int, marked: IntArray) -> None:
    """Mark the two pixels beside a hole that is at least two deep, and the one diagonal to it."""
    rows, state, marked = slice(row_start, row_stop), state.reshape(height, width), marked.reshape(height, width)
    marked[rows] = state[rows]
    missing = state != 0

    def at(distance: int, dy: int, dx: int) -> Any:
        return shifted(missing, distance * dy, distance * dx, RIM_PX, rows)

    edge = np.zeros(state[rows].shape, np.bool_)
    for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        edge |= at(2, dy, dx) & (at(1, dy, dx) | at(3, dy, dx))
    for dy, dx in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        edge |= at(1, dy, dx) & at(2, dy, dx)
    y, x = np.mgrid[rows, :width]
    inside = (y >= RIM_PX) & (y < height - RIM_PX) & (x >= RIM_PX) & (x < width - RIM_PX)
    marked[rows][edge & inside & ~missing[rows]] = PointState.RIM


def measure_gradients(
    phase: FloatArray, sigma: FloatArray, state: IntArray, shape: tuple[int, int], max_step: float, every: int, row_start: int,
    row_stop: int, records: FloatArray, quads: IntArray, samples: FloatArray,
) -> None:  # fmt: skip
    """Take central differences over ±3 px where the phase is smooth, else over the neighbours on the same surface."""
    rows, (height, width) = slice(row_start, row_stop), shape
    phase, sigma, state, quads = phase.reshape(shape), sigma.reshape(shape), state.reshape(shape), quads.reshape(shape)
    records = records.reshape(*shape, RECORD)
    missing = np.pad(state != 0, REACH_PX, constant_values=True)
    padded = np.pad(phase, REACH_PX)

    def at(image: Any, dy: int, dx: int) -> Any:
        return image[REACH_PX + rows.start + dy : REACH_PX + min(rows.stop, height) + dy, REACH_PX + dx : REACH_PX + dx + width]

    own, rises, curvatures, narrow = phase[rows], [], [], []
    smooth = ~at(missing, 0, 0)
    for dy, dx in DIRECTIONS:
        before, after = at(padded, -REACH_PX * dy, -REACH_PX * dx), at(padded, REACH_PX * dy, REACH_PX * dx)
        smooth &= ~at(missing, -REACH_PX * dy, -REACH_PX * dx) & ~at(missing, REACH_PX * dy, REACH_PX * dx)
        rises.append(after - before)
        curvatures.append(np.abs(before + after - 2 * own))
        differences = np.stack([own - at(padded, -dy, -dx), at(padded, dy, dx) - own])
        usable = ~np.stack([at(missing, -dy, -dx), at(missing, dy, dx)]) & (np.abs(differences) < max_step)
        narrow.append(np.where(usable, differences, 0).sum(axis=0) / np.maximum(usable.sum(axis=0), 1))
    limit = MAX_CURVATURE * (np.abs(rises[0]) + np.abs(rises[1])) + SMOOTH_SIGMAS * sigma[rows]
    smooth &= np.maximum(*curvatures) <= limit
    slopes = [
        np.where(state[rows] == 0, np.where(smooth, rise / (2 * REACH_PX), near), 0) for rise, near in zip(rises, narrow, strict=True)
    ]
    records[rows] = np.stack([own, *slopes, sigma[rows]], axis=-1)
    corners = [(0, 0), (0, 1), (1, 0), (1, 1)]
    quads[rows] = _quad_states([at(padded, *corner) for corner in corners], [~at(missing, *corner) for corner in corners], max_step)
    sampled = np.arange(-(-row_start // every) * every, min(row_stop, height), every)
    samples[:, sampled // every] = np.moveaxis(records[sampled][:, ::every, :3], -1, 0)


def _quad_states(phases: list[FloatArray], valid: list[BoolArray], max_step: float) -> IntArray:
    """Return the states of pixels with their right, lower and lower right neighbours."""
    spread = np.max(phases, axis=0) - np.min(phases, axis=0)
    upper, lower = valid[0] & valid[1], valid[2] & valid[3]
    partial = upper | lower | ((valid[0] | valid[1]) & (valid[2] | valid[3]))
    whole = np.where(spread <= max_step, CONTINUOUS, DISCONTINUOUS)
    return np.where(upper & lower, whole, np.where(partial, PARTIAL, NO_QUAD)).astype(np.uint8)
