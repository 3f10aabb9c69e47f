"""Profile of one blade section: mean line, sides, edges, thickness and camber."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from measureapp.arrays import BoolArray, FloatArray
from measureapp.errors import FitError
from measureapp.inspection.blades.edge import Edge, fit_edge
from measureapp.inspection.blades.mean_line import MeanLine, initial_mean_line, shift_mean_line

SIDE_DEGREE = 7
ROUNDS = 15
LEAST_ON_SIDE = 40
CONVERGED_MM = 1e-5
GRID = 400
EDGE_DEPTHS = 1.2  # in edge radii: extent of an edge, excluded from the sides
EDGE_SHARE = 0.04  # of the length, before the radius is known
TRIM = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """Nominal of a section; coordinates are along the nominal chord from the leading edge, and to its left."""

    chord_mm: float  # of the nominal
    open_leading: bool = False  # the blade continues beyond the nominal end
    open_trailing: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Sides:
    """Distances of both sides from the mean line as functions of its arc length."""

    first_mm: float  # range of arc lengths of the polynomial and of the square roots of round edges
    last_mm: float
    roots: tuple[bool, bool]
    upper: FloatArray
    lower: FloatArray

    def heights(self, lengths_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return signed heights (N,) of the upper and lower side over the mean line."""
        basis = side_basis(lengths_mm, self.first_mm, self.last_mm, self.roots)
        return np.asarray(basis @ self.upper), np.asarray(basis @ self.lower)


@dataclass(frozen=True, slots=True, eq=False)
class Profile:
    """Evaluated profile of one section."""

    line: MeanLine
    sides: Sides
    leading: Edge
    trailing: Edge
    ends_mm: FloatArray  # (2, 2): ends of the chord; an open end on the mean line
    thickness_mm: float
    thickness_at_mm: float  # along the chord from its leading end
    camber_mm: float
    scatter_mm: float  # of the points from the sides
    residuals_mm: FloatArray  # (K,)
    on_side: BoolArray  # (N,), the K points on the sides

    @property
    def chord(self) -> FloatArray:
        """The chord (2,), from leading to trailing end."""
        return np.asarray(self.ends_mm[1] - self.ends_mm[0])


def side_basis(lengths_mm: FloatArray, first_mm: float, last_mm: float, roots: tuple[bool, bool]) -> FloatArray:
    """Return the basis (N, B) of a side: Chebyshev polynomials, and the square roots of round edges."""
    share = np.clip((lengths_mm - first_mm) / (last_mm - first_mm), 0, 1)
    columns = [chebyshev.chebvander(2 * share - 1, SIDE_DEGREE)]
    if roots[0]:
        columns.append(np.sqrt(share)[:, None])
    if roots[1]:
        columns.append(np.sqrt(1 - share)[:, None])
    return np.hstack(columns)


def fit_profile(points_mm: FloatArray, shape: Shape, start: Profile | None = None, rounds: int = ROUNDS) -> Profile:
    """Fit mean line, sides and edges of a section.

    The mean line is shifted until both sides have equal distances normal to it (the thickness convention of NACA profiles: I. H. Abbott,
    A. E. von Doenhoff, L. S. Stivers, NACA Report 824, 1945).

    Parameters
    ----------
    points_mm : (N, 2), in any order, in the coordinates of ``shape``
    start : profile of nearly the same points, as a faster start

    Raises
    ------
    FitError
        The points do not cover the section, or only one side of it.
    """
    line = initial_mean_line(points_mm) if start is None else start.line
    leading = _missing_edge(shape.open_leading) if start is None else start.leading
    trailing = _missing_edge(shape.open_trailing) if start is None else start.trailing
    low, high = _extent(points_mm, line, shape)
    for number in range(rounds):
        ends = _ends_x(line, leading, trailing, low, high, shape)
        caps = _caps(leading, trailing, ends, shape)
        sides, on_side, residuals, _ = _fit_sides(points_mm, line, ends, caps, shape)
        x = np.linspace(ends[0] + caps[0], ends[1] - caps[1], GRID)
        upper, lower = sides.heights(line.lengths(x))
        middles = (upper + lower) / 2
        line = shift_mean_line(line, x, middles)
        scatter = float(np.std(residuals))
        leading, trailing = _edges(points_mm, line, x, (upper - lower) / 2, ends, scatter, shape)
        if number > 1 and np.abs(middles).max() < CONVERGED_MM:
            break
    ends = _ends_x(line, leading, trailing, low, high, shape)
    caps = _caps(leading, trailing, ends, shape)
    sides, on_side, residuals, _ = _fit_sides(points_mm, line, ends, caps, shape)
    return _make_profile(line, sides, leading, trailing, ends, caps, residuals, on_side)


def _missing_edge(is_open: bool) -> Edge:
    return Edge(None, reason="the blade continues there" if is_open else "its edge was not measured")


