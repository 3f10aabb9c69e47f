"""The mailbox of MeasureApp.mod: version, owner, start, orders and answers."""

from __future__ import annotations

import hashlib
import os
import re
import socket
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import psutil  # type: ignore[import-untyped]

from measureapp.arrays import FloatArray
from measureapp.errors import DeviceError, MotionError
from measureapp.resources import resource

from . import rapid
from .controller import Controller
from .session import Refused

VERSION = "MM 1.0"
SHIPPED = "rapid/MeasureApp.mod"
DIGEST_LINE = re.compile(r"^ *PERS string mm_program:=.*$\r?\n?", re.MULTILINE)
IDLE, MOVING, SETTLING, REFUSED, FAILED = 1, 2, 3, 7, 9
BEAT_PATIENCE_S = 2.0
LOAD_IT = "Load resources/rapid/MeasureApp.mod of this program into the task, and connect again."
HOST_LENGTH = 40  # a RAPID string has at most 80 characters


@dataclass(frozen=True)
class Identity:
    """Which controller and which program answer."""

    system_id: str
    version: str
    program: str

    @property
    def words(self) -> str:
        """The identity, for display."""
        return f"system {self.system_id}, RobotWare {self.version}, program {self.program}"


@dataclass(frozen=True)
class Answer:
    """One reading of mm_answer."""

    run: int  # starts of the program
    done: int  # number of the last order that was carried out
    state: int
    error: int
    beat: int


def digest(module_text: str) -> str:
    """Return the digest that a module states about itself: SHA-256 of its text without the line that holds it."""
    text = DIGEST_LINE.sub("", module_text).replace("\r\n", "\n")
    return hashlib.sha256(text.encode("ascii")).hexdigest()[:16]


def own_name() -> str:
    """Return how this program names itself to others at the controller."""
    host = re.sub(r"[^A-Za-z0-9.-]", "-", socket.gethostname())[:HOST_LENGTH]
    return f"{host}/{os.getpid()}"


