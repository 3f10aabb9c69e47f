"""Compiled loops of matching, fusing and cleaning; each works on a band of rows and releases the interpreter.

Numba notices a change only in a kernel's own file: kernels that call each other stand in one.
"""

from __future__ import annotations

from measureapp.reconstruct.kernels.binning import LINES_PER_CELL, fill_table, rectified_lines, spread_table
from measureapp.reconstruct.kernels.cleaning import count_points, drop_islands, find_runs, gather_points, invert, judge
from measureapp.reconstruct.kernels.fusing import fuse, observe, resample
from measureapp.reconstruct.kernels.matching import match
from measureapp.reconstruct.kernels.seen import BLANK, MATCHED, PARTLY, REPEATS, SEEN, WITHOUT_PARTNER
from measureapp.reconstruct.kernels.slopes import slopes

__all__ = [
    "BLANK",
    "LINES_PER_CELL",
    "MATCHED",
    "PARTLY",
    "REPEATS",
    "SEEN",
    "WITHOUT_PARTNER",
    "count_points",
    "drop_islands",
    "fill_table",
    "find_runs",
    "fuse",
    "gather_points",
    "invert",
    "judge",
    "match",
    "observe",
    "rectified_lines",
    "resample",
    "slopes",
    "spread_table",
]