def _extent(points_mm: FloatArray, line: MeanLine, shape: Shape) -> tuple[float, float]:
    """Return the range of the points along the chord; an open end is that of the nominal."""
    x, _ = line.feet(points_mm)
    low, high = np.percentile(x, [0.2, 99.8])
    return (0.0 if shape.open_leading else float(low)), (shape.chord_mm if shape.open_trailing else float(high))


def _ends_x(line: MeanLine, leading: Edge, trailing: Edge, low: float, high: float, shape: Shape) -> tuple[float, float]:
    """Return x of both ends on the mean line: of the edges where they are known."""

    def of(edge: Edge, otherwise: float) -> float:
        return otherwise if edge.apex_mm is None else float(line.feet(edge.apex_mm[None])[0][0])

    return (low if shape.open_leading else of(leading, low)), (high if shape.open_trailing else of(trailing, high))


def _caps(leading: Edge, trailing: Edge, ends: tuple[float, float], shape: Shape) -> tuple[float, float]:
    """Return the lengths at both ends that do not belong to the sides."""
    length = ends[1] - ends[0]

    def of(edge: Edge, is_open: bool) -> float:
        if is_open:
            return 0.0
        return EDGE_SHARE * length if edge.apex_mm is None else min(max(EDGE_DEPTHS * edge.radius_mm, 0.004 * length), 0.15 * length)

    return of(leading, shape.open_leading), of(trailing, shape.open_trailing)


def _fit_sides(
    points_mm: FloatArray, line: MeanLine, ends: tuple[float, float], caps: tuple[float, float], shape: Shape
) -> tuple[Sides, BoolArray, FloatArray, FloatArray]:
    x, heights = line.feet(points_mm)
    lengths = line.lengths(x)
    first, last = line.lengths(np.array(ends))
    roots = (not shape.open_leading, not shape.open_trailing)
    basis = side_basis(lengths, float(first), float(last), roots)
    inside = (x > ends[0] + caps[0]) & (x < ends[1] - caps[1])
    residuals, kept, solutions = np.zeros(len(x)), np.zeros(len(x), bool), []
    for side in (inside & (heights > 0), inside & (heights <= 0)):
        if side.sum() < LEAST_ON_SIDE:
            raise FitError("only one side of the blade was measured", "Scan its other side as well.")
        # Rows of the side alone, taken once: to choose them among all points anew in every round takes most of the time.
        of_side, over = basis[side], heights[side]
        used = np.ones(len(over), bool)
        for _ in range(3):
            everything = bool(used.all())
            solution = _solve(of_side if everything else of_side[used], over if everything else over[used])
            apart = over - of_side @ solution
            limit = TRIM * 1.4826 * float(np.median(np.abs(apart[used]))) + 1e-9
            used = np.abs(apart) <= limit
        residuals[side] = apart
        kept[side] = used
        solutions.append(solution)
    return Sides(float(first), float(last), roots, solutions[0], solutions[1]), kept, residuals[kept], lengths


def _solve(basis: FloatArray, heights: FloatArray) -> FloatArray:
    """Least squares by normal equations, fast and sufficient for the well-conditioned basis."""
    normal = basis.T @ basis
    return np.asarray(np.linalg.solve(normal + 1e-10 * np.trace(normal) * np.eye(len(normal)), basis.T @ heights))


def _edges(
    points_mm: FloatArray, line: MeanLine, x: FloatArray, half: FloatArray, ends: tuple[float, float], scatter: float, shape: Shape
) -> tuple[Edge, Edge]:
    found = []
    for is_open, at, inner, sign in ((shape.open_leading, 0, x[0], 1.0), (shape.open_trailing, 1, x[-1], -1.0)):
        if is_open:
            found.append(_missing_edge(True))
            continue
        start = line.points(np.array([ends[at]]))[0]
        slope = float(line.slopes(np.array([inner]))[0])
        inwards = sign * np.array([1.0, slope]) / np.hypot(1.0, slope)
        found.append(fit_edge(points_mm, start, inwards, max(float(half[0 if at == 0 else -1]), 1e-3), scatter))
    return found[0], found[1]


def _make_profile(
    line: MeanLine,
    sides: Sides,
    leading: Edge,
    trailing: Edge,
    ends: tuple[float, float],
    caps: tuple[float, float],
    residuals: FloatArray,
    on_side: BoolArray,
) -> Profile:
    x = np.linspace(ends[0] + caps[0], ends[1] - caps[1], 4 * GRID)
    upper, lower = sides.heights(line.lengths(x))
    thickest = int((upper - lower).argmax())
    on_line = line.points(np.array(ends))
    apexes = np.stack([on_line[k] if edge.apex_mm is None else edge.apex_mm for k, edge in enumerate((leading, trailing))])
    along = (apexes[1] - apexes[0]) / np.linalg.norm(apexes[1] - apexes[0])
    offset = line.points(x) - apexes[0]
    camber = float(np.abs(offset @ np.array([-along[1], along[0]])).max())
    return Profile(
        line,
        sides,
        leading,
        trailing,
        apexes,
        float((upper - lower)[thickest]),
        float(offset[thickest] @ along),
        camber,
        float(np.std(residuals)),
        residuals,
        on_side,
    )
