"""Distances that a minimum-zone fit minimises, one per point, with their derivatives."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.feature import Shape
from measureapp.geometry.shapes import MODELS, TINY, Distances, State, tangents


class _LineZone:
    """Distance from the axis: the zone is the smallest enclosing cylinder (straightness in space, ISO 12780-1)."""

    parameters = 4

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        across, derivatives = MODELS["line"].evaluate(state, points)
        length = np.hypot(*across)
        outward = across / np.maximum(length, TINY)
        return length[None], np.sum(outward[:, :, None] * derivatives, axis=0)[None]

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        return MODELS["line"].move(state, step)


class _CircleZone:
    """Radial distance in the least-squares plane: the zone is the narrowest annulus (reference circles MZCI, ISO 12181-1)."""

    parameters = 3

    def evaluate(self, state: State, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances and derivatives."""
        across = (points - state.point) @ tangents(state.direction).T
        rho = np.hypot(across[:, 0], across[:, 1])
        outward = across / np.maximum(rho, TINY)[:, None]
        return (rho - state.sizes[0])[None], np.column_stack([-outward, -np.ones(len(points))])[None]

    def move(self, state: State, step: FloatArray) -> State:
        """Return the state after a parameter increment."""
        return State(state.point + step[:2] @ tangents(state.direction), state.direction, state.sizes + step[2:])


ZONES: dict[Shape, Distances] = {**MODELS, "line": _LineZone(), "circle": _CircleZone()}
