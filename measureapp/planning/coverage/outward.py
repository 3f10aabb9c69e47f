"""Normals that point out of the material, also for meshes with holes and with triangles wound the wrong way."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.planning.coverage.scene import PartScene

RAYS = 16  # per sample and side
CLEARLY = 2.0  # how much freer the other side has to be
OFFSET_MM = 0.02


def outward(points_mm: FloatArray, normals: FloatArray, scene: PartScene, rng: np.random.Generator) -> FloatArray:
    """Return ``normals`` (N, 3), turned over where the other side of the surface is clearly freer.

    Free is the fraction of random rays over the hemisphere that leave the scene, plus half of those that miss the part, because the support
    lets none escape from below. Inside a closed mesh no ray is free, so normals that point inwards are recognised whatever the winding. An
    open sheet is free on both sides and keeps the side that its triangles state, unless the other one is twice as free.
    """
    directions = rng.normal(size=(len(points_mm), RAYS, 3))
    directions /= np.linalg.norm(directions, axis=2, keepdims=True)
    front, back = (_freedom(points_mm, side * normals, directions, scene) for side in (1.0, -1.0))
    return np.where((back > CLEARLY * front)[:, None], -normals, normals)


def is_wound_consistently(triangles: IntArray) -> bool:
    """Return whether no directed edge belongs to two triangles."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]).astype(np.int64)
    keys = edges[:, 0] * (int(triangles.max(initial=0)) + 1) + edges[:, 1]
    return len(np.unique(keys)) == len(keys)


def _freedom(points_mm: FloatArray, normals: FloatArray, directions: FloatArray, scene: PartScene) -> FloatArray:
    """Return the freedom (N,) of one side, by cosine-distributed rays."""
    rays = (directions + 1.001 * normals[:, None, :]).reshape(-1, 3)
    origins = np.repeat(points_mm + OFFSET_MM * normals, RAYS, axis=0)
    free = scene.escapes(origins, rays) + 0.5 * scene.escapes_part(origins, rays)
    return np.asarray(free.reshape(-1, RAYS).mean(axis=1))
