"""From fringe images to absolute phase."""

from __future__ import annotations

from pathlib import Path

from measureapp.kernel_cache import drop_stale

drop_stale(Path(__file__).parent / "kernels", Path(__file__).parents[1] / "machine_memory.py")
