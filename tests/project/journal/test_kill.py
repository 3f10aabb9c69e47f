"""A scan killed at random instants: nothing that was reported stored is lost, nothing is damaged, and it resumes to the same bytes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from measureapp.project import upkeep
from measureapp.project.folder import ProjectFolder
from tests.project.journal.whole_project import copied

ROOT = Path(__file__).resolve().parents[3]
KILLS = int(os.environ.get("MEASUREAPP_KILLS", "200"))  # of the slow test
pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork, as on Linux and macOS")


class Scans:
    """The program that forks scans."""

    def __init__(self, golden: Path) -> None:
        self._golden = golden
        command = [sys.executable, "-m", "tests.project.journal.killed_scan"]
        environment = os.environ | {"PYTHONPATH": str(ROOT)}
        self._process = subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
        assert self._line() == "ready"

    def run(self, project: Path, reported: Path, kill_after_s: float = 600.0) -> str:
        """Run one scan, kill it after a time, and return how it ended."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{project}\t{reported}\t{self._golden}\t{kill_after_s}\n")
        self._process.stdin.flush()
        return self._line()

    def close(self) -> None:
        self._process.communicate()

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()


@pytest.fixture
def scans(template: ProjectFolder) -> Iterator[Scans]:
    program = Scans(template.path)
    yield program
    program.close()


def essence(project: Path) -> dict[str, object]:
    """Stacks without the times at which they were taken, and results, byte for byte."""
    found: dict[str, object] = {}
    for path in sorted((*(project / "stacks").rglob("*.npy"), *(project / "results").rglob("*.ply"))):
        found[path.relative_to(project).as_posix()] = path.read_bytes()
    for path in sorted((project / "stacks").rglob("stack.json")):
        document = json.loads(path.read_text(encoding="utf-8"))
        del document["conditions"], document["approach"]
        found[path.relative_to(project).as_posix()] = document
    return found


def killed(scans: Scans, template: ProjectFolder, folder: Path, kills: int, seed: int) -> int:
    """Kill scans, each of which resumes the one before, and return how many were killed; a project that is complete gives way to a new one."""
    rng = np.random.default_rng(seed)
    reference = copied(template, folder / "reference").path
    started = time.monotonic()
    assert scans.run(reference, folder / "reference.txt") == "done"
    whole_s = time.monotonic() - started
    expected = essence(reference)
    done, round_ = 0, 0
    while done < kills:
        round_ += 1
        project, reported = copied(template, folder / f"project{round_}").path, folder / f"reported{round_}.txt"
        ended = ""
        while ended != "done":
            ended = scans.run(project, reported, rng.uniform(0.0, whole_s) if done < kills else 600.0)
            assert ended in ("done", "killed")
            done += ended == "killed"
            stored = set(ProjectFolder.open(project).stored_viewpoints())
            assert set(reported.read_text(encoding="utf-8").split() if reported.exists() else []) <= stored
            verified = upkeep.verify(project)
            assert verified.whole, verified.damage
        assert essence(project) == expected
        assert not [path for path in project.rglob("*") if ".part" in path.name]
    return done


def test_a_scan_killed_ten_times_loses_nothing_and_resumes_to_the_same_bytes(scans: Scans, template: ProjectFolder, tmp_path: Path) -> None:
    assert killed(scans, template, tmp_path, kills=10, seed=1) >= 10


@pytest.mark.slow
def test_a_scan_killed_many_times_loses_nothing(scans: Scans, template: ProjectFolder, tmp_path: Path) -> None:
    """200 times, or as often as MEASUREAPP_KILLS says."""
    assert killed(scans, template, tmp_path, kills=KILLS, seed=2) >= KILLS