class Mailbox:
    """Order and answer of the module.

    Parameters
    ----------
    owner : how this program names itself
    take_over : take the robot even from a program of another computer
    """

    def __init__(self, controller: Controller, owner: str, take_over: bool) -> None:
        self._controller, self._owner, self._take_over = controller, owner, take_over
        self._run = -1

    def identity(self) -> Identity:
        """Read who answers, and refuse a module that is not the one shipped.

        Raises
        ------
        DeviceError
            No such module, or another version.
        """
        system_id, version = self._controller.system()
        try:
            told = rapid.read_text(self._controller.read("mm_version"))
            program = rapid.read_text(self._controller.read("mm_program"))
        except Refused as error:
            raise DeviceError(f"The controller has no module of this program: {error.message}", LOAD_IT) from error
        except ValueError as error:
            raise DeviceError(f"The controller's module is another one: {error}.", LOAD_IT) from error
        expected = digest(Path(resource(SHIPPED)).read_text(encoding="ascii"))
        if told != VERSION or program != expected:
            raise DeviceError(
                f"The controller's module is version {told!r} ({program}); this program needs {VERSION!r} ({expected}).", LOAD_IT
            )
        return Identity(system_id, version, program)

    def claim(self) -> None:
        """Reserve the robot for this program.

        Raises
        ------
        DeviceError
            Another program has it; names it.
        """
        if self._holder() == self._owner:
            return
        with self._controller.mastership():
            holder = self._holder()
            if holder and holder != self._owner and not self._has_ended(holder):
                host, _, process = holder.partition("/")
                raise DeviceError(
                    f"The robot is used by another program (computer {host}, process {process}); this one may only read.",
                    "Close that program. If it has ended without releasing the robot, switch on take_over in the robot's settings.",
                )
            self._controller.write("mm_owner", rapid.text(self._owner))

    def release(self) -> None:
        """Let other programs use the robot, if it is ours."""
        if self._holder() == self._owner:
            with self._controller.mastership():
                self._controller.write("mm_owner", rapid.text(""))

    def answer(self) -> Answer:
        """Read the program's answer. Raises DeviceError when it makes no sense."""
        text = self._controller.read("mm_answer")
        try:
            numbers = rapid.read_numbers(text)
        except ValueError as error:
            raise DeviceError(f"mm_answer of the controller is invalid: {error}.", LOAD_IT) from error
        if numbers.shape != (5,):
            raise DeviceError(f"mm_answer of the controller has {numbers.size} numbers instead of 5: {text[:60]!r}.", LOAD_IT)
        return Answer(*(int(number) for number in numbers))

    def has_finished(self) -> bool:
        """Whether no order is under way, interrupted or waiting."""
        answer = self.answer()
        return answer.state not in (MOVING, SETTLING) and answer.done == self._command()

    def was_restarted(self, answer: Answer) -> bool:
        """Whether the program was started again since `start`."""
        return answer.run != self._run

    def start(self, switch_motors_on: bool, settle_s: float, pause: Callable[[float], None]) -> None:
        """Start the program afresh and see it live: motors, pointer to main, start, heartbeat.

        Parameters
        ----------
        pause : waits for seconds; raises Cancelled after a stop

        Raises
        ------
        MotionError
            The controller's state forbids it; names the state.
        """
        if self._controller.is_running():
            self._controller.stop()
        self._switch_motors_on(switch_motors_on, pause)
        before = self.answer().run
        try:
            with self._controller.mastership():
                self._controller.reset_pointer()
                self._controller.write("mm_settle", f"{settle_s:g}")
                pause(0.0)
                self._controller.start()
        except Refused as error:
            raise self._controller.explained(error) from error
        self._run = self._alive(before, pause).run

    def order(self, goal_deg: FloatArray, speed_mm_per_s: float, speed_deg_per_s: float, pause: Callable[[float], None]) -> int:
        """Order a move and return its number: the order first, read back, then its number, which starts it."""
        number = self._command() + 1
        if number >= rapid.LARGEST_COUNT:
            raise MotionError("The counter of orders is used up.", "Set mm_cmd to 0 on the FlexPendant while the program is stopped.")
        try:
            with self._controller.mastership():
                self._controller.write("mm_order", rapid.order(number, goal_deg, speed_mm_per_s, speed_deg_per_s))
                pause(0.0)
                self._controller.write("mm_cmd", str(number))
        except Refused as error:
            raise self._controller.explained(error) from error
        return number

    def abort(self) -> None:
        """Make the program drop its move."""
        with self._controller.mastership():
            self._controller.session.post("set symbol", {"value": "TRUE"}, name="mm_abort", **self._controller.symbols)

    def _command(self) -> int:
        text = self._controller.read("mm_cmd")
        try:
            return int(rapid.read_numbers(text)[0])
        except ValueError as error:
            raise DeviceError(f"mm_cmd of the controller is invalid: {error}.", LOAD_IT) from error

    def _switch_motors_on(self, allowed: bool, pause: Callable[[float], None]) -> None:
        situation = self._controller.situation()
        if situation.ctrlstate == "motoroff" and situation.opmode == "AUTO" and allowed:
            try:
                self._controller.switch_motors(on=True)
            except Refused as error:
                raise self._controller.explained(error) from error
            situation = self._controller.situation()
        if not situation.may_move:
            remedy = situation.remedy or "Switch the motors on."
            raise MotionError(f"The robot may not move: {situation.words}.", remedy)
        pause(0.0)

    def _alive(self, run_before: int, pause: Callable[[float], None]) -> Answer:
        """Wait until the program has passed its start and its heart beats."""
        end = time.monotonic() + BEAT_PATIENCE_S
        first: Answer | None = None
        while time.monotonic() < end:
            answer = self.answer()
            if answer.run != run_before:
                first = first or answer
                if answer.state == IDLE and answer.beat != first.beat:
                    return answer
            pause(0.03)
        what = "was not started" if first is None else f"has no heartbeat (state {first.state}, error {first.error})"
        raise MotionError(f"The program in the controller {what}.", "Check on the FlexPendant that its main is the one of MeasureApp.mod.")

    def _holder(self) -> str:
        try:
            return rapid.read_text(self._controller.read("mm_owner"))
        except ValueError as error:
            raise DeviceError(f"mm_owner of the controller is invalid: {error}.", LOAD_IT) from error

    def _has_ended(self, holder: str) -> bool:
        host, _, process = holder.partition("/")
        here = host == self._owner.partition("/")[0]
        return self._take_over or (here and process.isdecimal() and not psutil.pid_exists(int(process)))
