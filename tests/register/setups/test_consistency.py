"""The stated uncertainty of a joint against its true error over many draws of the noise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.icp import measure_pair
from measureapp.register.settings import StitchSettings
from measureapp.register.setups.joint import edge_by_surface, solve_joint
from measureapp.register.setups.setup_cloud import PreparedSetUp, SetUpCloud, prepare_setups
from measureapp.register.stitch import stitch
from tests.register.setups.conftest import TurnedOver
from tests.register.setups.scanned_setups import NOISE_MM

FORM_MM, FORM_REACH_MM = 0.01, 40.0  # smooth errors of every view: as large as those by light and blur


def measured_again(one: SetUpCloud, rng: np.random.Generator, form_mm: float) -> SetUpCloud:
    """Return a set-up with other noise, and with smooth errors of every view, as its cameras would give in another scan."""
    clouds = tuple(_noisy(cloud, rng, form_mm) for cloud in one.clouds)
    poses = [placement.part_from_camera for placement in one.stitched.placements]
    return SetUpCloud(one.name, stitch(clouds, poses, StitchSettings(fine=False)), clouds)


def _noisy(cloud: PointCloud, rng: np.random.Generator, form_mm: float) -> PointCloud:
    points = np.asarray(cloud.points_mm)
    rays = points / np.linalg.norm(points, axis=1, keepdims=True)
    waves = rng.normal(size=(20, 3)) / FORM_REACH_MM
    smooth = np.sqrt(2 / 20) * np.cos(points @ waves.T + rng.uniform(0, 2 * np.pi, 20)).sum(axis=1)
    return replace(cloud, points_mm=points + rays * (form_mm * smooth + NOISE_MM * rng.normal(size=len(points)))[:, None])


def normalised_errors(turned_over: TurnedOver, draws: int, form_mm: float) -> np.ndarray:
    """Return the squared errors (draws,) of the joint over its covariance: chi-square of six degrees of freedom if that is right."""
    found = []
    for seed in range(draws):
        rng = np.random.default_rng([seed, 5])
        pair = prepare_setups([measured_again(one, rng, form_mm) for one in (turned_over.up, turned_over.down)])
        found.append(_squared_error(pair, turned_over.up_from_down))
    return np.array(found)


def _squared_error(pair: list[PreparedSetUp], true: RigidTransform) -> float:
    poses = [RigidTransform.identity("part", "up"), RigidTransform(true.matrix, "part", "down")]
    for _ in range(3):
        measured = measure_pair(*[one.prepared for one in pair], poses[0].inverse() @ poses[1], (0, 1), 4.0)
        joint = solve_joint(pair, poses, [edge_by_surface(measured, (0, 1), pair, poses)])
        poses = list(joint.part_from_setup)
    wrong = poses[1].matrix @ np.linalg.inv(true.matrix)
    error = np.concatenate([wrong[:3, 3], Rotation.from_matrix(wrong[:3, :3]).as_rotvec()])
    return float(error @ np.linalg.solve(joint.covariance[6:, 6:], error))


def bounds(draws: int) -> tuple[float, float]:
    """Return the bounds of the mean of chi-square values of six degrees of freedom, for four standard deviations of the mean."""
    spread = 4 * (2 * 6 / draws) ** 0.5
    return 6 - spread, 6 + spread


def test_the_uncertainty_of_a_joint_is_of_the_size_of_its_errors(turned_over: TurnedOver) -> None:
    errors = normalised_errors(turned_over, 4, FORM_MM)
    assert errors.mean() < bounds(4)[1]  # not stated too small; the slow test has both sides


@pytest.mark.slow
@pytest.mark.parametrize("form_mm", [0.0, FORM_MM])
def test_the_errors_of_a_joint_are_consistent_with_its_covariance(turned_over: TurnedOver, form_mm: float) -> None:
    errors = normalised_errors(turned_over, 40, form_mm)
    low, high = bounds(40)
    assert errors.mean() < high, f"mean of the normalised squared errors {errors.mean():.2f}, expected 6"
    assert errors.mean() > low / 3  # form errors that residuals cannot show are assumed, so that it may be stated larger
