"""The controller's resources as typed calls; every write is confirmed by reading back what it should have changed."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import DeviceError, DeviceLost, MotionError
from measureapp.geometry.transform import RigidTransform

from . import rapid
from .session import Refused, RwsSession, Unanswered
from .words import mode_words, state_words

START = {
    "regain": "clear",
    "execmode": "continue",
    "cycle": "forever",
    "condition": "none",
    "stopatbp": "disabled",
    "alltaskbytsp": "false",
}
AXES = 6
SECOND_LOOK_S = 0.1
_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Situation:
    """Motors, operating mode and program at one moment."""

    ctrlstate: str
    opmode: str
    running: bool

    @property
    def may_move(self) -> bool:
        """Whether motors and operating mode allow moves."""
        return self.ctrlstate == "motoron" and self.opmode == "AUTO"

    @property
    def words(self) -> str:
        """The state, such as "motors on, automatic mode, program stopped"."""
        return f"{state_words(self.ctrlstate)[0]}, {mode_words(self.opmode)[0]}, program {'running' if self.running else 'stopped'}"

    @property
    def remedy(self) -> str:
        """What a person does about it; empty where nothing is wrong."""
        return state_words(self.ctrlstate)[1] if self.ctrlstate not in ("motoron", "motoroff") else mode_words(self.opmode)[1]


@dataclass(frozen=True)
class Message:
    """One message of the event log."""

    number: int
    kind: int  # 1 information, 2 warning, 3 error
    code: int
    title: str


class Controller:
    """Typed calls of one login.

    Parameters
    ----------
    names : "task", "module" and "unit"
    """

    def __init__(self, session: RwsSession, names: Mapping[str, str]) -> None:
        self.session = session
        self.symbols = {"task": names["task"], "module": names["module"]}
        self._unit = names["unit"]

    def system(self) -> tuple[str, str]:
        """Return id and RobotWare version of the system."""
        row = self._row("system")
        return str(row.get("sysid", "")), str(row.get("rwversion", ""))

    def situation(self) -> Situation:
        """Read motors, operating mode and program."""
        return Situation(self._field("ctrlstate", "ctrlstate"), self._field("opmode", "opmode"), self.is_running())

    def is_running(self) -> bool:
        """Read whether the program runs."""
        return self._field("execution", "ctrlexecstate") == "running"

    def speed_ratio(self) -> float:
        """Read the speed that is set at the controller, 0…1."""
        return self._number("speedratio", self._field("speedratio", "speedratio")) / 100.0

    def joints_deg(self) -> FloatArray:
        """Read the joint angles (6,) in degrees."""
        row = self._row("joints", unit=self._unit)
        return np.array([self._number("joints", str(row.get(f"rax_{axis}", ""))) for axis in range(1, AXES + 1)])

    def pose(self) -> RigidTransform:
        """Read base_from_flange as the controller calculates it."""
        row = self._row("pose", unit=self._unit)
        values = np.array([self._number("pose", str(row.get(name, ""))) for name in ("x", "y", "z", "q1", "q2", "q3", "q4")])
        length = float(np.linalg.norm(values[3:]))
        if abs(length - 1.0) > 1e-3:
            raise DeviceError(f"The controller's pose has a quaternion of length {length:g}.", "Connect again.")
        return RigidTransform.from_quaternion(values[3:] / length, values[:3], "base", "flange")

    def read(self, name: str) -> str:
        """Read a data object of the module as RAPID text."""
        return str(self._row("symbol", name=name, **self.symbols).get("value", ""))

    def write(self, name: str, value: str) -> None:
        """Write a data object of the module and read it back."""
        self._carry_out(
            lambda: self.session.post("set symbol", {"value": value}, name=name, **self.symbols),
            lambda: rapid.equal(self.read(name), value),
            f"the value {value} of {name}",
        )

    def switch_motors(self, on: bool) -> None:
        """Switch the motors."""
        wanted = "motoron" if on else "motoroff"
        self._carry_out(
            lambda: self.session.post("set ctrlstate", {"ctrl-state": wanted}),
            lambda: self._field("ctrlstate", "ctrlstate") == wanted,
            f"motors {'on' if on else 'off'}",
        )

    def start(self) -> None:
        """Start the program at its pointer."""
        self._carry_out(lambda: self.session.post("start", START), self.is_running, "the start of the program")

    def stop(self) -> None:
        """Stop the program and the robot."""
        form = {"stopmode": "stop", "usetsp": "normal"}
        self._carry_out(lambda: self.session.post("stop", form), lambda: not self.is_running(), "the stop of the program")

    def reset_pointer(self) -> None:
        """Set the program pointer to main; writing it twice does no harm, and there is nothing to read back."""
        try:
            self.session.post("resetpp")
        except Unanswered:
            if not self.is_running():
                self.session.post("resetpp")

    @contextmanager
    def mastership(self) -> Iterator[None]:
        """Hold mastership of RAPID for a few writes; it is released in every case.

        Raises
        ------
        DeviceError
            Another client holds it; names it.
        """
        try:
            self._carry_out(lambda: self.session.post("request mastership"), self._is_master, "mastership of RAPID")
        except Refused as error:
            raise self.explained(error, f"Mastership of RAPID is held by {self._master() or 'nobody'}.") from error
        try:
            yield
        except DeviceLost:
            _log.warning("mastership ends with the session: the controller does not answer")
            raise
        except BaseException:
            self._release()
            raise
        self._release()

    def messages(self, after: int = 0) -> list[Message]:
        """Read the event log, newest first: messages with a number greater than ``after``."""
        found = []
        for row in self.session.get("log"):
            number = self._number("log", str(row.get("_title", "")).rpartition("/")[2])
            kind, code = (self._number("log", str(row.get(name, "0"))) for name in ("msgtype", "code"))
            found.append(Message(int(number), int(kind), int(code), str(row.get("title", ""))))
        return [message for message in found if message.number > after]

    def explained(self, refused: Refused, more: str = "") -> MotionError:
        """Return the refusal together with the controller's state."""
        situation = self.situation()
        remedy = situation.remedy or "Bring the controller into the state named, then connect again."
        return MotionError(" ".join(filter(None, (refused.message, more, f"State: {situation.words}."))), remedy)

    def _is_master(self) -> bool:
        return self._field("mastership", "mastershipheldbyme").upper() == "TRUE"

    def _master(self) -> str:
        row = self._row("mastership")
        nobody = row.get("mastership", "nomaster") == "nomaster"
        return "" if nobody else f"{row.get('application') or 'another client'} ({row.get('mastership')}, user {row.get('uid')})"

    def _release(self) -> None:
        try:
            self.session.post("release mastership")
            return
        except (Unanswered, Refused) as error:
            _log.warning("mastership was not released: %s", error)
        try:
            if self._is_master():
                self.session.post("release mastership")
        except DeviceError as error:
            _log.warning("mastership ends with the session: %s", error)

    def _carry_out(self, write: Callable[[], None], is_done: Callable[[], bool], what: str) -> None:
        """Write, then read back. A write without an answer is repeated only after two read-backs deny it: every value is absolute."""
        end, attempts, answered = time.monotonic() + self.session.patience_s, 0, 0
        while attempts < 2 or (answered < 2 and time.monotonic() < end):
            attempts += 1
            try:
                write()
                answered += 1
            except Unanswered as error:
                _log.warning("no answer to %s: reading back: %s", what, error)
            except Refused:
                if attempts == 1 or not is_done():  # a repeated start is refused when the first one came late
                    raise
            if self._soon(is_done):
                return
        raise DeviceError(f"The controller did not carry out {what}: it reads back something else.", "Connect again.")

    @staticmethod
    def _soon(is_done: Callable[[], bool]) -> bool:
        if is_done():
            return True
        time.sleep(SECOND_LOOK_S)
        return is_done()

    def _row(self, what: str, **names: str) -> Mapping[str, object]:
        rows = self.session.get(what, **names)
        if not rows:
            raise DeviceError(f"The controller's answer to {what!r} is empty.", "Check the mechanical unit and task in the settings.")
        return rows[0]

    def _field(self, what: str, name: str) -> str:
        value = str(self._row(what).get(name, ""))
        if not value:
            raise DeviceError(f"The controller's answer to {what!r} has no {name!r}.", "Check the version of Robot Web Services.")
        return value

    @staticmethod
    def _number(what: str, text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not np.isfinite(value):
            raise DeviceError(f"The controller's answer to {what!r} has {text[:40]!r} in place of a number.", "Connect again.")
        return value
