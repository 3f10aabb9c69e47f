"""Solving a draft of any kind."""

from __future__ import annotations

from dataclasses import replace

from measureapp.calibrate.draft.draft import Draft, Solved
from measureapp.errors import CalibrationError
from measureapp.progress import NoProgress, Progress


def solve(draft: Draft, progress: Progress | None = None, *, afresh: bool = False) -> Solved:
    """Solve a draft, starting from its last solution where it has one.

    Parameters
    ----------
    afresh : ignore the last solution, as for a result that is accepted

    Raises
    ------
    CalibrationError
        The observations do not determine the result; the message says what is missing.
    """
    if not draft.observations:
        raise CalibrationError(f"The {draft.setup.board.label} was not detected yet.", "Add observations that show it.")
    start = replace(draft, solved=None) if afresh else draft
    return replace(draft.kind.solve(start, progress or NoProgress()), sightings=draft.sightings)
