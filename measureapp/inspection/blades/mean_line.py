"""Mean line (camber line) of a blade section: centre of the thickness measured normal to the line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Chebyshev

from measureapp.arrays import FloatArray
from measureapp.errors import FitError

DEGREE = 6
BINS = 40
NEWTON_STEPS = 4
SAMPLES = 1500


@dataclass(frozen=True, slots=True, eq=False)
class MeanLine:
    """A curve y(x) along the chord: polynomial from ``first_mm`` to ``last_mm``, straight beyond."""

    height: Chebyshev
    slope: Chebyshev
    first_mm: float
    last_mm: float

    def heights(self, x_mm: FloatArray) -> FloatArray:
        """Return y (N,) at x."""
        return self._heights_and_slopes(x_mm)[0]

    def slopes(self, x_mm: FloatArray) -> FloatArray:
        """Return dy/dx (N,) at x."""
        return np.asarray(self.slope(np.clip(x_mm, self.first_mm, self.last_mm)))

    def points(self, x_mm: FloatArray) -> FloatArray:
        """Return the points (N, 2) at x."""
        return np.column_stack([x_mm, self.heights(x_mm)])

    def normals(self, x_mm: FloatArray) -> FloatArray:
        """Return unit normals (N, 2), to the left of the chord direction."""
        slopes = self.slopes(x_mm)
        return np.column_stack([-slopes, np.ones_like(slopes)]) / np.sqrt(1 + slopes**2)[:, None]

    def feet(self, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return x of the feet of the perpendiculars from points (N, 2), and signed distances (N,) along the normals."""
        x = points_mm[:, 0].copy()
        for _ in range(NEWTON_STEPS):
            heights, slopes = self._heights_and_slopes(x)
            x += ((points_mm[:, 0] - x) + (points_mm[:, 1] - heights) * slopes) / (1 + slopes**2)
        heights, slopes = self._heights_and_slopes(x)
        return x, ((points_mm[:, 1] - heights) - (points_mm[:, 0] - x) * slopes) / np.sqrt(1 + slopes**2)

    def _heights_and_slopes(self, x_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Both together: polynomials are most of the time that a section takes."""
        inside = np.clip(x_mm, self.first_mm, self.last_mm)
        slopes = np.asarray(self.slope(inside))
        return np.asarray(self.height(inside) + (x_mm - inside) * slopes), slopes

    def lengths(self, x_mm: FloatArray) -> FloatArray:
        """Return arc lengths (N,) from x = 0 to x, negative before it."""
        from scipy.integrate import cumulative_trapezoid

        low, high = min(float(x_mm.min(initial=0.0)), 0.0), max(float(x_mm.max(initial=0.0)), 1e-6)
        grid = np.linspace(low, high, SAMPLES)
        length = cumulative_trapezoid(np.sqrt(1 + self.slopes(grid) ** 2), grid, initial=0.0)
        return np.asarray(np.interp(x_mm, grid, length) - np.interp(0.0, grid, length))


def initial_mean_line(points_mm: FloatArray) -> MeanLine:
    """Return an initial mean line through the centres between upper and lower points (N, 2) of strips normal to the chord.

    Raises
    ------
    FitError
        The points do not cover the length of the section.
    """
    low, high = np.percentile(points_mm[:, 0], [1, 99])
    strip = np.floor((points_mm[:, 0] - low) / (high - low) * BINS).astype(int)
    places, middles = [], []
    for number in range(BINS):
        inside = points_mm[strip == number]
        if len(inside) >= 4:
            places.append(float(inside[:, 0].mean()))
            middles.append(float(np.percentile(inside[:, 1], [3, 97]).mean()))
    if len(places) < BINS / 2:
        raise FitError("the points do not cover the section from one edge to the other", "Scan the blade more densely.")
    return _fit_line(np.array(places), np.array(middles), 4, float(low), float(high))


def shift_mean_line(line: MeanLine, x_mm: FloatArray, shifts_mm: FloatArray) -> MeanLine:
    """Shift a line along its normals by ``shifts_mm`` (N,) at ``x_mm`` (N,), which span its new range."""
    moved = line.points(x_mm) + shifts_mm[:, None] * line.normals(x_mm)
    first, last = float(moved[0, 0]), float(moved[-1, 0])
    return _fit_line(moved[:, 0], moved[:, 1], DEGREE, first, last)


def _fit_line(x_mm: FloatArray, y_mm: FloatArray, degree: int, first_mm: float, last_mm: float) -> MeanLine:
    height = Chebyshev.fit(x_mm, y_mm, degree, domain=[first_mm, last_mm])
    return MeanLine(height, height.deriv(), first_mm, last_mm)
