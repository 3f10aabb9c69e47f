"""An error that all views of an approach share is told from the part's size; one drawn anew for every view is not."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_prior import KinematicPrior, PosePrior
from measureapp.register.stitch import stitch
from tests.register.test_stitch import best_fit

DEEP_MM, TABLE_MM, NOISE_MM = 0.05, 0.002, 0.03
ANGLES = [0.0, 72.0, 144.0, 216.0, 288.0]
ARM_MM = 60.0


def swollen_mm(scan, poses) -> float:
    """Return by how much the cross is too long along x, by its poses alone."""
    samples = [np.asarray(cloud.points_mm)[::5] for cloud in scan.clouds]
    true = np.vstack([pose.apply(sample) for pose, sample in zip(scan.truth, samples, strict=True)])
    placed = np.vstack([pose.apply(sample) for pose, sample in zip(poses, samples, strict=True)])
    off = best_fit(placed, true).apply(placed) - true
    right, left = (np.abs(sign * true[:, 0] - ARM_MM) < 4 * NOISE_MM for sign in (1, -1))
    return float(off[right, 0].mean() - off[left, 0].mean())


@pytest.fixture(scope="module")
def scan(scanned, cross_mesh):
    return scanned(cross_mesh, ANGLES, [30.0], step_mm=0.9, noise_mm=NOISE_MM)


def too_deep(scan, seed: int):
    """The poses by the axes, were the camera farther from the part than calibrated."""
    rng = np.random.default_rng(seed)
    away = RigidTransform.from_parts(np.eye(3), [0, 0, DEEP_MM], "camera", "camera")
    turned = [rng.normal(0, TABLE_MM, 3) for _ in scan.truth]
    return [
        pose @ away @ RigidTransform.from_parts(np.eye(3), shift, "camera", "camera")
        for pose, shift in zip(scan.truth, turned, strict=True)
    ]


def test_a_camera_that_stands_too_far_away_does_not_shrink_the_part(scan) -> None:
    kinematic = too_deep(scan, 1)
    turns = np.radians(1e-3)
    shared, alone = (
        stitch(
            scan.clouds, kinematic, prior=PosePrior(covariance=KinematicPrior(DEEP_MM, turns, TABLE_MM, turns / 10).covariance(stations))
        )
        for stations in (scan.stations, list(range(len(kinematic))))
    )
    axes, together, apart = (
        swollen_mm(scan, poses) for poses in (kinematic, *([one.part_from_camera for one in s.placements] for s in (shared, alone)))
    )
    sigma = np.sqrt(2) * max(placement.sigma_mm for placement in shared.placements)  # of one end against the other
    assert abs(axes) > DEEP_MM > 5 * sigma / 2
    assert abs(together) < 3 * sigma and abs(together) < abs(axes) / 3
    assert abs(apart) > abs(axes) / 2
