"""Normal estimation by local plane fits."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray
from measureapp.errors import RegistrationError

NEIGHBOURS = 16


def estimate_normals(points_mm: FloatArray, towards_mm: FloatArray) -> FloatArray:
    """Estimate unit normals (N, 3) by principal components of the 16 nearest points, oriented towards ``towards_mm`` (3,).

    Raises
    ------
    RegistrationError
        Fewer than three points.
    """
    if len(points_mm) < 3:
        raise RegistrationError(f"A cloud of {len(points_mm)} points has no surface.", "Exclude it or measure it again.")
    count = min(NEIGHBOURS, len(points_mm))
    normals = np.empty((len(points_mm), 3))
    tree = cKDTree(points_mm)
    for start in range(0, len(points_mm), 200_000):  # limits the memory for neighbourhoods
        chosen = slice(start, start + 200_000)
        _, index = tree.query(points_mm[chosen], count, workers=-1)
        near = points_mm[index]
        near = near - near.mean(axis=1, keepdims=True)
        _, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", near, near))
        normals[chosen] = vectors[:, :, 0]
    away = np.einsum("ij,ij->i", normals, towards_mm - points_mm) < 0
    normals[away] *= -1
    return normals
