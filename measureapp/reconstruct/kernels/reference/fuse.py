"""NumPy statement of fusing the matches of a pixel with all other cameras."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.fuse import BOTH, CONTRADICTION, OCCLUSION_PX, TINY, Camera, Others, OwnTable
from measureapp.reconstruct.kernels.reference.match import match
from measureapp.reconstruct.kernels.reference.reproject import observe
from measureapp.reconstruct.kernels.reference.table import unpack
from measureapp.reconstruct.kernels.structures import ABSENT, AMBIGUOUS, INTERPOLATED, Candidates, DepthArrays, Limits
from measureapp.reconstruct.kernels.table import LINES_PER_CELL, REPEATED


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """Observations of the candidates of N pixels, (M, M, N) each: candidate k by camera c; a candidate's own camera sees what was matched."""

    seen: BoolArray
    excess: FloatArray
    slope: FloatArray
    gain: FloatArray
    variance: FloatArray
    own_x: FloatArray
    y: FloatArray
    excess_variance: FloatArray  # by the noise of both phases


@np.errstate(divide="ignore", invalid="ignore")
def fuse_pairs(
    camera: Camera, found: Candidates, px_per_mm: tuple[float, ...], limits: Limits, row_start: int, row_stop: int, column_start: int,
    column_stop: int, depth: FloatArray, depth_sigma: FloatArray,
) -> None:  # fmt: skip
    """Fuse the candidates of two other cameras that agree, by the normal equations for the depth and the projector's phase."""
    part, used = (slice(row_start, row_stop), slice(column_start, column_stop)), np.s_[:, : column_stop - column_start]
    z, gain, variance = (values[:, *used].astype(np.float64) for values in (found.depth, found.gain, found.variance))
    own = camera.sigma[part].astype(np.float64) ** 2
    px = (camera.rays[part] @ np.array(px_per_mm[:2]) + px_per_mm[2]) * z[1] ** 2  # mm of depth per px, times the depth of the point
    excess = gain[1] * (z[0] - z[1])
    ratio = gain[1] / gain[0]
    spread = variance[1] + own * (ratio - 1) ** 2 + variance[0] * ratio**2
    agrees = np.abs(excess) <= limits.sigmas * np.sqrt(spread) + limits.px * np.abs(gain[1]) * px
    # Equations: phase = 0 ± own; gain_k · dz − phase = −excess_k ± variance_k, for dz from the first candidate.
    zz, zd, dd = (gain**2 / variance).sum(axis=0), -(gain / variance).sum(axis=0), (1 / variance).sum(axis=0) + 1 / own
    determinant = zz * dd - zd**2
    solved = (z[0] > 0) & (z[1] > 0) & agrees & (determinant > 0)
    correction = (-gain[1] * dd - zd) * excess / variance[1] / determinant
    depth[part] = np.where(solved, z[0] + correction, 0)
    depth_sigma[part] = np.where(solved, np.sqrt(dd / determinant), 0)


def match_and_fuse(
    camera: Camera, others: Others, limits: Limits, sample: int, row_start: int, row_stop: int, out: DepthArrays,
    used: tuple[IntArray, ...], shifts: FloatArray, matched: IntArray,
) -> None:  # fmt: skip
    """Match the rows of a band with every other camera and fuse the candidates."""
    count, width, rows = len(others.partners), camera.phase.shape[1], slice(row_start, row_stop)
    shape = (count, row_stop - row_start, width)
    found = Candidates(*(np.zeros(shape, dtype) for dtype in (np.float32, np.float32, np.float32, np.int32, np.uint8)))
    for k, partner in enumerate(others.partners):
        of_one = Candidates(*(values[k] for values in found))
        matched[k] = match(camera.flat_rays, camera.phase, camera.skip, partner, row_start, row_stop, 0, width, of_one)
    out.depth[rows], out.sigma[rows], out.state[rows] = 0, 0, camera.skip[rows]
    if count == 2:
        fuse_pairs(camera, found, others.px_per_mm, limits, row_start, row_stop, 0, width, out.depth, out.sigma)
    fused = out.depth[rows] > 0
    out.cameras[rows] = np.where(fused, BOTH, 0)
    for k, of_camera in enumerate(used):
        of_camera[found.pixel[k][fused]] = 1
    y, x = np.mgrid[rows, :width]
    sampled = (y % sample == 0) & (x % sample == 0)
    chosen = (camera.skip[rows] == 0) & (~fused | sampled)
    if chosen.any():
        of_chosen = Candidates(*(values[:, chosen] for values in found))
        _fuse_pixels(camera, of_chosen, others, limits, y[chosen], x[chosen], sample, out, used, shifts)


