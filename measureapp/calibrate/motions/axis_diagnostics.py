"""Diagnostics of a rotation axis: conditioning of the arcs, wobble, and closure after rotating the board back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.motions.axis_circles import fit_arcs
from measureapp.calibrate.motions.axis_motion import perpendicular_basis, rigid_motion
from measureapp.data.calibration import RotationAxis

CIRCLE_POINTS = 12
LARGEST_CENTRE_SIGMA_MM = 0.1
ARC_PARAMETERS = 3


@dataclass(frozen=True, slots=True, eq=False)
class ArcConditioning:
    """How certain the centre of each corner's arc is; a short arc, or one near the axis whose noise is as large as it is, shows here."""

    radii_mm: FloatArray  # (m,), of the fitted circles
    lengths_mm: FloatArray  # (m,), of the arcs
    centre_sigma_mm: FloatArray  # (m,), of the centre, the largest over all directions in its plane
    point_sigma_mm: float  # standard deviation of one coordinate of a corner, from the arcs' own residuals


@dataclass(frozen=True, slots=True, eq=False)
class Closure:
    """Residuals after rotating every position back by the table's angle."""

    board_mm: float  # rms distance of the corners from their mean places
    positions_mm: FloatArray  # (n,), the same per position
    radius_mm: float
    at_radius_mm: float  # rms over a circle of that radius about the axis at the board's height, as the board's motions carry it
    wobble_rad: FloatArray  # (n,), tilt of the turning board against the axis
    angle_error_rad: FloatArray  # (n,), turn seen less the angle, about their mean
    angles_were_read: bool  # False: they were estimated from the same corners, which flatters


@dataclass(frozen=True, slots=True, eq=False)
class AxisDiagnostics:
    """Arcs and closure, with warnings."""

    arcs: ArcConditioning
    closure: Closure
    warnings: tuple[str, ...]


def diagnose(
    axis: RotationAxis, corners_mm: FloatArray, angles_rad: FloatArray, *, angles_were_read: bool, radius_mm: float
) -> AxisDiagnostics:
    """Return the diagnostics of an axis for corners (n, m, 3) at table angles (n,)."""
    arcs = arc_conditioning(corners_mm, angles_rad)
    warnings = []
    bad = int(np.sum(arcs.centre_sigma_mm > LARGEST_CENTRE_SIGMA_MM))
    if bad:
        worst = int(np.argmax(arcs.centre_sigma_mm))
        warnings.append(
            f"{bad} of {len(arcs.radii_mm)} centres of arcs are uncertain by more than {LARGEST_CENTRE_SIGMA_MM} mm: the worst, of corner "
            f"{worst} on an arc of {arcs.lengths_mm[worst]:.1f} mm, by {arcs.centre_sigma_mm[worst]:.2f} mm. "
            "Turn the table further, or trust maximum likelihood, which does not need the centres."
        )
    return AxisDiagnostics(arcs, closure_of(axis, corners_mm, angles_rad, angles_were_read, radius_mm), tuple(warnings))


def arc_conditioning(corners_mm: FloatArray, angles_rad: FloatArray) -> ArcConditioning:
    """Propagate the corners' noise to the centres of their circles: the covariance σ² (JᵀJ)⁻¹ of centre and radius [1]_.

    With J = (cos θ, sin θ, 1) per position it depends on the angles alone, not on the radius: a corner far from the axis has no
    better centre than a near one as long as its noise is the same.

    References
    ----------
    .. [1] N. Chernov, Circular and Linear Regression, CRC Press 2010, chapter 7.
    """
    fitted = fit_arcs(corners_mm)
    away = corners_mm - fitted.centres_mm
    height = np.einsum("nmk,mk->nm", away, fitted.normals)
    radial = np.linalg.norm(away - height[..., None] * fitted.normals, axis=2) - fitted.radii_mm
    positions, count = corners_mm.shape[:2]
    freedom = max(count * (positions - ARC_PARAMETERS), 1)
    across_planes = np.sum(height**2) if positions > ARC_PARAMETERS else 0.0
    point_sigma = float(np.sqrt((np.sum(radial**2) + across_planes) / (freedom * (2 if across_planes else 1))))
    design = np.column_stack([np.cos(angles_rad), np.sin(angles_rad), np.ones(positions)])
    by_noise = float(np.sqrt(np.linalg.eigvalsh(np.linalg.pinv(design.T @ design)[:2, :2])[-1]))
    sweep = float(np.ptp(angles_rad))
    return ArcConditioning(fitted.radii_mm, fitted.radii_mm * sweep, np.full(count, point_sigma * by_noise), point_sigma)


def closure_of(axis: RotationAxis, corners_mm: FloatArray, angles_rad: FloatArray, angles_were_read: bool, radius_mm: float) -> Closure:
    """Rotate every position back by its angle and return the residuals at the board and at a radius."""
    back = np.array([axis.turned(-float(angle)).apply(corners) for angle, corners in zip(angles_rad, corners_mm, strict=True)])
    mean = back.mean(axis=0)
    off = np.linalg.norm(back - mean, axis=2)
    motions = np.array([rigid_motion(mean, position) for position in back])
    turns = Rotation.from_matrix(motions[:, :3, :3]).as_rotvec()
    along = turns @ axis.direction
    circle = _circle(axis, mean.mean(axis=0), radius_mm)
    moved = circle @ np.swapaxes(motions[:, :3, :3], 1, 2) + motions[:, None, :3, 3]
    return Closure(
        board_mm=float(np.sqrt(np.mean(off**2))),
        positions_mm=np.sqrt(np.mean(off**2, axis=1)),
        radius_mm=radius_mm,
        at_radius_mm=float(np.sqrt(np.mean(np.sum((moved - circle) ** 2, axis=2)))),
        wobble_rad=np.linalg.norm(turns - along[:, None] * axis.direction, axis=1),
        angle_error_rad=along - along.mean(),
        angles_were_read=angles_were_read,
    )


def _circle(axis: RotationAxis, height_of_mm: FloatArray, radius_mm: float) -> FloatArray:
    """Return points (CIRCLE_POINTS, 3) on a circle about the axis at the height of a point."""
    centre = axis.point_mm + axis.direction * float(axis.direction @ (height_of_mm - axis.point_mm))
    angles = np.linspace(0, 2 * np.pi, CIRCLE_POINTS, endpoint=False)
    return np.asarray(centre + radius_mm * np.column_stack([np.cos(angles), np.sin(angles)]) @ perpendicular_basis(axis.direction))
