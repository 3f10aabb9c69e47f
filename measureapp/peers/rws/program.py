"""What the module `MeasureApp.mod` does when a controller runs it: its mailbox, moves, settling, abort and heartbeat."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.peers.moving_axes import MovingAxes
from measureapp.peers.rws.symbols import Symbols, Value

IDLE, MOVING, SETTLING, REFUSED = 1.0, 2.0, 3.0, 7.0
RUN, DONE, STATE, ERROR, BEAT = range(5)  # components of mm_answer
BEAT_S = 0.2
FULL_SPEED_DEG_PER_S = 300.0  # reorientation that the axes drive at their own speed
OUTSIDE = "50027: Joint Out of Range"


class MailboxProgram:
    """The program of one task. It has no thread: `advance` brings it up to now, and is called before anything is read or written.

    Parameters
    ----------
    symbols : the data of its module
    axes : the six joints, degrees
    limits_deg : (6, 2)
    now : clock in seconds
    time_scale : of settling; 0: at once
    fail : called with a text when a move is impossible, which stops the program
    """

    def __init__(
        self,
        symbols: Symbols,
        axes: MovingAxes,
        limits_deg: FloatArray,
        now: Callable[[], float],
        time_scale: float,
        fail: Callable[[str], None],
    ) -> None:
        self.symbols = symbols
        self.running = False
        self.speed_ratio = 1.0
        self.goal_error_deg = np.zeros(6)
        self.beats = True  # False: the interrupt of the heartbeat is dead
        self._axes, self._limits_deg, self._now, self._time_scale, self._fail = axes, limits_deg, now, time_scale, fail
        self._at_main = True
        self._seen = 0.0
        self._goal: FloatArray | None = None  # of a move that is under way or interrupted
        self._share = 1.0
        self._settled_at: float | None = None
        self._beat_from = now()

    def start(self) -> None:
        """Start at the program pointer: at main, or continue an interrupted move."""
        self.running = True
        self._beat_from = self._now()
        if self._at_main:
            self._begin_main()
        elif self._goal is not None:
            self._axes.move(list(self._goal), self._share * self.speed_ratio)

    def stop(self) -> None:
        """Stop the program and the axes; a move stays interrupted until `reset_pointer`."""
        self.advance()
        self.running = False
        self._axes.stop()

    def reset_pointer(self) -> None:
        """Set the program pointer to main."""
        self._at_main, self._goal, self._settled_at = True, None, None

    def written(self, name: str) -> None:
        """React to data written from outside."""
        if name == "mm_abort" and self.running and self.symbols.text("mm_abort") == "TRUE":
            self._axes.stop()
            self.reset_pointer()
            self._begin_main()
        self.advance()

    def advance(self) -> None:
        """Run until now."""
        if not self.running:
            return
        beats = int((self._now() - self._beat_from) / BEAT_S)
        if beats and self.beats:
            self._beat_from += beats * BEAT_S
            self._report(BEAT, (self._reported(BEAT) + beats) % 1_000_000)
        self._finish_move()
        if self._goal is None and self.symbols.number("mm_cmd") > self._seen:
            self._take_order()
            self._finish_move()

    def _begin_main(self) -> None:
        self._at_main = False
        self.symbols.put("mm_abort", False)
        self._report(ERROR, 0.0)
        self._seen = self.symbols.number("mm_cmd")
        self._report(RUN, self._reported(RUN) + 1.0)
        self._report(STATE, IDLE)

    def _take_order(self) -> None:
        self._seen = self.symbols.number("mm_cmd")
        order = self.symbols.record("mm_order")
        if order[0] != self._seen:
            self._report(STATE, REFUSED)
            return
        (joints, _external), (_path, turn, *_) = _lists(order[1]), _lists(order[2])
        goal = np.array(joints, float)
        if ((goal < self._limits_deg[:, 0]) | (goal > self._limits_deg[:, 1])).any():
            self._fail(OUTSIDE)
            return
        self._goal = goal + self.goal_error_deg
        self._share = min(1.0, float(np.array(turn)) / FULL_SPEED_DEG_PER_S)
        self._report(STATE, MOVING)
        self._axes.move(list(self._goal), self._share * self.speed_ratio)

    def _finish_move(self) -> None:
        if self._goal is None or self._axes.is_moving:
            return
        if self._settled_at is None:
            self._settled_at = self._now() + self.symbols.number("mm_settle") * self._time_scale
            self._report(STATE, SETTLING)
        if self._now() < self._settled_at:
            return
        self._report(STATE, IDLE)
        self._report(DONE, self._seen)
        self._goal = self._settled_at = None

    def _reported(self, component: int) -> float:
        return float(np.array(self.symbols.record("mm_answer")[component]))

    def _report(self, component: int, value: float) -> None:
        report = self.symbols.record("mm_answer")
        report[component] = value
        self.symbols.put("mm_answer", report)


def _lists(value: Value) -> list[Value]:
    assert isinstance(value, list)
    return value
