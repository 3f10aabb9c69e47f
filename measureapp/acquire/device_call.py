"""Calls of drivers that a person can cancel while they block, and that are given up when they never return."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Generic, TypeVar

from measureapp.errors import DeviceLost, MeasureError
from measureapp.progress import Cancelled

T = TypeVar("T")
POLL_S = 0.02
GRACE_S = 4.0  # beyond the time that a driver promised; it is then taken for lost
LEAVE_S = 0.5  # for a cancelled call to return


class _Outcome(Generic[T]):
    """What a call returned or raised."""

    def __init__(self, function: Callable[[], T]) -> None:
        self.done = threading.Event()
        self.value: T | None = None
        self.error: BaseException | None = None
        self._function = function

    def run(self) -> None:
        """Make the call; on its own thread."""
        try:
            self.value = self._function()
        except BaseException as error:  # passed on to the thread that waits
            self.error = error
        finally:
            self.done.set()


def call_device(what: str, function: Callable[[], T], within_s: float, check: Callable[[], None], on_cancel: Callable[[], object]) -> T:
    """Make a call of a driver on a thread of its own and wait for it.

    Parameters
    ----------
    what : the device, for a message
    within_s : how long the driver may take; it is left alone a few seconds later
    check : called while waiting; raises Cancelled when the call is to end
    on_cancel : stops the device then

    Raises
    ------
    DeviceLost
        The call did not return, and its thread is left behind; or the driver raised what is no error of this program: what the device does
        now is unknown.
    Cancelled
        From ``check``; the device was stopped.
    """
    outcome: _Outcome[T] = _Outcome(function)
    threading.Thread(target=outcome.run, name=what, daemon=True).start()
    deadline = time.monotonic() + within_s + GRACE_S
    try:
        while not outcome.done.wait(POLL_S):
            check()
            if time.monotonic() > deadline:
                raise DeviceLost(f"{what} does not answer any more.", "Check its power and cable, and connect the rig again.")
    except (Cancelled, KeyboardInterrupt):
        on_cancel()
        outcome.done.wait(LEAVE_S)
        raise
    if isinstance(outcome.error, Exception) and not isinstance(outcome.error, MeasureError | Cancelled):
        raise DeviceLost(
            f"{what} failed: {type(outcome.error).__name__}: {outcome.error}.",
            "Check its power and cable, and connect the rig again; if it happens again, report it to the author of the driver.",
        ) from outcome.error
    if outcome.error is not None:
        raise outcome.error
    return outcome.value  # type: ignore[return-value]
