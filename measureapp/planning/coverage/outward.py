"""Normals that point out of the material, also for meshes with holes and with triangles wound the wrong way."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.planning.coverage.scene import PartScene

RAYS = 24  # per sample and side
CLEARLY = 2.0  # how much freer the other side has to be
OFFSET_MM = 0.02


def outward(points_mm: FloatArray, normals: FloatArray, scene: PartScene, rng: np.random.Generator) -> FloatArray:
    """Return ``normals`` (N, 3), turned over where the other side of the surface is clearly freer.

    Free is the fraction of random rays over the hemisphere that leave the scene. Inside a closed mesh none does, so normals that point
    inwards are recognised whatever the winding. An open sheet is free on both sides and keeps the side that its triangles state, unless the
    other one is twice as free. Inner surfaces from which nothing escapes keep theirs.
    """
    front = _freedom(points_mm, normals, scene, rng)
    back = _freedom(points_mm, -normals, scene, rng)
    turned = back > CLEARLY * front
    return np.where(turned[:, None], -normals, normals)


def _freedom(points_mm: FloatArray, normals: FloatArray, scene: PartScene, rng: np.random.Generator) -> FloatArray:
    """Return the fraction (N,) of cosine-distributed rays from one side that hit nothing."""
    directions = rng.normal(size=(len(points_mm), RAYS, 3))
    directions /= np.linalg.norm(directions, axis=2, keepdims=True)
    directions = directions + normals[:, None, :] * 1.001
    origins = np.repeat(points_mm + OFFSET_MM * normals, RAYS, axis=0)
    return scene.escapes(origins, directions.reshape(-1, 3)).reshape(-1, RAYS).mean(axis=1)
