"""STEP files as nominals: tessellation by OpenCASCADE in a separate process with limited time and memory.

The library (cascadio, MIT licence, with OpenCASCADE under the LGPL) is optional. A crash, hang or memory leak on a file does not
affect the program.
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
from measureapp.child_process import describe_exit
from measureapp.errors import InputError
from measureapp.project.geometry.step_worker import EXIT_NO_SURFACE, EXIT_OUT_OF_MEMORY

STEP_KINDS = (".step", ".stp")
LIBRARY = "cascadio"
WORKER = Path(__file__).with_name("step_worker.py")
MAGIC = b"ISO-10303-21"
EXPORT_AS_MESH = "Export the part as STL from the CAD program."


@dataclass(frozen=True, slots=True)
class StepLimits:
    """Tolerances and resource limits of the tessellation of a STEP file."""

    chord_mm: float = 0.01  # greatest distance between triangle and surface
    angle_rad: float = 0.5  # greatest angle between surface normals along a triangle
    longest_s: float = 300.0
    memory_bytes: int = 4 * 2**30  # of the process; not enforced on Windows


def read_step(path: Path, limits: StepLimits = StepLimits(), worker: Path = WORKER) -> tuple[FloatArray, IntArray]:
    """Tessellate a STEP file; return vertices (V, 3) in mm, converted from the unit of the file, and triangles (T, 3).

    Raises
    ------
    InputError
        The library is not installed, the file is not a STEP file or damaged, or the tessellation exceeds a limit.
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
        target, log = Path(folder) / "out.npz", Path(folder) / "log.txt"
        numbers = (limits.chord_mm, limits.angle_rad, limits.memory_bytes)
        code = _run([sys.executable, "-P", str(worker), str(path), str(target), *map(str, numbers)], log, path, limits)
        if code != 0 or not target.is_file():
            raise InputError(f"{path} could not be tessellated: {_reason(code, log, limits)}.", EXPORT_AS_MESH)
        with np.load(target) as made:
            return made["vertices"], made["triangles"]


def _run(command: list[str], log: Path, path: Path, limits: StepLimits) -> int:
    with log.open("wb") as output:
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


def _reason(code: int, log: Path, limits: StepLimits) -> str:
    """Describe why the process ended without a result."""
    if code == EXIT_OUT_OF_MEMORY:
        return f"it needs more than {limits.memory_bytes / 2**30:.1f} GiB of memory"
    if code == EXIT_NO_SURFACE:
        return "it contains no surface, or is damaged"
    return describe_exit(code, log)
