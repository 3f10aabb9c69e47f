"""Which points of one camera another camera already has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, in_bands
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.match import observe_rows, shift_sums
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings


@dataclass(frozen=True, slots=True, eq=False)
class Coverage:
    """What an earlier camera says about points of a later one."""

    new: BoolArray  # (H, W), points whose surroundings the earlier camera has no phase of
    contradicted: int  # points where it sees another phase
    shift_squares: float  # sum of squared shifts along its epipolar lines, px²
    shift_count: int


def coverage(depth_mm: FloatArray, here: PhaseMap, earlier: PhaseMap, rectifier: Rectifier, settings: ReconstructSettings) -> Coverage:
    """Look at the points of camera ``here`` with an earlier one."""
    view, other = (PhaseView.of(seen_by, settings.max_phase_step_rad) for seen_by in (here, earlier))
    pair = rectifier.pair(here.camera, earlier.camera)
    rays = rectifier.rays(here.camera)
    new = np.empty(depth_mm.shape, np.bool_)

    def work(start: int, stop: int) -> tuple[int, float, int]:
        shape = (stop - start, depth_mm.shape[1])
        seen = np.empty(shape, np.uint8)
        excess, shift, gain, variance = (np.empty(shape, np.float32) for _ in range(4))
        observe_rows(view, other, pair, rays, settings, depth_mm[start:stop], (start, stop), (seen, excess, shift, gain, variance))
        limit_rad = settings.agreement_sigmas * np.sqrt(variance + 2 * view.sigma[start:stop] ** 2)
        slope = np.abs(excess) / np.maximum(np.abs(shift), 1e-9)
        differs = np.abs(excess) > limit_rad + settings.agreement_px * slope
        new[start:stop] = (seen == kernels.BLANK) & (depth_mm[start:stop] > 0)
        squares, count = shift_sums(shift, seen)
        return int(((seen == kernels.SEEN) & differs).sum()), float(squares), int(count)

    contradicted, squares, counts = zip(*in_bands(work, len(depth_mm)), strict=True)
    return Coverage(new, sum(contradicted), sum(squares), sum(counts))
