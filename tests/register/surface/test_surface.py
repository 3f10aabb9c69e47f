"""The surface is made beside the program: it stays responsive, can be stopped, and survives what happens there."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from pathlib import Path
from tempfile import gettempdir

import numpy as np
import pytest

from measureapp.data.cloud import StitchedCloud
from measureapp.errors import RegistrationError
from measureapp.progress import CallbackProgress, Cancelled, NoProgress
from measureapp.register.surface.closed import reconstruct_surface
from measureapp.register.surface.poisson import run_poisson

RADIUS_MM, NOISE_MM = 30.0, 0.02
LONGEST_GAP_S = 0.3


def ball(count: int = 20_000) -> StitchedCloud:
    """Points spread evenly over a ball, all with the same noise along the normal."""
    random = np.random.default_rng(7)
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.arange(count) * np.pi * (3 - np.sqrt(5))
    flat = np.sqrt(1 - height**2)
    normals = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), height])
    points = normals * (RADIUS_MM + random.normal(0, NOISE_MM, count))[:, None]
    return StitchedCloud(points, normals, np.full(count, NOISE_MM), np.full(count, 0.5), np.zeros(count), ())


def leftovers() -> set[Path]:
    return set(Path(gettempdir()).glob("measureapp-surface-*"))


def run_worker(path: Path, code: str, progress: CallbackProgress | NoProgress | None = None) -> object:
    """Ask another program for the surface of three points."""
    worker = path / "worker.py"
    worker.write_text(code, encoding="utf-8")
    return run_poisson(np.eye(3), np.eye(3), 5, 1.1, progress or NoProgress(), worker)


def test_a_ball_is_closed_and_lies_within_the_noise_of_its_points() -> None:
    mesh = reconstruct_surface(ball())
    off = np.linalg.norm(mesh.vertices_mm, axis=1) - RADIUS_MM
    assert np.sqrt(np.mean(off**2)) < 2 * NOISE_MM
    assert mesh.measured is not None and mesh.measured.all()
    sides = np.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (np.unique(sides, axis=0, return_counts=True)[1] == 2).all()


@pytest.mark.timed
def test_other_threads_go_on_while_the_surface_is_made() -> None:
    cloud, done, gaps = ball(), threading.Event(), []

    def tick() -> None:
        last = time.perf_counter()
        while not done.wait(0.01):
            now = time.perf_counter()
            gaps.append(now - last)
            last = now

    ticking = threading.Thread(target=tick)
    ticking.start()
    reconstruct_surface(cloud)
    done.set()
    ticking.join()
    assert len(gaps) > 20
    assert max(gaps) < LONGEST_GAP_S


def test_what_the_process_prints_does_not_reach_our_output(capfd: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    noisy = "import os, sys\nos.write(1, b'[WARNING] bad average roots')\nos.write(2, b'[WARNING] more')\nsys.exit(1)\n"
    with pytest.raises(RegistrationError, match=r"ended with code 1.*bad average roots"):
        run_worker(tmp_path, noisy)
    reconstruct_surface(ball(2000))
    told = capfd.readouterr()
    assert (told.out, told.err) == ("", "")


@pytest.mark.timed
def test_a_stop_kills_the_process_at_once_and_leaves_nothing_behind(tmp_path: Path) -> None:
    reports, before, sign = [], leftovers(), tmp_path / "alive"
    sleeper = f"import time, pathlib\nwhile True:\n    pathlib.Path({str(sign)!r}).write_text(str(time.time()))\n    time.sleep(0.05)\n"

    def listen(_done: float, _total: float, _note: str) -> None:
        if sign.is_file():
            reports.append(time.monotonic())
            raise Cancelled

    with pytest.raises(Cancelled):
        run_worker(tmp_path, sleeper, CallbackProgress(listen))
    assert time.monotonic() - reports[0] < 1.0
    last = sign.read_text()
    time.sleep(0.2)
    assert sign.read_text() == last
    assert leftovers() == before


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("import os\nos.abort()\n", "its process (was ended by signal 6|ended with code)"),
        ("import sys\nsys.exit(3)\n", "out of memory"),
        ("raise ValueError('no normals')\n", "code 1 .*no normals"),
        ("", "its process ended with code 0"),
    ],
)
def test_a_process_that_dies_is_an_error_in_words(tmp_path: Path, code: str, words: str) -> None:
    before = leftovers()
    with pytest.raises(RegistrationError, match=words) as caught:
        run_worker(tmp_path, code)
    assert caught.value.hint
    assert leftovers() == before


def test_the_worker_needs_nothing_of_the_application_and_no_folder_of_ours(tmp_path: Path) -> None:
    from measureapp.register.surface.poisson import WORKER

    cloud = ball(2000)
    np.savez(tmp_path / "in.npz", points=cloud.points_mm, normals=np.asarray(cloud.normals, np.float64), depth=5, scale=1.1)
    subprocess.run([sys.executable, "-I", str(WORKER), "in.npz", "out.npz"], cwd=tmp_path, check=True, capture_output=True, timeout=60)
    with np.load(tmp_path / "out.npz") as made:
        assert made["triangles"].max() < len(made["vertices"])


def test_points_in_one_place_are_refused() -> None:
    cloud = ball(300)
    with pytest.raises(RegistrationError, match="coincide"):
        reconstruct_surface(StitchedCloud(np.zeros((300, 3)), cloud.normals, cloud.sigma_mm, cloud.grey, cloud.view, ()))
