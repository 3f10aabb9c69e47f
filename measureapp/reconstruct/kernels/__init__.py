"""Kernels of reconstruction; each works on a band of rows and releases the interpreter.

``kernels.NAME`` is the compiled loop, or its statement in NumPy (`reference`) while ``MEASUREAPP_KERNELS=reference`` is set; both have the same
parameters.
"""

from __future__ import annotations

from typing import Any

from measureapp.compiled.selection import use_reference
from measureapp.reconstruct.kernels import (
    blur,
    clean,
    components,
    cross_check,
    fuse,
    gather,
    gradients,
    projector,
    reference,
    reproject,
    table,
)

_COMPILED = {
    kernel.__name__: kernel
    for kernel in (
        blur.correct_blur,
        blur.mark_discontinuities,
        clean.invert_depth,
        clean.refit_normals,
        clean.reject_points,
        components.find_runs,
        components.remove_small_components,
        cross_check.check_orthogonal,
        cross_check.keep_new,
        cross_check.mark_used,
        fuse.match_and_fuse,
        gather.gather_points,
        gradients.measure_gradients,
        projector.triangulate,
        reproject.resample_phase,
        table.fill_gaps,
        table.fill_table,
        table.rectify_pixels,
    )
}


def __getattr__(name: str) -> Any:
    """Return the selected version of a kernel."""
    if name not in _COMPILED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(reference, name) if use_reference() else _COMPILED[name]
