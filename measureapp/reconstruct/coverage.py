"""What other cameras say of the points of one: which they have already, and which their horizontal fringes contradict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, in_bands
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels
from measureapp.reconstruct.match import DepthMap, sample_step, sight_of
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
        kernels.observe(
            rectifier.rays(name),
            here.phase,
            here.sigma,
            depth,
            view.sigma_mm,
            view.pair_gain,
            sight,
            start,
            stop,
            seen,
            excess,
            shift,
            variance,
        )
        found = seen == kernels.SEEN
        over, off = excess[found], shift[found]
        noise = variance[found]
        slope = np.abs(over) / np.maximum(np.abs(off), np.float32(1e-9))
        differs = np.abs(over) > settings.agreement_sigmas * np.sqrt(noise) + settings.agreement_px * slope
        fate[rows][points & (seen != kernels.BLANK)] = PointState.SEEN_BY_ANOTHER
        fate[rows][found] = np.where(differs, PointState.CONTRADICTED, PointState.SEEN_BY_ANOTHER)
        depth[rows][points & (seen != kernels.BLANK)] = 0
        return np.column_stack([off, noise / np.maximum(slope, np.float32(1e-9)) ** 2])

    return np.concatenate(in_bands(work, len(depth)))


def check_across(
    name: str,
    others: Sequence[str],
    view: DepthMap,
    across: Mapping[str, PhaseView],
    rectifier: Rectifier,
    settings: ReconstructSettings,
) -> dict[str, FloatArray]:
    """Drop points of ``view`` at which a camera that takes part sees another phase of the horizontal fringes; write their fate.

    The epipolar line and one phase leave the place across the line untested: a moved camera, or another surface with the same phase on a
    line nearby, shows here alone.

    Parameters
    ----------
    across : the horizontal fringes' phases, of the cameras that have them

    Returns
    -------
    per other camera samples (rows, columns, 2) of the distance across the epipolar line in px and its variance; (0, 0) for none
    """
    every = sample_step(view.depth_mm.shape)
    shape = tuple(-(-length // every) for length in view.depth_mm.shape)
    made: dict[str, FloatArray] = {}
    for bit, other in enumerate(others):
        if name not in across or other not in across:
            continue
        here, sight, shifts = across[name], sight_of(name, other, across, rectifier), np.zeros((*shape, 2), np.float32)
        arguments: tuple[Any, ...] = (rectifier.rays(name), here.phase, here.sigma, here.state, view.depth_mm, view.sigma_mm, view.others)
        limits = (bit, sight, settings.agreement_sigmas, settings.agreement_px, every)
        in_bands(partial(_check_rows, (*arguments, *limits), (view.fate, shifts)), len(view.depth_mm))
        made[other] = shifts
    return made


def _check_rows(arguments: tuple[Any, ...], out: tuple[Any, ...], start: int, stop: int) -> None:
    everything: tuple[Any, ...] = (*arguments, start, stop, *out)
    kernels.check_across(*everything)
