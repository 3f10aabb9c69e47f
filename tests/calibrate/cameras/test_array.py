"""Cameras are recovered from simulated and recorded views."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.calibrate.boards.find import detect
from measureapp.calibrate.boards.quality import blur_px
from measureapp.calibrate.cameras.array import CameraArrayProblem, left_from_right, solve
from measureapp.calibrate.cameras.shortfalls import shortfalls
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import CheckerboardDescription
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

SIZES = dict.fromkeys(("left", "right", "upper"), (1296, 972))


def problem_of(board, sightings, names=("left", "right", "upper")) -> CameraArrayProblem:
    return CameraArrayProblem(board, "left", {name: SIZES[name] for name in names}, sightings)


def errors_over_sigma(solution, head) -> dict[str, float]:
    """Return every parameter's error in units of its own standard deviation."""
    result = {}
    for name, camera in solution.calibration.cameras.items():
        true, sigma = head.cameras[name], camera.standard_deviations
        pairs = [("fx", 0, 0), ("fy", 1, 1), ("cx", 0, 2), ("cy", 1, 2)]
        result |= {f"{name}.{key}": (camera.pinhole.matrix[i, j] - true.pinhole.matrix[i, j]) / sigma[key] for key, i, j in pairs}
        for index, key in enumerate(("k1", "k2", "p1", "p2", "k3")):
            result[f"{name}.{key}"] = (camera.pinhole.distortion[index] - true.pinhole.distortion[index]) / sigma[key]
        if name != "left":
            shift = camera.reference_from_camera.translation_mm - true.reference_from_camera.translation_mm
            result |= {f"{name}.{key}": shift[index] / sigma[key] for index, key in enumerate(("x_mm", "y_mm", "z_mm"))}
            turn = camera.reference_from_camera.rotation @ true.reference_from_camera.rotation.T
            vector = RigidTransform.from_parts(turn, np.zeros(3), "a", "b").rotation_vector
            keys = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad")
            result |= {f"{name}.{key}": vector[index] / sigma[key] for index, key in enumerate(keys)}
    return result


def test_cameras_without_noise_are_recovered_exactly(head, board, simulate, generator):
    solution = solve(problem_of(board, simulate.sightings(head, board, 8, 0.0, generator)))
    for name, camera in solution.calibration.cameras.items():
        np.testing.assert_allclose(camera.pinhole.matrix, head.cameras[name].pinhole.matrix, atol=2e-3)
        np.testing.assert_allclose(camera.reference_from_camera.matrix, head.cameras[name].reference_from_camera.matrix, atol=2e-3)
    assert solution.joint_rms_px < 1e-4
    assert solution.loops[0].distance_mm < 0.01
    assert not solution.rejected


@pytest.fixture(scope="module")
def repeated(head, board, simulate):
    """Twelve calibrations that differ in their noise and in where the board was shown."""
    return [solve(problem_of(board, simulate.sightings(head, board, 10, 0.1, np.random.default_rng(seed)))) for seed in range(12)]


def test_predicted_standard_deviations_agree_with_the_scatter_of_repeated_runs(head, repeated):
    normalised = np.array([list(errors_over_sigma(solution, head).values()) for solution in repeated])
    assert 0.85 < np.sqrt(np.mean(normalised**2)) < 1.15  # 1 is perfect; 12 runs of 39 correlated parameters
    assert np.mean(np.abs(normalised) < 1.96) > 0.90  # 0.94 over 120 runs


def test_noise_of_the_corners_is_estimated(head, board, simulate, generator):
    solution = solve(problem_of(board, simulate.sightings(head, board, 10, 0.1, generator)))
    assert solution.sigma_px == pytest.approx(0.1, rel=0.05)
    assert solution.joint_rms_px == pytest.approx(0.1 * np.sqrt(2), rel=0.05)


def test_the_same_views_give_the_same_digits_again(head, board, simulate, generator):
    problem = problem_of(board, simulate.sightings(head, board, 10, 0.1, generator))
    first = solve(problem)
    for _ in range(2):
        again = solve(problem)
        np.testing.assert_array_equal(again.covariance, first.covariance)
        for name, camera in first.calibration.cameras.items():
            np.testing.assert_array_equal(again.calibration.cameras[name].pinhole.matrix, camera.pinhole.matrix)


def test_a_camera_need_not_see_all_views(head, board, simulate, generator):
    sightings = [one for one in simulate.sightings(head, board, 12, 0.05, generator) if one.camera != "upper" or int(one.view) >= 6]
    solution = solve(problem_of(board, tuple(sightings)))
    assert max(abs(value) for value in errors_over_sigma(solution, head).values()) < 4.5


def test_a_single_camera_can_be_calibrated(head, board, simulate, generator):
    seen = (one for one in simulate.sightings(head, board, 10, 0.1, generator) if one.camera == "left")
    sightings = tuple(replace(one, edge_px=2.1) for one in seen)
    solution = solve(problem_of(board, sightings, ("left",)))
    own = [value for name, value in errors_over_sigma(solution, head).items() if name.startswith("left.")]
    assert max(map(abs, own)) < 4.5
    assert solution.calibration.pair_rms_px == {}
    assert solution.calibration.cameras["left"].blur_px == blur_px([2.1])


