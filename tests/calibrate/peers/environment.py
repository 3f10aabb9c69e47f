"""An environment of their own for the hand-eye methods of OpenCV 4, which OpenCV 5 no longer has."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
FOLDER = HERE.parents[2] / ".peers" / "opencv4"
LOCK = HERE / "requirements.lock"


def peer_python() -> Path:
    """Return the interpreter with OpenCV 4 (Apache 2.0); makes the environment when it is missing or its lock file has changed.

    Raises
    ------
    subprocess.CalledProcessError
        The packages cannot be installed (this needs the network).
    """
    python = FOLDER / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    stamp = FOLDER / "installed.lock"
    wanted = LOCK.read_text(encoding="utf-8")
    if not python.exists() or not stamp.exists() or stamp.read_text(encoding="utf-8") != wanted:
        subprocess.run([sys.executable, "-m", "venv", str(FOLDER)], check=True)
        subprocess.run([str(python), "-m", "pip", "install", "--quiet", "--require-hashes", "--requirement", str(LOCK)], check=True)
        stamp.write_text(wanted, encoding="utf-8")
    return python
