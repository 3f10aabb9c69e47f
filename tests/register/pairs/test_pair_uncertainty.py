"""What pairs say of their own uncertainty, beside how far they are off in simulated scenes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from measureapp.data.cloud import PointCloud
from measureapp.register.pairs.icp import apply_motion, register_pair
from measureapp.register.pairs.prepare import prepare

VOXEL_MM, STEP_MM = 1.4, 0.6
RIPPLE_MM = 0.02
PAIRS = ((0, 1), (1, 2), (0, 2))
SEEDS = range(1, 7)


def rippled(cloud: PointCloud, length_mm: float, rng: np.random.Generator) -> PointCloud:
    """The cloud with an error along its rays that neighbouring pixels have in common."""
    pixel, points = np.asarray(cloud.pixel), np.asarray(cloud.points_mm)
    field = gaussian_filter(rng.normal(size=(pixel.max() + 1,) * 2), length_mm / STEP_MM)
    error = field[pixel[:, 0], pixel[:, 1]] * (RIPPLE_MM / field.std())
    return replace(cloud, points_mm=points * (1 + error / np.linalg.norm(points, axis=1))[:, None])


@pytest.fixture(scope="module")
def scans(scanned, request):
    """The scans of a part, made once for all errors that are put upon them."""

    @cache
    def scans_of(mesh):
        part = request.getfixturevalue(mesh)
        return [scanned(part, [0.0, 25.0, 50.0], [45.0], step_mm=STEP_MM, seed=seed) for seed in SEEDS]

    return scans_of


@pytest.mark.parametrize("length_mm", [0.0, 1.8, 3.6])
@pytest.mark.parametrize("mesh", ["impeller_mesh", "cross_mesh"])
def test_pairs_are_off_as_far_as_they_say(scans, mesh, length_mm):
    squares, directions = 0.0, 0
    for seed, scan in zip(SEEDS, scans(mesh), strict=True):
        rng = np.random.default_rng(seed)
        views = [prepare(rippled(cloud, length_mm, rng) if length_mm else cloud, VOXEL_MM) for cloud in scan.clouds]
        for i, j in PAIRS:
            truth = scan.truth[i].inverse() @ scan.truth[j]
            found = register_pair(views[i], views[j], truth, (i, j), 3.0)
            off = apply_motion(found.target_from_source, found.change, found.centre_mm) @ truth.inverse()
            error = np.concatenate([off.apply(found.centre_mm) - found.centre_mm, off.rotation_vector])
            squares += error @ found.information @ error
            directions += int(np.linalg.matrix_rank(found.information))
    # 18 pairs of three views with six numbers each, two thirds of them independent: a standard deviation of 8 % of the ratio. Pairs also
    # claim the smooth errors that their residuals cannot exclude, which these clouds do not have: up to half of a deviation is theirs
    assert 0.5 - 0.08 < np.sqrt(squares / directions) < 1.25 + 0.08