def _fuse_pixels(
    camera: Camera, found: Candidates, others: Others, limits: Limits, y: IntArray, x: IntArray, sample: int, out: DepthArrays,
    used: tuple[IntArray, ...], shifts: FloatArray,
) -> None:  # fmt: skip
    """Choose the candidates of N pixels that no camera contradicts and most agree with, and solve for the depth with all that agree."""
    phase, own = camera.phase[y, x].astype(np.float64), camera.sigma[y, x].astype(np.float64) ** 2
    seen = _observe_candidates(found, phase, camera.rays[y, x], own, others)
    _sample_shifts(seen, y, x, sample, shifts)
    has = np.einsum("kkn->kn", seen.seen)
    limit = limits.sigmas * np.sqrt(seen.excess_variance) + limits.px * np.abs(seen.slope)
    agrees = seen.seen & (np.abs(seen.excess) <= limit) | np.eye(len(has), dtype=np.bool_)[:, :, None]
    occluded = np.stack(
        [is_occluded(phase + seen.excess[:, c], seen.own_x[:, c], seen.y[:, c], table) for c, table in enumerate(others.tables)], 1
    )
    contradicted = (seen.seen & ~agrees & ~occluded).any(axis=1)
    support = np.where(has, np.where(contradicted, CONTRADICTION, agrees.sum(axis=1)), 0)
    best, pixel = np.argmax(support, axis=0), np.arange(len(y))
    accepted = support[best, pixel] > 0
    correction, sigma, cameras = _solve(seen, agrees[best, :, pixel].T, best, own)
    solved = accepted & (sigma > 0)
    without = np.where((found.reason == AMBIGUOUS).any(axis=0), PointState.AMBIGUOUS, PointState.UNMATCHED)
    without = np.where(has.any(axis=0), PointState.CONTRADICTED, without)
    out.state[y, x] = np.where(solved, PointState.VALID, np.where(accepted, PointState.AMBIGUOUS, without))
    out.depth[y, x] = np.where(solved, found.depth[best, pixel] + correction, 0)
    out.sigma[y, x] = np.where(solved, sigma, 0)
    out.cameras[y, x] = np.where(solved, cameras, 0)
    for c, of_camera in enumerate(used):
        of_camera[found.pixel[c][accepted & agrees[best, c, pixel] & has[c]]] = 1
    if len(used) == 1:
        out.pair_gain[y[solved], x[solved]] = seen.gain[0, 0][solved]


def _observe_candidates(found: Candidates, phase: FloatArray, rays: FloatArray, own: FloatArray, others: Others) -> Seen:
    """Observe every candidate of N pixels with every other camera."""
    count = len(others.observers)
    fields = np.zeros((6, count, count, len(phase)))
    sight = np.full((count, count, len(phase)), ABSENT)
    for k in range(count):
        has = found.depth[k] > 0
        for c, observer in enumerate(others.observers):
            if c == k:
                sight[k, c, has] = INTERPOLATED
                fields[2, k, c], fields[3, k, c] = found.gain[k], found.variance[k]
                continue
            one = observe(phase[has], rays[has], found.depth[k][has].astype(np.float64), observer)
            sight[k, c, has] = one.sight
            fields[:, k, c, has] = (one.excess, one.slope, one.gain, one.variance, one.own_x, one.y)
    seen, gain, variance = sight == INTERPOLATED, fields[2], fields[3]
    own_gain, own_variance = (np.einsum("kkn->kn", values)[:, None] for values in (gain, variance))
    ratio = gain / np.where(seen, own_gain, 1)
    excess, slope, _gain, _variance, own_x, y = fields
    return Seen(seen, excess, slope, gain, variance, own_x, y, variance + own * (ratio - 1) ** 2 + own_variance * ratio**2)


def _sample_shifts(seen: Seen, y: IntArray, x: IntArray, sample: int, shifts: FloatArray) -> None:
    """Note by how many pixels along the epipolar line other cameras see the candidates shifted, and the variance; the last camera counts."""
    sampled = (y % sample == 0) & (x % sample == 0)
    for k in range(len(shifts)):
        for c in range(len(shifts)):
            chosen = sampled & seen.seen[k, c]
            if c != k:
                slope = seen.slope[k, c][chosen]
                values = (seen.excess[k, c][chosen] / slope, seen.excess_variance[k, c][chosen] / slope**2)
                shifts[k, y[chosen] // sample, x[chosen] // sample] = np.stack(values, axis=-1)


def is_occluded(phase: FloatArray, own_x: FloatArray, y: FloatArray, own: OwnTable) -> BoolArray:
    """Whether phases that another camera sees instead of points belong to surfaces that this camera sees before them."""
    cells = own.table.cells
    row = np.trunc(y / LINES_PER_CELL).astype(int) + 1
    column = np.trunc((phase - own.table.lowest) * own.table.per_rad).astype(int) + 1
    inside = (row >= 1) & (column >= 1) & (row < cells.shape[0] - 1) & (column < cells.shape[1] - 1)
    held = np.where(inside, cells[np.where(inside, row, 0), np.where(inside, column, 0)], -1)
    known = (held >= 0) & (held & REPEATED == 0)
    v, u = unpack(np.where(known, held, 0))
    return np.asarray(known & (own.rectified[v, u, 0] + own.x0 - own_x > OCCLUSION_PX))


@np.errstate(divide="ignore", invalid="ignore")
def _solve(seen: Seen, agrees: BoolArray, best: IntArray, own: FloatArray) -> tuple[FloatArray, FloatArray, IntArray]:
    """Return corrections of the best candidates' depths, their standard deviations (0 without a solution) and the cameras in them."""
    pixel = np.arange(len(best))
    excess, gain, variance = (values[best, :, pixel].T for values in (seen.excess, seen.gain, seen.variance))
    correction, sigma = solve_depth(np.where(agrees, 1 / (variance + TINY), 0.0), gain, excess, own)
    return correction, sigma, (agrees * (1 << np.arange(len(agrees)))[:, None]).sum(axis=0)


@np.errstate(divide="ignore", invalid="ignore")
def solve_depth(weight: FloatArray, gain: FloatArray, excess: FloatArray, own: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve gain · dz − phase = −excess, phase = 0 ± √own by weighted least squares, (M, N); returns dz and its standard deviation, 0 for none."""
    zz, zd, dd = (weight * gain**2).sum(axis=0), -(weight * gain).sum(axis=0), weight.sum(axis=0) + 1 / (own + TINY)
    rz, rd = -(weight * gain * excess).sum(axis=0), (weight * excess).sum(axis=0)
    determinant = zz * dd - zd**2
    solvable = determinant > 0
    return np.where(solvable, (rz * dd - zd * rd) / determinant, 0), np.where(solvable, np.sqrt(dd / determinant), 0)
