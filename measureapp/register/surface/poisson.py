"""Poisson reconstruction in a separate process.

Open3D holds the interpreter lock, prints to the terminal and terminates the process on some input. In a separate process this is
harmless, and the reconstruction can be cancelled at any time.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.child_process import describe_exit, run_child
from measureapp.errors import RegistrationError
from measureapp.progress import Progress
from measureapp.register.surface.poisson_worker import EXIT_OUT_OF_MEMORY

WORKER = Path(__file__).with_name("poisson_worker.py")
HINT = "Merge on a coarser grid, close other programs, and check the cloud's normals."


def run_poisson(
    points_mm: FloatArray, normals: FloatArray, depth: int, scale: float, progress: Progress, worker: Path = WORKER
) -> tuple[FloatArray, IntArray]:
    """Screened Poisson reconstruction of oriented points; return vertices (V, 3) and triangles (T, 3).

    Parameters
    ----------
    points_mm, normals : (N, 3)
    depth : of the octree
    scale : side of the octree over the size of the points' bounding box
    progress : called ten times a second; when it raises, the process is killed
    worker : program to run

    Raises
    ------
    RegistrationError
        The process failed, ran out of memory or gave no surface.
    """
    with TemporaryDirectory(prefix="measureapp-surface-", ignore_cleanup_errors=True) as folder:
        source, target, log = (Path(folder) / name for name in ("in.npz", "out.npz", "log.txt"))
        try:
            np.savez(source, points=points_mm, normals=normals, depth=depth, scale=scale)
        except OSError as error:
            raise RegistrationError(
                f"The points of the surface cannot be written to {folder}: {error.strerror or error}.", "Free disk space there."
            ) from error
        command = [sys.executable, "-P", str(worker), str(source), str(target)]
        try:
            code = run_child(command, log, lambda: progress.report(0, 1, "reconstructing the surface"))
        except OSError as error:
            raise RegistrationError(f"The surface reconstruction could not be started: {error.strerror or error}.", HINT) from error
        if code != 0 or not target.is_file():
            raise RegistrationError(f"The surface reconstruction failed: {_describe_failure(code, log)}.", HINT)
        with np.load(target) as made:
            return made["vertices"], made["triangles"]


def _describe_failure(code: int, log: Path) -> str:
    """Describe why a process gave no surface."""
    if code == EXIT_OUT_OF_MEMORY:
        return "out of memory"
    return describe_exit(code, log)
