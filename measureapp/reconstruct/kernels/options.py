"""How kernels are compiled that allocate nothing."""

from __future__ import annotations

from typing import Any

# Without reference counts, which threads would contend for at every slice; with the error model of Python a division is a branch.
LOOP: dict[str, Any] = {"nogil": True, "cache": True, "fastmath": True, "error_model": "numpy", "_nrt": False}
INLINE: dict[str, Any] = {**LOOP, "forceinline": True}

PIXELS = 16  # of a row that loops with vectors take at a time; of float32 they fill a line of the cache
