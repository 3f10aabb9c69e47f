"""How long a measurement still takes, as an operator likes to read it: it may shrink freely, and hardly grow."""

from __future__ import annotations

KNOWN_SHARE = 0.2  # of the work, before which only earlier runs say something
LARGEST_GROWTH = 1.2


class SteadyTime:
    """Time left from the usual duration of earlier runs, else from the share done; it never grows by more than a fifth.

    Parameters
    ----------
    usual_s : duration of earlier runs of the same program; None: there was none
    """

    def __init__(self, usual_s: float | None = None) -> None:
        self._usual_s = usual_s
        self._least_s: float | None = None  # that was shown

    def left(self, share: float, elapsed_s: float) -> float | None:
        """Return the seconds left when ``share`` of the work was done after ``elapsed_s``; None while nobody knows."""
        own = elapsed_s * (1.0 - share) / share if share >= KNOWN_SHARE else None
        usual = None if self._usual_s is None else max(self._usual_s - elapsed_s, (1.0 - share) * self._usual_s / 2)
        if own is None and usual is None:
            return None
        estimate = own if usual is None else usual if own is None else share * own + (1.0 - share) * usual
        assert estimate is not None
        shown = estimate if self._least_s is None else min(estimate, LARGEST_GROWTH * self._least_s)
        self._least_s = shown if self._least_s is None else min(self._least_s, shown)
        return shown
