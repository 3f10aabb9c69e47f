"""Which points of one camera another camera already has."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from measureapp.arrays import FloatArray, in_bands
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels
from measureapp.reconstruct.match import DepthMap, sight_of
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings


def keep_new(
    name: str, earlier: str, view: DepthMap, views: Mapping[str, PhaseView], rectifier: Rectifier, settings: ReconstructSettings
) -> FloatArray:
    """Leave in ``view`` only points of camera ``name`` whose surroundings camera ``earlier`` has no phase of; write the others' fate.

    Returns
    -------
    (N, 2) distance in px between a point's image in the earlier camera and the place with its phase, and the variance of it
    """
    here, sight = views[name], sight_of(name, earlier, views, rectifier)
    depth, fate = view.depth_mm, view.fate

    def work(start: int, stop: int) -> FloatArray:
        rows = slice(start, stop)
        points = depth[rows] > 0
        if not points.any():
            return np.zeros((0, 2), np.float32)
        seen = np.empty(points.shape, np.uint8)
        excess, shift, variance = (np.zeros(points.shape, np.float32) for _ in range(3))
        kernels.observe(rectifier.rays(name), here.phase, depth, sight, start, stop, seen, excess, shift, variance)
        found = seen == kernels.SEEN
        over, off = excess[found], shift[found]
        noise = variance[found] + 2 * here.sigma[rows][found] ** 2
        slope = np.abs(over) / np.maximum(np.abs(off), np.float32(1e-9))
        differs = np.abs(over) > settings.agreement_sigmas * np.sqrt(noise) + settings.agreement_px * slope
        fate[rows][points & (seen != kernels.BLANK)] = PointState.SEEN_BY_ANOTHER
        fate[rows][found] = np.where(differs, PointState.CONTRADICTED, PointState.SEEN_BY_ANOTHER)
        depth[rows][points & (seen != kernels.BLANK)] = 0
        return np.column_stack([off, noise / np.maximum(slope, np.float32(1e-9)) ** 2])

    return np.concatenate(in_bands(work, len(depth)))
