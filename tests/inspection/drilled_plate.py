"""A plate of 60 × 40 × 10 mm with three equal holes in a row, a slot and a smaller hole, as a nominal and as measured points."""

from __future__ import annotations

import numpy as np

from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import MeasuredPoints

TILE_MM, THICK_MM, SPACING_MM = 20.0, 10.0, 1.25
HOLE_MM, SMALL_MM = 6.0, 3.0  # radii
SLOT_LENGTH_MM, SLOT_WIDTH_MM, SLOT_AT = 24.0, 8.0, (20.0, 30.0)
HOLES_AT = ((10.0, 10.0), (30.0, 10.0), (50.0, 10.0))
SMALL_AT = (50.0, 30.0)
SIZE_MM = (60.0, 40.0)


def drilled_plate() -> Mesh:
    """The nominal: its top is at z = 10, a corner at the origin."""
    facets: list[np.ndarray] = []
    for centre in HOLES_AT:
        _tile(facets, centre, TILE_MM, lambda outer: _circle(outer, HOLE_MM))
    _tile(facets, SMALL_AT, TILE_MM, lambda outer: _circle(outer, SMALL_MM))
    _tile(facets, SLOT_AT, 2 * TILE_MM, _stadium)
    corners = [(0.0, 0.0), (SIZE_MM[0], 0.0), SIZE_MM, (0.0, SIZE_MM[1])]
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        _wall(facets, _side(np.array(start), np.array(end)))
    return mesh_of(np.concatenate(facets))


def mesh_of(facets: np.ndarray) -> Mesh:
    """Triangles (T, 3, 3) as a mesh."""
    return Mesh(facets.reshape(-1, 3), np.arange(3 * len(facets)).reshape(-1, 3), "nominal")


def points_on(mesh: Mesh, *, per_mm2: float = 6.0, noise_mm: float = 0.01, seed: int = 7) -> MeasuredPoints:
    """Points spread evenly over a mesh, with noise along its normals."""
    rng, corners = np.random.default_rng(seed), mesh.vertices_mm[mesh.triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(cross, axis=1)
    which = rng.choice(len(corners), int(per_mm2 * doubled.sum() / 2), p=doubled / doubled.sum())
    u, v = rng.uniform(size=(2, len(which)))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    chosen, normals = corners[which], cross[which] / doubled[which, None]
    on = chosen[:, 0] + u[:, None] * (chosen[:, 1] - chosen[:, 0]) + v[:, None] * (chosen[:, 2] - chosen[:, 0])
    return MeasuredPoints(on + noise_mm * rng.standard_normal((len(on), 1)) * normals, normals)


def tube(centre, radius_mm, low, high, *, axis=(0.0, 0.0, 1.0), hole=True, facets=48, top_mm=None) -> np.ndarray:
    """The wall of a hole or pin as triangles (T, 3, 3); with ``top_mm`` it is a cone."""
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    u = np.cross(axis, np.eye(3)[int(np.abs(axis).argmin())])
    u /= np.linalg.norm(u)
    turn = np.linspace(0, 2 * np.pi, facets + 1)[:, None]
    around = np.cos(turn) * u + np.sin(turn) * np.cross(axis, u)
    lower, upper = (
        np.asarray(centre, float) + level * axis + size * around for level, size in ((low, radius_mm), (high, top_mm or radius_mm))
    )
    made: list[np.ndarray] = []
    _strip(made, lower, upper)
    return made[0][:, ::-1] if hole else made[0]


def _tile(facets, centre, width_mm, inner) -> None:
    centre, half = np.asarray(centre), np.array([width_mm, TILE_MM]) / 2
    corners = [np.array(one) * half for one in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    outer = np.vstack([_side(a, b)[:-1] for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)])
    outer = np.vstack([outer, outer[:1]])
    hole = inner(outer)
    for z, is_top in ((THICK_MM, True), (0.0, False)):
        made: list[np.ndarray] = []
        _strip(made, *(np.column_stack([one + centre, np.full(len(one), z)]) for one in (outer, hole)))
        facets.append(made[0] if is_top else made[0][:, ::-1])
    _wall(facets, (hole + centre)[::-1])


def _side(start, end) -> np.ndarray:
    count = round(float(np.linalg.norm(end - start)) / SPACING_MM)
    return start + np.linspace(0, 1, count + 1)[:, None] * (end - start)


def _circle(outer, radius_mm) -> np.ndarray:
    return outer / np.linalg.norm(outer, axis=1, keepdims=True) * radius_mm


def _stadium(outer) -> np.ndarray:
    """The outline of the slot, each point where the middle line is nearest to that of the tile."""
    half = (SLOT_LENGTH_MM - SLOT_WIDTH_MM) / 2
    middle = np.column_stack([np.clip(outer[:, 0], -half, half), np.zeros(len(outer))])
    away = outer - middle
    return middle + away / np.linalg.norm(away, axis=1, keepdims=True) * SLOT_WIDTH_MM / 2


def _wall(facets, outline) -> None:
    """The wall from z = 0 to the top along an outline (N, 2); the material is on its left."""
    lower, upper = (np.column_stack([outline, np.full(len(outline), z)]) for z in (0.0, THICK_MM))
    _strip(facets, lower, upper)


def _strip(facets, lower, upper) -> None:
    """Triangles between two polylines with the same number of points."""
    a, b, c, d = lower[:-1], lower[1:], upper[1:], upper[:-1]
    facets.append(np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))
