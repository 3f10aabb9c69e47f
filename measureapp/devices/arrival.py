"""When an axis has arrived: two reads agree with each other and with the goal, whatever the controller says of itself."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from measureapp.devices.attempt import Attempt
from measureapp.errors import MotionError

GIVEN_UP_S = 1.0  # at rest beside the goal, after which it is not expected to go on
MARGIN, MARGIN_S = 1.5, 2.0  # of the predicted duration of a move


@dataclass(frozen=True, slots=True)
class Arrival:
    """How arrival is judged, in the unit of the axis."""

    axis: str
    unit: str
    tolerance: float  # largest difference of two reads, and of read and goal
    settled_s: float  # time between the two reads
    poll_s: float

    def wait(self, goal: float, read: Callable[[], float], moves: Callable[[], bool], attempt: Attempt) -> None:
        """Wait until ``read`` gives the goal twice, ``settled_s`` apart, while ``moves`` says no.

        Raises
        ------
        MotionError
            The axis came to rest beside its goal.
        Cancelled, DeviceTimeout
            From ``attempt``.
        """
        since, last = time.monotonic(), None
        while True:
            attempt.wait(self.poll_s)
            now, here = time.monotonic(), read()
            if last is None or abs(here - last) > self.tolerance or moves():
                since, last = now, here
            elif now - since >= self.settled_s:
                if abs(here - goal) <= self.tolerance:
                    return
                if now - since > max(GIVEN_UP_S, 2.0 * self.settled_s):
                    raise MotionError(
                        f"{self.axis} came to rest {abs(here - goal):.3f}{self.unit} away from its goal.",
                        "Check for an obstacle, a limit switch, and the scale of the drive.",
                    )


def within_s(predicted_s: float, timeout_s: float) -> float:
    """Return how long a move may take: half as long again as predicted and two seconds, at most ``timeout_s``."""
    return min(timeout_s, MARGIN * predicted_s + MARGIN_S)
