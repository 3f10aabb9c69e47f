"""The clouds of one set-up, prepared to be joined to those of another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.errors import RegistrationError
from measureapp.register.pairs.prepare import PreparedCloud, prepare
from measureapp.register.setups.empty_space import SeenSpace

VOXEL_PER_SPACING = 2.5
LEAST_VOXEL_MM = 1.0
SAMPLE_POINTS, SAMPLE_SEED = 800, 7
LEAST_POINTS = 500


@dataclass(frozen=True, slots=True, eq=False)
class SetUpCloud:
    """All clouds of one set-up of a part."""

    name: str
    stitched: StitchedCloud  # in the set-up's own part frame
    clouds: tuple[PointCloud, ...]  # one per placement, in frame `camera`


@dataclass(frozen=True, eq=False)
class PreparedSetUp:
    """A set-up, thinned for registration; its points are in its own part frame."""

    given: SetUpCloud
    prepared: PreparedCloud
    view: IntArray  # (M,), view of each thinned point
    seen: tuple[SeenSpace, ...]  # of the used views

    @classmethod
    def of(cls, given: SetUpCloud, voxel_mm: float) -> Self:
        """Thin the stitched cloud to voxels. Raises RegistrationError when it is too small."""
        stitched = given.stitched
        unknown = np.zeros((len(stitched), 2), np.int32)
        cloud = PointCloud(
            stitched.points_mm,
            stitched.normals,
            stitched.sigma_mm,
            stitched.grey,
            unknown,
            np.zeros(len(stitched), np.uint8),
            stitched.frame,
            given.name,
        )
        thinned = prepare(cloud, voxel_mm, least_cosine=-1.0)
        if len(thinned) < LEAST_POINTS:
            raise RegistrationError(
                f"{given.name} has only {len(thinned)} points for registration.",
                f"A set-up needs at least {LEAST_POINTS}; scan more of the part.",
            )
        nearest = cKDTree(stitched.points_mm).query(thinned.points_mm)[1]
        view = np.asarray(stitched.view if stitched.sampled_view is None else stitched.sampled_view)[nearest]
        seen = tuple(
            SeenSpace.of(cloud, placement.part_from_camera)
            for cloud, placement in zip(given.clouds, stitched.placements, strict=True)
            if placement.used and len(cloud) >= LEAST_POINTS
        )
        return cls(given, thinned, view, seen)

    @property
    def name(self) -> str:
        """Name of the set-up."""
        return self.given.name

    @cached_property
    def tree(self) -> cKDTree:
        """Search tree of the thinned points."""
        return cKDTree(self.prepared.points_mm)

    @cached_property
    def sample(self) -> IntArray:
        """Indices of a random sample of the thinned points."""
        order = np.random.default_rng(SAMPLE_SEED).permutation(len(self.prepared))
        return np.sort(order[:SAMPLE_POINTS])

    @cached_property
    def principal_axes(self) -> FloatArray:
        """Principal axes of the points as rows (3, 3), right-handed."""
        points = self.prepared.points_mm
        axes = np.array(np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2])
        axes[2] *= np.linalg.det(axes)
        return axes

    @cached_property
    def diagonal_mm(self) -> float:
        """Diagonal of the bounding box."""
        return float(np.linalg.norm(np.ptp(self.prepared.points_mm, axis=0)))


def prepare_setups(setups: Sequence[SetUpCloud]) -> list[PreparedSetUp]:
    """Prepare all set-ups with one voxel size, from the largest point spacing."""
    spacing = max(float(one.stitched.notes.get("spacing_mm", LEAST_VOXEL_MM / VOXEL_PER_SPACING)) for one in setups)
    voxel = max(LEAST_VOXEL_MM, VOXEL_PER_SPACING * spacing)
    return [PreparedSetUp.of(one, voxel) for one in setups]
