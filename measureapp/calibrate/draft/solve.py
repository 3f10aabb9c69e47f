"""Solving a draft of any kind."""

from __future__ import annotations

from dataclasses import replace

from measureapp.calibrate.draft.draft import Draft, Solved
from measureapp.data.calibration import CameraArrayCalibration
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
    start = _start(draft, afresh)
    return replace(draft.kind.solve(start, progress or NoProgress()), sightings=draft.sightings)


def solve_cameras_alone(draft: Draft, progress: Progress | None = None, *, afresh: bool = False) -> CameraArrayCalibration | None:
    """Calibrate the cameras of a draft in which more is to be solved; None where there is nothing more. Parameters and errors as `solve`."""
    return draft.kind.solve_cameras_alone(_start(draft, afresh), progress or NoProgress())


def _start(draft: Draft, afresh: bool) -> Draft:
    if not draft.observations:
        raise CalibrationError(f"The {draft.setup.board.label} was not detected yet.", "Add observations that show it.")
    return replace(draft, solved=None) if afresh else draft
