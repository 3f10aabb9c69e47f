"""Set-ups of a part that was turned over: joined without a hint, and refused where they do not belong together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.register.setups.join import JoinRequest, join_setups
from measureapp.register.setups.setup_cloud import SetUpCloud
from tests.register.setups.conftest import TurnedOver
from tests.register.setups.scanned_setups import NOISE_MM, drum, put, set_up

SAME = ("calibration", "calibration")
COARSE_MM = 1.2  # from point to point, where set-ups are refused: what is in the way is as plain with half of the points


def error_mm(found: RigidTransform, true: RigidTransform) -> float:
    """Largest displacement of a point of the part by the error of a joint."""
    corners = np.array([[x, y, z] for x in (-60.0, 60.0) for y in (-40.0, 40.0) for z in (0.0, 70.0)])
    wrong = RigidTransform(found.matrix @ np.linalg.inv(true.matrix), "part", "part")
    return float(np.linalg.norm(wrong.apply(corners) - corners, axis=1).max())


@pytest.fixture(scope="module")
def joined(turned_over: TurnedOver):
    return join_setups([turned_over.up, turned_over.down], SAME, JoinRequest())


def test_a_part_turned_over_is_joined_without_a_hint(joined, turned_over) -> None:
    setup = joined.setups[1]
    assert error_mm(setup.part_from_setup, turned_over.up_from_down) < 4 * np.hypot(setup.sigma_mm, 80 * np.radians(setup.sigma_deg))
    assert setup.sigma_mm < 0.01
    assert setup.overlap > 0.5


def test_the_joined_cloud_contains_all_views_of_both_in_one_frame(joined, turned_over) -> None:
    import open3d as o3d

    cloud = joined.stitched
    names = [placement.viewpoint_id for placement in cloud.placements]
    assert names == [
        f"{one.name}.{placement.viewpoint_id}" for one in (turned_over.up, turned_over.down) for placement in one.stitched.placements
    ]
    mesh, _ = put(turned_over.mesh, (0.0, 0.0, 0.0))
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(o3d.core.Tensor(np.asarray(mesh.vertices, np.float32)), o3d.core.Tensor(np.asarray(mesh.faces, np.uint32)))
    distances = scene.compute_distance(o3d.core.Tensor(cloud.points_mm.astype(np.float32))).numpy()
    assert np.percentile(distances, 95) < 3 * NOISE_MM
    assert np.ptp(cloud.points_mm[:, 2]) == pytest.approx(np.ptp(np.asarray(mesh.vertices)[:, 2]), abs=1.0)  # edges are rounded by merging


def test_the_joint_is_an_error_of_its_own_that_features_of_one_set_up_do_not_have(joined) -> None:
    cloud = joined.stitched
    assert cloud.errors is not None
    up = np.flatnonzero(cloud.view < 8)[::500]
    down = np.flatnonzero(cloud.view >= 8)[::500]

    def moved(rows: np.ndarray, direction: np.ndarray) -> np.ndarray:
        return cloud.errors.along(cloud.points_mm[rows], np.tile(direction, (len(rows), 1)), cloud.view[rows])["setups"]

    for axis in np.eye(3):
        assert np.abs(moved(up, axis)).max() == 0.0  # the first set-up defines the frame
    first, second = down[0], down[-1]
    apart = cloud.points_mm[second] - cloud.points_mm[first]
    direction = apart / np.linalg.norm(apart)
    within = moved(np.array([second]), direction) - moved(np.array([first]), direction)
    across = moved(np.array([second]), direction)
    assert np.linalg.norm(within) < 1e-9  # a rigid motion changes no distance
    assert np.linalg.norm(across) > 1e-4


def test_different_calibrations_are_independent_and_the_same_one_is_common(joined, turned_over) -> None:
    from measureapp.data.view_errors import POWERS, CloudDistortion
    from measureapp.register.setups.errors import join_errors

    rng = np.random.default_rng(3)
    bend = rng.normal(size=(len(POWERS), 3, 2))
    members = []
    for number, one in enumerate((turned_over.up, turned_over.down)):
        box = CloudDistortion(np.array([0.0, 0.0, 400.0 + 10 * number]), np.array([80.0, 80.0, 60.0]), bend)
        errors = one.stitched.errors
        members.append(replace(errors, distortion=box, calibration_motions=np.zeros((6 * len(errors.poses), 2))))
    common, apart = (join_errors(members, names, joined.joint) for names in (SAME, ("one", "other")))
    assert (common.calibration_motions.shape[1], apart.calibration_motions.shape[1]) == (2, 4)
    place, direction = np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]])
    assert np.abs(apart.along(place, direction, np.array([0]))["calibration"][0, 2:]).max() < 1e-9
    np.testing.assert_allclose(
        common.along(place, direction, np.array([0]))["calibration"][0],
        members[0].along(place, direction, np.array([0]))["calibration"][0],
        atol=1e-6 * np.abs(bend).max(),
    )


def test_another_part_is_refused(turned_over) -> None:
    other = set_up("drum", put(drum(), (0.0, 0.0, 0.0))[0], 3, step_mm=COARSE_MM)
    with pytest.raises(RegistrationError, match=r"up and drum (do not fit in any position|have too little surface in common)"):
        join_setups([turned_over.up, other], SAME, JoinRequest())


def test_set_ups_without_common_surface_are_refused(turned_over) -> None:
    up, down = (cut(one, side) for one, side in ((turned_over.up, 1.0), (turned_over.down, 1.0)))
    with pytest.raises(RegistrationError, match=r"too little surface in common|do not fit|does not determine"):
        join_setups([up, down], SAME, JoinRequest())


def cut(one: SetUpCloud, side: float) -> SetUpCloud:
    """Keep the points that face up: a part that was turned over then has none in common."""
    clouds = []
    for cloud, placement in zip(one.clouds, one.stitched.placements, strict=True):
        facing = placement.part_from_camera.rotate(np.asarray(cloud.normals, float))[:, 2] * side > 0.97
        clouds.append(cloud.where(facing))
    stitched = one.stitched.where(np.asarray(one.stitched.normals)[:, 2] * side > 0.97)
    return SetUpCloud(one.name, stitched, tuple(clouds))


def test_a_rotationally_symmetric_part_is_refused_with_the_motion_or_the_number_of_positions() -> None:
    mesh = drum()
    up = set_up("up", put(mesh, (0.0, 0.0, 0.0))[0], 4, step_mm=COARSE_MM)
    tilted = set_up("tilted", put(mesh, (90.0, 0.0, 0.0))[0], 5, step_mm=COARSE_MM)
    with pytest.raises(RegistrationError, match=r"does not determine: rotation about|positions of tilted relative to up fit equally well"):
        join_setups([up, tilted], SAME, JoinRequest())


def test_a_rough_rotation_far_from_any_position_is_refused(turned_over) -> None:
    with pytest.raises(RegistrationError, match=r"near the stated rotation|do not fit|too little"):
        join_setups([turned_over.up, turned_over.down], SAME, JoinRequest(turned={"down": np.eye(3)}))


def test_a_rough_rotation_finds_the_position_too(turned_over) -> None:
    rough = RigidTransform.from_vector([np.pi, 0, 0], [0, 0, 0], "part", "part").rotation  # 25° about z are missing
    setup = join_setups([turned_over.up, turned_over.down], SAME, JoinRequest(turned={"down": rough})).setups[1]
    assert error_mm(setup.part_from_setup, turned_over.up_from_down) < 0.03
