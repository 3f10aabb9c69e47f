"""Compiled kernels on disk are dropped when a source of theirs is newer."""

from __future__ import annotations

import os
from pathlib import Path

from measureapp.compiled.kernel_cache import drop_stale


def test_kernels_older_than_a_source_of_their_package_are_dropped(tmp_path: Path) -> None:
    compiled = tmp_path / "__pycache__" / "summing.clear-1.py311.1.nbc"
    compiled.parent.mkdir()
    for file, seconds in ((tmp_path / "summing.py", 100), (tmp_path / "records.py", 100), (compiled, 200)):
        file.write_text("x", encoding="utf-8")
        os.utime(file, (seconds, seconds))
    drop_stale(tmp_path)
    assert compiled.exists()
    os.utime(tmp_path / "records.py", (300, 300))
    drop_stale(tmp_path)
    assert not compiled.exists()
    drop_stale(tmp_path)


def test_kernels_older_than_what_they_share_with_other_packages_are_dropped(tmp_path: Path) -> None:
    kernels, shared = tmp_path / "kernels", tmp_path / "shared.py"
    compiled = kernels / "__pycache__" / "summing.clear-1.py311.1.nbc"
    compiled.parent.mkdir(parents=True)
    for file, seconds in ((kernels / "summing.py", 100), (shared, 100), (compiled, 200)):
        file.write_text("x", encoding="utf-8")
        os.utime(file, (seconds, seconds))
    drop_stale(kernels, shared)
    assert compiled.exists()
    os.utime(shared, (300, 300))
    drop_stale(kernels, shared)
    assert not compiled.exists()
