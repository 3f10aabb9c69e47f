"""Signals that end a program, as an interruption: a terminal that is closed, or a computer that shuts down, must leave no axis moving."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager

ENDING = ("SIGTERM", "SIGHUP", "SIGBREAK")  # those that this system knows


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Let signals that end a program raise KeyboardInterrupt, as Ctrl-C does, while the body runs; in the main thread only."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    numbers = [number for name in ENDING if (number := getattr(signal, name, None)) is not None]
    former = {number: signal.signal(number, _interrupt) for number in numbers}
    try:
        yield
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)


def _interrupt(*_: object) -> None:
    raise KeyboardInterrupt
