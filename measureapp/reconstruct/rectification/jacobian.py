"""Jacobian of a smooth map over an image, as cubic polynomials that the kernels evaluate at any pixel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

NODES = 24
STEP_PX = 4

Cubic = tuple[np.float32, ...]


@dataclass(frozen=True, slots=True, eq=False)
class PixelJacobian:
    """Derivatives of a map (x, y) with respect to pixels (u, v)."""

    cubics: tuple[Cubic, Cubic, Cubic, Cubic]  # of ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v
    unit: tuple[
        np.float32, np.float32, np.float32, np.float32
    ]  # (u0, per u, v0, per v) of their variables (u − u0) · per u, (v − v0) · per v

    @classmethod
    def of(cls, image: FloatArray) -> PixelJacobian:
        """Fit the derivatives of a map (H, W, 2) by least squares to differences over eight pixels."""
        height, width = image.shape[:2]
        reach_u, reach_v = min(STEP_PX, (width - 1) // 2), min(STEP_PX, (height - 1) // 2)
        us = np.unique(np.linspace(reach_u, width - 1 - reach_u, NODES).astype(int))
        vs = np.unique(np.linspace(reach_v, height - 1 - reach_v, NODES).astype(int))
        u, v = (grid.ravel() for grid in np.meshgrid(us, vs))
        along_u = (image[v, u + reach_u].astype(float) - image[v, u - reach_u]) / (2 * reach_u)
        along_v = (image[v + reach_v, u].astype(float) - image[v - reach_v, u]) / (2 * reach_v)
        unit = ((width - 1) / 2, 2 / width, (height - 1) / 2, 2 / height)
        s, t = (u - unit[0]) * unit[1], (v - unit[2]) * unit[3]
        terms = np.column_stack([np.ones(len(s)), s, t, s * s, s * t, t * t, s**3, s * s * t, s * t * t, t**3])
        solved = np.linalg.lstsq(terms, np.column_stack([along_u[:, 0], along_v[:, 0], along_u[:, 1], along_v[:, 1]]), rcond=None)[0]
        cubics = [tuple(np.float32(value) for value in column) for column in solved.T]
        scaled = (np.float32(unit[0]), np.float32(unit[1]), np.float32(unit[2]), np.float32(unit[3]))
        return cls((cubics[0], cubics[1], cubics[2], cubics[3]), scaled)

    def at_centre(self) -> FloatArray:
        """Return [[∂x/∂u, ∂x/∂v], [∂y/∂u, ∂y/∂v]] in the middle of the image."""
        return np.array([float(cubic[0]) for cubic in self.cubics]).reshape(2, 2)