def test_a_view_whose_board_moved_between_cameras_is_rejected_with_its_reason(head, board, simulate, generator):
    sightings = list(simulate.sightings(head, board, 10, 0.05, generator))
    index = next(i for i, one in enumerate(sightings) if one.camera == "right" and one.view == "04")
    sightings[index] = replace(sightings[index], corners_px=sightings[index].corners_px + np.array([4.0, 0.0]))
    solution = solve(problem_of(board, tuple(sightings)))
    assert [(one.camera, one.view) for one in solution.rejected] == [("right", "04")]
    assert "the board moved between the images" in solution.rejected[0].reason
    assert solution.joint_rms_px < 0.05 * np.sqrt(2) * 1.1


def test_a_single_wrong_corner_is_rejected_and_its_view_kept(head, board, simulate, generator):
    sightings = list(simulate.sightings(head, board, 8, 0.05, generator))
    corners = np.array(sightings[0].corners_px)
    corners[17] += [1.0, -0.5]
    sightings[0] = replace(sightings[0], corners_px=corners)
    solution = solve(problem_of(board, tuple(sightings)))
    assert solution.rejected == ()
    assert [(one.camera, one.view, one.corner) for one in solution.rejected_corners] == [("left", "00", 17)]
    assert solution.rejected_corners[0].distance_px == pytest.approx(np.hypot(1.0, 0.5), abs=0.2)
    assert "px from its expected position" in solution.rejected_corners[0].reason
    assert next(view for view in solution.views if (view.camera, view.view) == ("left", "00")).corners == board.columns * board.rows - 1


def test_a_board_that_moved_by_a_twentieth_of_a_millimetre_is_noticed(head, board, simulate, generator):
    poses = {f"{number:02d}": simulate.board_pose(generator) for number in range(12)}
    moved = RigidTransform.from_parts(np.eye(3), [0.05, 0.0, 0.0], "camera", "camera")
    sightings = [
        Sighting(name, view, pixels)
        for view, pose in poses.items()
        for name in head.names
        for pixels in [simulate.corners(head, board, moved @ pose if (name, view) == ("upper", "07") else pose, 0.05, generator)[name]]
    ]
    solution = solve(problem_of(board, tuple(sightings)))
    assert [(one.camera, one.view) for one in solution.rejected] == [("upper", "07")]
    assert "the board moved between the images" in solution.rejected[0].reason
    assert solution.rejected_corners == ()


def test_nothing_is_rejected_in_clean_views(repeated):
    assert [solution.rejected for solution in repeated] == [()] * 12
    assert max(len(solution.rejected_corners) for solution in repeated) <= 1  # 5.5 standard deviations in 55 000 corners


def test_exchanged_images_of_two_cameras_are_named(head, board, simulate, generator):
    sightings = list(simulate.sightings(head, board, 8, 0.05, generator))
    other = {"left": "right", "right": "left"}
    exchanged = tuple(replace(one, camera=other.get(one.camera, one.camera)) if one.view == "03" else one for one in sightings)
    solution = solve(problem_of(board, exchanged))
    assert {(one.camera, one.view) for one in solution.rejected} == {("left", "03"), ("right", "03")}
    assert all(one.reason == "the images of cameras left and right were exchanged" for one in solution.rejected)


def test_a_camera_that_saw_another_board_position_is_distinguished_from_the_two_that_agree(head, board, simulate, generator):
    sightings = list(simulate.sightings(head, board, 8, 0.05, generator))
    elsewhere = next(one for one in sightings if (one.camera, one.view) == ("right", "05"))
    wrong = tuple(replace(one, corners_px=elsewhere.corners_px) if (one.camera, one.view) == ("right", "02") else one for one in sightings)
    solution = solve(problem_of(board, wrong))
    assert [(one.camera, one.view) for one in solution.rejected] == [("right", "02")]
    assert "cameras left and upper saw" in solution.rejected[0].reason


def test_corners_of_a_part_of_the_board_are_enough(head, board, simulate, generator):
    part = np.flatnonzero(np.arange(154) % 14 < 9)
    sightings = tuple(
        replace(one, corners_px=one.corners_px[part], ids=part) if int(one.view) % 2 else one
        for one in simulate.sightings(head, board, 12, 0.05, generator)
    )
    solution = solve(problem_of(board, sightings))
    assert max(abs(value) for value in errors_over_sigma(solution, head).values()) < 4.5
    assert {view.corners for view in solution.views} == {154, len(part)}


def test_each_camera_is_weighted_by_its_own_noise(head, board, simulate):
    sightings = tuple(
        fine if fine.camera != "upper" else coarse
        for fine, coarse in zip(
            simulate.sightings(head, board, 12, 0.05, np.random.default_rng(3)),
            simulate.sightings(head, board, 12, 0.4, np.random.default_rng(3)),
            strict=True,
        )
    )
    first = {one.view: one for one in sightings if one.camera == "upper"}
    assert len(first) == 12
    solution = solve(problem_of(board, sightings))
    assert solution.sigmas_px["left"] == pytest.approx(0.05, rel=0.1)
    assert solution.sigmas_px["upper"] == pytest.approx(0.4, rel=0.1)
    assert solution.rejected == ()


