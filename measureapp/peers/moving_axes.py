"""Axes that move as a controller moves them: together, smoothly, and as long as a trapezoidal profile takes."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray

Now = Callable[[], float]  # seconds, never back


class MovingAxes:
    """One or several axes of a controller that start and stop together. All methods may be called from any thread.

    Parameters
    ----------
    start : (n,) positions, in the controller's unit
    speed, acceleration : (n,) in units per second and per second squared
    now : clock in seconds
    on_rest : called with the positions (n,) at the end of every move, also of a stopped one, before `is_moving` turns false
    """

    def __init__(
        self,
        start: Sequence[float],
        speed: Sequence[float],
        acceleration: Sequence[float],
        now: Now = time.monotonic,
        on_rest: Callable[[FloatArray], None] = lambda _: None,
    ) -> None:
        self._lock = threading.RLock()
        self._from = self._to = np.array(start, float)
        self._speed, self._acceleration = np.array(speed, float), np.array(acceleration, float)
        self._now, self._on_rest = now, on_rest
        self._began = self._ends = now()
        self._rests = True

    def move(self, goal: Sequence[float], share_of_speed: float = 1.0) -> float:
        """Start a move from the present position to ``goal`` and return its duration in seconds."""
        with self._lock:
            here = self.positions()
            self._from, self._to = here, np.array(goal, float)
            self._began = self._now()
            seconds = float(np.max(self._durations(np.abs(self._to - here), share_of_speed), initial=0.0))
            self._ends = self._began + seconds
            self._rests = False
            return seconds

    def stop(self) -> None:
        """Stop where the axes are."""
        with self._lock:
            self._from = self._to = self.positions()
            self._ends = self._now()
            self.positions()

    def positions(self) -> FloatArray:
        """Return the present positions (n,)."""
        with self._lock:
            now = self._now()
            if now >= self._ends:
                if not self._rests:
                    self._on_rest(self._to.copy())
                    self._rests = True
                return self._to.copy()
            share = (now - self._began) / (self._ends - self._began)
            smooth = share * share * (3.0 - 2.0 * share)  # at rest at both ends
            return self._from + smooth * (self._to - self._from)

    @property
    def is_moving(self) -> bool:
        """Whether a move is under way."""
        self.positions()
        return not self._rests

    def _durations(self, way: FloatArray, share_of_speed: float) -> FloatArray:
        speed = self._speed * share_of_speed
        ramps = speed / self._acceleration
        short = way < speed * ramps
        return np.where(short, 2.0 * np.sqrt(way / self._acceleration), way / speed + ramps)
