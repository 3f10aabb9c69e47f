"""From fringe images to absolute phase."""

from __future__ import annotations

from pathlib import Path

from measureapp.compiled.kernel_cache import drop_stale, shared_sources

drop_stale(Path(__file__).parent / "kernels", *shared_sources())
