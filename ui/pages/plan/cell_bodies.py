"""The bodies of the cell as triangles, as the collision check knows them."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ui.viewport.layers import SurfaceLayer

if TYPE_CHECKING:
    from measureapp.planning.collision.bodies import Body
    from measureapp.planning.collision.cell import Cell
    from measureapp.planning.collision.motion import Placement

SIDES = 24  # of a round body
HIDDEN = ("floor",)
Colour = tuple[int, int, int]
BOX_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
BOX_FACES = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
)


@dataclass(frozen=True, eq=False)
class Triangles:
    """Flat triangles in one colour, or one for each."""

    corners_mm: np.ndarray  # (T, 3, 3)
    normals: np.ndarray  # (T, 3)
    colours: np.ndarray  # (T, 3) uint8

    @classmethod
    def of(cls, corners: np.ndarray, colour: Colour) -> Triangles:
        """Build from corners (T, 3, 3), counter-clockwise seen from outside."""
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        return cls(corners, normals, np.tile(np.array(colour, np.uint8), (len(corners), 1)))


def surface_of(parts: Collection[Triangles]) -> SurfaceLayer | None:
    """Return all triangles as one surface; None if there are none."""
    if not parts:
        return None
    corners = np.concatenate([part.corners_mm for part in parts]).astype(np.float32)
    count = 3 * len(corners)
    normals = np.repeat(np.concatenate([part.normals for part in parts]).astype(np.float32), 3, axis=0)
    colours = np.repeat(np.concatenate([part.colours for part in parts]), 3, axis=0)
    return SurfaceLayer(corners.reshape(count, 3), np.arange(count).reshape(-1, 3), colours, normals=normals)


def cell_triangles(cell: Cell, placement: Placement, colours: dict[str, Colour], bad: Colour) -> Iterator[Triangles]:
    """Yield the bodies of a cell at a placement, in the guide frame; what would touch is red. The part is not among them.

    Parameters
    ----------
    colours : by the kind of a body
    bad : colour of what would touch
    """
    met = cell.encounter_at(placement)
    touching = () if met is None else (met.first, met.second)
    frames = cell.scene.mechanism.frames(placement, placement, np.zeros(1))[0]
    for body in cell.scene.bodies:
        corners = _corners(body)
        if body.name in HIDDEN or corners is None:
            continue
        pose = frames[body.carrier] @ body.placed
        placed = corners @ pose[:3, :3].T + pose[:3, 3]
        yield Triangles.of(placed, bad if body.name in touching else colours.get(body.kind.value, colours["obstacle"]))


def _corners(body: Body) -> np.ndarray | None:
    """Return the triangles of a body in the frame of its geometry; None for a hull, which is the part."""
    geometry = body.solid.geometry
    kind = type(geometry).__name__
    if kind == "Box":
        return (BOX_CORNERS * np.asarray(geometry.side) / 2.0)[BOX_FACES]
    if kind in ("Cylinder", "Capsule"):
        ends = geometry.lz / 2.0 + (geometry.radius if kind == "Capsule" else 0.0)
        return _round(float(geometry.radius), float(ends))
    return None


def _round(radius_mm: float, half_mm: float) -> np.ndarray:
    """Return an upright cylinder, closed."""
    angles = np.linspace(0.0, 2.0 * np.pi, SIDES + 1)
    rim = np.column_stack([radius_mm * np.cos(angles), radius_mm * np.sin(angles)])
    low, high = np.column_stack([rim, np.full(SIDES + 1, -half_mm)]), np.column_stack([rim, np.full(SIDES + 1, half_mm)])
    bottom, top = np.tile([0.0, 0.0, -half_mm], (SIDES, 1)), np.tile([0.0, 0.0, half_mm], (SIDES, 1))
    return np.concatenate(
        [
            np.stack([low[:-1], low[1:], high[1:]], axis=1),
            np.stack([low[:-1], high[1:], high[:-1]], axis=1),
            np.stack([bottom, low[1:], low[:-1]], axis=1),
            np.stack([top, high[:-1], high[1:]], axis=1),
        ]
    )
