"""Matching one camera with all others: by phase along epipolar lines, checked by the cameras that did not take part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.reconstruct import kernels
from measureapp.reconstruct.matching.tables import PairTables
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings

ROWS_PER_BAND = 80
SAMPLES = 160  # along the longer side of an image: shifts between the cameras are noted at so many places


@dataclass(frozen=True, slots=True, eq=False)
class DepthMap:
    """What one camera sees with the help of others; pixels without a point hold 0."""

    depth_mm: FloatArray  # (H, W) float32, z in the camera's frame
    sigma_mm: FloatArray  # (H, W) float32, standard deviation of it
    others: IntArray  # (H, W) uint8, bit i: the i-th other camera takes part
    fate: IntArray  # (H, W) uint8 of PointState
    pair_gain: (
        FloatArray  # (H, W) float32, change of the phase of the only other camera with z, rad/mm, of points; (0, 0) with more cameras
    )
    matched: tuple[int, ...]  # pixels matched with each other camera
    shifts: FloatArray  # (M, rows, columns, 2) float32, places where points of one pair are in the other cameras: px off, variance


def sample_step(shape: tuple[int, ...]) -> int:
    """Return at every how many pixels shifts are noted."""
    return max(1, max(shape[:2]) // SAMPLES)


def match_view(
    name: str,
    others: Sequence[str],
    views: Mapping[str, PhaseView],
    tables: Mapping[str, PairTables],
    skip: IntArray,
    covered: Mapping[str, IntArray],
    rectifier: Rectifier,
    settings: ReconstructSettings,
    memory: BufferPool,
) -> DepthMap:
    """Match camera ``name`` with each of ``others``; candidates that another camera contradicts are dropped, the rest fused.

    The phase of a match is bilinear in the other image, so its variance is known; the pixel of ``name`` itself is not resampled.

    Parameters
    ----------
    skip : (H, W) uint8, 0 for pixels to match
    covered : per other camera (H, W) uint8, set to 1 where its pixels take part in points
    """
    view = views[name]
    shape = view.phase.shape
    every = sample_step(shape)
    made = DepthMap(
        memory.empty(shape, np.float32),
        memory.empty(shape, np.float32),
        memory.empty(shape, np.uint8),
        memory.empty(shape, np.uint8),
        memory.empty(shape if len(others) == 1 else (0, 0), np.float32),
        (),
        np.zeros((len(others), *(-(-length // every) for length in shape), 2), np.float32),
    )
    work = _Work(
        name,
        tuple(others),
        views,
        tables,
        skip,
        tuple(covered[other].reshape(-1) for other in others),
        rectifier,
        settings,
        made,
        every,
    )
    bands = in_bands(work.rows, shape[0], max(8, shape[0] // ROWS_PER_BAND))
    totals = np.sum(bands, axis=0)
    return replace(made, matched=tuple(int(count) for count in totals))


def sight_of(name: str, other: str, views: Mapping[str, PhaseView], rectifier: Rectifier) -> tuple[Any, ...]:
    """Return what the kernels need to look at points of camera ``name`` with ``other``."""
    pair, view = rectifier.pair(name, other), views[other]
    place = (pair.here.rectified_from_camera, pair.here.frame, pair.there.frame, pair.there.grid, pair.stride, pair.baseline_mm)
    return (view.state, view.pixels, view.quad, *place)


def partner_of(name: str, other: str, views: Mapping[str, PhaseView], tables: PairTables, rectifier: Rectifier) -> tuple[Any, ...]:
    """Return what `kernels.match` needs of ``other`` to match camera ``name`` with it."""
    pair, there = rectifier.pair(name, other), views[other]
    lines = rectifier.lines(name, other, other)
    numbers = (pair.here.frame[0], pair.here.frame[1] - pair.there.frame[1], pair.baseline_mm)
    return (
        flat(rectifier.lines(name, other, name).pixels),
        tuple(np.float32(value) for value in pair.here.rectified_from_camera[2]),
        there.phase.shape,
        there.phase.reshape(-1),
        there.quad.reshape(-1),
        there.pixels.reshape(-1),
        lines.pixels.reshape(-1),
        lines.steps.cubics,
        lines.steps.unit,
        tables.there.shape,
        tables.there.reshape(-1),
        np.float32(tables.lowest_rad),
        np.float32(tables.per_rad),
        tuple(np.float32(value) for value in numbers),
    )


def flat(pairs: FloatArray) -> FloatArray:
    """Return a map of pairs (H, W, 2) as rows of numbers (H, 2 W), as the kernels want it."""
    return pairs.reshape(len(pairs), -1)


@dataclass(frozen=True, eq=False)
class _Work:
    """Matches, checks and fuses bands of rows of one camera."""

    name: str
    others: tuple[str, ...]
    views: Mapping[str, PhaseView]
    tables: Mapping[str, PairTables]
    skip: IntArray
    covered: tuple[IntArray, ...]
    rectifier: Rectifier
    settings: ReconstructSettings
    made: DepthMap
    every: int

    def rows(self, start: int, stop: int) -> IntArray:
        """Do the rows from ``start`` to ``stop``; returns how many pixels were matched with each other camera."""
        matched = np.empty(len(self.others), np.int64)
        arguments: tuple[Any, ...] = (*self._arguments, start, stop, *self._out, matched)
        kernels.match_and_fuse(*arguments)
        return matched

    @cached_property
    def _arguments(self) -> tuple[Any, ...]:
        """What is known of this camera and of every other one."""
        rays, view = self.rectifier.rays(self.name), self.views[self.name]
        own = (rays, flat(rays), view.phase, view.sigma, self.skip)
        partners = tuple(partner_of(self.name, other, self.views, self.tables[other], self.rectifier) for other in self.others)
        sights = tuple(sight_of(self.name, other, self.views, self.rectifier) for other in self.others)
        tables = tuple(self._table_of(other) for other in self.others)
        pair = self.rectifier.pair(self.name, self.others[-1])
        step = tuple(np.float32(value / (pair.there.frame[0] * pair.baseline_mm)) for value in pair.here.rectified_from_camera[2])
        limits = (np.float32(self.settings.agreement_sigmas), np.float32(self.settings.agreement_px))
        return (*own, partners, sights, tables, step, limits, self.every)

    @property
    def _out(self) -> tuple[Any, ...]:
        made = self.made
        return made.depth_mm, made.sigma_mm, made.others, made.fate, made.pair_gain, self.covered, made.shifts

    def _table_of(self, other: str) -> tuple[Any, ...]:
        tables, pair = self.tables[other], self.rectifier.pair(self.name, other)
        return tables.here, self.rectifier.lines(self.name, other, self.name).pixels, pair.here.frame, tables.lowest_rad, tables.per_rad
