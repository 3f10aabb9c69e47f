"""Array types and the one way to make an array read-only."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.floating[Any]]
IntArray = npt.NDArray[np.integer[Any]]
BoolArray = npt.NDArray[np.bool_]
ImageArray = npt.NDArray[np.unsignedinteger[Any]]


def read_only(array: npt.ArrayLike, dtype: npt.DTypeLike | None = None, shape: tuple[int | None, ...] | None = None) -> Any:
    """Return ``array`` as a contiguous array that cannot be written to.

    Parameters
    ----------
    array : array-like
    dtype : wanted element type; None keeps the one it has
    shape : wanted shape, with None where any length is right

    Raises
    ------
    ValueError
        The shape differs from ``shape``: a programming error, not one of the user.
    """
    made = np.ascontiguousarray(array, dtype=dtype)
    if shape is not None and (made.ndim != len(shape) or any(w is not None and w != g for w, g in zip(shape, made.shape, strict=True))):
        raise ValueError(f"expected an array of shape {shape}, got {made.shape}")
    view = made.view()
    view.flags.writeable = False
    return view
