"""A rotary table on a pair of pseudo-terminals: its axis, its faults, and the line. What it is told in is in `serial_controllers`."""

from __future__ import annotations

import os
import select
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Protocol

from measureapp.peers.moving_axes import MovingAxes, Now
from measureapp.peers.pseudo_terminal import serial_line

LOOK_S = 0.02


@dataclass(frozen=True, slots=True)
class TableFaults:
    """What goes wrong; may be replaced at any time."""

    silent: bool = False  # nothing is answered, and nothing is done
    late_s: float = 0.0  # commands are carried out at once and answered this much later
    late_once: bool = False  # only the next answer is late
    sliced: bool = False  # answers arrive byte by byte
    garbage: bytes = b""  # sent in place of answers
    shifted: bool = False  # every answer is that to the question before
    frozen: bool = False  # the reported position never changes
    early_done: bool = False  # the end of a move is reported while the table still turns
    off_target: float = 0.0  # it comes to rest beside its goal by this much, in the controller's unit
    refuse: str = ""  # error code for every command that moves
    alarm: str = ""  # error code reported with the state, where the controller has one
    referenced: bool = True


class TableAxis:
    """The axis, in the unit of its controller. All methods may be called from any thread."""

    def __init__(
        self,
        position: float = 0.0,
        speed: float = 20.0,
        acceleration: float = 80.0,
        now: Now = time.monotonic,
        on_rest: Callable[[float], None] = lambda _: None,
    ) -> None:
        self.faults = TableFaults()
        self.moves: list[float] = []  # goals of all moves that were started
        self.stops = 0
        self.goal = position
        self.motor_on = False
        self._frozen_at = position
        self._axes = MovingAxes((position,), (speed,), (acceleration,), now, lambda at: on_rest(float(at[0])))

    def position(self) -> float:
        """Return the true position."""
        return float(self._axes.positions()[0])

    def told_position(self) -> float:
        """Return the position that the controller reports."""
        if not self.faults.frozen:
            self._frozen_at = self.position()
        return self._frozen_at

    def told_moving(self) -> bool:
        """Return whether the controller says that the table turns."""
        return self._axes.is_moving and not self.faults.early_done

    def start(self, goal: float) -> None:
        """Start a move."""
        self.goal = goal
        self.moves.append(goal)
        self._axes.move((goal + self.faults.off_target,))

    def stop(self) -> None:
        """Stop where it is."""
        self.stops += 1
        self._axes.stop()

    def find_reference(self) -> None:
        """Find the reference position."""
        self.faults = replace(self.faults, referenced=True)
        self.start(0.0)


class Controller(Protocol):
    """A controller that understands lines."""

    axis: TableAxis
    command_end: bytes
    reply_end: bytes
    echo: bool

    def answer(self, command: str) -> str | None:
        """Carry a command out; return its answer, or None where there is none."""


class TableLine:
    """Answers on a terminal."""

    def __init__(self, controller: Controller, handle: int) -> None:
        self._controller, self._handle = controller, handle
        self._ends = threading.Event()
        self._before = b""

    def serve(self) -> None:
        """Answer until `end`."""
        heard, end = b"", self._controller.command_end
        while not self._ends.is_set():
            if not select.select([self._handle], [], [], LOOK_S)[0]:
                continue
            try:
                heard += os.read(self._handle, 4096)
            except OSError:
                return
            while end in heard:
                line, heard = heard.split(end, 1)
                self._reply(line)

    def end(self) -> None:
        """Let `serve` return."""
        self._ends.set()

    def _reply(self, line: bytes) -> None:
        controller = self._controller
        if controller.axis.faults.silent:
            return
        answer = controller.answer(line.decode("ascii", "replace").strip())
        echoed = line + controller.command_end if controller.echo else b""
        if answer is None:
            self._write(echoed)
            return
        self._send(echoed + answer.encode("ascii") + controller.reply_end)

    def _send(self, reply: bytes) -> None:
        axis = self._controller.axis
        faults = axis.faults
        if faults.shifted:
            reply, self._before = self._before or reply, reply
        reply = faults.garbage or reply
        if faults.late_s:
            if faults.late_once:
                axis.faults = replace(faults, late_s=0.0, late_once=False)
            self._ends.wait(faults.late_s)
        for piece in [reply[place : place + 1] for place in range(len(reply))] if faults.sliced else [reply]:
            self._write(piece)
            if faults.sliced:
                self._ends.wait(0.001)

    def _write(self, data: bytes) -> None:
        try:
            os.write(self._handle, data)
        except OSError:
            self._ends.set()


@contextmanager
def on_serial(controller: Controller) -> Iterator[str]:
    """Serve on a pair of pseudo-terminals; yields the port for the client."""
    with serial_line() as (handle, port):
        line = TableLine(controller, handle)
        thread = threading.Thread(target=line.serve, name="Rotary table, serial")
        thread.start()
        try:
            yield port
        finally:
            line.end()
            thread.join()
