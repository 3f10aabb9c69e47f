"""Characters that a path cannot have, or that the terminal cannot show."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from tests.cli.refusal import filled, refused

ROOT = Path(__file__).resolve().parents[2]


def test_a_path_that_no_system_can_have_is_refused(shelf: Path, capsys) -> None:
    for line in ("compare NOMINAL NOMINAL --align IN", "fit plane IN", "process IN"):
        refused(capsys, filled(line, shelf, Path("out"), "\0"))


def test_an_encoding_that_lacks_a_character_gets_a_question_mark(tmp_path: Path) -> None:
    points = tmp_path / "points.xyz"
    np.savetxt(points, np.random.default_rng(5).normal(0, [10, 10, 0.01], (50, 3)))
    code = "import sys; from measureapp.cli import main; sys.exit(main(['fit', 'plane', sys.argv[1]]))"
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code, str(points)], env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "? position_mm" in done.stdout  # σ
