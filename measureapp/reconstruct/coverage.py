"""What other cameras say of the points of one: which they have already, and which their horizontal fringes contradict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels
from measureapp.reconstruct.clean import DepthGrid
from measureapp.reconstruct.match import DepthMap, sample_step, sight_of
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings


def keep_new(
    name: str,
    earlier: str,
    view: DepthMap,
    views: Mapping[str, PhaseView],
    measured: DepthGrid | None,
    rectifier: Rectifier,
    settings: ReconstructSettings,
) -> FloatArray:
    """Leave in ``view`` only points of camera ``name`` whose surroundings camera ``earlier`` has no phase of; write the others' fate.

    A point also stays that a surface hides from the earlier camera: one that it has measured, behind whose border the line of sight
    from ``name`` to the point runs.

    Parameters
    ----------
    measured : the cleaned points of the earlier camera, on its grid; None where it has none of its own

    Returns
    -------
    (N, 2) distance in px between a point's image in the earlier camera and the place with its phase, and the variance of it, of samples
    from all over the image
    """
    here, sight = views[name], sight_of(name, earlier, views, rectifier)
    depth, fate, every = view.depth_mm, view.fate, sample_step(view.depth_mm.shape)

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
        slope = np.abs(excess) / np.maximum(np.abs(shift), np.float32(1e-9))
        found = seen == kernels.SEEN
        differs = found & (np.abs(excess) > settings.agreement_sigmas * np.sqrt(variance) + settings.agreement_px * slope)
        known = points & (seen != kernels.BLANK)
        if measured is not None:
            row, column = np.nonzero(differs | (known & ~found))
            hidden = _hidden(name, earlier, depth, np.column_stack([row + start, column]), measured, rectifier)
            known[row[hidden], column[hidden]] = False
        fate[rows][known] = np.where(differs[known], np.uint8(PointState.CONTRADICTED), np.uint8(PointState.SEEN_BY_ANOTHER))
        depth[rows][known] = 0
        # Of pixels that take part in points already only samples were matched; among all others most are wrong, or at borders.
        samples = (slice(-start % every, None, every), slice(None, None, every))
        of_them = (found & known)[samples]
        steep = np.maximum(slope[samples][of_them], np.float32(1e-9))
        return np.column_stack([shift[samples][of_them], variance[samples][of_them] / steep**2])

    return np.concatenate(in_bands(work, len(depth)))


def _hidden(name: str, earlier: str, depth: FloatArray, asked: IntArray, measured: DepthGrid, rectifier: Rectifier) -> BoolArray:
    """Return which of the points at ``asked`` (N, 2), row and column, a surface measured by the earlier camera hides from it, (N,)."""
    pair, hidden = rectifier.pair(name, earlier), np.zeros(len(asked), np.bool_)
    geometry = (pair.here.rectified_from_camera, pair.here.frame, pair.there.frame, pair.there.grid, pair.stride, pair.baseline_mm)
    axis, there = pair.there.rectified_from_camera[2], (rectifier.rays(earlier), measured.depth_mm, measured.fate)
    kernels.hidden_points(rectifier.rays(name), depth, asked, geometry, axis, *there, 0, len(asked), hidden)
    return hidden


@dataclass(frozen=True, slots=True, eq=False)
class AcrossCheck:
    """What the horizontal fringes said of the points of a camera."""

    shifts: Mapping[str, FloatArray]  # other camera -> samples (rows, columns, 2) of the distance across the epipolar line in px, variance
    set_aside: BoolArray  # (H, W), points of others: they agree with each other against this camera; (0, 0) where nothing was compared


def check_across(
    name: str,
    others: Sequence[str],
    view: DepthMap,
    views: Mapping[str, PhaseView],
    across: Mapping[str, PhaseView],
    covered: Mapping[str, IntArray],
    rectifier: Rectifier,
    settings: ReconstructSettings,
) -> AcrossCheck:
    """Drop from the points of ``view`` the cameras that see another phase of the horizontal fringes than two others do.

    The epipolar line and one phase leave the place across the line untested: a moved camera, or another surface with the same phase on a
    line nearby, shows here alone. A point is dropped where no two cameras agree, and left to the others where they agree against ``name``.

    Parameters
    ----------
    across : the horizontal fringes' phases, of the cameras that have them
    covered : per other camera (H, W) uint8, set to 0 where its pixels no longer take part in points
    """
    asked = [other for other in others if other in across] if name in across else []
    if not asked:
        return AcrossCheck({}, np.zeros((0, 0), np.bool_))
    every = sample_step(view.depth_mm.shape)
    shape = tuple(-(-length // every) for length in view.depth_mm.shape)
    shifts, set_aside = np.zeros((len(asked), *shape, 2), np.float32), np.zeros(view.depth_mm.shape, np.bool_)
    here, there = views[name], across[name]
    own = ((here.phase, here.sigma), (there.phase, there.sigma, there.state))
    places = np.array([others.index(other) for other in asked])
    sights = tuple(sight_of(name, other, views, rectifier) for other in others)
    sights_across = tuple(sight_of(name, other, across, rectifier) for other in asked)
    widths = np.array([views[other].phase.shape[1] for other in others])
    points = (view.depth_mm, view.sigma_mm, view.pair_gain, view.others)
    limits = (settings.agreement_sigmas, settings.agreement_px, every)
    out = (view.fate, tuple(covered[other].reshape(-1) for other in others), set_aside, shifts)
    arguments: tuple[Any, ...] = (rectifier.rays(name), *own, *points, places, sights, sights_across, widths, *limits)
    in_bands(partial(_check_rows, arguments, out), len(view.depth_mm))
    return AcrossCheck(dict(zip(asked, shifts, strict=True)), set_aside)


def _check_rows(arguments: tuple[Any, ...], out: tuple[Any, ...], start: int, stop: int) -> None:
    everything: tuple[Any, ...] = (*arguments, start, stop, *out)
    kernels.check_across(*everything)
