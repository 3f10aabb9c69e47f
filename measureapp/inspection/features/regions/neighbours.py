"""Neighbourhood graph of points: estimated normals, connected components, and borders of regions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray

LEAST_NEIGHBOURS, MOST_NEIGHBOURS = 12, 80
WANTED_TILT_RAD = 0.02  # target standard deviation of a normal
LINK_SPACINGS = 2.5
ONE_SIDED = 0.25  # of the neighbourhood's radius: offset of the neighbours' centroid at a border


@dataclass(frozen=True, slots=True, eq=False)
class Neighbourhood:
    """Points with a search tree; normals use as many neighbours as the noise requires."""

    points_mm: FloatArray  # (N, 3)
    tree: cKDTree
    spacing_mm: float
    neighbours: int
    tilt_sigma_rad: float  # standard deviation of a fitted normal

    @classmethod
    def of(cls, points_mm: FloatArray, spacing_mm: float, noise_mm: float) -> Neighbourhood:
        """Prepare points.

        The tilt of a plane through k points on a disc of radius r is σ·2/(r√k); for points of spacing s, r is s√(k/π), so that the
        standard deviation of the normal is 2σ√π/(k s).
        """
        wanted = 2 * noise_mm * np.sqrt(np.pi) / (WANTED_TILT_RAD * spacing_mm)
        count = int(np.clip(np.ceil(wanted), LEAST_NEIGHBOURS, MOST_NEIGHBOURS))
        tilt = float(2 * noise_mm * np.sqrt(np.pi) / (count * spacing_mm))
        return cls(points_mm, cKDTree(points_mm), spacing_mm, min(count, len(points_mm)), tilt)

    @property
    def link_mm(self) -> float:
        """The greatest distance of connected points."""
        return LINK_SPACINGS * self.spacing_mm

    def normals(self, which: IntArray) -> FloatArray:
        """Return the normals (K, 3), of either sign, of planes through the neighbours of points ``which``."""
        _, near = self.tree.query(self.points_mm[which], self.neighbours)
        offset = self.points_mm[near.reshape(len(which), -1)]
        offset = offset - offset.mean(axis=1, keepdims=True)
        return np.asarray(np.linalg.eigh(np.einsum("nki,nkj->nij", offset, offset))[1][:, :, 0])

    def connected_component(self, allowed: BoolArray, start: int) -> BoolArray:
        """Return the mask (N,) of the connected component of allowed points that contains ``start``."""
        which = np.flatnonzero(allowed)
        pairs = cKDTree(self.points_mm[which]).query_pairs(self.link_mm, output_type="ndarray")
        links = coo_matrix((np.ones(len(pairs), np.int8), (pairs[:, 0], pairs[:, 1])), shape=(len(which), len(which)))
        _, label = connected_components(links, directed=False)
        reached = np.zeros(len(self.points_mm), bool)
        reached[which[label == label[int(np.searchsorted(which, start))]]] = True
        return reached

    def border(self, region: BoolArray) -> tuple[IntArray, IntArray]:
        """Return the points of a region at the end of the measured surface, and the adjacent points outside the region."""
        inside = np.flatnonzero(region)
        distance, near = self.tree.query(self.points_mm[inside], self.neighbours)
        at_border = np.linalg.norm(self.points_mm[near].mean(axis=1) - self.points_mm[inside], axis=1) > ONE_SIDED * distance[:, -1]
        outside = np.unique(near[distance <= self.link_mm])
        outside = outside[~region[outside]]
        meeting = np.zeros(len(inside), bool)
        if len(outside):
            away, _ = cKDTree(self.points_mm[outside]).query(self.points_mm[inside], distance_upper_bound=self.link_mm)
            meeting = np.isfinite(away)
        return inside[at_border & ~meeting], outside


def local_spacing(distances_mm: FloatArray) -> float:
    """Return the point spacing on a surface from the ascending distances of the nearest points."""
    return float(distances_mm[-1] * np.sqrt(np.pi / len(distances_mm)))
