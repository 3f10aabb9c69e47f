"""A program whose scans are killed: it forks a scan of fakes for every project named on its standard input."""

from __future__ import annotations

import hashlib
import os
import signal
import sys
import time
from pathlib import Path

import numpy as np

from measureapp.acquire.engine import Engine
from measureapp.acquire.events import ViewpointStored
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from tests.acquire.fake_rig import HEIGHT, SIGMA, WIDTH, Cell, drawn, fake_plan, fake_rig

VIEWPOINTS = 5


class SameAgain(Cell):
    """A cell whose noise depends on place, camera, exposure and pattern only, so that a repeated scan has the same images."""

    def image(self, camera: str, exposure_us: int, pattern: int) -> np.ndarray:
        place = f"{self.robot.matrix.round(6).tolist()} {self.guide_mm:.6f} {self.table_rad:.6f} {camera} {exposure_us} {pattern}"
        seed = int.from_bytes(hashlib.sha256(place.encode()).digest()[:8], "big")
        noise = np.random.default_rng(seed).normal(0.0, SIGMA, (HEIGHT, WIDTH))
        return np.clip(np.rint(self.mean(camera, exposure_us, pattern) + noise), 0, 255).astype(np.uint8)


class Storing:
    """Stores every stack."""

    def __init__(self, project: ProjectFolder) -> None:
        self._project = project

    def exposure_taken(self, taken: object) -> None:
        """Nothing is decoded here."""

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was kept of it."""

    def store(self, stack) -> None:
        self._project.frames.store(stack)


def scan(place: Path, reported: Path, golden: Path) -> None:
    """Take what is missing, then store the results of ``golden``; ``reported`` gets every viewpoint that was said to be stored."""
    project, plan = ProjectFolder.open(place), fake_plan(VIEWPOINTS, exposures_us=(100_000, 50_000))
    with project.lock(), reported.open("a", encoding="utf-8") as report:

        def note(event: object) -> None:
            if isinstance(event, ViewpointStored):
                report.write(f"{event.viewpoint_id}\n")
                report.flush()

        stored = project.stored_viewpoints()
        rig = fake_rig(SameAgain())
        try:
            task = FringeTask(plan.patterns, plan.bracket.exposures_us, drawn(plan), Storing(project))
            waiting = [viewpoint for viewpoint in plan if viewpoint.id not in stored]
            Engine(rig).run(plan.name, waiting, task, note, NoProgress())
        finally:
            rig.close()
        measured = ProjectFolder.open(golden).measurement()
        assert measured is not None
        project.save_measurement(measured)
        project.save_program(project.program_text(has_nominal=True))


def main() -> None:
    """Fork one scan per line of input, kill it after the time that the line names, and answer how it ended."""
    _answer("ready")
    for line in sys.stdin:
        place, reported, golden, kill_after_s = line.rstrip("\n").split("\t")
        child = os.fork()
        if child == 0:
            code = 1
            try:
                scan(Path(place), Path(reported), Path(golden))
                code = 0
            finally:
                os._exit(code)
        status = _wait(child, float(kill_after_s))
        _answer("done" if status == 0 else "killed" if os.WIFSIGNALED(status) else "failed")


def _wait(child: int, kill_after_s: float) -> int:
    end = time.monotonic() + kill_after_s
    while time.monotonic() < end:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return status
        time.sleep(0.001)
    os.kill(child, signal.SIGKILL)
    return os.waitpid(child, 0)[1]


def _answer(word: str) -> None:
    sys.stdout.write(f"{word}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
