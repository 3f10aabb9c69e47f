"""The form that clouds have by themselves: as large as told, less what the views follow."""

from __future__ import annotations

import numpy as np
from scipy.spatial.distance import cdist

from measureapp.data.cloud import PointCloud
from measureapp.data.view_errors import ViewErrors, smooth_basis
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.form_errors import estimate_form_errors
from measureapp.register.pairs.prepare import PreparedCloud, prepare
from measureapp.register.pairs.smooth_errors import CORRELATION_LENGTH

SIZES_MM = np.array([0.001, 0.003])


def saddle(seed: int) -> PreparedCloud:
    """A wavy sheet before the camera."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-60, 60, (2, 10_000))
    points = np.column_stack([x, y, 500 + x * y / 150])
    normals = np.column_stack([y / 150, x / 150, -np.ones_like(x)])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    same = np.full(len(x), 0.01)
    # a point every 4 mm: errors that are smooth over 50 mm need no more, and the covariance of all pairs of points grows with their square
    return prepare(PointCloud(points, normals, same, same, np.full((len(x), 2), -1), np.ones(len(x)), "camera", f"v{seed}"), 4.0)


def known() -> tuple[list[PreparedCloud], ViewErrors]:
    clouds = [saddle(1), saddle(2)]
    poses = tuple(RigidTransform.from_vector([0.0, 0.4 * k, 0.1], [20.0, 0, -500], "part", "camera") for k in range(2))
    centres = np.stack([pose.apply(cloud.centroid_mm) for pose, cloud in zip(poses, clouds, strict=True)])
    form = estimate_form_errors(clouds, SIZES_MM, poses, centres)
    return clouds, ViewErrors(poses, centres, np.zeros((12, 0)), np.zeros((12, 0)), form=form)


def test_form_is_what_a_motion_of_the_view_leaves_of_a_smooth_error() -> None:
    clouds, errors = known()
    assert errors.form is not None
    for number, (cloud, pose) in enumerate(zip(clouds, errors.poses, strict=True)):
        points, normals = pose.apply(cloud.points_mm), pose.rotate(np.asarray(cloud.normals, float))
        columns = errors.along(points, normals, np.full(len(points), number))["form"]
        lever = np.hstack([normals, np.cross(points - errors.centres_mm[number], normals) / 50])
        exact = SIZES_MM[number] ** 2 * np.exp(-cdist(points, points, "sqeuclidean") / (2 * (CORRELATION_LENGTH * cloud.radius_mm) ** 2))
        followed = np.linalg.qr(lever)[0]  # by a motion of the view; taken from rows and columns, as the whole projector is slow
        exact -= followed @ (followed.T @ exact)
        exact -= (exact @ followed) @ followed.T
        size = float(exact.diagonal().max())
        np.testing.assert_allclose(columns @ columns.T, exact, atol=0.11 * SIZES_MM[number] ** 2)  # a tenth is left out at most
        assert size > 0.05 * SIZES_MM[number] ** 2


def test_views_have_their_own_form_wherever_the_part_is_seen_from() -> None:
    clouds, errors = known()
    points = errors.poses[0].apply(clouds[0].points_mm[::50])
    normals = errors.poses[0].rotate(np.asarray(clouds[0].normals[::50], float))
    first, second = (errors.along(points, normals, np.full(len(points), number))["form"] for number in range(2))
    np.testing.assert_array_equal(first @ second.T, 0)
    moved = RigidTransform.from_vector([0.3, -0.2, 1.0], [10.0, 20, 30], "nominal", "part")
    seen = errors.seen_from(moved).along(moved.apply(points), moved.rotate(normals), np.zeros(len(points), int))["form"]
    np.testing.assert_allclose(seen, first, atol=1e-9)


def test_nodes_that_lie_on_each_other_do_no_harm() -> None:
    nodes = np.array([[0.0, 0, 0], [0, 0, 1e-9], [50, 0, 0]])
    patterns = smooth_basis(np.array([[0.0, 0, 0], [500, 0, 0]]), nodes, 30.0)
    variance = np.sum(patterns**2, axis=1)
    assert abs(variance[0] - 1) < 1e-6 and variance[1] < 1e-6
