"""Sample parts made of blocks: the cross-shaped gypsum polyhedron and the flat."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.simulate.part import MATT_GREY, MATT_WHITE, Part

_CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]])
_SIDES = {  # step to the neighbour -> corners of the side, counter-clockwise seen from there
    (-1, 0, 0): (0, 4, 6, 2),
    (1, 0, 0): (1, 3, 7, 5),
    (0, -1, 0): (0, 1, 5, 4),
    (0, 1, 0): (2, 6, 7, 3),
    (0, 0, -1): (0, 2, 3, 1),
    (0, 0, 1): (4, 5, 7, 6),
}


def gypsum() -> Part:
    """Return the paper's cross-shaped polyhedron: two arms z 0…50, a raised centre to z 90."""
    x, y, z = np.array([-90.0, -30.0, 30.0, 90.0]), np.array([-70.0, -30.0, 30.0, 70.0]), np.array([0.0, 50.0, 90.0])
    solid = np.zeros((3, 3, 2), bool)
    solid[:, 1, 0] = solid[1, :, 0] = True
    solid[1, 1, 1] = True
    mesh = _surface(x, y, z, solid)
    dimensions = {"a": 180.0, "b": 140.0, "c": 60.0, "d": 40.0}
    return Part("gypsum", mesh, (MATT_WHITE,), np.zeros(len(mesh.triangles), np.uint8), dimensions)


def flat() -> Part:
    """Return a block of 300 × 220 × 20 mm."""
    mesh = _surface(np.array([-150.0, 150.0]), np.array([-110.0, 110.0]), np.array([0.0, 20.0]), np.ones((1, 1, 1), bool))
    return Part("flat", mesh, (MATT_GREY,), np.zeros(len(mesh.triangles), np.uint8))


def _surface(x: FloatArray, y: FloatArray, z: FloatArray, solid: BoolArray) -> Mesh:
    """Return the boundary faces of the solid cells of a rectangular grid."""
    sides = []
    for cell in np.argwhere(solid):
        for step, corners in _SIDES.items():
            neighbour = cell + step
            if np.any(neighbour < 0) or np.any(neighbour >= solid.shape) or not solid[tuple(neighbour)]:
                sides.append(cell + _CORNERS[list(corners)])
    quads = np.array(sides)  # (Q, 4, 3) grid indices
    used, index = np.unique(quads.reshape(-1, 3), axis=0, return_inverse=True)
    vertices = np.column_stack([x[used[:, 0]], y[used[:, 1]], z[used[:, 2]]])
    return Mesh(vertices, _split_quads(index.reshape(-1, 4)), "nominal")


def _split_quads(quads: IntArray) -> IntArray:
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
