"""Advice for the rotation axis and the linear guide: how far they were moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.draft.advice import Gauge, Ghost, Notes, outlines_px
from measureapp.calibrate.draft.draft import Draft
from measureapp.calibrate.motions.axis_circles import LEAST_POSITIONS as LEAST_TABLE_POSITIONS
from measureapp.calibrate.motions.axis_noise import SAME_POSE
from measureapp.calibrate.motions.chain import groups_of
from measureapp.calibrate.motions.linear_guide import ADVISED_STROKE_MM
from measureapp.calibrate.motions.linear_guide import LEAST_POSITIONS as LEAST_SLIDE_POSITIONS
from measureapp.calibrate.motions.rotation_axis import AxisSolution
from measureapp.data.calibration import RotationAxis
from measureapp.geometry.transform import RigidTransform

WIDE_GAP = 0.4  # of the whole span; a wider gap between two positions needs one more between them
SWEEP_TARGET_DEG = 120.0  # the axis of a shorter arc is known worse; the paper turns its table by 120°


@dataclass(frozen=True, slots=True)
class Travel:
    """How far an axis should be moved, in how many positions, and the texts for it."""

    positions: int
    span: float
    unit: str
    positions_gauge: str
    span_gauge: str
    further: str  # order to move beyond the positions there are
    between: str  # order to take the board between the positions there are


TABLE = Travel(
    *(7, SWEEP_TARGET_DEG, "°", "Table positions", "Sweep of the table", "Turn the table further"),
    "Take the board at {count} more table {positions}, between those there are",
)
SLIDE = Travel(
    *(5, ADVISED_STROKE_MM, " mm", "Guide positions", "Travel of the guide", "Move the guide further"),
    "Take the board from {count} more guide {positions}, between those there are",
)


def advise_table(draft: Draft, notes: Notes) -> None:
    """Note which table positions are missing."""
    angles, count = np.rad2deg(table_angles_rad(draft)).tolist(), len(draft.counted)
    _advise_travel(TABLE, angles, count, notes)
    if not angles and count < LEAST_TABLE_POSITIONS:
        notes.wish(f"Take the board at {LEAST_TABLE_POSITIONS - count} more table positions, each turned by 15° to 30°")


def advise_guide(draft: Draft, notes: Notes, *, still_robot: bool = False) -> None:
    """Note which guide positions are missing; and that the robot should stay still, where it is not to be calibrated by the same views."""
    slides = [one.readback.guide_mm for one in draft.counted if one.readback.guide_mm is not None]
    _advise_travel(SLIDE, slides, len(slides), notes)
    if not slides:
        notes.wish(f"Take the fixed board from {LEAST_SLIDE_POSITIONS} positions of the guide or more, {ADVISED_STROKE_MM:.0f} mm apart")
    elif still_robot and _robot_moved(draft):
        notes.wish("Keep the robot still while the guide moves: the errors of its poses would count as errors of the guide")


def ghost_for_table(draft: Draft) -> Ghost | None:
    """Predict the outline of the board after the table is turned to a missing position."""
    solved = draft.solved
    if solved is None or not solved.used:
        return None
    angles = solved.solution.best.angles_rad
    first = next(one for one in draft.counted if one.id == solved.used[0]).readback.table_rad if _all_known(draft) else 0.0
    goal = next_position(list(angles), float(np.deg2rad(SWEEP_TARGET_DEG)))
    outlines = outlines_px(solved.cameras, _turn_board(solved.solution.best.axis, solved.places[solved.used[0]], goal), solved.board)
    return Ghost(outlines, table_rad=(first or 0.0) + goal if _all_known(draft) else None) if outlines else None


def ghost_for_guide(draft: Draft) -> Ghost | None:
    """Predict the outline of the board after the guide is moved to a missing position."""
    solved, hand_eye = draft.solved, draft.setup.hand_eye
    if solved is None or hand_eye is None or not solved.used:
        return None
    used = [one for one in draft.counted if one.id in solved.used]
    last, slides = used[-1], [one.readback.guide_mm or 0.0 for one in used]
    flange = last.readback.base_from_flange
    if flange is None:
        return None
    goal = next_position(slides, ADVISED_STROKE_MM)
    travel = solved.solution.guide.direction * solved.solution.guide.scale * (goal - slides[-1])
    camera_from_base = (flange @ hand_eye.flange_from_camera).inverse()
    seen = solved.places[last.id]
    place = RigidTransform.from_parts(seen.rotation, seen.translation_mm - camera_from_base.rotate(travel), "camera", "board")
    outlines = outlines_px(solved.cameras, place, solved.board)
    return Ghost(outlines, base_from_flange=flange, guide_mm=goal) if outlines else None


def table_angles_rad(draft: Draft) -> FloatArray:
    """Return the table angles: as read back where all are known, else as the last solution estimated them; empty without either."""
    if _all_known(draft):
        return np.array([one.readback.table_rad for one in draft.counted], float)
    solved = draft.solved
    return solved.solution.best.angles_rad if solved is not None and isinstance(solved.solution, AxisSolution) else np.zeros(0)


def _all_known(draft: Draft) -> bool:
    return all(one.readback.table_rad is not None for one in draft.counted)


def _turn_board(axis: RotationAxis, place: RigidTransform, angle_rad: float) -> RigidTransform:
    turn = axis.turned(angle_rad)
    return RigidTransform(turn.matrix, "camera", "camera") @ place


def _robot_moved(draft: Draft) -> bool:
    poses = [one.readback.base_from_flange for one in draft.counted if one.readback.base_from_flange is not None]
    return len(set(groups_of(np.array([pose.matrix[:3].ravel() for pose in poses]), SAME_POSE).tolist())) > 1 if poses else False


def _advise_travel(travel: Travel, positions: Sequence[float], count: int, notes: Notes) -> None:
    """Note how many positions there are and how far they reach; where they are known, which are missing."""
    notes.gauges.append(Gauge(travel.positions_gauge, count, travel.positions, ""))
    notes.gauges.append(Gauge(travel.span_gauge, span_of(positions), travel.span, travel.unit.strip()))
    if not positions:
        return
    missing = max(travel.positions - count, 0)
    if span_of(positions) < travel.span:
        _more(max(missing, 1), positions, travel, notes)
    elif missing:
        notes.wish(travel.between.format(count=missing, positions=_positions(missing)))
    _gap(positions, travel.unit, notes)


def _more(count: int, positions: Sequence[float], travel: Travel, notes: Notes) -> None:
    goal = next_position(positions, travel.span)
    low, high = min(positions), max(positions)
    beyond = high if goal > high else low
    if low <= goal <= high:  # the gap is named by itself
        beyond = high if abs(high) <= abs(low) else low
    notes.wish(f"{travel.further}: {_number(count)} more {_positions(count)} beyond {_format_signed(beyond)}{travel.unit}")


def _gap(positions: Sequence[float], unit: str, notes: Notes) -> None:
    gap = widest_gap(positions)
    if gap is not None:
        notes.wish(
            f"Add a position near {(gap[0] + gap[1]) / 2:.0f}{unit}: there is none between {gap[0]:.0f}{unit} and {gap[1]:.0f}{unit}"
        )


def _format_signed(value: float) -> str:
    """A whole number with a minus sign instead of a hyphen."""
    return f"{value:.0f}".replace("-", "−")


def _positions(count: int) -> str:
    return "position" if count == 1 else "positions"


def _number(count: int) -> str:
    return {1: "one", 2: "two", 3: "three", 4: "four", 5: "five", 6: "six"}.get(count, str(count))


def widest_gap(positions: Sequence[float]) -> tuple[float, float] | None:
    """Return the ends of a gap between neighbouring positions that is too wide; None where there is none or fewer than four."""
    ordered = sorted(positions)
    if len(ordered) < 4:
        return None
    start, end = max(pairwise(ordered), key=lambda pair: pair[1] - pair[0])
    return (start, end) if end - start > WIDE_GAP * (ordered[-1] - ordered[0]) else None


def next_position(positions: Sequence[float], span: float) -> float:
    """Return where the next position adds most: within a gap, otherwise beyond the end that is nearer to zero."""
    gap = widest_gap(positions)
    if gap is not None:
        return (gap[0] + gap[1]) / 2
    low, high = min(positions), max(positions)
    step = max((span - (high - low)) / 2, span / 8)
    return high + step if abs(high) <= abs(low) else low - step


def span_of(positions: Sequence[float]) -> float:
    """Return largest less smallest; 0 without any."""
    return float(np.ptp(positions)) if len(positions) else 0.0
