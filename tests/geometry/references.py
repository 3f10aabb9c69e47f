"""Least-squares references in 50 digits: `python tests/geometry/references.py` writes `references.json` again.

The distances are written down here once more, with other parameters than in the core, derived numerically in mpmath and
solved by Gauss-Newton until a step is below 1e-25. Nothing of the core takes part.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

FILE = Path(__file__).with_name("references.json")
SHAPES = ("plane", "line", "circle", "sphere", "cylinder", "cone", "torus")
SIZES = {"circle": (50.0,), "sphere": (50.0,), "cylinder": (50.0,), "cone": (50.0, 0.3), "torus": (50.0, 9.0)}
POINTS = 30
NOISE_MM = {"whole": 1e-3, "5 degrees": 1e-4}
ARCS = {"whole": 2 * np.pi, "5 degrees": np.radians(5)}
OFFSETS_MM = (0.0, 1000.0)
DIGITS = 50


def cases() -> list[dict[str, Any]]:
    """Noisy points on pieces of every shape, near and far from the origin, with the shape they were taken from."""
    made = []
    for number, (shape, arc, offset) in enumerate((s, a, o) for s in SHAPES for a in ARCS for o in OFFSETS_MM):
        rng = np.random.default_rng(number)
        turn = Rotation.random(random_state=number).as_matrix()
        centre = np.round([offset, -offset, offset / 2], 3)
        local = _points(shape, rng, ARCS[arc]) + rng.normal(0, NOISE_MM[arc], (POINTS, 3))
        points = np.round(local @ turn.T + centre, 9)
        made.append({"shape": shape, "arc": arc, "offset_mm": offset, "points_mm": points, "centre_mm": centre, "axis": turn[:, 2]})
    return made


def _points(shape: str, rng: np.random.Generator, arc: float) -> np.ndarray:
    a, h = rng.uniform(0, arc, POINTS), rng.uniform(-20, 20, POINTS)
    b, zero = rng.uniform(0, 3.0 if arc > 1 else 1.0, POINTS), np.zeros(POINTS)
    if shape == "plane":
        return np.column_stack([h, a, zero])
    if shape == "line":
        return np.column_stack([zero, zero, h * arc])
    if shape == "sphere":
        b = rng.uniform(0, min(arc, 3.0), POINTS)
        return 50 * np.column_stack([np.cos(a) * np.sin(b), np.sin(a) * np.sin(b), np.cos(b)])
    radius = {"circle": 50.0 + zero, "cylinder": 50.0 + zero, "cone": 50.0 - h * np.tan(0.3), "torus": 50 + 9 * np.cos(b)}[shape]
    height = {"circle": zero, "cylinder": h, "cone": h, "torus": 9 * np.sin(b)}[shape]
    return np.column_stack([radius * np.cos(a), radius * np.sin(a), height])


def solved(case: dict[str, Any]) -> dict[str, Any]:
    """Return the least-squares feature of a case: point nearest the centroid, direction and sizes, as decimal strings."""
    import mpmath

    mpmath.mp.dps = DIGITS
    mp, shape = mpmath, case["shape"]
    points = [[mp.mpf(repr(float(value))) for value in row] for row in case["points_mm"]]
    helper = np.eye(3)[np.argmin(np.abs(case["axis"]))]
    u = np.cross(case["axis"], helper)
    triad = [[mp.mpf(float(value)) for value in row] for row in (u, np.cross(case["axis"], u), case["axis"])]
    centre = [mp.mpf(float(value)) for value in case["centre_mm"]]

    def dot(x: Any, y: Any) -> Any:
        return sum(p * q for p, q in zip(x, y, strict=True))

    def unpacked(q: Any) -> tuple[Any, Any, Any]:
        """Point, unit direction and sizes: shifts and leans along the triad of the true shape; an axis does not shift along itself."""
        shifts = {"plane": [0, 0, q[0]], "sphere": q[:3]}.get(shape, [q[0], q[1], 0 if shape in ("line", "cylinder", "cone") else q[2]])
        rest = q[{"plane": 1, "sphere": 3, "circle": 3, "torus": 3}.get(shape, 2) :]
        leans = [0, 0] if shape == "sphere" else rest[:2]
        sizes = rest[0 if shape == "sphere" else 2 :]
        point = [centre[k] + sum(shifts[j] * triad[j][k] for j in range(3)) for k in range(3)]
        leaning = [triad[2][k] + leans[0] * triad[0][k] + leans[1] * triad[1][k] for k in range(3)]
        length = mp.sqrt(dot(leaning, leaning))
        return point, [value / length for value in leaning], sizes

    def residuals(q: Any) -> list[Any]:
        point, axis, sizes = unpacked(q)
        found = []
        for x in points:
            away = [a - b for a, b in zip(x, point, strict=True)]
            h = dot(away, axis)
            across = [a - h * n for a, n in zip(away, axis, strict=True)]
            if shape == "plane":
                found.append(h)
            elif shape == "line":
                found += across
            elif shape == "sphere":
                found.append(mp.sqrt(dot(away, away)) - sizes[0])
            else:
                rho = mp.sqrt(dot(across, across))
                found += {
                    "circle": lambda rho=rho, h=h: [rho - sizes[0], h],
                    "cylinder": lambda rho=rho: [rho - sizes[0]],
                    "cone": lambda rho=rho, h=h: [(rho - sizes[0]) * mp.cos(sizes[1]) + h * mp.sin(sizes[1])],
                    "torus": lambda rho=rho, h=h: [mp.sqrt((rho - sizes[0]) ** 2 + h * h) - sizes[1]],
                }[shape]()
        return found

    free = {"plane": 3, "line": 4, "circle": 5, "sphere": 3, "cylinder": 4, "cone": 4, "torus": 5}[shape]
    q = [mp.mpf(0)] * free + [mp.mpf(size) for size in SIZES.get(shape, ())]
    h = mp.mpf(10) ** -18
    for _ in range(400):
        now = residuals(q)
        columns = []
        for k in range(len(q)):
            up, down = list(q), list(q)
            up[k], down[k] = q[k] + h, q[k] - h
            columns.append([(a - b) / (2 * h) for a, b in zip(residuals(up), residuals(down), strict=True)])
        normal = mp.matrix([[dot(a, b) for b in columns] for a in columns])
        step = mp.lu_solve(normal, mp.matrix([-dot(column, now) for column in columns]))
        q = [a + b for a, b in zip(q, step, strict=True)]
        if mp.norm(step) < mp.mpf(10) ** -25:
            break
    else:
        raise ArithmeticError(f"No reference was found for a {shape} ({case['arc']}).")
    point, axis, sizes = unpacked(q)
    sizes = list(sizes)
    centroid = [sum(x[k] for x in points) / len(points) for k in range(3)]
    along = dot([a - b for a, b in zip(centroid, point, strict=True)], axis)
    if shape == "plane":
        point = [a - along * n for a, n in zip(centroid, axis, strict=True)]
    elif shape in ("line", "cylinder", "cone"):
        point = [a + along * n for a, n in zip(point, axis, strict=True)]
        if shape == "cone":
            sizes[0] -= along * mp.tan(sizes[1])
    texts = {"point_mm": point, "direction": [] if shape == "sphere" else axis, "sizes": sizes}
    return {name: [mp.nstr(value, 25) for value in values] for name, values in texts.items()}


def write() -> None:
    """Write all cases with their answers."""
    rows = []
    for case in cases():
        plain = {name: value.tolist() if isinstance(value, np.ndarray) else value for name, value in case.items()}
        rows.append(json.dumps({name: plain[name] for name in ("shape", "arc", "offset_mm", "points_mm")} | {"answer": solved(case)}))
    FILE.write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    write()
