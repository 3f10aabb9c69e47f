"""Threads for calls that may block for ever, and cancellation of calls that wait for them."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from queue import SimpleQueue
from typing import Generic, TypeVar

from measureapp.progress import Cancelled

T = TypeVar("T")


class Blocked(Exception):
    """A call did not return in time; its thread is left to it."""


class Waiting:
    """One call of the driver while it waits."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._cancelled = False

    def cancel(self) -> None:
        """Let the call raise Cancelled, from any thread."""
        with self._changed:
            self._cancelled = True
            self._changed.notify_all()

    def notify(self) -> None:
        """Let the call see what has changed."""
        with self._changed:
            self._changed.notify_all()

    def until(self, is_done: Callable[[], bool], timeout_s: float) -> bool:
        """Wait until ``is_done()``; return whether it is. Raises Cancelled."""
        with self._changed:
            self._changed.wait_for(lambda: self._cancelled or is_done(), timeout_s)
            if self._cancelled:
                raise Cancelled
            return is_done()


class Stopping:
    """Cancels the calls that wait when `stop` is called; later calls are not affected."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._calls: list[Waiting] = []

    def stop(self) -> None:
        """Cancel every call that waits."""
        with self._lock:
            for call in self._calls:
                call.cancel()

    @contextmanager
    def waiting(self) -> Iterator[Waiting]:
        """Register a call for the duration of a block."""
        call = Waiting()
        with self._lock:
            self._calls.append(call)
        try:
            yield call
        finally:
            with self._lock:
                self._calls.remove(call)


class _Work(Generic[T]):
    def __init__(self, work: Callable[[], T], waiting: Waiting) -> None:
        self._work, self._waiting = work, waiting
        self.is_abandoned = False
        self.is_done = False
        self._result: T | None = None
        self._error: Exception | None = None

    def run(self) -> None:
        if not self.is_abandoned:
            try:
                self._result = self._work()
            except Exception as error:  # foreign code may raise anything; the caller gets it
                self._error = error
        self.is_done = True
        self._waiting.notify()

    def result(self) -> T:
        if self._error is not None:
            raise self._error
        return self._result  # type: ignore[return-value]  # None only where T allows it


class Worker:
    """A thread that runs calls one after the other; a daemon, since a call that blocks for ever must not keep the program."""

    def __init__(self, name: str) -> None:
        self._queue: SimpleQueue[_Work[object] | None] = SimpleQueue()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)
        self._thread.start()

    def call(self, work: Callable[[], T], waiting: Waiting, timeout_s: float) -> T:
        """Run ``work`` on the thread and return its result, or raise its exception.

        Raises
        ------
        Blocked
            It did not return within ``timeout_s``.
        Cancelled
            `waiting` was cancelled; work that has not begun is dropped.
        """
        item = _Work(work, waiting)
        self._queue.put(item)  # type: ignore[arg-type]  # the thread ignores the type of the result
        try:
            if not waiting.until(lambda: item.is_done, timeout_s):
                raise Blocked
        except BaseException:
            item.is_abandoned = True
            raise
        return item.result()

    def finish(self, timeout_s: float) -> None:
        """End the thread after the calls that have begun; not waited for longer than ``timeout_s``."""
        self._queue.put(None)
        self._thread.join(timeout_s)

    def _run(self) -> None:
        while (item := self._queue.get()) is not None:
            item.run()
