"""A heartbeat in the window's thread, which finds what stalls the window, with the stack of each stall.

A timer beats every 20 ms in the window's thread. A daemon thread notices silence and takes the stack of the window's thread. When the beat
is back, the silence is divided into what the window itself caused and what other programs on the machine caused:

- *own*: the larger of the CPU time of the window's thread and of the whole process (the thread may wait for a renderer's threads, or for a
  job that holds the interpreter lock), but at most the silence less the time for which the kernel let the thread wait for a free processor;
- *waited*: silence without CPU time of this process: sleep, disk, or other programs.

A stall counts by *own* time. Times are divided by a factor for slow machines: the CPU time of a fixed loop over its time on the machine on which the limit was set.
"""

from __future__ import annotations

import faulthandler
import linecache
import os
import re
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QObject, Qt, QTimer

from ui.look.look import Look
from ui.look.theme import Shade

LIMIT_MS, BEAT_MS = 100.0, 20
SHADES: tuple[Shade, ...] = ("dark", "light")
FIRST_LOOK_MS, LOOKS = 70.0, 6  # silence until the first stack is taken; further ones after twice the time each
LOOP_MS = 17.0  # CPU time of `_loop` on an idle core of the machine with 2 cores and software OpenGL on which the limit was set
ROOT = str(Path(__file__).resolve().parents[2]) + os.sep
FRAME = re.compile(r'  File "(.+)", line (\d+) in (.+)')
JOB, JOB_FRAMES = "ui/workers/job.py", 4  # of a job, which may hold the interpreter lock, the innermost frames


@dataclass(frozen=True)
class Stall:
    """One silence of the window's thread."""

    place: str  # what the test was doing
    own_ms: float
    waited_ms: float
    wall_ms: float
    stacks: tuple[str, ...]

    @property
    def words(self) -> str:
        """Times, place and stack."""
        head = f"{self.own_ms:.0f} ms own, {self.waited_ms:.0f} ms waited, {self.wall_ms:.0f} ms in all: {self.place or 'somewhere'}"
        later = [f"  later: {stack.splitlines()[-1].strip()}" for stack in self.stacks[1:]]
        return "\n".join((head, *self.stacks[:1], *later))


@dataclass(frozen=True)
class _Beat:
    wall_s: float
    thread_s: float
    process_s: float
    queued_s: float


class Heartbeat(QObject):
    """Beats in the window's thread while it is used as a context."""

    def __init__(self, limit_ms: float = LIMIT_MS) -> None:
        super().__init__()
        self.limit_ms, self.place, self.stalls, self.beats = limit_ms, "", list[Stall](), 0
        self.factor = slowness()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(BEAT_MS)
        self._timer.timeout.connect(self._beat)
        self._main, self._queue = threading.main_thread().ident or 0, _queue_file()
        self._end, self._paused = threading.Event(), False
        self._stacks: list[str] = []
        self._last = self._now()

    def __enter__(self) -> Heartbeat:
        self._watcher = threading.Thread(target=self._watch, name="heartbeat", daemon=True)
        self._last = self._now()
        self._timer.start()
        self._watcher.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._beat()
        self._timer.stop()
        self._end.set()
        self._watcher.join()
        if self._queue is not None:
            os.close(self._queue)

    @contextmanager
    def pause(self) -> Iterator[None]:
        """Overlook what the test itself does meanwhile, such as screenshots."""
        self._beat()
        self._paused = True
        try:
            yield
        finally:
            self._paused, self._last = False, self._now()
            self._stacks.clear()

    @contextmanager
    def at(self, place: str) -> Iterator[None]:
        """Name what is done meanwhile; the event loop should turn before the end, so that what is posted counts here."""
        self._beat()
        self.place = place
        try:
            yield
        finally:
            self._beat()
            self.place = ""

    def over(self, limit_ms: float | None = None) -> list[Stall]:
        """Return the stalls above the limit, worst first."""
        limit = self.limit_ms if limit_ms is None else limit_ms
        return sorted((stall for stall in self.stalls if stall.own_ms > limit), key=lambda stall: -stall.own_ms)

    def report(self, count: int = 5, limit_ms: float | None = None) -> str:
        """Return the worst stalls with their stacks as text."""
        over = self.over(limit_ms)
        head = f"{len(over)} stalls in {self.beats} beats; factor of this machine {self.factor:.2f}"
        return "\n\n".join((head, *(stall.words for stall in over[:count])))

    def check(self, limit_ms: float | None = None) -> None:
        """Fail the test if the window stalled for longer than the limit."""
        if self.over(limit_ms):
            pytest.fail(self.report(limit_ms=limit_ms), pytrace=False)

    def _now(self) -> _Beat:
        queued = int(os.pread(self._queue, 100, 0).split()[1]) * 1e-9 if self._queue is not None else 0.0
        return _Beat(time.perf_counter(), time.thread_time(), time.process_time(), queued)

    def _beat(self) -> None:
        last, now = self._last, self._now()
        stacks, self._stacks = tuple(self._stacks), []
        self._last = now
        self.beats += 1
        wall = now.wall_s - last.wall_s
        if self._paused or wall * 1000 <= self.limit_ms * self.factor:
            return
        most = wall - (now.queued_s - last.queued_s)
        used = max(now.thread_s - last.thread_s, now.process_s - last.process_s)
        own = max(0.0, min(most, used))
        scale = 1000 / self.factor
        self.stalls.append(Stall(self.place, own * scale, (wall - own) * scale, wall * scale, stacks))

    def _watch(self) -> None:
        """Take the stack of the window's thread when it is silent; runs in its own thread."""
        while not self._end.wait(0.01):
            silent_ms = (time.perf_counter() - self._last.wall_s) * 1000
            taken = len(self._stacks)
            if taken < LOOKS and silent_ms > FIRST_LOOK_MS * 2**taken and not self._paused:
                self._stacks.append(_stack_of(self._main))


