"""STEP files as nominals: tessellated by OpenCASCADE in a process of its own, whose time and memory are limited.

The library (cascadio, MIT licence, with OpenCASCADE under the LGPL) is optional. What crashes, hangs or grows without
end on some file does so beside the program.
"""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.child_process import how_it_ended
from measureapp.errors import InputError
from measureapp.project.geometry.step_worker import EXIT_NO_SURFACE, EXIT_OUT_OF_MEMORY

STEP_KINDS = (".step", ".stp")
LIBRARY = "cascadio"
WORKER = Path(__file__).with_name("step_worker.py")
MAGIC = b"ISO-10303-21"
EXPORT_AS_MESH = "Export the part as STL from the CAD program."


@dataclass(frozen=True, slots=True)
class StepLimits:
    """How finely a STEP file is tessellated, and what that may cost."""

    chord_mm: float = 0.01  # greatest distance of a triangle from the surface
    angle_rad: float = 0.5  # greatest turn of the surface along a triangle
    longest_s: float = 300.0
    memory_bytes: int = 4 * 2**30  # of the process; not limited on Windows


def read_step(path: Path, limits: StepLimits = StepLimits(), worker: Path = WORKER) -> tuple[FloatArray, IntArray]:
    """Return vertices (V, 3) in mm, from the unit that the file states, and triangles (T, 3).

    Raises
    ------
    InputError
        The library is not installed, the file is no STEP file or damaged, or its tessellation takes too long or too much memory.
    """
    with path.open("rb") as file:
        if MAGIC not in file.read(256):
            raise InputError(f"{path} is not a STEP file.", "Export or copy the file again.")
    if find_spec(LIBRARY) is None:
        raise InputError(
            f"{path} is a STEP file; the library that reads it is not installed.",
            f"Install it with `python -m pip install {LIBRARY}` in MeasureApp's environment, or export the part as STL.",
        )
    with TemporaryDirectory(prefix="measureapp-step-", ignore_cleanup_errors=True) as folder:
        target, told = Path(folder) / "out.npz", Path(folder) / "told.txt"
        numbers = (limits.chord_mm, limits.angle_rad, limits.memory_bytes)
        code = _run([sys.executable, "-P", str(worker), str(path), str(target), *map(str, numbers)], told, path, limits)
        if code != 0 or not target.is_file():
            raise InputError(f"{path} could not be tessellated: {_reason(code, told, limits)}.", EXPORT_AS_MESH)
        with np.load(target) as made:
            return made["vertices"], made["triangles"]


def _run(command: list[str], told: Path, path: Path, limits: StepLimits) -> int:
    with told.open("wb") as output:
        try:
            return subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                timeout=limits.longest_s,
                check=False,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            ).returncode
        except subprocess.TimeoutExpired as error:
            raise InputError(f"{path} was not tessellated within {limits.longest_s:g} s.", EXPORT_AS_MESH) from error


def _reason(code: int, told: Path, limits: StepLimits) -> str:
    """Say in words how the process ended without triangles."""
    if code == EXIT_OUT_OF_MEMORY:
        return f"{limits.memory_bytes / 2**30:.1f} GiB of memory did not suffice"
    if code == EXIT_NO_SURFACE:
        return "it holds no surface, or is damaged"
    return how_it_ended(code, told)
