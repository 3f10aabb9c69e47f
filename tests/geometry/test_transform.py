import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from measureapp.errors import FrameMismatch
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about

vectors = arrays(np.float64, 3, elements=st.floats(-3, 3))


@given(vectors, vectors)
def test_a_transform_and_its_inverse_cancel(rotation, translation):
    a_from_b = RigidTransform.from_vector(rotation, translation * 100, "a", "b")
    points = np.array([[1.0, 2.0, 3.0], [-400.0, 5.0, 1000.0]])
    assert np.allclose((a_from_b.inverse() @ a_from_b).apply(points), points, atol=1e-9)


@given(vectors, vectors)
def test_a_quaternion_round_trip_keeps_the_pose(rotation, translation):
    a_from_b = RigidTransform.from_vector(rotation, translation, "a", "b")
    again = RigidTransform.from_quaternion(a_from_b.quaternion_wxyz, a_from_b.translation_mm, "a", "b")
    assert np.allclose(again.matrix, a_from_b.matrix, atol=1e-12)


def test_a_chain_whose_frames_do_not_meet_is_refused():
    a_from_b = RigidTransform.identity("a", "b")
    with pytest.raises(FrameMismatch, match="a_from_b cannot be multiplied by c_from_d"):
        a_from_b @ RigidTransform.identity("c", "d")


def test_a_matrix_that_is_not_rigid_is_refused():
    with pytest.raises(FrameMismatch, match="not a rigid transform"):
        RigidTransform(np.diag([1.0, 1.0, -1.0, 1.0]), "a", "b")


def test_a_rotation_about_z_is_right_handed():
    assert np.allclose(rotation_about([0, 0, 2], np.pi / 2) @ [1, 0, 0], [0, 1, 0])


def test_a_transform_cannot_be_written_to():
    with pytest.raises(ValueError, match="read-only"):
        RigidTransform.identity("a", "b").matrix[0, 3] = 1.0


@pytest.mark.parametrize("coefficients", [4, 5, 8, 12, 14])
@pytest.mark.parametrize("count", [3, 500])
def test_points_are_projected_as_by_opencv_also_in_the_plane_of_the_camera_and_behind_it(coefficients, count):
    generator = np.random.default_rng(coefficients)
    lens = generator.normal(scale=0.05, size=coefficients)
    camera = PinholeCamera(2592, 1944, np.array([[4091, 0, 1295.5], [0, 4080, 971.5], [0, 0, 1]]), lens)
    points = generator.normal((0.0, 0.0, 300.0), 40.0, (count, 3))
    points[:2, 2] = 0.0, -200.0
    expected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), camera.matrix.copy(), lens)
    np.testing.assert_allclose(camera.project(points), expected.reshape(-1, 2), rtol=1e-11)


def test_projecting_and_undistorting_cancel_for_a_distorted_lens():
    camera = PinholeCamera(2592, 1944, np.array([[4091, 0, 1295.5], [0, 4091, 971.5], [0, 0, 1]]), np.array([-0.1, 0.05, 1e-4, 2e-4, 0]))
    pixels = np.random.default_rng(0).uniform([0, 0], [2591, 1943], (500, 2))
    assert np.abs(camera.project(camera.rays(pixels) * 550.0) - pixels).max() < 1e-9
