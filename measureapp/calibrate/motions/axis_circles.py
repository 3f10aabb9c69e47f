"""The rotation axis through the centres of the arcs the corners describe."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import CalibrationError

LEAST_POSITIONS = 3
LEAST_LINE_RATIO = 4.0  # the centres must spread at least this many times further along the axis than across it


@dataclass(frozen=True, slots=True, eq=False)
class Arcs:
    """The circle through the positions of every corner."""

    centres_mm: FloatArray  # (m, 3)
    normals: FloatArray  # (m, 3)
    radii_mm: FloatArray  # (m,)


def fit_arcs(corners_mm: FloatArray) -> Arcs:
    """Fit a circle to the positions of each corner.

    The plane is that of least squares over all positions (for three, the one through them); the centre minimises
    Σ (|P_ij - C_i|² - r_i²)² in the plane [1]_.

    Parameters
    ----------
    corners_mm : (n, m, 3), corner i at table position j is ``corners_mm[j, i]``

    References
    ----------
    .. [1] I. Kåsa, IEEE Trans. Instrumentation and Measurement 25(1), 8-14, 1976.
    """
    means = corners_mm.mean(axis=0)
    centred = np.swapaxes(corners_mm - means, 0, 1)
    _, spreads, axes = np.linalg.svd(centred, full_matrices=False)
    if np.any(spreads[:, 1] <= 1e-9 * np.maximum(spreads[:, 0], 1e-12)):
        raise CalibrationError("The positions of a corner lie on a line, not on an arc.", "Turn the table further between the positions.")
    in_plane = np.einsum("ijk,ick->ijc", centred, axes[:, :2])
    square = np.sum(in_plane**2, axis=2)
    design = np.concatenate([2 * in_plane, np.ones((*in_plane.shape[:2], 1))], axis=2)
    solution = np.linalg.solve(np.swapaxes(design, 1, 2) @ design, (np.swapaxes(design, 1, 2) @ square[..., None]))[..., 0]
    centres = means + np.einsum("ic,ick->ik", solution[:, :2], axes[:, :2])
    radii = np.sqrt(np.maximum(solution[:, 2] + np.sum(solution[:, :2] ** 2, axis=1), 0))
    return Arcs(centres, axes[:, 2], radii)


def distance_weights(corners_mm: FloatArray, power: float) -> FloatArray:
    """Return α_i = 1/(n-1) Σ_j (l_ij / mean_k l_kj)^p with the chords l_ij = |P_i,j+1 - P_i,j|: far corners weigh more.

    Parameters
    ----------
    corners_mm : (n, m, 3)
    power : p; 0 gives equal weights
    """
    chords = np.linalg.norm(np.diff(corners_mm, axis=0), axis=2)
    return np.asarray(np.mean((chords / chords.mean(axis=1, keepdims=True)) ** power, axis=0))


def line_through(centres_mm: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Return point, unit direction and conditioning of the line with the least Σ α_i d_i².

    The point is the weighted centroid, the direction the leading eigenvector of the weighted scatter; the conditioning is
    the spread of the centres along the line over that across it.
    """
    share = weights / weights.sum()
    point = share @ centres_mm
    away = centres_mm - point
    values, vectors = np.linalg.eigh((away * share[:, None]).T @ away)
    ratio = float(np.sqrt(max(values[2], 0.0) / max(values[1], 1e-300)))
    return point, vectors[:, 2], ratio


def axis_through_centres(corners_mm: FloatArray, power: float) -> tuple[FloatArray, FloatArray]:
    """Return a point and the direction (sign open) of the axis by weighted least squares over the arcs' centres.

    Raises
    ------
    CalibrationError
        The centres do not spread along a line: board perpendicular to the axis, or arcs too short.
    """
    arcs = fit_arcs(corners_mm)
    point, direction, ratio = line_through(arcs.centres_mm, distance_weights(corners_mm, power))
    if ratio < LEAST_LINE_RATIO:
        raise CalibrationError(
            "The centres of the corners' arcs do not form a line "
            f"(they spread {ratio:.1f} times as far along the axis as across it; {LEAST_LINE_RATIO:.0f} are needed).",
            "Set the board up steeply on the table, so that its corners lie at different heights, and turn the table further.",
        )
    return point, direction
