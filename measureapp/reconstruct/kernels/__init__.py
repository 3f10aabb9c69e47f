"""Compiled loops of matching, checking, fusing and cleaning; each works on a band of rows and releases the interpreter.

Numba notices a change only in a kernel's own file: kernels that call each other stand in one.
"""

from __future__ import annotations

from measureapp.reconstruct.kernels.borders import continue_borders
from measureapp.reconstruct.kernels.cleaning import fit_planes, island_sizes
from measureapp.reconstruct.kernels.fusing import fuse
from measureapp.reconstruct.kernels.matching import fill_table, match, observe, resample
from measureapp.reconstruct.kernels.seen import BLANK, BORROWED, PARTLY, SEEN

__all__ = [
    "BLANK",
    "BORROWED",
    "PARTLY",
    "SEEN",
    "continue_borders",
    "fill_table",
    "fit_planes",
    "fuse",
    "island_sizes",
    "match",
    "observe",
    "resample",
]
