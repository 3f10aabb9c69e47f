"""Compiled loops of matching, fusing and cleaning; each works on a band of rows and releases the interpreter."""

from __future__ import annotations

from measureapp.reconstruct.kernels.across import check_across
from measureapp.reconstruct.kernels.band import match_and_fuse
from measureapp.reconstruct.kernels.binning import LEAST_SINE, LINES_PER_CELL, fill_table, rectified_lines, spread_table
from measureapp.reconstruct.kernels.blur import take_blur
from measureapp.reconstruct.kernels.both import fuse_both
from measureapp.reconstruct.kernels.cleaning import CHUNK, invert, judge
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.covered import mark_covered, mark_without_phase
from measureapp.reconstruct.kernels.gathering import Points, gather_points
from measureapp.reconstruct.kernels.islands import drop_islands, find_runs
from measureapp.reconstruct.kernels.lanes import Found
from measureapp.reconstruct.kernels.looking import resample
from measureapp.reconstruct.kernels.matching import match
from measureapp.reconstruct.kernels.rims import mark_rims
from measureapp.reconstruct.kernels.seen import BLANK, MATCHED, PARTLY, REPEATS, SEEN, WITHOUT_PARTNER
from measureapp.reconstruct.kernels.sightlines import keep_new
from measureapp.reconstruct.kernels.slopes import slopes

__all__ = [
    "BLANK",
    "CHUNK",
    "LEAST_SINE",
    "LINES_PER_CELL",
    "MATCHED",
    "PARTLY",
    "PIXELS",
    "REPEATS",
    "SEEN",
    "WITHOUT_PARTNER",
    "Found",
    "Points",
    "check_across",
    "drop_islands",
    "fill_table",
    "find_runs",
    "fuse_both",
    "gather_points",
    "invert",
    "judge",
    "keep_new",
    "mark_covered",
    "mark_rims",
    "mark_without_phase",
    "match",
    "match_and_fuse",
    "rectified_lines",
    "resample",
    "slopes",
    "spread_table",
    "take_blur",
]
