"""What is made once for all processes of a run."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from made_once import made_once

TESTS = Path(__file__).resolve().parents[1]
MODULE = """
import os
from pathlib import Path

from made_once import made_once

def test_it(tmp_path_factory):
    def make(folder):
        with Path("made").open("a") as file:
            file.write("once ")
        (folder / "file").write_text("made")

    assert (made_once(tmp_path_factory, "thing", make) / "file").read_text() == "made"
"""


def test_of_several_processes_one_makes_it(tmp_path: Path) -> None:
    for number in range(4):
        (tmp_path / f"test_{number}.py").write_text(MODULE)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:dash", "--import-mode=importlib", "-n", "2", "--dist", "loadfile"]
    variables = {**os.environ, "PYTHONPATH": str(TESTS)}
    variables.pop("PYTEST_XDIST_WORKER", None)  # this test may itself be one of a worker's
    run = subprocess.run(command, cwd=tmp_path, env=variables, capture_output=True, text=True, check=False)
    assert "4 passed" in run.stdout, run.stdout
    assert (tmp_path / "made").read_text() == "once "


def test_what_failed_is_tried_again_from_an_empty_folder(tmp_path_factory: pytest.TempPathFactory) -> None:
    def fail(folder: Path) -> None:
        (folder / "half").touch()
        raise RuntimeError("no light")

    with pytest.raises(RuntimeError, match="no light"):
        made_once(tmp_path_factory, "of the house", fail)
    found = made_once(tmp_path_factory, "of the house", lambda folder: (folder / "whole").touch())
    assert [path.name for path in found.iterdir()] == ["whole"]
