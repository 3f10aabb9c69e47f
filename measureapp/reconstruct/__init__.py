"""From phase maps to points."""

from __future__ import annotations

from pathlib import Path

from measureapp.kernel_cache import drop_stale

_CORE = Path(__file__).parents[1]
drop_stale(Path(__file__).parent / "kernels", _CORE / "machine_memory.py", *(_CORE / "simd").glob("*.py"))
