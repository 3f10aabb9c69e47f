"""Least-squares references in 50 digits: `python tests/geometry/references.py` writes `references.json` again.

The distances are written down in `fifty_digits.py` once more, with other parameters than in the core, derived numerically in mpmath and
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
POINTS = 30
NOISE_MM = {"whole": 1e-3, "5 degrees": 1e-4}
ARCS = {"whole": 2 * np.pi, "5 degrees": np.radians(5)}
OFFSETS_MM = (0.0, 1000.0)


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


def write() -> None:
    """Write all cases with their answers."""
    from fifty_digits import solved

    rows = []
    for case in cases():
        plain = {name: value.tolist() if isinstance(value, np.ndarray) else value for name, value in case.items()}
        rows.append(json.dumps({name: plain[name] for name in ("shape", "arc", "offset_mm", "points_mm")} | {"answer": solved(case)}))
    FILE.write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    write()
