"""Stopping: the ladder of ways that make the controller stop, on a login of its own."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable

from measureapp.errors import DeviceError, DeviceLost

from .controller import Controller
from .mailbox import Mailbox
from .session import Unanswered

STOP_FORM = {"stopmode": "stop", "usetsp": "normal"}
MOTORS_OFF = {"ctrl-state": "motoroff"}
_log = logging.getLogger(__name__)


class StopLadder:
    """Three ways to stop the robot, tried one after the other until one is confirmed; none of them replaces the emergency stop.

    Parameters
    ----------
    controller, mailbox : of a login that nothing else uses, so that a stop never waits for another call
    """

    def __init__(self, controller: Controller, mailbox: Mailbox) -> None:
        self._controller, self._mailbox = controller, mailbox
        self._lock = threading.Lock()

    def keep_alive(self, patience_s: float) -> None:
        """Use the login, so that it has not expired when it is needed. Raises DeviceLost when it is not answered in time."""
        end = time.monotonic() + patience_s
        while True:
            try:
                self._controller.is_running()
                return
            except DeviceLost:
                if time.monotonic() > end:
                    raise

    def stop(self) -> None:
        """Stop the robot.

        Raises
        ------
        DeviceLost
            The controller confirms none of the three ways.
        """
        ways: tuple[tuple[str, Callable[[], bool]], ...] = (
            ("stop of the program", self._stop_program),
            ("abort of the move", self._abort),
            ("motors off", self._switch_off),
        )
        with self._lock:
            for name, way in ways:
                try:
                    if way():
                        return
                except DeviceError as error:
                    _log.warning("%s is not confirmed: %s", name, error)
        raise DeviceLost("The robot's controller confirms no stop.", "Press the emergency stop.")

    def forget_move(self) -> None:
        """Make sure that whatever starts the program later does not go on with an order that was interrupted, or not begun yet."""
        with self._lock:
            self._forget_move()

    def stop_unheard(self) -> None:
        """Request a stop from a controller that does not answer any more: it may still hear. Takes two time limits at most."""
        for what, form in (("stop", STOP_FORM), ("set ctrlstate", MOTORS_OFF)):
            try:
                self._controller.session.post(what, form)
                return
            except DeviceError as error:
                _log.warning("%s is not confirmed: %s", what, error)

    def _stop_program(self) -> bool:
        try:
            self._controller.session.post("stop", STOP_FORM)
        except Unanswered as error:
            _log.warning("the stop was not answered: %s", error)
        stopped = not self._controller.is_running()
        if stopped:
            self._forget_move()
        return stopped

    def _abort(self) -> bool:
        before = self._mailbox.answer().run
        self._mailbox.abort()
        return self._mailbox.answer().run != before

    def _switch_off(self) -> bool:
        try:
            self._controller.session.post("set ctrlstate", MOTORS_OFF)
        except Unanswered as error:
            _log.warning("motors off was not answered: %s", error)
        return self._controller.situation().ctrlstate != "motoron"

    def _forget_move(self) -> None:
        """Set the pointer to main, unless the last order was carried out to its end."""
        try:
            if self._mailbox.has_finished():
                return
            with self._controller.mastership():
                self._controller.reset_pointer()
        except DeviceError as error:
            _log.warning("the program pointer stays in the interrupted move: %s", error)
