"""Guidance for a calibration of any kind: what to observe next."""

from __future__ import annotations

from measureapp.calibrate.draft.advice import Advice, Notes
from measureapp.calibrate.draft.draft import Draft
from measureapp.calibrate.draft.locate import locate
from measureapp.errors import CalibrationError


def advise(draft: Draft) -> Advice:
    """Determine what is still missing, and where the board should be shown next.

    Cheap enough to be called after every observation; better once the draft is solved, since lenses and axes are known then.
    """
    notes, cameras = Notes(), draft.setup.cameras
    try:
        if cameras is not None and draft.counted:
            locate(draft.counted, cameras, draft.setup.board)
        ghost = draft.kind.advise(draft, notes)
    except CalibrationError as error:  # images that contradict each other: that comes before all else
        return Advice((str(error),), tuple(notes.gauges))
    return Advice(notes.sentences(draft.setup.lenses), tuple(notes.gauges), ghost)
