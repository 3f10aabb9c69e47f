"""What other cameras say of the points of one: which they have already, and which their horizontal fringes contradict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid
from measureapp.reconstruct.matching.match import DepthMap, sample_step, sight_of
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectifier import Rectifier
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
    (rows, columns, 2) distance in px between a point's image in the earlier camera and the place with its phase, and the variance of it,
    of samples from all over the image; (0, 0) for none. Of pixels that take part in points already only samples were matched; among all
    others most are wrong, or at borders.
    """
    here, pair, every = views[name], rectifier.pair(name, earlier), sample_step(view.depth_mm.shape)
    shifts = np.zeros((*(-(-length // every) for length in view.depth_mm.shape), 2), np.float32)
    geometry = (pair.here.rectified_from_camera, pair.here.frame, pair.there.frame, pair.there.grid, pair.stride, pair.baseline_mm)
    nothing = (np.zeros((0, 0), np.float32), np.zeros((0, 0), np.uint8))
    there = nothing if measured is None else (measured.depth_mm, measured.fate)
    points = (rectifier.rays(name), here.phase, here.sigma, view.sigma_mm, view.pair_gain, sight_of(name, earlier, views, rectifier))
    surface = (geometry, pair.there.rectified_from_camera[2], rectifier.rays(earlier), *there)
    limits = (settings.agreement_sigmas, settings.agreement_px, every)
    arguments: tuple[Any, ...] = (*points, *surface, *limits)
    in_bands(partial(_in_rows, kernels.keep_new, arguments, (view.depth_mm, view.fate, shifts)), len(view.depth_mm))
    return shifts


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
    in_bands(partial(_in_rows, kernels.check_across, arguments, out), len(view.depth_mm))
    return AcrossCheck(dict(zip(asked, shifts, strict=True)), set_aside)


def _in_rows(kernel: Any, arguments: tuple[Any, ...], out: tuple[Any, ...], start: int, stop: int) -> None:
    kernel(*arguments, start, stop, *out)
