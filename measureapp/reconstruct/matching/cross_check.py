"""Checks of the points of one camera by others: which surfaces these measured already, and what orthogonal fringes contradict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid
from measureapp.reconstruct.matching.match import CameraSet, DepthMap, sample_step
from measureapp.reconstruct.phase_view import PhaseView


def keep_new(
    name: str, earlier: str, depth_map: DepthMap, camera_set: CameraSet, observing: PhaseView, skip: IntArray, measured: DepthGrid | None
) -> FloatArray:
    """Keep only points of camera ``name`` whose surroundings have no phase in camera ``earlier``; write the state of the others.

    A point is also kept if a surface occludes it from the earlier camera: one that this camera has measured, behind whose edge the line of
    sight from ``name`` to the point runs.

    Parameters
    ----------
    observing : phases of the earlier camera
    measured : the cleaned points of the earlier camera, on its grid; None where it has none of its own

    Returns
    -------
    (rows, columns, 2) distance in px between a point's image in the earlier camera and the place with its phase, and its variance, of samples
    from all over the image; (0, 0) for none. Of pixels that take part in points already only samples were matched; among all others most
    are wrong, or at discontinuities.
    """
    every, shape = sample_step(depth_map.depth_mm.shape), depth_map.depth_mm.shape
    shifts = np.zeros((*(-(-length // every) for length in shape), 2), np.float32)
    camera, observer = camera_set.camera(name, skip), camera_set.observer(name, earlier, {earlier: observing})
    axis, rays = camera_set.rectifier.pair(name, earlier).there.rectified_from_camera[2], camera_set.rectifier.rays(earlier)
    none = (np.zeros((0, 0), np.float32), np.zeros((0, 0), np.uint8))
    surface = none if measured is None else (measured.depth_mm, measured.state)
    limits, out = camera_set.limits, depth_map.kernel_arrays
    in_bands(
        lambda start, stop: kernels.keep_new(camera, observer, axis, rays, *surface, limits, every, start, stop, out, shifts), shape[0]
    )
    return shifts


@dataclass(frozen=True, slots=True, eq=False)
class OrthogonalCheck:
    """Result of comparing the orthogonal fringes at the points of a camera."""

    shifts: Mapping[str, FloatArray]  # other camera -> samples (rows, columns, 2) of the distance across the epipolar line in px, variance
    set_aside: BoolArray  # (H, W), points of others: they agree with each other against this camera; (0, 0) where nothing was compared


def check_orthogonal(
    name: str,
    others: Sequence[str],
    depth_map: DepthMap,
    camera_set: CameraSet,
    orthogonal: Mapping[str, PhaseView],
    skip: IntArray,
    used: Mapping[str, IntArray],
) -> OrthogonalCheck:
    """Reject from the points of a camera the cameras whose orthogonal fringes contradict two others.

    The epipolar line and one phase leave the place across the line untested: a moved camera, or another surface with the same phase on a
    line nearby, shows here alone. A point is rejected where no two cameras agree, and left to the others where they agree against ``name``.

    Parameters
    ----------
    orthogonal : phases of the orthogonal fringes, of the cameras that have them
    used : per other camera (H, W) uint8, set to 0 where its pixels no longer take part in points
    """
    checked = [other for other in others if other in orthogonal] if name in orthogonal else []
    shape = depth_map.depth_mm.shape
    if not checked:
        return OrthogonalCheck({}, np.zeros((0, 0), np.bool_))
    every = sample_step(shape)
    shifts = np.zeros((len(checked), *(-(-length // every) for length in shape), 2), np.float32)
    set_aside = np.zeros(shape, np.bool_)
    own = orthogonal[name]
    cameras = (
        camera_set.camera(name, skip),
        (own.phase, own.sigma, own.state),
        np.array([others.index(other) for other in checked]),
        tuple(camera_set.observer(name, other) for other in others),
        tuple(camera_set.observer(name, other, orthogonal) for other in checked),
        np.array([camera_set.phases[other].phase.shape[1] for other in others]),
    )
    limits, out = camera_set.limits, depth_map.kernel_arrays
    marks = tuple(used[other].reshape(-1) for other in others)
    in_bands(lambda start, stop: kernels.check_orthogonal(*cameras, limits, every, start, stop, out, marks, set_aside, shifts), shape[0])
    return OrthogonalCheck(dict(zip(checked, shifts, strict=True)), set_aside)