def load_themes(qtbot: Any, look: Look) -> None:
    """Switch to the dark theme and back, so that both are loaded: the first switch of a whole window is measured in `journey/test_stalls.py`."""
    for shade in SHADES:
        look.set_shade(shade)
        qtbot.wait(60)


def slowness() -> float:
    """Return how many times slower this machine is than the one on which the limit was set, at least 1: the best of three runs of a fixed loop."""
    return max(1.0, min(_loop() for _ in range(3)) / LOOP_MS)


def _loop() -> float:
    """Run a fixed mixture of Python and NumPy; return its CPU time in ms."""
    start, total, values = time.thread_time(), 0, np.arange(20_000.0)
    for number in range(300_000):
        total += number % 7
    for _ in range(200):
        values = np.sqrt(values * values + 1.0)
    return (time.thread_time() - start) * 1000


def _queue_file() -> int | None:
    """Open the file in which Linux states how long this thread waited for a free processor; None elsewhere."""
    try:
        return os.open(f"/proc/self/task/{threading.get_native_id()}/schedstat", os.O_RDONLY)
    except OSError:
        return None


def _stack_of(thread: int) -> str:
    """Return the part of a thread's stack that lies below the test, without the folder of the checkout.

    `sys._current_frames` makes frame objects of a thread that goes on, which ends the process now and then; faulthandler only reads.
    """
    with tempfile.TemporaryFile("w+") as file:
        faulthandler.dump_traceback(file, all_threads=True)
        file.seek(0)
        blocks = file.read().split("\n\n")
    block = next((block for block in blocks if f"0x{thread:016x}" in block), "")
    jobs = [FRAME.findall(other) for other in blocks if JOB in other]
    stack = [(name, int(line), function) for name, line, function in FRAME.findall(block)][::-1]
    library = os.sep + "site-packages" + os.sep
    own = [frame for frame in stack if library not in frame[0] or frame is stack[-1]]
    inside = [place for place, frame in enumerate(own) if frame[0].startswith(ROOT)]
    kept = own[inside[0] :] if inside else own[-3:]
    lines = [
        f"    {name.removeprefix(ROOT)}:{line} in {function}: {linecache.getline(name, line).strip()}" for name, line, function in kept
    ]
    running = [f"    (job: {' < '.join(f'{name.removeprefix(ROOT)}:{line}' for name, line, _ in job[:JOB_FRAMES])})" for job in jobs]
    return "\n".join((*running, *lines))
