"""What the errors of the views do to one blade section: turn it about the axis, turn it in its section, and move its sides apart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.blades.cut import SectionFrame
from measureapp.inspection.measured import MeasuredPoints

STEP_MM = 0.01
LEAST_IN_SECTION = 0.3  # share of a normal that lies in the section; steeper sides count no more


@dataclass(frozen=True, slots=True, eq=False)
class BladeErrors:
    """By shares ("stitching", "calibration") of the errors of the views, which all blades have in common."""

    turn_rad: Mapping[str, FloatArray]  # (M,), about the part's axis
    lean_rad: Mapping[str, FloatArray]  # (M,), in the section
    apart_mm: Mapping[str, float]  # standard deviation, rms over the points, of what no motion of the blade in its section explains
    total_mm: Mapping[str, float]  # the same of everything


def blade_errors(own: MeasuredPoints, number: int, frame: SectionFrame) -> BladeErrors | None:
    """Return what the views do to the section of blade ``number``; None where that, or the normals, are not known."""
    if own.errors is None or own.view is None or own.normals is None:
        return None
    points, normals = own.points_mm, np.asarray(own.normals, float)
    flat = frame.flat(frame.turned_back(points, number))
    along, up = ((frame.lifted(flat + STEP_MM * side, number) - frame.lifted(flat, number)) / STEP_MM for side in np.eye(2))
    across = np.column_stack([np.einsum("nd,nd->n", normals, side) for side in (along, up)])
    arms = flat - flat.mean(axis=0)
    motions = np.column_stack([across, across[:, 1] * arms[:, 0] - across[:, 0] * arms[:, 1]])
    effect = np.einsum("nd,nd->n", normals, (frame.turned(points, STEP_MM) - frame.turned(points, -STEP_MM)) / (2 * STEP_MM))
    in_section = np.maximum(np.linalg.norm(across, axis=1), LEAST_IN_SECTION)[:, None]
    turn, lean, apart, total = {}, {}, {}, {}
    for share, moved in own.errors.along(points, normals, own.view).items():
        explained = np.linalg.lstsq(motions, moved, rcond=None)[0]
        turn[share], lean[share] = effect @ moved / (effect @ effect), explained[2]
        apart[share], total[share] = (_rms(change / in_section) for change in (moved - motions @ explained, moved))
    return BladeErrors(turn, lean, apart, total)


def _rms(columns: FloatArray) -> float:
    """Root of the mean variance of errors (N, M) over the points."""
    return float(np.sqrt(np.mean(np.sum(columns**2, axis=1))))
