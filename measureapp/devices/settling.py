"""When an axis counts as being at rest, and where: decided from reads of its position, not from what was commanded."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

Verdict = Literal["moving", "arrived", "elsewhere"]
ELSEWHERE_S = 1.0  # of rest away from the goal before it is taken for the end of the move
MARGIN, MARGIN_S = 1.5, 2.0  # of the predicted duration of a move


def allowed_s(predicted_s: float, timeout_s: float) -> float:
    """Return how long a move may take: 1.5 times its predicted duration and 2 s, at most ``timeout_s``."""
    return min(timeout_s, MARGIN * predicted_s + MARGIN_S)


class Settling:
    """Follows one move.

    Parameters
    ----------
    goal, tolerance : in any one unit
    settled_s : time between two reads that must agree
    difference : distance of two positions; for axes that count modulo one turn
    """

    def __init__(
        self, goal: float, tolerance: float, settled_s: float, difference: Callable[[float, float], float] = lambda one, other: one - other
    ) -> None:
        self._goal, self._tolerance, self._settled_s = goal, tolerance, settled_s
        self._difference = difference
        self._since: tuple[float, float] | None = None  # time and position of the first read at rest

    def observe(self, now_s: float, position: float, moving: bool) -> Verdict:
        """Take a read of the position, and whether the drive reports that it moves; return what follows."""
        if self._since is None or moving or abs(self._difference(position, self._since[1])) > self._tolerance:
            self._since = (now_s, position)
            return "moving"
        rested_s = now_s - self._since[0]
        if rested_s >= self._settled_s and self.distance(position) <= self._tolerance:
            return "arrived"
        return "elsewhere" if rested_s > max(ELSEWHERE_S, self._settled_s) else "moving"

    def distance(self, position: float) -> float:
        """Return the distance to the goal."""
        return abs(self._difference(position, self._goal))
