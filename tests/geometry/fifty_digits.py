"""Least-squares fits in 50 digits: the distances written down once more, derived numerically, solved by Gauss-Newton."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from mpmath import mp

SIZES = {"circle": (50.0,), "sphere": (50.0,), "cylinder": (50.0,), "cone": (50.0, 0.3), "torus": (50.0, 9.0)}
FREE = {"plane": 3, "line": 4, "circle": 5, "sphere": 3, "cylinder": 4, "cone": 4, "torus": 5}  # unknowns without the sizes
DIGITS = 50


def solved(case: dict[str, Any]) -> dict[str, Any]:
    """Return the least-squares feature of a case: point nearest the centroid, direction and sizes, as decimal strings."""
    mp.dps = DIGITS
    shape = case["shape"]
    problem = Problem.of(case)
    start = [mp.mpf(0)] * FREE[shape] + [mp.mpf(size) for size in SIZES.get(shape, ())]
    point, axis, sizes = problem.unpacked(_minimised(problem, start))
    centroid = [sum(x[k] for x in problem.points) / len(problem.points) for k in range(3)]
    along = _dot([a - b for a, b in zip(centroid, point, strict=True)], axis)
    if shape == "plane":
        point = [a - along * n for a, n in zip(centroid, axis, strict=True)]
    elif shape in ("line", "cylinder", "cone"):
        point = [a + along * n for a, n in zip(point, axis, strict=True)]
        if shape == "cone":
            sizes[0] -= along * mp.tan(sizes[1])
    texts = {"point_mm": point, "direction": [] if shape == "sphere" else axis, "sizes": sizes}
    return {name: [mp.nstr(value, 25) for value in values] for name, values in texts.items()}


@dataclass(frozen=True)
class Problem:
    """Points to be fitted, and the true shape's centre and triad, from which its unknowns are counted."""

    shape: str
    points: list[list[Any]]
    centre: list[Any]
    triad: list[list[Any]]

    @classmethod
    def of(cls, case: dict[str, Any]) -> Problem:
        """Take a case over into decimal numbers."""
        points = [[mp.mpf(repr(float(value))) for value in row] for row in case["points_mm"]]
        helper = np.eye(3)[np.argmin(np.abs(case["axis"]))]
        u = np.cross(case["axis"], helper)
        triad = [[mp.mpf(float(value)) for value in row] for row in (u, np.cross(case["axis"], u), case["axis"])]
        return cls(case["shape"], points, [mp.mpf(float(value)) for value in case["centre_mm"]], triad)

    def unpacked(self, q: list[Any]) -> tuple[list[Any], list[Any], list[Any]]:
        """Point, unit direction and sizes: shifts and leans along the triad of the true shape; an axis does not shift along itself."""
        shape, triad = self.shape, self.triad
        shifts = {"plane": [0, 0, q[0]], "sphere": q[:3]}.get(shape, [q[0], q[1], 0 if shape in ("line", "cylinder", "cone") else q[2]])
        rest = q[{"plane": 1, "sphere": 3, "circle": 3, "torus": 3}.get(shape, 2) :]
        leans = [0, 0] if shape == "sphere" else rest[:2]
        sizes = rest[0 if shape == "sphere" else 2 :]
        point = [self.centre[k] + sum(shifts[j] * triad[j][k] for j in range(3)) for k in range(3)]
        leaning = [triad[2][k] + leans[0] * triad[0][k] + leans[1] * triad[1][k] for k in range(3)]
        length = mp.sqrt(_dot(leaning, leaning))
        return point, [value / length for value in leaning], list(sizes)

    def residuals(self, q: list[Any]) -> list[Any]:
        """Return the distances of all points from the shape, in parts where a distance has several directions."""
        point, axis, sizes = self.unpacked(q)
        return [value for x in self.points for value in self._distances([a - b for a, b in zip(x, point, strict=True)], axis, sizes)]

    def _distances(self, away: list[Any], axis: list[Any], sizes: list[Any]) -> list[Any]:
        if self.shape == "sphere":
            return [mp.sqrt(_dot(away, away)) - sizes[0]]
        h = _dot(away, axis)
        across = [a - h * n for a, n in zip(away, axis, strict=True)]
        if self.shape in ("plane", "line"):
            return [h] if self.shape == "plane" else across
        rho = mp.sqrt(_dot(across, across))
        return {
            "circle": lambda: [rho - sizes[0], h],
            "cylinder": lambda: [rho - sizes[0]],
            "cone": lambda: [(rho - sizes[0]) * mp.cos(sizes[1]) + h * mp.sin(sizes[1])],
            "torus": lambda: [mp.sqrt((rho - sizes[0]) ** 2 + h * h) - sizes[1]],
        }[self.shape]()


def _minimised(problem: Problem, start: list[Any]) -> list[Any]:
    """Step by Gauss-Newton, with numerical derivatives, until a step says nothing more."""
    q, h = start, mp.mpf(10) ** -18
    for _ in range(400):
        now = problem.residuals(q)
        columns = []
        for k in range(len(q)):
            up, down = list(q), list(q)
            up[k], down[k] = q[k] + h, q[k] - h
            columns.append([(a - b) / (2 * h) for a, b in zip(problem.residuals(up), problem.residuals(down), strict=True)])
        normal = mp.matrix([[_dot(a, b) for b in columns] for a in columns])
        step = mp.lu_solve(normal, mp.matrix([-_dot(column, now) for column in columns]))
        q = [a + b for a, b in zip(q, step, strict=True)]
        if mp.norm(step) < mp.mpf(10) ** -25:
            return q
    raise ArithmeticError(f"No reference was found for a {problem.shape}.")


def _dot(x: list[Any], y: list[Any]) -> Any:
    return sum(p * q for p, q in zip(x, y, strict=True))
