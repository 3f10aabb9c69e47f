"""Starting values of the fits from the points alone, in coordinates centred on the points and scaled to about 1."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.feature import Shape
from measureapp.geometry.shapes import MODELS, State, tangents

DIRECTIONS = 120  # over the half sphere: every axis is within about 8° of one of them
SAMPLE = 1500
FLAT = 1e-4  # curvature of a plane, relative to the size of the data
TUBE_PLACES = 24
TRIED = 6  # number of starts that are refined for a shape with an axis


def find_starts(shape: Shape, points: FloatArray) -> list[State]:
    """Estimate starting states for ``shape``, best first; ``points`` (N, 3) are centred and scaled."""
    sample = points if len(points) <= SAMPLE else points[np.random.default_rng(0).choice(len(points), SAMPLE, replace=False)]
    _, _, axes = np.linalg.svd(sample - sample.mean(axis=0), full_matrices=False)
    centre = points.mean(axis=0)
    if shape == "plane":
        return [State(centre, axes[2], np.empty(0))]
    if shape == "line":
        return [State(centre, axes[0], np.empty(0))]
    if shape == "sphere":
        return [_sphere(sample)]
    if shape == "circle":
        return [_on_axis(sample, axes[2], cone=False)]
    height, curvatures, curved = _curvatures(sample, axes)
    directions = np.vstack([axes, curved, _half_sphere()])
    candidates = [_axis_start(shape, sample, direction) for direction in directions]
    if shape == "torus":
        candidates += _torus_patches(sample.mean(axis=0) + height * axes[2], curvatures, curved, axes[2])
    scored = sorted(((_score(shape, state, sample), i) for i, state in enumerate(candidates)), key=lambda pair: pair[0])
    return [candidates[i] for _, i in scored[:TRIED]]


def _score(shape: Shape, state: State, points: FloatArray) -> float:
    if not (np.isfinite(state.sizes).all() and np.isfinite(state.point).all()):
        return np.inf
    distances, _ = MODELS[shape].evaluate(state, points)
    return float(np.sqrt(np.mean(distances**2)))


def _half_sphere() -> FloatArray:
    """Return evenly spread directions (Fibonacci lattice)."""
    k = np.arange(DIRECTIONS) + 0.5
    z = k / DIRECTIONS
    turn = np.pi * (1 + np.sqrt(5)) * k
    flat = np.sqrt(1 - z * z)
    return np.column_stack([flat * np.cos(turn), flat * np.sin(turn), z])


def _curvatures(points: FloatArray, axes: FloatArray) -> tuple[float, FloatArray, FloatArray]:
    """Fit a quadratic over the plane of a patch: height at the centroid, principal curvatures (2,) and their directions (2, 3)."""
    x, y, z = ((points - points.mean(axis=0)) @ axes.T).T
    design = np.column_stack([x * x, x * y, y * y, x, y, np.ones(len(x))])
    a, b, c, _, _, height = np.linalg.lstsq(design, z, rcond=None)[0]
    values, vectors = np.linalg.eigh([[2 * a, b], [b, 2 * c]])
    return float(height), values, np.asarray(vectors.T @ axes[:2])


def _torus_patches(point: FloatArray, curvatures: FloatArray, directions: FloatArray, normal: FloatArray) -> list[State]:
    """Return tori with these curvatures at a point: one curvature is 1/r, the other cos θ/(R + r cos θ) at angle θ of the tube."""
    made = []
    for tube in (0, 1):
        if abs(curvatures[tube]) < FLAT:
            continue
        outward, minor = -np.sign(curvatures[tube]) * normal, 1 / abs(curvatures[tube])
        around = curvatures[1 - tube] * np.sign(curvatures[tube])
        for theta in (np.arange(TUBE_PLACES) + 0.5) * 2 * np.pi / TUBE_PLACES:
            cos, sin = np.cos(theta), np.sin(theta)
            major = cos / around - minor * cos if abs(around) > FLAT else -1.0
            if major > 0 and cos / around > 0:
                radial, axis = cos * outward - sin * directions[tube], sin * outward + cos * directions[tube]
                made.append(State(point - minor * outward - major * radial, axis, np.array([major, minor])))
    return made


def _sphere(points: FloatArray) -> State:
    solution = np.linalg.lstsq(np.column_stack([2 * points, np.ones(len(points))]), np.sum(points**2, axis=1), rcond=None)[0]
    centre = solution[:3]
    return State(centre, np.array([0.0, 0.0, 1.0]), np.sqrt(np.maximum([solution[3] + centre @ centre], 0)))


def _axis_start(shape: Shape, points: FloatArray, direction: FloatArray) -> State:
    return _torus(points, direction) if shape == "torus" else _on_axis(points, direction, cone=shape == "cone")


def _on_axis(points: FloatArray, direction: FloatArray, *, cone: bool) -> State:
    """Fit the algebraic circle, or cone, about the given direction: x² + y² = 2ax + 2by + c [+ eh + fh²]."""
    side = tangents(direction)
    flat, height = points @ side.T, points @ direction
    columns = [2 * flat[:, 0], 2 * flat[:, 1], np.ones(len(points))] + ([height, height**2] if cone else [])
    solution = np.linalg.lstsq(np.column_stack(columns), np.sum(flat**2, axis=1), rcond=None)[0]
    a, b, c = solution[:3]
    radius = np.sqrt(max(c + a * a + b * b, 1e-12))
    point = a * side[0] + b * side[1]
    if not cone:
        return State(point + direction * height.mean(), direction, np.array([radius]))
    slope = -solution[3] / (2 * radius)
    if slope < 0:  # the direction points to the apex
        direction, slope = -direction, -slope
    angle = float(np.clip(np.arctan(slope), 1e-3, 1.5))
    return State(point, direction, np.array([radius * np.cos(angle), angle]))


def _torus(points: FloatArray, direction: FloatArray) -> State:
    """Fit the torus about the direction: centre from a circle about it, radii from a circle in the section (ρ, h)."""
    ring = _on_axis(points, direction, cone=False)
    offset = points - ring.point
    height = offset @ direction
    rho = np.linalg.norm(offset - height[:, None] * direction, axis=1)
    design = np.column_stack([2 * rho, 2 * height, np.ones(len(points))])
    major, up, rest = np.linalg.lstsq(design, rho**2 + height**2, rcond=None)[0]
    minor = np.sqrt(max(rest + major**2 + up**2, 1e-12))
    return State(ring.point + up * direction, direction, np.array([major, minor]))
