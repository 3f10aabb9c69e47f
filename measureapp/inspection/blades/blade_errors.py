"""What the errors of the views do to one blade section: turn it about the axis, change its stagger, and move its sides apart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.blades.section_frame import SectionFrame
from measureapp.inspection.measured_points import MeasuredPoints

STEP_MM, STEP_RAD = 0.01, 1e-4
LEAST_IN_SECTION = 0.3  # share of a normal that lies in the section; steeper sides count no more


@dataclass(frozen=True, slots=True, eq=False)
class BladeErrors:
    """By shares ("stitching", "calibration", "form", "common") of the errors of the views, which all blades have in common."""

    turn_rad: Mapping[str, FloatArray]  # (M,), about the part's axis
    stagger_rad: Mapping[str, FloatArray]  # (M,), changes of the stagger, by turn and by shift in the section
    deformation_mm: Mapping[str, float]  # standard deviation, rms over the points, of what no motion of the blade in its section explains
    total_mm: Mapping[str, float]  # the same of everything


def estimate_blade_errors(own: MeasuredPoints, number: int, frame: SectionFrame) -> BladeErrors | None:
    """Return what the views do to the section of blade ``number``; None where that, or the normals, are not known."""
    if own.errors is None or own.view is None or own.normals is None:
        return None
    points, normals = own.points_mm, np.asarray(own.normals, float)
    flat = frame.flatten(frame.rotate_to_first(points, number))
    along, up = ((frame.lift(flat + STEP_MM * side, number) - frame.lift(flat, number)) / STEP_MM for side in np.eye(2))
    across = np.column_stack([np.einsum("nd,nd->n", normals, side) for side in (along, up)])
    arms = flat - flat.mean(axis=0)
    motions = np.column_stack([across, across[:, 1] * arms[:, 0] - across[:, 0] * arms[:, 1]])
    effect = np.einsum("nd,nd->n", normals, (frame.rotate(points, STEP_RAD) - frame.rotate(points, -STEP_RAD)) / (2 * STEP_RAD))
    in_section = np.maximum(np.linalg.norm(across, axis=1), LEAST_IN_SECTION)[:, None]
    by_motion = _stagger_derivatives(frame, flat.mean(axis=0))
    turn, stagger, apart, total = {}, {}, {}, {}
    for share, moved in own.errors.along(points, normals, own.view).items():
        explained = np.linalg.lstsq(motions, moved, rcond=None)[0]
        turn[share], stagger[share] = effect @ moved / (effect @ effect), by_motion @ explained
        apart[share], total[share] = (_rms(change / in_section) for change in (moved - motions @ explained, moved))
    return BladeErrors(turn, stagger, apart, total)


def _stagger_derivatives(frame: SectionFrame, middle_mm: FloatArray) -> FloatArray:
    """Return how the stagger follows shifts of the blade along and across its chord (rad/mm) and a turn about its middle, (3,).

    Where it is counted from the ray out of the axis through the leading end, a blade that is shifted has another ray.
    """

    def stagger(motion: FloatArray) -> float:
        turn = motion[2]
        start = motion[:2] + turn * np.array([middle_mm[1], -middle_mm[0]])  # the drawn leading end is the origin of the section
        return frame.stagger_rad(frame.shape.chord_mm * np.array([np.cos(turn), np.sin(turn)]), start)

    steps = np.diag([STEP_MM, STEP_MM, STEP_RAD])
    return np.array([(stagger(step) - stagger(-step)) / (2 * step.sum()) for step in steps])


def _rms(columns: FloatArray) -> float:
    """Root of the mean variance of errors (N, M) over the points."""
    return float(np.sqrt(np.mean(np.sum(columns**2, axis=1))))
