"""A worker that is killed in the middle costs its tasks, which another one repeats; the numbers stay the same to the last bit. Run with ``-m slow``."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from demo_fixture import linked_copy

from measureapp.campaign.tasks import SCRATCH

pytestmark = pytest.mark.slow
PATIENCE_S = 600.0


@contextmanager
def started(folder: Path, name: str, *arguments: str) -> Iterator[subprocess.Popen[bytes]]:
    with (folder / f"{name}.log").open("wb") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", *arguments], stdout=log, stderr=log, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def wait_for(happened: Callable[[], object], what: str) -> None:
    until = time.monotonic() + PATIENCE_S
    while not happened():
        assert time.monotonic() < until, f"{what} did not happen within {PATIENCE_S:.0f} s"
        time.sleep(0.02)


def test_a_killed_worker_costs_its_task_and_nothing_else(demo, tmp_path):
    project, there = linked_copy(demo.folder, tmp_path / "project"), tmp_path / "scheduler.json"
    at, quiet = ("--scheduler-file", str(there)), ("--no-dashboard",)
    worker = ("distributed.cli.dask_worker", *at, *quiet, "--nthreads", "1", "--no-nanny", "--local-directory", str(tmp_path))
    with started(tmp_path, "scheduler", "distributed.cli.dask_scheduler", *at, "--port", "0", *quiet):
        wait_for(there.is_file, "the start of the scheduler")
        address = json.loads(there.read_text(encoding="utf-8"))["address"]
        with started(tmp_path, "first", *worker) as first, started(tmp_path, "second", *worker) as second:
            command = [sys.executable, "-c", "import sys; from measureapp.cli import main; sys.exit(main())", "process", str(project)]
            answer, said = tmp_path / "answer.json", tmp_path / "said.txt"
            with answer.open("wb") as out, said.open("wb") as err:
                run = subprocess.Popen([*command, "--cluster", address, "--json"], stdout=out, stderr=err)
                wait_for(lambda: any((project / SCRATCH).glob("*.view")) or run.poll() is not None, "the first cloud")
                first.send_signal(signal.SIGKILL)  # with a view under way, and clouds of its own that others need
                assert run.wait(PATIENCE_S) == 0, said.read_text(encoding="utf-8") + answer.read_text(encoding="utf-8")[-500:]
            assert first.wait() == -signal.SIGKILL
            assert second.poll() is None
    (job,) = json.loads(answer.read_text(encoding="utf-8"))["jobs"]
    assert not job["problem"] and not (project / SCRATCH).exists()
    expected = {one["name"]: (one["measured"], one["uncertainty"]) for one in demo.document["dimensions"]}
    assert {one["name"]: (one["measured"], one["uncertainty"]) for one in job["dimensions"]} == expected
