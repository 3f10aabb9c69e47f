"""Compiled kernels on disk that no longer fit their sources."""

from __future__ import annotations

import contextlib
from pathlib import Path


def drop_stale(folder: Path, *shared: Path) -> None:
    """Delete the compiled kernels of a package that are older than one of its sources or of the ``shared`` ones from outside it.

    Numba compiles a kernel anew when the kernel's own file changes; what it takes from a neighbour (constants, the fields of a
    tuple) would stay as it was. Costs a look at a dozen files; to be called before the kernels are imported.
    """
    newest = max((source.stat().st_mtime for source in (*folder.glob("*.py"), *shared)), default=0.0)
    for compiled in (folder / "__pycache__").glob("*.nb[ci]"):
        with contextlib.suppress(OSError):  # another process may do the same, and a read-only folder is never stale
            if compiled.stat().st_mtime < newest:
                compiled.unlink()
