"""Pairs whose correspondences are wrong: views that share little, or lie far from where they belong, end without a figure or with a finite one."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from measureapp.geometry.transform import RigidTransform
from measureapp.register.grid.cells import CellIndex
from measureapp.register.pairs import icp
from measureapp.register.pairs.prepare import PreparedCloud

COUNT = 60
BAD = 1423  # a seed whose normal matrix has a negative diagonal, once what few points support is taken out of it


def wrong_correspondences(rng: np.random.Generator, kind: int) -> icp._Correspondences:
    """Points on a plane (even) or with any normals (odd), off by either sign, or by one amount with outliers."""
    arm = rng.normal(size=(COUNT, 3)) * [30, 30, 0 if kind < 2 else 10]
    normal = np.tile([0.0, 0.0, 1.0], (COUNT, 1)) if kind % 2 == 0 else rng.normal(size=(COUNT, 3))
    normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    if kind < 3:
        distance = rng.choice([-1, 1], COUNT) * rng.uniform(0.5, 3, COUNT)
    else:
        distance = 2.0 + (rng.random(COUNT) < 0.3) * rng.normal(size=COUNT) * 5
    every = np.arange(COUNT)
    return icp._Correspondences(every, every, np.zeros(3), arm, normal, distance, np.full(COUNT, 1e-4), 0.05 + 0.5 * rng.random())


@pytest.mark.parametrize("seed", [*range(40), BAD, 2563])
def test_a_wrong_pair_has_a_finite_figure_or_none(monkeypatch, seed):
    common = wrong_correspondences(np.random.default_rng(seed), seed % 4)
    monkeypatch.setattr(icp, "_find_correspondences", lambda *_: common)
    index, _ = CellIndex.build(common.arm_mm, 2.0)
    cloud = PreparedCloud(common.arm_mm, common.normal, common.variance_mm2, index, 1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = icp.measure_pair(cloud, cloud, RigidTransform.identity("camera", "camera"), (0, 1), 3.0)
    if found.is_valid:
        assert np.isfinite(found.change).all()
        assert np.isfinite(found.residual_mm)
        assert np.linalg.eigvalsh(found.information)[0] > -1e-6 * np.abs(found.information).max()
    else:
        assert not found.information.any()


def test_points_without_a_common_direction_determine_nothing():
    values, axes, forms = icp._determined_directions(np.zeros((6, 6)))
    assert (len(values), axes.shape, forms.shape) == (0, (6, 0), (6, 0))
