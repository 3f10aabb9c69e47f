"""Poisson reconstruction in a process of its own.

Open3D keeps the interpreter to itself as long as it works, prints what it likes and ends the process on some input. Beside
ours it can do all three, and can be stopped at any moment.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.child_process import describe_exit
from measureapp.errors import RegistrationError
from measureapp.progress import Progress
from measureapp.register.surface.poisson_worker import EXIT_OUT_OF_MEMORY

WORKER = Path(__file__).with_name("poisson_worker.py")
LOOK_EVERY_S = 0.1
HINT = "Merge on a coarser grid or close other programs, and look at the cloud's normals."


def poisson(
    points_mm: FloatArray, normals: FloatArray, depth: int, scale: float, progress: Progress, worker: Path = WORKER
) -> tuple[FloatArray, IntArray]:
    """Return vertices (V, 3) and triangles (T, 3) of the surface through oriented points.

    Parameters
    ----------
    points_mm, normals : (N, 3)
    depth : of the octree
    scale : side of the octree, in sizes of the points' box
    progress : asked ten times a second whether to go on; when it raises, the process is killed
    worker : the program that does it

    Raises
    ------
    RegistrationError
        The process died, ran out of memory or left no surface.
    """
    with TemporaryDirectory(prefix="measureapp-surface-", ignore_cleanup_errors=True) as folder:
        source, target, told = (Path(folder) / name for name in ("in.npz", "out.npz", "told.txt"))
        try:
            np.savez(source, points=points_mm, normals=normals, depth=depth, scale=scale)
        except OSError as error:
            raise RegistrationError(
                f"The points of the surface cannot be written to {folder}: {error.strerror or error}.", "Free some space there."
            ) from error
        code = _run([sys.executable, "-P", str(worker), str(source), str(target)], told, progress)
        if code != 0 or not target.is_file():
            raise RegistrationError(f"The surface could not be made: {_reason(code, told)}.", HINT)
        with np.load(target) as made:
            return made["vertices"], made["triangles"]


def _run(command: list[str], told: Path, progress: Progress) -> int:
    """Run a program to its end and return its exit code; whatever it prints goes to the file ``told``."""
    with told.open("wb") as output:
        try:
            process = subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        except OSError as error:
            raise RegistrationError(f"The surface could not be started: {error.strerror or error}.", HINT) from error
        try:
            while True:
                progress.report(0, 1, "making the surface")
                try:
                    return process.wait(LOOK_EVERY_S)
                except subprocess.TimeoutExpired:
                    continue
        finally:
            process.kill()
            process.wait()


def _reason(code: int, told: Path) -> str:
    """Say in words how a process ended without a surface."""
    if code == EXIT_OUT_OF_MEMORY:
        return "the memory did not suffice"
    return describe_exit(code, told)
