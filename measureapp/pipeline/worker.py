"""One thread that computes behind a scan, and that a program can leave behind when it is stuck."""

from __future__ import annotations

import os
import queue
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from typing import Any, TypeVar

T = TypeVar("T")
LEAVE_S = 30.0  # for the task under way, when the worker is closed
STOPPED_WITHIN_S = 0.3  # the same, where a scan was stopped
NICE = 5  # of its thread, so that images are taken first where processors are scarce


class Worker:
    """Does tasks in their order on a thread of its own.

    Unlike a pool of the standard library it never keeps the program from ending: a task that does not return is left behind.
    """

    def __init__(self, name: str) -> None:
        self._waiting: queue.SimpleQueue[tuple[Callable[[], Any], Future[Any]] | None] = queue.SimpleQueue()
        self._since: float | None = None  # of the monotonic clock: start of the task under way
        self._thread = threading.Thread(target=self._work, name=name, daemon=True)
        self._thread.start()

    def submit(self, task: Callable[[], T]) -> Future[T]:
        """Queue a task and return at once."""
        future: Future[T] = Future()
        self._waiting.put((task, future))
        return future

    def busy_s(self) -> float:
        """Return for how long the task under way has lasted; 0 without one."""
        since = self._since
        return 0.0 if since is None else time.monotonic() - since

    def close(self, within_s: float = LEAVE_S) -> None:
        """Cancel what has not begun, and wait a while for the task under way."""
        while True:
            try:
                entry = self._waiting.get_nowait()
            except queue.Empty:
                break
            if entry is not None:
                entry[1].cancel()
        self._waiting.put(None)
        self._thread.join(within_s)

    def _work(self) -> None:
        _step_back()
        while (entry := self._waiting.get()) is not None:
            task, future = entry
            if not future.set_running_or_notify_cancel():
                continue
            self._since = time.monotonic()
            try:
                future.set_result(task())
            except BaseException as error:  # passed on to whoever wants the result
                future.set_exception(error)
            finally:
                self._since = None
            del task, future, entry  # an idle worker keeps no images alive


def _step_back() -> None:
    """Lower the priority of this thread and of those it starts; only Linux has priorities of threads."""
    if sys.platform == "linux":
        with suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, 0, min(19, os.getpriority(os.PRIO_PROCESS, 0) + NICE))  # 0: this thread
