"""Which axes a recording has read-backs of, and what each view of the board can be used for."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians

from measureapp.data.fringe import AxisReadback
from measureapp.data.recording import AXES, AXIS_WORDS, RecordedAxes, Recording
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.recording.problems import Problems, list_places

MOVED_BY = {"base_from_flange": "robot", "guide_mm": "guide", "table_deg": "table"}
HINT = (
    "Give it everywhere, or nowhere if the rig does not have that axis; "
    "board views for the cameras alone need on_table = false and no read-backs."
)
HEAD_AXES = frozenset({"base_from_flange", "guide_mm"})  # that move the cameras


@dataclass(frozen=True, slots=True)
class RecordedViews:
    """The axes of a recording, and the views of the board that stand apart."""

    axes: tuple[str, ...]
    in_cell: tuple[str, ...]  # the board stands in the cell
    loose: tuple[str, ...]  # without read-backs, or nothing moves: for the cameras only


def board_view_id(number: int, count: int) -> str:
    """Return the id of the board view of this index; the ids sort in the order of the recording."""
    return f"board{number + 1:0{max(3, len(str(count)))}d}"


def find_axes(recording: Recording, problems: Problems) -> RecordedViews:
    """Return the axes with read-backs; an axis that only some entries have is noted as a problem."""
    views = {board_view_id(index, len(recording.board_view)): view for index, view in enumerate(recording.board_view)}
    axes = frozenset[str]().union(*(one.given for one in (*recording.viewpoint, *views.values())))
    in_cell, loose = [], []
    lacking: dict[tuple[str, ...], list[str]] = {}
    for number, (name, view) in enumerate(views.items(), 1):
        needed = axes if view.on_table else axes & HEAD_AXES
        if not needed or (not view.on_table and not view.given & needed):
            loose.append(name)
        else:
            lacking.setdefault(_lacking(needed, view), []).append(f"[[board_view]] {number}")
            in_cell += [] if view.on_table else [name]
    for viewpoint in recording.viewpoint:
        lacking.setdefault(_lacking(axes, viewpoint), []).append(f"viewpoint {viewpoint.id!r}")
    for missing, places in lacking.items():
        if missing:
            words = " and no ".join(f"{AXIS_WORDS[name]} ({name})" for name in missing)
            verb = "has" if len(places) == 1 else "have"
            problems.note(f"{list_places(places)} {verb} no {words}, but other entries have.", HINT)
    return RecordedViews(tuple(name for name in AXES if name in axes), tuple(in_cell), tuple(loose))


def readback_of(one: RecordedAxes) -> AxisReadback:
    """Return the read-back; an axis that the rig does not have rests at its origin."""
    pose = RigidTransform.identity("base", "flange") if one.base_from_flange is None else one.base_from_flange.transform()
    return AxisReadback(pose, one.guide_mm or 0.0, radians(one.table_deg or 0.0))


def _lacking(needed: frozenset[str], one: RecordedAxes) -> tuple[str, ...]:
    return tuple(name for name in AXES if name in needed - one.given)
