"""The whole rig is recovered from one series of sightings."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.poses import apply_changes, change_between
from measureapp.calibrate.rig.joint import number_approaches, shortfalls, solve_rig
from measureapp.calibrate.rig.stages import transform_axis
from measureapp.data.calibration import RotationAxis
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform


def errors_over_sigma(solution, rig):
    """Return errors of hand-eye (6), guide scale and direction, and axis, over their standard deviations."""
    calibration, sigma = solution.calibration, solution.standard_deviations
    x = change_between(rig.flange_from_camera.matrix[None], calibration.hand_eye.flange_from_camera.matrix[None])[0]
    named = [f"hand_eye.{name}" for name in ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")]
    return [*(x / [sigma[name] for name in named]), (calibration.guide.scale - rig.guide.scale) / sigma["guide.scale"]]


def off_axis_mm(axis, truth) -> float:
    away = truth.point_mm - axis.point_mm
    return float(np.linalg.norm(away - axis.direction * (away @ axis.direction)))


def test_the_rig_is_recovered_without_robot_errors(rig, simulate, generator):
    solution = solve_rig(simulate.observations(rig, generator, robot_errors=False), rig.head)
    calibration = solution.calibration
    assert np.linalg.norm(calibration.hand_eye.flange_from_camera.translation_mm - rig.flange_from_camera.translation_mm) < 0.02
    assert np.linalg.norm(calibration.guide.direction - rig.guide.direction) < 5e-5
    assert abs(calibration.guide.scale - rig.guide.scale) < 5e-5
    assert np.linalg.norm(calibration.axis.direction - rig.axis.direction) < 5e-5
    assert off_axis_mm(calibration.axis, rig.axis) < 0.02
    stroke = np.ptp([one.guide_mm for one in simulate.readbacks(rig).values()])
    assert solution.paper_cost_mm == pytest.approx(stroke * np.linalg.norm(rig.guide.direction * rig.guide.scale - [0, 1, 0]), rel=0.02)
    assert not solution.not_observable
    assert not solution.rejected


@pytest.fixture(scope="module")
def solutions(rig, simulate):
    """Five runs with robot errors as stated."""
    return [solve_rig(simulate.observations(rig, np.random.default_rng(seed)), rig.head) for seed in range(5)]


def test_errors_agree_with_the_predicted_standard_deviations(rig, solutions):
    ratios = [errors_over_sigma(solution, rig) for solution in solutions]
    assert 0.6 < np.sqrt(np.mean(np.square(ratios))) < 1.4  # five runs
    assert 0.8 < np.mean([solution.sigma_ratio for solution in solutions]) < 1.2


def test_the_joint_solution_is_better_than_the_stages(rig, solutions):
    joint = [np.linalg.norm(solution.calibration.axis.direction - rig.axis.direction) for solution in solutions]
    stages = [np.linalg.norm(solution.stages.axis.direction - rig.axis.direction) for solution in solutions]
    assert np.mean(joint) < np.mean(stages)


def test_a_sighting_whose_board_moved_is_rejected_with_its_reason(rig, simulate, generator):
    observations = simulate.observations(rig, generator)
    index = next(index for index, one in enumerate(observations) if one.id == "axis3")
    shifted = apply_changes(observations[index].board.camera_from_board.matrix, np.array([0, 0, 0, 3.0, 0, 0]))
    pose = replace(observations[index].board, camera_from_board=RigidTransform(shifted, "camera", "board"))
    observations[index] = replace(observations[index], board=pose)
    solution = solve_rig(observations, rig.head)
    assert set(solution.rejected) == {"axis3"}
    assert max(map(abs, errors_over_sigma(solution, rig))) < 4.5


def test_a_rejected_sighting_does_not_make_one_approach_of_its_neighbours(rig, simulate, generator):
    """The robot stood at one pose, went away and came back; from where it was meanwhile the board was not seen, or is rejected."""
    observations = simulate.observations(rig, generator)
    pose = observations[0].readback.base_from_flange
    away = pose @ RigidTransform.from_vector([0.1, 0, 0], [30, 20, 10], "flange", "flange")
    assert number_approaches([pose, pose, away, pose]) == (0, 0, 1, 2)
    gone = replace(observations[-1], id="gone", readback=replace(observations[-1].readback, base_from_flange=away))
    index = next(index for index, one in enumerate(observations) if one.id == "axis3")
    shifted = apply_changes(observations[index].board.camera_from_board.matrix, np.array([0, 0, 0, 30.0, 0, 0]))
    gone = replace(gone, board=replace(gone.board, camera_from_board=RigidTransform(shifted, "camera", "board")))
    told = [*observations[: index + 1], gone, *observations[index + 1 :]]
    noise = AxisNoise(robot_mm=simulate.robot_sigma_mm, robot_rad=simulate.robot_sigma_rad, robot_repeat_mm=0.01, robot_repeat_rad=1e-5)
    solution = solve_rig(told, rig.head, noise=noise)
    assert set(solution.rejected) == {"gone"}
    names = [one.name for one in solution.residuals]
    before, after = solution.chain.robot_group[[names.index("axis3"), names.index("axis3") + 1]]
    assert before != after


def test_a_guide_that_did_not_move_is_said_to_be_unobservable(rig, simulate, generator):
    observations = [one for one in simulate.observations(rig, generator) if abs(one.readback.guide_mm) < 1e-6]
    solution = solve_rig(observations, rig.head)
    assert "guide" in solution.not_observable[0]
    assert solution.calibration.guide.scale == 1.0


def test_a_table_that_did_not_turn_is_refused(rig, simulate, generator):
    observations = [one for one in simulate.observations(rig, generator) if not one.id.startswith("axis")]
    with pytest.raises(CalibrationError, match="turn the table"):
        solve_rig(observations, rig.head)


def test_an_axis_is_transformed_with_its_camera(generator):
    guide_from_camera = RigidTransform.from_vector([0.4, 0.2, -0.3], [10, 20, 30], "guide", "camera")
    axis = RotationAxis(np.array([1.0, 2, 3]), np.array([0, 0.6, 0.8]), "camera", point_sigma_mm=0.1)
    carried = transform_axis(axis, guide_from_camera)
    points = generator.normal(size=(4, 3)) * 100
    expected = guide_from_camera.apply(axis.turned(0.7).apply(points))
    np.testing.assert_allclose(carried.turned(0.7).apply(guide_from_camera.apply(points)), expected, atol=1e-9)
    assert (carried.frame, carried.point_sigma_mm) == ("guide", 0.1)


def test_what_is_missing_is_asked_for_along_every_axis(rig, simulate, generator):
    assert len(shortfalls([])) == 3
    observations = simulate.observations(rig, generator)
    assert shortfalls([observation.readback for observation in observations]) == ()
