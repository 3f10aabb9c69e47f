"""Surfaces of region growing: a quadric patch at first, then the shape itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.feature import Feature
from measureapp.geometry.shapes import tangents
from measureapp.inspection.features.cells import angles
from measureapp.inspection.features.shapes import along_and_off, outward_normals, signed_distances

STEEPEST_DEG = 40.0  # greatest slope at which a patch is valid
MAD_TO_SIGMA = 1.4826
OUTLYING = 3.5
FITS = 4


class LocalSurface(Protocol):
    """A surface with distances and normals."""

    def distances(self, points_mm: FloatArray) -> FloatArray:
        """Return signed distances (N,)."""

    def normals(self, points_mm: FloatArray) -> FloatArray:
        """Return unit normals (N, 3) at the points, of either sign."""


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """Quadric height field over a plane: local approximation of a smooth surface."""

    point_mm: FloatArray  # (3,)
    axes: FloatArray  # (3, 3): two tangents, and the height
    terms: FloatArray  # (6,) of 1, u, v, u², uv, v²
    scatter_mm: float  # standard deviation of its points, for their degrees of freedom

    @classmethod
    def fit(cls, points_mm: FloatArray, normal: FloatArray, point_mm: FloatArray) -> Patch:
        """Fit to points (N, 3) by least squares of their heights, with outlier rejection."""
        axes = np.vstack([tangents(normal), normal])
        u, v, height = ((points_mm - point_mm) @ axes.T).T
        design = _design(u, v)
        kept = np.ones(len(height), bool)
        for _ in range(FITS):
            terms = np.linalg.lstsq(design[kept], height[kept], rcond=None)[0]
            off = np.abs(height - design @ terms)
            kept = off <= OUTLYING * max(MAD_TO_SIGMA * float(np.median(off)), 1e-9)
        free = max(int(kept.sum()) - design.shape[1], 1)
        return cls(point_mm, axes, terms, float(np.sqrt(np.sum(off[kept] ** 2) / free)))

    def distances(self, points_mm: FloatArray) -> FloatArray:
        """Return heights over the patch, shortened by its slope."""
        u, v, height = ((points_mm - self.point_mm) @ self.axes.T).T
        slope = self._slopes(u, v)
        return np.asarray((height - _design(u, v) @ self.terms) / np.sqrt(1 + np.sum(slope**2, axis=0)))

    def normals(self, points_mm: FloatArray) -> FloatArray:
        """Return the normals of the patch at the points; tangents where the patch is too steep to be valid."""
        u, v, _ = ((points_mm - self.point_mm) @ self.axes.T).T
        slope = self._slopes(u, v)
        made = np.stack([-slope[0], -slope[1], np.ones_like(u)])
        made /= np.linalg.norm(made, axis=0)
        made[:, made[2] < np.cos(np.radians(STEEPEST_DEG))] = np.array([[1.0], [0.0], [0.0]])
        return np.asarray(made.T @ self.axes)

    def _slopes(self, u: FloatArray, v: FloatArray) -> FloatArray:
        _, b, c, d, e, f = self.terms
        return np.stack([b + 2 * d * u + e * v, c + e * u + 2 * f * v])


@dataclass(frozen=True, slots=True, eq=False)
class ShapeSurface:
    """A fitted plane, cylinder, sphere or cone."""

    feature: Feature

    def distances(self, points_mm: FloatArray) -> FloatArray:
        """Return orthogonal distances."""
        return signed_distances(self.feature, points_mm)

    def normals(self, points_mm: FloatArray) -> FloatArray:
        """Return the shape's normals."""
        return outward_normals(self.feature, points_mm)


def measure_bending(feature: Feature, points_mm: FloatArray, kept: BoolArray) -> tuple[float, float]:
    """Return the range (mm) of a quadratic fit of the residuals over the surface, and its noise.

    A region of another shape, such as a strip of a cylinder taken as a plane, shows such bending even if all its points are within limits.
    """
    points = points_mm[kept]
    u, v = _unroll(feature, points)
    residuals = signed_distances(feature, points)
    design = _design(u, v)
    inverse = np.linalg.pinv(design.T @ design)
    bent = design @ (inverse @ (design.T @ residuals))
    free = max(len(points) - design.shape[1], 1)
    sigma = float(np.sqrt(np.sum((residuals - bent) ** 2) / free))
    noise = sigma * float(np.sqrt(np.einsum("nk,kl,nl->n", design, inverse, design).max()))
    return float(np.ptp(bent)), noise


def _unroll(feature: Feature, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return coordinates along the surface, between -1 and 1."""
    if feature.shape in ("cylinder", "cone") and feature.direction is not None:
        along, _, _ = along_and_off(points_mm, feature.point_mm, feature.direction)
        turn = angles(points_mm, feature.point_mm, feature.direction)
        start = _gap_end(turn)
        return _normalise((turn - start) % (2 * np.pi)), _normalise(along)
    normal = feature.direction
    if normal is None:
        normal = points_mm.mean(axis=0) - feature.point_mm
        normal = normal / max(float(np.linalg.norm(normal)), 1e-12)
    across = tangents(normal)
    return _normalise((points_mm - feature.point_mm) @ across[0]), _normalise((points_mm - feature.point_mm) @ across[1])


def _gap_end(turn: FloatArray) -> float:
    """Return the angle at the end of the widest gap of the points."""
    ordered = np.sort(turn)
    gaps = np.diff(np.append(ordered, ordered[0] + 2 * np.pi))
    return float(ordered[(int(gaps.argmax()) + 1) % len(ordered)])


def _normalise(values: FloatArray) -> FloatArray:
    low, high = float(values.min()), float(values.max())
    return (2 * values - low - high) / max(high - low, 1e-9)


def _design(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.column_stack([np.ones_like(u), u, v, u * u, u * v, v * v])
