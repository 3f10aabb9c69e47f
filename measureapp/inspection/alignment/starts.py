"""Initial poses of the best fit: rotations about z, or in all directions."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.inspection.surface.nominal import NominalSurface

UPRIGHT_TURNS = 36
ALL_ROUND_TURNS = 240
PHI, PSI = 1.4142135623730951, 1.533751168755204288118041  # of the super-Fibonacci spiral


def upright_starts(points_mm: FloatArray, surface: NominalSurface) -> list[FloatArray]:
    """Return 4×4 starts rotated about z in equal steps, with equal heights of the tops and centred plan views."""
    starts = []
    for angle in np.arange(UPRIGHT_TURNS) * 2 * np.pi / UPRIGHT_TURNS:
        rotation = Rotation.from_rotvec([0, 0, angle]).as_matrix()
        low, high = np.percentile(points_mm @ rotation.T, [1, 99], axis=0)
        shift = (surface.low_mm + surface.high_mm) / 2 - (low + high) / 2
        shift[2] = surface.high_mm[2] - high[2]
        starts.append(_matrix(rotation, shift))
    return starts


def head_down_starts(points_mm: FloatArray, surface: NominalSurface) -> list[FloatArray]:
    """Return 4×4 starts as `upright_starts`, for a part that was turned over about x."""
    over = np.diag([1.0, -1.0, -1.0, 1.0])
    return [start @ over for start in upright_starts(points_mm @ over[:3, :3].T, surface)]


def all_round_starts(points_mm: FloatArray, surface: NominalSurface) -> list[FloatArray]:
    """Return 4×4 starts in all directions: aligned principal axes, and uniform rotations (super-Fibonacci spiral, M. Alexa, CVPR 2022)."""
    centre, nominal_centre = _middle(points_mm), (surface.low_mm + surface.high_mm) / 2
    axes, nominal_axes = _principal_axes(points_mm), _principal_axes(surface.vertices_mm[surface.triangles].mean(axis=1))
    signs = [np.diag([a, b, a * b]) for a in (1.0, -1.0) for b in (1.0, -1.0)]
    turns = [nominal_axes.T @ sign @ axes for sign in signs]
    s = np.arange(ALL_ROUND_TURNS) + 0.5
    r, outer = np.sqrt(s / ALL_ROUND_TURNS), np.sqrt(1 - s / ALL_ROUND_TURNS)
    alpha, beta = 2 * np.pi * s / PHI, 2 * np.pi * s / PSI
    quaternions = np.column_stack([r * np.sin(alpha), r * np.cos(alpha), outer * np.sin(beta), outer * np.cos(beta)])
    turns += list(Rotation.from_quat(quaternions).as_matrix())
    return [_matrix(turn, nominal_centre - turn @ centre) for turn in turns]


def _middle(points_mm: FloatArray) -> FloatArray:
    axes = _principal_axes(points_mm)
    low, high = np.percentile(points_mm @ axes.T, [1, 99], axis=0)
    return (low + high) / 2 @ axes


def _principal_axes(points_mm: FloatArray) -> FloatArray:
    axes = np.array(np.linalg.svd(points_mm - points_mm.mean(axis=0), full_matrices=False)[2])
    axes[2] *= np.linalg.det(axes)
    return axes


def _matrix(rotation: FloatArray, shift: FloatArray) -> FloatArray:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, shift
    return matrix
