"""Matching one camera with all others: by phase along epipolar lines, checked by the cameras that did not take part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.map_memory import MapMemory
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.tables import PairTables

ROWS_PER_BAND = 48
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
    memory: MapMemory,
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
        memory,
    )
    bands = in_bands(work.rows, shape[0], max(8, shape[0] // ROWS_PER_BAND))
    totals = np.sum(bands, axis=0)
    return replace(made, matched=tuple(int(count) for count in totals))


def sight_of(name: str, other: str, views: Mapping[str, PhaseView], rectifier: Rectifier) -> tuple[Any, ...]:
    """Return what the kernels need to look at points of camera ``name`` with ``other``."""
    pair, view = rectifier.pair(name, other), views[other]
    place = (pair.here.rectified_from_camera, pair.here.frame, pair.there.frame, pair.there.grid, pair.stride, pair.baseline_mm)
    return (view.state, view.pixels, view.quad, *place)


def match_rows(
    name: str,
    other: str,
    views: Mapping[str, PhaseView],
    tables: PairTables,
    skip: IntArray,
    rectifier: Rectifier,
    rows: tuple[int, int],
    out: Sequence[Any],
) -> int:
    """Match rows of camera ``name`` with ``other``; ``out``: depth, gain, variance, place there and reason, (rows, W) each."""
    pair, here, there = rectifier.pair(name, other), views[name], views[other]
    lines = rectifier.lines(name, other, other)
    ray_depth = tuple(np.float32(value) for value in pair.here.rectified_from_camera[2])
    numbers = (pair.here.frame[0], pair.here.frame[1] - pair.there.frame[1], pair.baseline_mm)
    matched = kernels.match(
        rectifier.rays(name).reshape(len(skip), -1),
        here.phase,
        skip,
        rectifier.lines(name, other, name).pixels.reshape(len(skip), -1),
        ray_depth,
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
        rows[0],
        rows[1],
        *out,
    )
    return int(matched)


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
    memory: MapMemory

    def rows(self, start: int, stop: int) -> IntArray:
        """Do the rows from ``start`` to ``stop``; returns how many pixels were matched with each other camera."""
        view, made, settings = self.views[self.name], self.made, self.settings
        shape = (len(self.others), stop - start, view.phase.shape[1])
        found: list[Any] = [self.memory.empty(shape, dtype) for dtype in (np.float32, np.float32, np.float32, np.int32, np.uint8)]
        matched = [
            match_rows(
                self.name, other, self.views, self.tables[other], self.skip, self.rectifier, (start, stop), [part[k] for part in found]
            )
            for k, other in enumerate(self.others)
        ]
        self._fuse_both(found, start, stop)
        own = (self.rectifier.rays(self.name), view.phase, view.sigma, self.skip)
        limits = (settings.agreement_sigmas, settings.agreement_px, self.every)
        out = (made.depth_mm, made.sigma_mm, made.others, made.fate, made.pair_gain, self.covered, made.shifts)
        arguments: tuple[Any, ...] = (*own, *found, *self._seen_by_others, *limits, start, stop, *out)
        kernels.fuse(*arguments)
        return np.array(matched)

    @cached_property
    def _seen_by_others(self) -> tuple[Any, ...]:
        """What the kernels need to look at points with every other camera, and where this one has their phases."""
        sights = tuple(sight_of(self.name, other, self.views, self.rectifier) for other in self.others)
        return sights, tuple(self._table_of(other) for other in self.others)

    def _fuse_both(self, found: Sequence[Any], start: int, stop: int) -> None:
        """Fuse the pixels that two other cameras match alike; all others are left to the general way."""
        if len(self.others) != 2:
            self.made.depth_mm[start:stop] = 0
            self.made.sigma_mm[start:stop] = 0
            return
        pair = self.rectifier.pair(self.name, self.others[1])
        step = tuple(np.float32(value / (pair.there.frame[0] * pair.baseline_mm)) for value in pair.here.rectified_from_camera[2])
        limits = (np.float32(self.settings.agreement_sigmas), np.float32(self.settings.agreement_px))
        out = (self.made.depth_mm, self.made.sigma_mm)
        arguments: tuple[Any, ...] = (
            self.rectifier.rays(self.name).reshape(len(self.skip), -1),
            self.views[self.name].sigma,
            *found[:3],
            step,
            limits,
            start,
            stop,
            *out,
        )
        kernels.fuse_both(*arguments)

    def _table_of(self, other: str) -> tuple[Any, ...]:
        tables, pair = self.tables[other], self.rectifier.pair(self.name, other)
        return tables.here, self.rectifier.lines(self.name, other, self.name).pixels, pair.here.frame, tables.lowest_rad, tables.per_rad
