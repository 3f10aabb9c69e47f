"""Propagation of the errors of the views to one blade section: rotation about the axis, stagger, and deformation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.blades.section_frame import SectionFrame
from measureapp.inspection.measured_points import MeasuredPoints

STEP_MM, STEP_RAD = 0.01, 1e-4
LEAST_IN_SECTION = 0.3  # lower limit of the in-plane component of a normal


@dataclass(frozen=True, slots=True, eq=False)
class BladeErrors:
    """Errors of a section by contribution ("stitching", "calibration", "form", "common"); the error sources are shared by all blades."""

    turn_rad: Mapping[str, FloatArray]  # (M,), about the part's axis
    stagger_rad: Mapping[str, FloatArray]  # (M,), change of the stagger by rotation and translation in the section
    deformation_mm: Mapping[str, float]  # standard deviation, rms over the points, without rigid motion in the section
    total_mm: Mapping[str, float]  # the same including rigid motion


def estimate_blade_errors(own: MeasuredPoints, number: int, frame: SectionFrame) -> BladeErrors | None:
    """Propagate the errors of the views to the section of blade ``number``; None without an error model or normals."""
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
    for contribution, moved in own.errors.along(points, normals, own.view).items():
        explained = np.linalg.lstsq(motions, moved, rcond=None)[0]
        turn[contribution], stagger[contribution] = effect @ moved / (effect @ effect), by_motion @ explained
        apart[contribution], total[contribution] = (_rms(change / in_section) for change in (moved - motions @ explained, moved))
    return BladeErrors(turn, stagger, apart, total)


def _stagger_derivatives(frame: SectionFrame, middle_mm: FloatArray) -> FloatArray:
    """Return the derivatives (3,) of the stagger: translations along and normal to the chord (rad/mm), and rotation about the centre.

    If the stagger is measured from the ray through the leading end, a translated blade has another ray.
    """

    def stagger(motion: FloatArray) -> float:
        turn = motion[2]
        start = motion[:2] + turn * np.array([middle_mm[1], -middle_mm[0]])  # the nominal leading end is the origin of the section
        return frame.stagger_rad(frame.shape.chord_mm * np.array([np.cos(turn), np.sin(turn)]), start)

    steps = np.diag([STEP_MM, STEP_MM, STEP_RAD])
    return np.array([(stagger(step) - stagger(-step)) / (2 * step.sum()) for step in steps])


def _rms(columns: FloatArray) -> float:
    """Return the root of the mean variance of errors (N, M) over the points."""
    return float(np.sqrt(np.mean(np.sum(columns**2, axis=1))))
