"""Statements of all kernels in NumPy, with the same names and parameters; selected by ``MEASUREAPP_KERNELS=reference``."""

from __future__ import annotations

from measureapp.reconstruct.kernels.reference.cross_check import check_orthogonal, keep_new, mark_used
from measureapp.reconstruct.kernels.reference.fuse import fuse_pairs, match_and_fuse
from measureapp.reconstruct.kernels.reference.images import correct_blur, mark_discontinuities, measure_gradients
from measureapp.reconstruct.kernels.reference.match import match
from measureapp.reconstruct.kernels.reference.projector import triangulate
from measureapp.reconstruct.kernels.reference.reproject import resample_phase
from measureapp.reconstruct.kernels.reference.surface import (
    find_runs,
    gather_points,
    invert_depth,
    refit_normals,
    reject_points,
    remove_small_components,
)
from measureapp.reconstruct.kernels.reference.table import fill_gaps, fill_table, rectify_pixels

__all__ = [
    "check_orthogonal",
    "correct_blur",
    "fill_gaps",
    "fill_table",
    "find_runs",
    "fuse_pairs",
    "gather_points",
    "invert_depth",
    "keep_new",
    "mark_discontinuities",
    "mark_used",
    "match",
    "match_and_fuse",
    "measure_gradients",
    "rectify_pixels",
    "refit_normals",
    "reject_points",
    "remove_small_components",
    "resample_phase",
    "triangulate",
]
