"""Distances from the nominal by ray casting along the points' normals, many times faster than closest-point queries."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.inspection.surface.nominal import STEEP, NominalSurface

REACH_MM = 1.0  # greatest distance at which the closest point is assumed to lie along the normal
LEAN_DEG = 12.0  # between the normals of point and nominal
SLIDE_MM = 0.02  # greatest tangential distance between the hit and the foot of the perpendicular


def distances_along_normals(points_mm: FloatArray, normals: FloatArray, surface: NominalSurface) -> tuple[FloatArray, IntArray, BoolArray]:
    """Cast rays from each point along its normal to both sides; return point-to-plane distances from the triangles hit.

    Parameters
    ----------
    points_mm, normals : (N, 3), in the nominal's frame; unit normals, outwards

    Returns
    -------
    distances_mm : (N,) from the plane of the triangle hit, positive on the side its normal points to
    triangles : (N,)
    sure : (N,) whether the result is valid: a hit within `REACH_MM` on a triangle of matching normal, with the foot of the
        perpendicular within `SLIDE_MM` of the hit; otherwise a closest-point query is required
    """
    outwards = surface.rough_hits(points_mm, normals)
    away, triangles = outwards.distances_mm, outwards.triangles
    doubtful: BoolArray = away >= REACH_MM
    near = np.flatnonzero(~doubtful)
    doubtful[near] = surface.has_hits(points_mm[near], -normals[near], REACH_MM + SLIDE_MM)
    behind = np.flatnonzero(doubtful)  # rays inwards from elsewhere only cross the whole part
    inwards = surface.rough_hits(points_mm[behind], -normals[behind])
    nearer = inwards.distances_mm <= away[behind]
    away[behind[nearer]], triangles[behind[nearer]] = inwards.distances_mm[nearer], inwards.triangles[nearer]
    triangles = np.where(np.isfinite(away), triangles, 0)
    faces = surface.normals[triangles]
    corner = surface.vertices_mm[surface.triangles[triangles, 0]]
    distances = np.einsum("nd,nd->n", points_mm - corner, faces)
    facing = np.einsum("nd,nd->n", faces, normals)
    steep = np.isfinite(away) & (np.abs(facing) > STEEP)
    away[steep] = np.abs(distances[steep] / facing[steep])  # in double precision
    hit = away < REACH_MM
    slide = np.sqrt(np.maximum(np.where(hit, away, 0.0) ** 2 - distances**2, 0.0))
    return distances, triangles, hit & (facing > np.cos(np.radians(LEAN_DEG))) & (slide < SLIDE_MM)
