"""Faces of the nominal: the connected facets around a clicked one, the shape they have, and the sharp edges between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import distances_mm, fit
from measureapp.inspection.surface.nominal import SHARP_DEG, NominalSurface

FLAT_DEG, SMOOTH_DEG = 1.0, 20.0  # greatest angle to the clicked facet, and between neighbouring facets of a curved face
CHORD = 5e-3  # greatest distance of vertices from a shape, relative to the size of the face
LEAST_CHORD_MM = 0.01
NEAR = 0.05  # greatest distance of a click from the edge that it means, relative to the size of the part
ON_IT_MM = 3.0  # greatest distance of a click from the nominal that it means
DIGITS = 6


@dataclass(frozen=True, slots=True, eq=False)
class SharpEdges:
    """Edges between facets that meet at more than `SHARP_DEG`."""

    vertices: IntArray  # (E, 2)
    triangles: IntArray  # (E, 2), on both sides
    distances_mm: FloatArray  # (E,), from the click


def clicked_facet(surface: NominalSurface, place_mm: FloatArray) -> tuple[int, FloatArray]:
    """Return the facet and the place on it that a click means. Raises InspectionError off the nominal."""
    place = np.asarray(place_mm, float)
    closest = surface.closest(place[None])
    off = float(np.linalg.norm(closest.points_mm[0] - place))
    if off > ON_IT_MM:
        raise InspectionError(
            f"The clicked place is {off:.1f} mm off the CAD model.", "Click where the part follows the model, or display the model itself."
        )
    return int(closest.triangles[0]), closest.points_mm[0]


def flat_face(surface: NominalSurface, seed: int) -> IntArray:
    """Return the connected facets that are parallel to one."""
    return _connected(surface, surface.normals @ surface.normals[seed] > np.cos(np.radians(FLAT_DEG)), seed, -1.0)


def smooth_face(surface: NominalSurface, seed: int) -> IntArray:
    """Return the connected facets of a curved face, each of which is nearly parallel to the next."""
    return _connected(surface, np.ones(len(surface.triangles), np.bool_), seed, float(np.cos(np.radians(SMOOTH_DEG))))


def _connected(surface: NominalSurface, allowed: BoolArray, seed: int, least_cosine: float) -> IntArray:
    """Return the triangles connected to ``seed`` by edges between allowed ones that are at most so sharp."""
    labels = _labels(surface, allowed, least_cosine)
    return np.flatnonzero(labels == labels[seed])


def smooth_faces(surface: NominalSurface) -> list[IntArray]:
    """Return all curved and flat faces of the nominal, the facets of each."""
    labels = _labels(surface, np.ones(len(surface.triangles), np.bool_), float(np.cos(np.radians(SMOOTH_DEG))))
    order = np.argsort(labels, kind="stable")
    return np.split(order, np.cumsum(np.bincount(labels))[:-1])


def _labels(surface: NominalSurface, allowed: BoolArray, least_cosine: float) -> IntArray:
    pairs, cosines = surface.face_neighbours
    kept = pairs[(cosines >= least_cosine) & allowed[pairs].all(axis=1)]
    count = len(surface.triangles)
    links = coo_matrix((np.ones(len(kept), np.int8), (kept[:, 0], kept[:, 1])), shape=(count, count))
    return np.asarray(connected_components(links, directed=False)[1])


def corners_of(surface: NominalSurface, triangles: IntArray) -> FloatArray:
    """Return the vertices (N, 3) of facets, each once."""
    return surface.vertices_mm[np.unique(surface.triangles[triangles])]


def fit_face(surface: NominalSurface, triangles: IntArray, shape: Shape) -> Feature | None:
    """Return the shape of a face if all its vertices are on it."""
    vertices = corners_of(surface, triangles)
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    try:
        found = fit(shape, vertices)
    except FitError:
        return None
    most = float(np.abs(distances_mm(found, vertices)).max())
    small = (found.radius_mm or 0.0) < 5 * size
    return found if small and most < max(CHORD * size, LEAST_CHORD_MM) else None


def sharp_edges_near(surface: NominalSurface, place_mm: FloatArray) -> SharpEdges:
    """Return all sharp edges of the nominal with their distances from a place."""
    pairs, cosines = surface.face_neighbours
    pairs = pairs[cosines < np.cos(np.radians(SHARP_DEG))]
    one, other = surface.triangles[pairs[:, 0]], surface.triangles[pairs[:, 1]]
    common = (one[:, :, None] == other[:, None, :]).any(axis=2)
    vertices = one[common].reshape(-1, 2)
    start, end = surface.vertices_mm[vertices[:, 0]], surface.vertices_mm[vertices[:, 1]]
    along = end - start
    share = np.clip(np.einsum("nd,nd->n", place_mm - start, along) / np.maximum(np.einsum("nd,nd->n", along, along), 1e-12), 0.0, 1.0)
    return SharpEdges(vertices, pairs, np.linalg.norm(start + share[:, None] * along - place_mm, axis=1))


def wall_at(surface: NominalSurface, place_mm: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the curved wall that a click means, and the place on the nominal: the clicked face, or, beside a hole, the wall of the hole.

    Raises
    ------
    InspectionError
        Off the nominal, or on a face without a curved one beside it.
    """
    seed, place = clicked_facet(surface, place_mm)
    face = smooth_face(surface, seed)
    if len(face) > len(flat_face(surface, seed)):
        return face, place
    edges = sharp_edges_near(surface, place)
    inside = np.isin(edges.triangles, face)
    for number in np.argsort(np.where(inside.any(axis=1), edges.distances_mm, np.inf)):
        if not inside[number].any() or edges.distances_mm[number] > NEAR * surface.diagonal_mm:
            break
        beyond = int(edges.triangles[number][~inside[number]][0]) if not inside[number].all() else -1
        if beyond >= 0 and len(wall := smooth_face(surface, beyond)) > len(flat_face(surface, beyond)):
            return wall, place
    raise InspectionError("There is no curved wall at the clicked place.", "Click the wall of the hole, or its edge on the face beside it.")


def listed(vector: FloatArray) -> list[float]:
    """Return a vector for an entry of a program."""
    return [rounded(float(value)) for value in vector]


def rounded(value: float | None) -> float:
    """Return a number for an entry of a program."""
    return round(value or 0.0, DIGITS) + 0.0
