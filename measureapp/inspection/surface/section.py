"""Sections: intersection curves of the nominal with a plane or cylinder, and the measured points along them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import InspectionError
from measureapp.inspection.surface.cutting_surface import CuttingSurface
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.nominal import NominalSurface

BISECTIONS = 40


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """One section. Coordinates are in the nominal's frame."""

    name: str
    nominal: tuple[FloatArray, ...]  # curves (K, 3); a closed one ends at its first point
    measured_mm: FloatArray  # (N, 3), projected onto the cutting surface, in order along the nominal curves
    deviations_mm: FloatArray  # (N,)
    nominal_normals: FloatArray  # (N, 3), of the nominal at each point


def cut_section(name: str, found: Deviation, surface: NominalSurface, cut: CuttingSurface, half_width_mm: float) -> Section:
    """Cut the nominal, and select the measured points within ``half_width_mm`` of the cutting surface.

    Raises
    ------
    InspectionError
        The cutting surface intersects neither the nominal nor measured points.
    """
    curves = intersect_mesh(surface.vertices_mm, surface.triangles, cut)
    offsets = cut.offsets_mm(found.points_mm)
    near = np.flatnonzero(np.abs(offsets) < half_width_mm)
    if not curves and len(near) == 0:
        raise InspectionError(
            f"The section {name} intersects neither the nominal nor measured points.",
            f"The nominal extends from {_format_point(surface.low_mm)} to {_format_point(surface.high_mm)} mm: place the section inside.",
        )
    moved = found.points_mm[near] - offsets[near, None] * cut.normals(found.points_mm[near])
    order = _order_along_curves(moved, curves)
    return Section(name, curves, moved[order], found.distances_mm[near][order], np.asarray(found.nominal_normals[near][order], np.float64))


def intersect_mesh(vertices_mm: FloatArray, triangles: IntArray, cut: CuttingSurface) -> tuple[FloatArray, ...]:
    """Return the intersection curves (K, 3) of ``cut`` with a triangle mesh, chained from triangle to triangle.

    An edge is cut if the offset of its ends changes sign; a vertex on the surface counts as outside, so that every triangle is cut at
    exactly two edges or none.
    """
    outside = cut.offsets_mm(vertices_mm) >= 0
    crossed = triangles[outside[triangles].any(axis=1) & ~outside[triangles].all(axis=1)]
    if len(crossed) == 0:
        return ()
    edges = np.sort(np.stack([crossed[:, [0, 1]], crossed[:, [1, 2]], crossed[:, [2, 0]]], axis=1), axis=2)
    changes = outside[edges[..., 0]] != outside[edges[..., 1]]
    unique, numbers = np.unique(edges[changes], axis=0, return_inverse=True)
    places = _edge_intersections(vertices_mm[unique[:, 0]], vertices_mm[unique[:, 1]], cut)
    return tuple(places[chain] for chain in _chain_segments(numbers.reshape(-1, 2)))


def _edge_intersections(start: FloatArray, end: FloatArray, cut: CuttingSurface) -> FloatArray:
    """Return the intersections of edges with the cutting surface, by bisection."""
    low, high = np.zeros(len(start)), np.ones(len(start))
    sign = np.where(cut.offsets_mm(start) >= 0, 1.0, -1.0)
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        same = sign * cut.offsets_mm(start + middle[:, None] * (end - start)) >= 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return np.asarray(start + ((low + high) / 2)[:, None] * (end - start))


def _chain_segments(segments: IntArray) -> list[list[int]]:
    """Chain segments (S, 2) of point numbers; open chains start at their ends."""
    at: dict[int, list[int]] = {}
    for number, (one, other) in enumerate(segments.tolist()):
        at.setdefault(one, []).append(number)
        at.setdefault(other, []).append(number)
    used = np.zeros(len(segments), bool)
    chains = []
    for start in [point for point, meeting in at.items() if len(meeting) == 1] + list(at):
        while any(not used[number] for number in at[start]):
            chains.append(_walk(start, segments, at, used))
    return chains


def _walk(start: int, segments: IntArray, at: dict[int, list[int]], used: np.ndarray) -> list[int]:
    chain, point = [start], start
    while (following := next((number for number in at[point] if not used[number]), None)) is not None:
        used[following] = True
        one, other = segments[following]
        point = int(other if point == one else one)
        chain.append(point)
    return chain


def _order_along_curves(points_mm: FloatArray, curves: tuple[FloatArray, ...]) -> IntArray:
    """Return the order of points along the nearest curves; unchanged without curves."""
    if not curves or len(points_mm) == 0:
        return np.arange(len(points_mm))
    from scipy.spatial import cKDTree

    dense = [_densify(curve) for curve in curves]
    return np.argsort(cKDTree(np.vstack(dense)).query(points_mm)[1], kind="stable")


def _densify(curve: FloatArray, steps: int = 2000) -> FloatArray:
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    at = np.union1d(np.linspace(0, length[-1], steps), length)
    return np.column_stack([np.interp(at, length, curve[:, k]) for k in range(3)])


def _format_point(corner: FloatArray) -> str:
    return "(" + ", ".join(f"{value:.1f}" for value in corner) + ")"
