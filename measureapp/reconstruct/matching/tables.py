"""Both cameras of a pair sorted by epipolar line and phase."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import PhaseView, table_step
from measureapp.reconstruct.rectification.rectifier import EpipolarLines, Rectifier

BIN_PX = 4.0  # width of a bin at the usual slope
RANGE_MARGIN_RAD = 2 * np.pi
MOST_BINS = 4096
LEAST_SINE = kernels.LEAST_SINE


@dataclass(frozen=True, slots=True, eq=False)
class PairTables:
    """The tables of a pair; see `kernels.binning`."""

    here: IntArray  # (rows + 2, bins + 2) int32
    there: IntArray  # gaps filled, and with what is repeated in `here`
    lowest_rad: float
    per_rad: float


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One camera of a pair."""

    view: PhaseView
    lines: EpipolarLines

    def rises(self) -> FloatArray:
        """Return |slope along the epipolar lines| of a sparse choice of pixels."""
        return np.abs(self.view.some_slopes @ np.array(self.lines.direction))


def pair_sides(name: str, other: str, views: dict[str, PhaseView], rectifier: Rectifier) -> list[Side]:
    """Return both cameras of a pair."""
    return [Side(views[camera], rectifier.lines(name, other, camera)) for camera in (name, other)]


def fringe_sine(sides: Sequence[Side]) -> float:
    """Return the sine of the angle between fringes and epipolar lines, the median of both images; 1 where there are no phases."""
    sines = np.concatenate([side.rises() / np.hypot(*side.view.some_slopes.T) for side in sides])
    return float(np.median(sines)) if len(sines) else 1.0


def pair_tables(
    name: str,
    others: Sequence[str],
    views: dict[str, PhaseView],
    maps: PhaseMap,
    rectifier: Rectifier,
    memory: BufferPool | None = None,
) -> dict[str, PairTables]:
    """Sort camera ``name`` and each of ``others`` for their common epipolar lines; one thread per table."""
    memory, made, jobs = memory or BufferPool(), {}, []
    for other in others:
        sides = pair_sides(name, other, views, rectifier)
        rise = np.concatenate([side.rises() for side in sides])
        range_rad = 2 * np.pi * maps.projector_px / maps.pitch_px
        usual = float(np.median(rise)) if len(rise) else 1.0
        bins = int(np.clip((range_rad + 2 * RANGE_MARGIN_RAD) / max(BIN_PX * usual, 1e-9), 16, MOST_BINS))
        per_rad = bins / (range_rad + 2 * RANGE_MARGIN_RAD)
        shape = (rectifier.pair(name, other).rows // kernels.LINES_PER_CELL + 3, bins + 2)
        tables = [memory.empty(shape, np.int32) for _ in sides]
        made[other] = PairTables(tables[0], tables[1], -RANGE_MARGIN_RAD, per_rad)
        scratch = [memory.empty(shape, np.uint8) for _ in sides]
        jobs += [_fill(side, made[other], table, repeated) for side, table, repeated in zip(sides, tables, scratch, strict=True)]
    in_bands(lambda start, stop: [job() for job in jobs[start:stop]], len(jobs), len(jobs))
    return {other: _spread(tables, memory) for other, tables in made.items()}


def _fill(side: Side, tables: PairTables, table: IntArray, repeated: IntArray) -> Callable[[], None]:
    view, (along_x, along_y) = side.view, side.lines.direction
    numbers = [np.float32(value) for value in (along_x, along_y, tables.lowest_rad, tables.per_rad)]
    every = table_step(view.phase.shape)
    arguments: tuple[Any, ...] = (view.samples, side.lines.levels, *numbers, every, table.shape, repeated.reshape(-1), table.reshape(-1))
    return lambda: kernels.fill_table(*arguments)


def _spread(tables: PairTables, memory: BufferPool) -> PairTables:
    """Fill gaps of the other camera's table and mark in it what is repeated in the first one's."""
    wider = memory.empty(tables.there.shape, np.int32)
    in_bands(lambda start, stop: kernels.spread_table(tables.there, tables.here, start, stop, wider), len(wider))
    return PairTables(read_only(tables.here), read_only(wider), tables.lowest_rad, tables.per_rad)
