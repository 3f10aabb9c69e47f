"""What the calibration of the cameras leaves uncertain is found again in the standard deviations of what was solved with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions import hand_eye, linear_guide, rotation_axis
from measureapp.calibrate.motions.axis_motion import perpendicular_basis
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.poses import apply_changes
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import HandEye, LabelledCovariance, LinearGuide, RotationAxis
from measureapp.data.fringe import Readback
from measureapp.geometry.transform import RigidTransform

BOARD = CheckerboardDescription(columns=9, rows=6, square_mm=12.0)
X = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
PRIOR = LabelledCovariance(("left.fx", "left.cx"), np.array([[1.0, 0.3], [0.3, 0.5]]))


@pytest.fixture
def generator():
    return np.random.default_rng(4)


def changes(generator, count):
    """How poses might move with two parameters of the cameras."""
    return generator.normal(size=(count, 6, 2)) * np.array([2e-5] * 3 + [0.02] * 3)[:, None]


def seen_with_errors(poses, camera_jacobian, generator):
    """The board poses as cameras with one draw of their errors see them."""
    step = camera_jacobian @ (PRIOR.root @ generator.normal(size=PRIOR.root.shape[1]))
    return [RigidTransform(apply_changes(pose.matrix, change), "camera", "board") for pose, change in zip(poses, step, strict=True)]


def test_the_root_of_a_covariance_gives_it_back():
    np.testing.assert_allclose(PRIOR.root @ PRIOR.root.T, PRIOR.covariance, atol=1e-12)
    np.testing.assert_allclose(PRIOR.rows_of(["left.cx", "left.k1", "left.fx"]), [[0.5, 0, 0.3], [0, 0, 0], [0.3, 0, 1.0]])


@pytest.mark.parametrize("draws", [60, pytest.param(300, marks=pytest.mark.slow)])
def test_a_guide_scatters_by_what_is_stated(generator, draws):
    truth, standing = (
        LinearGuide(np.array([0.003, 1.0, -0.002]), 1.0004),
        RigidTransform.from_vector([2.0, 0.3, -0.4], [600, 50, 100], "guide", "board"),
    )
    slides = np.linspace(-200, 200, 9)
    poses, flanges = [], []
    for slide in slides:
        pose = RigidTransform.from_vector(generator.uniform(-0.5, 0.5, 3), [*generator.uniform(-80, 80, 2), 550], "camera", "board")
        poses.append(pose)
        flange = truth.guide_from_base(slide).inverse() @ standing @ pose.inverse() @ X.inverse()
        flanges.append(RigidTransform(flange.matrix, "base", "flange"))
    camera_jacobian = changes(generator, len(poses))

    def solved(seen, derivatives=None):
        known = [None] * len(seen) if derivatives is None else derivatives
        observations = tuple(
            Observation(str(slide), Readback(flange, float(slide)), stated_pose(pose, 1.0, 1.0), own)
            for flange, slide, pose, own in zip(flanges, slides, seen, known, strict=True)
        )
        return linear_guide.solve(linear_guide.GuideProblem(observations, HandEye(X), None if derivatives is None else PRIOR)).guide

    stated = solved(poses, camera_jacobian)
    scales = [solved(seen_with_errors(poses, camera_jacobian, generator)).scale for _ in range(draws)]
    assert np.std(scales) == pytest.approx(
        stated.scale_sigma, rel=4 / np.sqrt(2 * draws)
    )  # of a sampled standard deviation, four of its own


def test_an_axis_scatters_by_what_is_stated(generator):
    axis = RotationAxis(np.array([170.0, 90.0, 600.0]), np.array([0.05, -0.8, -0.6]), "camera")
    start = RigidTransform.from_vector([0.3, -0.25, 0.1], [90, -20, 560], "camera", "board")
    angles = np.deg2rad(np.arange(0, 91, 30))
    poses = [RigidTransform((axis.turned(angle) @ start).matrix, "camera", "board") for angle in angles]
    camera_jacobian = changes(generator, len(poses))

    def solved(seen, **known):
        boards = [stated_pose(pose, 1e-5, 0.01) for pose in seen]
        problem = rotation_axis.problem_from_poses(boards, BOARD, list(angles))

        return rotation_axis._maximum_likelihood(
            replace(problem, **known),
            problem.corners_mm,
            rotation_axis._start(problem.corners_mm, problem.angles_rad, problem.names),
            False,
        )

    estimate, covariance, _ = solved(poses, camera_jacobian=camera_jacobian, camera_prior=PRIOR)
    basis = perpendicular_basis(estimate.axis.direction)
    drawn = [solved(seen_with_errors(poses, camera_jacobian, generator))[0].axis for _ in range(60)]
    turns = np.array([basis @ (one.direction - estimate.axis.direction) for one in drawn])
    np.testing.assert_allclose(turns.std(axis=0), np.sqrt(np.diag(covariance)[:2]), rtol=4 / np.sqrt(2 * 60))


def test_a_hand_eye_transform_is_less_certain_with_uncertain_cameras(generator):
    standing = RigidTransform.from_vector([2.0, 0.3, -0.4], [600, 50, 100], "base", "board")
    poses = [
        RigidTransform.from_vector(generator.uniform(-0.6, 0.6, 3), [*generator.uniform(-80, 80, 2), 550], "camera", "board")
        for _ in range(9)
    ]
    flanges = tuple(RigidTransform((standing @ pose.inverse() @ X.inverse()).matrix, "base", "flange") for pose in poses)
    boards, noise = tuple(stated_pose(pose, 1e-5, 0.005) for pose in poses), AxisNoise(robot_mm=0.005, robot_rad=1e-5)
    camera_jacobian = changes(generator, len(poses))
    plain = hand_eye.solve(hand_eye.HandEyeProblem(flanges, boards, noise))
    carried = hand_eye.solve(hand_eye.HandEyeProblem(flanges, boards, noise, camera_jacobian, PRIOR))
    added = carried.covariance - plain.covariance
    scale = np.sqrt(np.diag(carried.covariance))
    values = np.linalg.eigvalsh(added / np.outer(scale, scale))
    assert values[0] > -1e-6
    assert np.sum(values > 1e-3) == 2  # two parameters are uncertain
