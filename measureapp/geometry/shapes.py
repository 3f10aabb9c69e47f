"""Signed orthogonal distances from basic shapes and their derivatives.

A shape is a `State`: a point, a unit direction and sizes. Its local parameters are ordered: first the translations of the point,
then the two tilts of the direction along `tangents(direction)`, then the sizes. Distances by
G. T. Anthony et al., "Reference software for finding Chebyshev best-fit geometric elements", NPL DITC, 1996, and
A. B. Forbes, "Least-squares best-fit geometric elements", NPL DITC 140/89, 1989.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt
from typing import Protocol

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.feature import Shape

TINY = 1e-300


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """Position, direction and sizes of a shape in the centred, scaled coordinates of a fit."""

    point: FloatArray  # (3,)
    direction: FloatArray  # (3,), unit; unused by a sphere
    sizes: FloatArray  # radius | (distance of the surface at `point`, half angle) | (major, minor radius)


class Distances(Protocol):
    """Distances of points from a shape and their derivatives by the local parameters of the shape."""

    parameters: int

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances (K, N) and their derivatives (K, N, P); K distances per point, squared and summed."""

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after the parameter increment ``step`` (P,)."""


class Model(Distances, Protocol):
    """Distance model of one shape."""

    moves: int  # number of translations of the point
    tilts: int  # number of tilts of the direction

    def form(self, distances: FloatArray) -> FloatArray:
        """Return the signed distance (N,) whose range is the form error."""


def tangents(direction: FloatArray) -> FloatArray:
    """Return two unit vectors (2, 3) that form a right-handed triad with ``direction``."""
    x, y, z = map(float, direction)  # written out: for three numbers NumPy takes many times as long, and fits call this all the time
    if abs(x) <= min(abs(y), abs(z)):  # the direction times the axis of the frame that is most across it
        a, b, c = 0.0, z, -y
    elif abs(y) <= abs(z):
        a, b, c = -z, 0.0, x
    else:
        a, b, c = y, -x, 0.0
    length = sqrt(a * a + b * b + c * c)
    a, b, c = a / length, b / length, c / length
    return np.array([(a, b, c), (y * c - z * b, z * a - x * c, x * b - y * a)])


def tilt(direction: FloatArray, step: FloatArray) -> FloatArray:
    """Tilt a unit direction by the two components of ``step`` along its tangents."""
    leaning = direction + step @ tangents(direction)
    return np.asarray(leaning / sqrt(leaning @ leaning))


def _radial(state: State, points: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return height along the axis (N,), distance from it (N,) and the outward components along the tangents (N, 2)."""
    offset = points - state.point
    across = offset @ tangents(state.direction).T
    rho = np.hypot(across[:, 0], across[:, 1])
    return offset @ state.direction, rho, across / np.maximum(rho, TINY)[:, None]


class _FreeModel:
    """Base of shapes with a centre and a direction: the point moves in all directions."""

    moves, tilts = 3, 2

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        point = state.point + step[:2] @ tangents(state.direction) + step[2] * state.direction
        return State(point, tilt(state.direction, step[3:5]), state.sizes + step[5:])

    def form(self, distances: FloatArray) -> FloatArray:
        """Return the first (radial) distance."""
        return distances[0]


class _AxisModel(_FreeModel):
    """Base of shapes with an axis: the point moves perpendicular to the axis only."""

    moves, tilts = 2, 2

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        return State(state.point + step[:2] @ tangents(state.direction), tilt(state.direction, step[2:4]), state.sizes + step[4:])


class Plane(_FreeModel):
    """Distance n·(x − p)."""

    parameters, moves, tilts = 3, 1, 2

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        offset = points - state.point
        across = offset @ tangents(state.direction).T
        return (offset @ state.direction)[None], np.column_stack([-np.ones(len(points)), across])[None]

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        return State(state.point + step[0] * state.direction, tilt(state.direction, step[1:]), state.sizes)


class Line(_AxisModel):
    """The two components of the distance from an axis; the form error is the diameter of the enclosing cylinder."""

    parameters = 4

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        offset = points - state.point
        height = offset @ state.direction
        derivatives = np.zeros((2, len(points), 4))
        for k in range(2):
            derivatives[k, :, k] = -1.0
            derivatives[k, :, 2 + k] = -height
        return (offset @ tangents(state.direction).T).T, derivatives

    def form(self, distances: FloatArray) -> FloatArray:
        """Return the distances with both signs, so that their range is the diameter."""
        far = np.hypot(*distances)
        return np.concatenate([far, -far])


class Circle(_FreeModel):
    """Distance from a circle in space: radial component (first) and out-of-plane component."""

    parameters = 6

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        height, rho, outward = _radial(state, points)
        across = outward * rho[:, None]
        derivatives = np.zeros((2, len(points), 6))
        derivatives[0, :, :2] = -outward
        derivatives[0, :, 3:5] = -height[:, None] * outward
        derivatives[0, :, 5] = -1.0
        derivatives[1, :, 2] = -1.0
        derivatives[1, :, 3:5] = across
        return np.stack([rho - state.sizes[0], height]), derivatives


class Sphere(_FreeModel):
    """Distance |x − c| − r."""

    parameters, moves, tilts = 4, 3, 0

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        offset = points - state.point
        length = np.linalg.norm(offset, axis=1)
        outward = offset / np.maximum(length, TINY)[:, None]
        return (length - state.sizes[0])[None], np.column_stack([-outward, -np.ones(len(points))])[None]

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        return replace(state, point=state.point + step[:3], sizes=state.sizes + step[3:])


class Cylinder(_AxisModel):
    """Distance ρ − r from the axis."""

    parameters = 5

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        height, rho, outward = _radial(state, points)
        derivatives = np.column_stack([-outward, -height[:, None] * outward, -np.ones(len(points))])
        return (rho - state.sizes[0])[None], derivatives[None]


class Cone(_AxisModel):
    """Distance ρ cos t + h sin t − s; the direction points to the apex, s is the surface's orthogonal distance at the point."""

    parameters = 6

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        height, rho, outward = _radial(state, points)
        distance, angle = state.sizes
        cos, sin = np.cos(angle), np.sin(angle)
        tilts = (rho * sin - height * cos)[:, None] * outward
        derivatives = np.column_stack([-cos * outward, tilts, -np.ones(len(points)), height * cos - rho * sin])
        return (rho * cos + height * sin - distance)[None], derivatives[None]


class Torus(_FreeModel):
    """Distance √((ρ − R)² + h²) − r."""

    parameters = 7

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        height, rho, outward = _radial(state, points)
        ring = rho - state.sizes[0]
        length = np.maximum(np.hypot(ring, height), TINY)
        along, up = ring / length, height / length
        tilts = (up * rho - along * height)[:, None] * outward
        derivatives = np.column_stack([-along[:, None] * outward, -up, tilts, -along, -np.ones(len(points))])
        return (length - state.sizes[1])[None], derivatives[None]


MODELS: dict[Shape, Model] = {
    "line": Line(),
    "plane": Plane(),
    "circle": Circle(),
    "sphere": Sphere(),
    "cylinder": Cylinder(),
    "cone": Cone(),
    "torus": Torus(),
}