def test_images_in_another_order_are_refused(head, board, simulate, generator):
    sightings = simulate.sightings(head, board, 8, 0.05, generator)
    shuffled = tuple(replace(one, view=f"{(int(one.view) + 3) % 8:02d}") if one.camera == "right" else one for one in sightings)
    with pytest.raises(CalibrationError, match="do not belong together"):
        solve(problem_of(board, shuffled))


def test_two_views_are_too_few(head, board, simulate, generator):
    with pytest.raises(CalibrationError, match="at least 3"):
        solve(problem_of(board, simulate.sightings(head, board, 2, 0.05, generator)))


def test_boards_that_are_all_parallel_do_not_determine_the_focal_length(head, board, generator):
    camera = head.cameras["left"]
    sightings = []
    for view in range(5):
        pose = RigidTransform.from_vector([0, 0, 0.1 * view], [-70 + 5 * view, -60, 540 + 10 * view], "camera", "board")
        pixels = camera.pinhole.project(pose.apply(board.corners_mm)) + generator.normal(scale=0.1, size=(154, 2))
        sightings.append(Sighting("left", str(view), pixels))
    with pytest.raises(CalibrationError, match=r"(?i)tilt"):
        solve(problem_of(board, tuple(sightings), ("left",)))


def test_a_symmetric_board_is_refused_for_several_cameras(head, simulate, generator):
    symmetric = CheckerboardDescription(columns=8, rows=6, square_mm=12)
    with pytest.raises(CalibrationError, match="half a turn"):
        solve(problem_of(symmetric, simulate.sightings(head, symmetric, 5, 0.05, generator)))


def test_shortfalls_name_what_is_missing(head, board, simulate, generator):
    problem = CameraArrayProblem(board, "left", {"left": SIZES["left"]}, ())
    assert shortfalls(problem) == ("Camera left: 3 more views are needed.",)
    camera = head.cameras["left"]
    poses = [RigidTransform.from_vector([0.05 * number, 0, 0], [-70, -60, 800], "camera", "board") for number in range(4)]
    sightings = [Sighting("left", str(index), camera.pinhole.project(pose.apply(board.corners_mm))) for index, pose in enumerate(poses)]
    said = " ".join(shortfalls(replace(problem, sightings=tuple(sightings))))
    assert "6 more views" in said
    assert "tilt the board" in said
    assert "image was covered" in said


@pytest.fixture(scope="module")
def opencv_pairs():
    """Images and corners of the recorded pairs."""
    folder = recorded("opencv_stereo")
    board = CheckerboardDescription(columns=9, rows=6, square_mm=1.0)
    images = {(camera, path.stem[-2:]): cv2.imread(str(path), 0) for camera in ("left", "right") for path in folder.glob(f"{camera}*.jpg")}
    return board, images, {key: detect(image, board) for key, image in images.items()}


def solved(board, corners):
    sightings = tuple(Sighting(*key, pixels) for key, pixels in sorted(corners.items()))
    return solve(CameraArrayProblem(board, "left", {"left": (640, 480), "right": (640, 480)}, sightings))


def test_the_recorded_pairs_give_the_published_stereo_calibration(opencv_pairs):
    board, _, corners = opencv_pairs
    solution = solved(board, corners)
    baseline = np.linalg.norm(left_from_right(solution.calibration, "left", "right").translation_mm)
    assert solution.calibration.pair_rms_px["left-right"] < 0.30
    assert baseline == pytest.approx(3.328, abs=0.02)


def test_triangulated_squares_of_the_recorded_pairs_have_their_size(opencv_pairs):
    from measureapp.calibrate.boards.pose import triangulate

    board, _, corners = opencv_pairs
    calibration = solved(board, corners).calibration
    sides = []
    for view in sorted({view for _, view in corners}):
        points = triangulate({camera: corners[camera, view] for camera in ("left", "right")}, calibration).reshape(6, 9, 3)
        sides += [np.linalg.norm(np.diff(points, axis=axis), axis=2).ravel() for axis in (0, 1)]
    assert np.mean(np.concatenate(sides)) == pytest.approx(1.0, abs=0.002)


def test_views_refined_with_too_wide_a_window_are_found_and_rejected(opencv_pairs):
    board, images, corners = opencv_pairs
    until = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 100, 0.01)
    wide = {
        key: cv2.cornerSubPix(images[key], pixels.astype(np.float32).reshape(-1, 1, 2), (11, 11), (-1, -1), until).reshape(-1, 2)
        for key, pixels in corners.items()
    }
    solution = solved(board, wide)
    whole = {one.view for one in solution.rejected if "median" in one.reason}
    assert whole == {"02", "05"}
    assert solution.joint_rms_px < 0.30
    assert np.linalg.norm(left_from_right(solution.calibration, "left", "right").translation_mm) == pytest.approx(3.328, abs=0.02)
