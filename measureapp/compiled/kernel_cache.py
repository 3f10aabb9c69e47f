"""Compiled kernels on disk: whether there are any, and invalidation of those that are older than their sources."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path


def shared_sources() -> list[Path]:
    """Return the sources of `measureapp.compiled`, from which the kernels of all packages are compiled."""
    return sorted(Path(__file__).parent.rglob("*.py"))


def drop_stale(folder: Path, *shared: Path) -> None:
    """Delete the compiled kernels of a package that are older than one of its sources or of the ``shared`` ones from outside it.

    Numba recompiles a kernel when the kernel's own file changes, but not when a constant, a named tuple or an inlined function does that
    it imports from another file. Costs the time stamps of some dozen files; to be called before the kernels are imported.

    Parameters
    ----------
    folder : of the package of kernels
    shared : sources elsewhere that its kernels import
    """
    newest = max((source.stat().st_mtime for source in (*folder.glob("*.py"), *shared)), default=0.0)
    for compiled in (folder / "__pycache__").glob("*.nb[ci]"):
        with contextlib.suppress(OSError):  # another process may delete the same file; a read-only folder is never stale
            if compiled.stat().st_mtime < newest:
                compiled.unlink()


def lacks_compiled(folder: Path) -> bool:
    """Return whether a package of kernels could have compiled ones beside its sources and has none."""
    return os.access(folder, os.W_OK) and "NUMBA_CACHE_DIR" not in os.environ and not any((folder / "__pycache__").glob("*.nbi"))
