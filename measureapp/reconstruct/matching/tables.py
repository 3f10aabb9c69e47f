"""Tables of the pixels of both cameras of a pair by epipolar line and phase."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.table import LINES_PER_CELL
from measureapp.reconstruct.phase_view import PhaseView, table_step
from measureapp.reconstruct.rectification.rectifier import EpipolarLines, Rectifier

BIN_PX = 4.0  # width of a bin at the median slope
RANGE_MARGIN_RAD = 2 * np.pi
MIN_BINS, MAX_BINS = 16, 4096


@dataclass(frozen=True, slots=True, eq=False)
class PairTables:
    """The tables of a pair; see `kernels.table`."""

    here: IntArray  # (rows + 2, bins + 2) int32
    there: IntArray  # with gaps filled, and what is repeated in `here`
    lowest_rad: float
    per_rad: float


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One camera of a pair."""

    view: PhaseView
    lines: EpipolarLines

    def slopes_along(self) -> FloatArray:
        """Return |slope of the phase along the epipolar lines| of a sparse choice of pixels."""
        return np.abs(self.view.slopes @ np.array(self.lines.direction))


def pair_sides(name: str, other: str, views: dict[str, PhaseView], rectifier: Rectifier) -> list[Side]:
    """Return both cameras of a pair."""
    return [Side(views[camera], rectifier.lines(name, other, camera)) for camera in (name, other)]


def fringe_sine(sides: Sequence[Side]) -> float:
    """Return the sine of the angle between fringes and epipolar lines, the median of both images; 1 without phases."""
    sines = np.concatenate([side.slopes_along() / np.hypot(*side.view.slopes.T) for side in sides])
    return float(np.median(sines)) if len(sines) else 1.0


def pair_tables(
    name: str,
    others: Sequence[str],
    views: dict[str, PhaseView],
    phase_map: PhaseMap,
    rectifier: Rectifier,
    memory: BufferPool | None = None,
) -> dict[str, PairTables]:
    """Sort camera ``name`` and each of ``others`` by their common epipolar lines; one thread per table.

    Parameters
    ----------
    phase_map : of any camera, for the range of phases
    """
    memory, pairs, jobs = memory or BufferPool(), {}, []
    for other in others:
        sides = pair_sides(name, other, views, rectifier)
        slopes = np.concatenate([side.slopes_along() for side in sides])
        range_rad = 2 * np.pi * phase_map.projector_px / phase_map.pitch_px + 2 * RANGE_MARGIN_RAD
        usual = float(np.median(slopes)) if len(slopes) else 1.0
        bins = int(np.clip(range_rad / max(BIN_PX * usual, 1e-9), MIN_BINS, MAX_BINS))
        shape = (rectifier.pair(name, other).rows // LINES_PER_CELL + 3, bins + 2)
        tables = [memory.empty(shape, np.int32) for _ in sides]
        pairs[other] = PairTables(tables[0], tables[1], -RANGE_MARGIN_RAD, bins / range_rad)
        jobs += [_table_filler(side, pairs[other], table, memory.empty(shape, np.uint8)) for side, table in zip(sides, tables, strict=True)]
    in_bands(lambda start, stop: [job() for job in jobs[start:stop]], len(jobs), len(jobs))
    return {other: _fill_gaps(tables, memory) for other, tables in pairs.items()}


def _table_filler(side: Side, tables: PairTables, table: IntArray, repeated: IntArray) -> Callable[[], None]:
    direction = tuple(np.float32(value) for value in side.lines.direction)
    bins, every = (np.float32(tables.lowest_rad), np.float32(tables.per_rad)), table_step(side.view.phase.shape)
    flat = (repeated.reshape(-1), table.reshape(-1))
    return lambda: kernels.fill_table(side.view.samples, side.lines.sampled_y, direction, *bins, every, table.shape, *flat)


def _fill_gaps(tables: PairTables, memory: BufferPool) -> PairTables:
    """Fill gaps of the other camera's table, and mark in it what is repeated in the first one's."""
    filled = memory.empty(tables.there.shape, np.int32)
    in_bands(lambda start, stop: kernels.fill_gaps(tables.there, tables.here, start, stop, filled), len(filled))
    return PairTables(read_only(tables.here), read_only(filled), tables.lowest_rad, tables.per_rad)
