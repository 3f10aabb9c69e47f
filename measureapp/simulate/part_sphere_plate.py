"""Sample part: the sphere plate, five spheres on pillars, for acceptance tests."""

from __future__ import annotations

from itertools import combinations
from math import acos, ceil, pi, sin, sqrt

import numpy as np
from scipy.spatial import ConvexHull

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.simulate.part import MATT_GREY, Part
from measureapp.simulate.solids import Soup, circle, polyline

PLATE_MM = (240.0, 180.0, 10.0)
SPHERE_RADIUS_MM, SPHERE_HEIGHT_MM, PILLAR_RADIUS_MM = 20.0, 28.0, 10.0
CENTRES_MM = ((-80.0, -55.0), (80.0, -55.0), (0.0, 0.0), (-80.0, 55.0), (80.0, 55.0))
FORM_ERROR_MM = 0.004  # greatest distance of the facets from the sphere, to both sides
BORDER_STEP_MM = 5.0


def sphere_plate() -> Part:
    """Return the plate of 240 × 180 × 10 mm with spheres Ø40 at z = 28 on pillars Ø20."""
    width, depth, top = PLATE_MM
    corners = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]]) * [width / 2, depth / 2]
    border = polyline(corners, BORDER_STEP_MM)[:-1]
    pillar = circle(PILLAR_RADIUS_MM)
    joint_mm = SPHERE_HEIGHT_MM - sqrt(SPHERE_RADIUS_MM**2 - PILLAR_RADIUS_MM**2)
    ball = _ball(pillar)
    soup = Soup()
    soup.face([border], 0.0, up=False)
    soup.wall(border, 0.0, top)
    soup.face([border, *(pillar + centre for centre in CENTRES_MM)], top, up=True)
    for centre in CENTRES_MM:
        soup.wall(pillar + centre, top, joint_mm)
        soup.add(ball + np.array([*centre, SPHERE_HEIGHT_MM]))
    mesh = Mesh(*soup.merge(), "nominal")
    return Part("sphere_plate", mesh, (MATT_GREY,), np.zeros(len(mesh.triangles), np.uint8), _dimensions())


def _dimensions() -> dict[str, float]:
    dimensions = {f"sphere_{index + 1}_diameter": 2 * SPHERE_RADIUS_MM for index in range(len(CENTRES_MM))}
    for (i, first), (j, second) in combinations(enumerate(CENTRES_MM), 2):
        dimensions[f"distance_{i + 1}_{j + 1}"] = float(np.hypot(*np.subtract(first, second)))
    return dimensions


def _ball(foot: FloatArray) -> FloatArray:
    """The sphere above its circle ``foot`` (n, 2), as triangles (T, 3, 3) about its centre.

    Its corners are outside the sphere by as much as the centres of its facets are inside, so that a sphere fitted to the
    facets has the true radius. The convex hull of points on a sphere is their Delaunay triangulation.
    """
    outer = SPHERE_RADIUS_MM + FORM_ERROR_MM
    step_rad = sqrt(2.0 * 2.0 * FORM_ERROR_MM / SPHERE_RADIUS_MM) * sqrt(2.0)
    low = sqrt(SPHERE_RADIUS_MM**2 - PILLAR_RADIUS_MM**2)
    foot_ring = np.column_stack([foot, np.full(len(foot), -low)])
    widest = acos(-low / SPHERE_RADIUS_MM)
    rings = [foot_ring, np.array([[0.0, 0.0, outer]])]
    for index, polar in enumerate(np.linspace(0.0, widest, ceil(widest / step_rad) + 1)[1:-1]):
        count = ceil(2 * pi * sin(polar) / step_rad)
        turn = 2 * pi * (np.arange(count) + 0.5 * (index % 2)) / count
        rings.append(outer * np.column_stack([np.cos(turn) * sin(polar), np.sin(turn) * sin(polar), np.full(count, np.cos(polar))]))
    points = np.concatenate(rings)
    triangles = ConvexHull(points).simplices
    triangles = triangles[~np.all(triangles < len(foot), axis=1)]
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", normals, corners[:, 0]) < 0
    corners[inward] = corners[inward][:, [0, 2, 1]]
    return corners
