"""Environments of their own for libraries that results are compared with: two builds of OpenCV do not live in one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / ".peers"


def peer_python(name: str, lock: Path) -> Path:
    """Return the interpreter of the environment ``name``; makes it when it is missing or its lock file has changed.

    Raises
    ------
    subprocess.CalledProcessError
        The packages cannot be installed (this needs the network).
    """
    folder = FOLDER / name
    python = folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    stamp = folder / "installed.lock"
    wanted = lock.read_text(encoding="utf-8")
    if not python.exists() or not stamp.exists() or stamp.read_text(encoding="utf-8") != wanted:
        subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
        subprocess.run([str(python), "-m", "pip", "install", "--quiet", "--require-hashes", "--requirement", str(lock)], check=True)
        stamp.write_text(wanted, encoding="utf-8")
    return python
