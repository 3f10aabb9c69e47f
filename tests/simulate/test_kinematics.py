"""The axes err as their data sheets say, and do so again for the same seed."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.kinematics import draw_guide_errors, draw_robot_errors, draw_table_errors

POSES = 400


def poses(rng: np.random.Generator) -> list[RigidTransform]:
    """Flange poses in front of the robot, looking forward and down, as scans use them."""
    forward = RigidTransform.from_parts(
        np.column_stack([[0.0, -1.0, 0.0], [-0.7, 0.0, -0.7] / np.sqrt(0.98), [0.7, 0.0, -0.7] / np.sqrt(0.98)]),
        [450.0, 0.0, 600.0],
        "base",
        "flange",
    )
    return [
        RigidTransform.from_vector([0, 0, 0], rng.uniform(-150, 150, 3), "base", "base")
        @ forward
        @ RigidTransform.from_vector(rng.uniform(-0.4, 0.4, 3), [0, 0, 0], "flange", "flange")
        for _ in range(POSES)
    ]


def test_the_robot_s_error_has_the_stated_rms_and_repeats(paper: RigDescription) -> None:
    squares_mm, squares_rad = [], []
    for seed in range(12):  # one robot's field is smooth, so that a part of its reach says little about all of it
        errors = draw_robot_errors(paper.robot, np.random.default_rng(seed))
        field = np.array([errors.field(pose) for pose in poses(np.random.default_rng(100 + seed))[:60]])
        squares_mm.append((field[:, :3] ** 2).sum(axis=1).mean())
        squares_rad.append((field[:, 3:] ** 2).sum(axis=1).mean())
    assert np.sqrt(np.mean(squares_mm)) == pytest.approx(0.3, rel=0.25)
    assert np.rad2deg(np.sqrt(np.mean(squares_rad))) == pytest.approx(0.02, rel=0.25)
    again = draw_robot_errors(paper.robot, np.random.default_rng(11))
    pose = poses(np.random.default_rng(1))[0]
    np.testing.assert_array_equal(errors.field(pose), again.field(pose))


def test_the_robot_s_error_changes_smoothly_with_the_pose(paper: RigDescription) -> None:
    errors = draw_robot_errors(paper.robot, np.random.default_rng(4))
    step = RigidTransform.from_vector([0, 0, 0], [5.0, 0, 0], "base", "base")
    for pose in poses(np.random.default_rng(5))[:50]:
        change = errors.field(step @ pose) - errors.field(pose)
        assert np.linalg.norm(change[:3]) < 0.02


def test_a_pose_reached_again_scatters_by_the_repeatability(paper: RigDescription) -> None:
    errors = draw_robot_errors(paper.robot, np.random.default_rng(6))
    rng = np.random.default_rng(7)
    pose = poses(rng)[0]
    reached = np.array([errors.true_pose(pose, rng).translation_mm for _ in range(POSES)])
    scatter = np.sqrt(((reached - reached.mean(axis=0)) ** 2).sum(axis=1).mean())
    assert scatter == pytest.approx(paper.robot.repeatability_mm, rel=0.15)  # 3·400 draws: 2 % standard deviation


def test_the_guide_runs_a_little_askew_and_nearly_straight(paper: RigDescription) -> None:
    for seed in range(20):
        errors = draw_guide_errors(paper.guide, np.random.default_rng(seed))
        tilt_deg = np.rad2deg(np.arccos(errors.direction[1]))
        assert 0.1 <= tilt_deg <= 0.2
        assert abs(errors.scale - 1.0) <= 2e-4
        rail = np.array([errors.straightness_mm(position) for position in np.linspace(-650, 650, 53)])
        assert 0.0 < np.abs(rail).max() < 0.03
        np.testing.assert_array_equal(errors.straightness_mm(0.0), 0.0)


def test_the_table_s_indexing_error_spans_its_accuracy_and_is_none_at_zero(paper: RigDescription) -> None:
    for seed in range(10):
        errors = draw_table_errors(paper.table, np.random.default_rng(seed))
        arcsec = np.rad2deg([errors.indexing_rad(angle) for angle in np.linspace(0, 2 * np.pi, 721)]) * 3600
        assert np.ptp(arcsec) == pytest.approx(paper.table.accuracy_arcsec)
        assert errors.indexing_rad(0.0) == 0.0
        assert errors.indexing_rad(2 * np.pi) == pytest.approx(0.0, abs=1e-12)


def test_an_angle_reached_again_scatters_by_the_repeatability(paper: RigDescription) -> None:
    errors = draw_table_errors(paper.table, np.random.default_rng(1))
    rng = np.random.default_rng(2)
    reached = np.rad2deg([errors.true_angle_rad(1.0, rng) for _ in range(POSES)]) * 3600
    assert 2 * reached.std() == pytest.approx(paper.table.repeatability_arcsec, rel=0.15)
