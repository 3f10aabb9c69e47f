"""Parts for the planner, made from parameters; none of them is a sample part."""

from __future__ import annotations

import numpy as np

from measureapp.data.mesh import Mesh
from measureapp.resources import resource


def mesh_of(quads: list[np.ndarray]) -> Mesh:
    """A mesh of quads, each (4, 3), counter-clockwise seen from outside."""
    vertices = np.concatenate(quads)
    first = 4 * np.arange(len(quads))[:, None]
    return Mesh(vertices, np.concatenate([first + np.array(corners) for corners in ([0, 1, 2], [0, 2, 3])]), "nominal")


def _ring(x: float, y: float, z: float) -> np.ndarray:
    return np.array([[-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]])


def _walls(low: np.ndarray, high: np.ndarray) -> list[np.ndarray]:
    """Quads between two rings of four points, facing outwards if ``low`` is below ``high``."""
    return [np.array([low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]]) for i in range(4)]


def casting(pocket_mm: float = 45.0) -> Mesh:
    """A box of 180 × 120 × 70 mm with a rectangular pocket in its top."""
    bottom, top = _ring(90, 60, 0), _ring(90, 60, 70)
    edge, floor = _ring(55, 30, 70), _ring(45, 22, 70 - pocket_mm)
    return mesh_of([bottom[::-1], *_walls(bottom, top), *_walls(top, edge), *_walls(edge, floor), floor])


def torus() -> Mesh:
    """A ring of 190 mm diameter that lies on the table."""
    import trimesh

    made = trimesh.creation.torus(major_radius=70.0, minor_radius=25.0, major_sections=96, minor_sections=48)
    return Mesh(np.asarray(made.vertices), np.asarray(made.faces), "nominal")


def blade() -> Mesh:
    """A twisted, tapered blade of 220 mm on a foot, upright."""
    along, around = 60, 48
    rows = []
    for s in np.linspace(0.0, 1.0, along):
        turn, chord, thick = np.deg2rad(45.0) * s, 90.0 - 35.0 * s, 14.0 - 8.0 * s
        angle = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
        x, y = chord / 2.0 * np.cos(angle), thick / 2.0 * np.sin(angle) + 10.0 * (1.0 - np.cos(angle) ** 2) * (1.0 - s)
        c, d = np.cos(turn), np.sin(turn)
        rows.append(np.column_stack([c * x - d * y, d * x + c * y, np.full(around, 20.0 + 200.0 * s)]))
    skin = [
        np.array([rows[k][i], rows[k][(i + 1) % around], rows[k + 1][(i + 1) % around], rows[k + 1][i]])
        for k in range(along - 1)
        for i in range(around)
    ]
    centre = rows[-1].mean(axis=0)
    cap = [np.array([rows[-1][i], rows[-1][(i + 1) % around], centre, centre]) for i in range(around)]
    foot_low, foot_high = _ring(60, 40, 0), _ring(60, 40, 20)
    return mesh_of([*skin, *cap, foot_low[::-1], *_walls(foot_low, foot_high), foot_high])


def impeller() -> Mesh:
    """The sample impeller, as its STL file."""
    from measureapp.project.geometry.files import read_mesh

    return read_mesh(resource("parts/impeller/nominal.stl"))
