"""Numbers that several reconstruction kernels use."""

from __future__ import annotations

PIXELS = 16  # of a row in one vector; as float32 they fill a cache line
