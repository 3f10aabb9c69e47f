"""A surface prepared for drawing: normals that keep edges sharp, parts small enough for one frame, a coarse copy for motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ui.viewport.layers import SurfaceLayer

SHARP_RAD = np.radians(35.0)  # between triangles, from which on the edge stays sharp
PART_TRIANGLES = 30_000  # drawn by a busy software renderer within a frame; an idle one draws several
PROXY_TRIANGLES = 50_000
CROWD = 64  # triangles around a vertex beyond which its edges are not searched


@dataclass(frozen=True, eq=False)
class SurfacePart:
    """Vertices of their own, so that each part is handed to the graphics alone."""

    vertices_mm: np.ndarray  # (V, 3) float32
    triangles: np.ndarray  # (T, 3) int64
    normals: np.ndarray  # (V, 3) float32
    colours: np.ndarray | None  # (V, 3) uint8


@dataclass(frozen=True, eq=False)
class PreparedSurface:
    """Parts drawn one after the other at rest, and what is drawn while the camera moves."""

    layer: SurfaceLayer
    parts: tuple[SurfacePart, ...]
    proxy: SurfacePart | None  # None: the parts themselves are small enough


def prepare_surface(layer: SurfaceLayer) -> PreparedSurface:
    """Prepare a surface; slow for millions of triangles, so it belongs on a thread."""
    whole = _with_normals(layer)
    count = len(whole.triangles)
    parts = tuple(_part(whole, whole.triangles[start : start + PART_TRIANGLES]) for start in range(0, count, PART_TRIANGLES))
    return PreparedSurface(
        layer, parts if count > PART_TRIANGLES else (whole,) if count else (), coarse(whole) if count > PROXY_TRIANGLES else None
    )


def _with_normals(layer: SurfaceLayer) -> SurfacePart:
    vertices, triangles = np.asarray(layer.vertices_mm, np.float32), np.asarray(layer.triangles, np.int64).reshape(-1, 3)
    colours = None if layer.colours is None else np.asarray(layer.colours, np.uint8)
    if layer.normals is not None:
        return SurfacePart(vertices, triangles, np.asarray(layer.normals, np.float32), colours)
    return split_at_edges(vertices, triangles, colours)


def split_at_edges(vertices: np.ndarray, triangles: np.ndarray, colours: np.ndarray | None = None) -> SurfacePart:
    """Compute vertex normals; where triangles meet at a sharp edge, each corner gets a vertex and a normal of its own."""
    first, second, third = (vertices[triangles[:, corner]].astype(float) for corner in range(3))
    faces = np.cross(second - first, third - first)  # their length is twice the area: the weight in the mean
    units = faces / np.maximum(np.linalg.norm(faces, axis=1, keepdims=True), 1e-30)
    means = _unit(_sum_at(triangles, faces, len(vertices)))
    agrees = np.einsum("td,tcd->tc", units, means[triangles]) > np.cos(SHARP_RAD / 2.0)
    sharp = np.zeros(len(vertices), bool)
    sharp[triangles[~agrees]] = True
    corners = np.flatnonzero(sharp[triangles].ravel())
    if not len(corners):
        return SurfacePart(vertices, triangles, means.astype(np.float32), colours)
    own = _corner_normals(triangles.ravel()[corners], corners // 3, faces, units)
    made = triangles.ravel().copy()
    made[corners] = len(vertices) + np.arange(len(corners))
    from_vertex = triangles.ravel()[corners]
    return SurfacePart(
        np.concatenate([vertices, vertices[from_vertex]]),
        made.reshape(-1, 3),
        np.concatenate([means, own]).astype(np.float32),
        None if colours is None else np.concatenate([colours, colours[from_vertex]]),
    )


def _corner_normals(vertex: np.ndarray, face: np.ndarray, faces: np.ndarray, units: np.ndarray) -> np.ndarray:
    """Return a normal per corner: the mean of the triangles at its vertex that are less inclined to its own than a sharp edge."""
    order = np.argsort(vertex, kind="stable")
    sorted_vertex = vertex[order]
    starts = np.searchsorted(sorted_vertex, vertex, "left")
    counts = np.searchsorted(sorted_vertex, vertex, "right") - starts
    counts = np.where(counts <= CROWD, counts, 0)  # crowded corners keep the normal of their triangle
    corner = np.repeat(np.arange(len(vertex)), counts)
    inside = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    other = face[order[starts[corner] + inside]]
    near = np.einsum("nd,nd->n", units[face[corner]], units[other]) > np.cos(SHARP_RAD)
    summed = np.stack([np.bincount(corner[near], faces[other[near], axis], len(vertex)) for axis in range(3)], axis=1)
    summed[counts == 0] = faces[face[counts == 0]]
    return _unit(summed)


def _sum_at(triangles: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    corners = triangles.ravel()
    return np.stack([np.bincount(corners, np.repeat(values[:, axis], 3), count) for axis in range(3)], axis=1)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-30))


def _part(whole: SurfacePart, triangles: np.ndarray) -> SurfacePart:
    used, renumbered = np.unique(triangles, return_inverse=True)
    colours = None if whole.colours is None else whole.colours[used]
    return SurfacePart(whole.vertices_mm[used], renumbered.reshape(-1, 3).astype(np.int64), whole.normals[used], colours)


def coarse(whole: SurfacePart, most: int = PROXY_TRIANGLES) -> SurfacePart:
    """Return a surface of at most about ``most`` triangles: vertices in one cube become one (vertex clustering)."""
    low = whole.vertices_mm.min(axis=0)
    diagonal = float(np.linalg.norm(whole.vertices_mm.max(axis=0) - low))
    cells = np.sqrt(most)  # along the diagonal; a closed surface has about twice as many triangles as the square
    made = whole
    for _ in range(6):
        made = _clustered(whole, low, diagonal / cells)
        if len(made.triangles) <= most:
            break
        cells *= 0.8 * np.sqrt(most / len(made.triangles))
    return made


def _clustered(whole: SurfacePart, low: np.ndarray, edge: float) -> SurfacePart:
    cells = np.floor((whole.vertices_mm - low) / max(edge, 1e-9)).astype(np.int64)
    shape = cells.max(axis=0) + 1
    _, cube = np.unique((cells[:, 0] * shape[1] + cells[:, 1]) * shape[2] + cells[:, 2], return_inverse=True)
    count = int(cube.max()) + 1
    sizes = np.bincount(cube, minlength=count)[:, None]

    def mean(values: np.ndarray) -> np.ndarray:
        return np.stack([np.bincount(cube, values[:, axis], count) for axis in range(3)], axis=1) / sizes

    triangles = cube[whole.triangles]
    alive = (triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2]) & (triangles[:, 0] != triangles[:, 2])
    triangles = triangles[alive]
    _, once = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True) if len(triangles) else (None, np.empty(0, np.int64))
    colours = None if whole.colours is None else np.rint(mean(whole.colours.astype(float))).astype(np.uint8)
    normals = _unit(mean(whole.normals.astype(float))).astype(np.float32)
    return SurfacePart(mean(whole.vertices_mm.astype(float)).astype(np.float32), triangles[once], normals, colours)
