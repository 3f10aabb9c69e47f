"""An environment of their own for the libraries that decoding is compared with: two builds of OpenCV do not live in one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
FOLDER = HERE.parents[2] / ".peers"
LOCK = HERE / "requirements.lock"


def peer_python() -> Path:
    """Return the peers' interpreter; makes the environment when it is missing or its lock file has changed (needs the network).

    The peers are OpenCV with contrib modules (Apache 2.0) and scikit-image (BSD 3-clause).

    Raises
    ------
    subprocess.CalledProcessError
        The packages cannot be installed.
    """
    python = FOLDER / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    stamp = FOLDER / "installed.lock"
    wanted = LOCK.read_text(encoding="utf-8")
    if not python.exists() or not stamp.exists() or stamp.read_text(encoding="utf-8") != wanted:
        subprocess.run([sys.executable, "-m", "venv", str(FOLDER)], check=True)
        subprocess.run([str(python), "-m", "pip", "install", "--quiet", "--require-hashes", "--requirement", str(LOCK)], check=True)
        stamp.write_text(wanted, encoding="utf-8")
    return python
