from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import AxisReadback
from measureapp.errors import FrameMismatch
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import optimise_pose_graph, twist_rotation, twist_shift
from measureapp.register.joint.pose_prior import KinematicPrior
from measureapp.register.pairs.icp import measure_pair, register_pair
from measureapp.register.pairs.prepare import prepare
from measureapp.register.place import number_stations, place

PRIOR = KinematicPrior(0.5, 1e-3, 0.02, 1e-4)


@pytest.fixture(scope="module")
def pair(scanned, impeller_mesh):
    scan = scanned(impeller_mesh, [0.0, 40.0], [45.0], step_mm=0.8)
    return scan, [prepare(cloud, 1.8) for cloud in scan.clouds]


def test_a_pair_is_registered_within_its_stated_uncertainty(pair):
    scan, (a, b) = pair
    truth = scan.truth[0].inverse() @ scan.truth[1]
    off = RigidTransform.from_vector([1e-3, -1e-3, 5e-4], [0.5, -0.4, 0.6], "camera", "camera")
    found = register_pair(a, b, off @ truth, (0, 1), 3.0)
    error = found.target_from_source @ truth.inverse()
    shift = error.apply(np.array(found.centre_mm)) - found.centre_mm
    sigma = np.sqrt(np.diag(np.linalg.inv(found.information)))
    assert np.all(np.abs(shift) < 5 * sigma[:3])
    assert np.linalg.norm(shift) < 0.01
    assert found.residual_mm < 0.05


def test_a_plane_gives_no_information_along_itself(scanned):
    import trimesh

    plate = trimesh.creation.box((100, 100, 10))
    scan = scanned(plate, [0.0, 30.0], [89.0], step_mm=1.0)
    a, b = (prepare(cloud, 2.2) for cloud in scan.clouds)
    found = measure_pair(a, b, scan.truth[0].inverse() @ scan.truth[1], (0, 1), 3.0)
    values = np.linalg.eigvalsh(found.information[:3, :3])
    # across: known better than by one point of each view, and no better than by all of them
    assert 1 / (2 * 0.04**2) < values[2] < len(scan.clouds[1]) / (2 * 0.04**2)
    assert values[1] < 4  # along: no better than the axes


def test_views_of_one_station_share_their_error():
    covariance = PRIOR.covariance(["a", "a", "b"])
    assert covariance[0, 6] == pytest.approx(0.25) and covariance[0, 12] == pytest.approx(0, abs=1e-12)
    assert covariance[0, 0] == pytest.approx(0.25 + 0.02**2)


def test_a_motion_common_to_all_views_adds_no_relative_uncertainty() -> None:
    """The part as a whole known to 5 mm and 0.01 rad, each view in it to 0.02 mm and 1e-4 rad: 4 of 5 parts of the latter remain."""
    generator = np.random.default_rng(3)
    poses = [RigidTransform.from_vector(generator.uniform(-1, 1, 3), generator.uniform(-50, 50, 3), "part", "camera") for _ in range(5)]
    centres = generator.uniform(-40, 40, (5, 3))
    own = np.diag([0.02**2] * 3 + [1e-8] * 3)
    seen = np.vstack([twist_rotation(pose.rotation.T) @ twist_shift(pose.translation_mm, np.zeros(3)) for pose in poses])
    common = seen @ np.diag([25.0] * 3 + [1e-4] * 3) @ seen.T
    about = [
        twist_rotation(pose.rotation.T) @ twist_shift(pose.translation_mm, centre) for pose, centre in zip(poses, centres, strict=True)
    ]
    apart = np.zeros((30, 30))
    for k, change in enumerate(about):
        apart[6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = change @ own @ change.T
    solution = optimise_pose_graph(poses, poses, np.linalg.inv(common + apart), [], centres)
    found = [solution.covariance_of(index) for index in range(len(poses))]
    shift = np.mean([np.trace(one[:3, :3]) for one in found])
    assert shift < 3 * 0.02**2  # less than before: what the views' errors have in common is gone as well
    assert shift > 3 * 0.02**2 * (1 - 6 / 15)  # at most six of the fifteen shifts


def test_without_pairs_the_poses_are_the_axes_own():
    poses = [RigidTransform.from_vector([0.1 * i, 0, 0], [i, 2.0, 3.0], "part", "camera") for i in range(3)]
    solution = optimise_pose_graph(poses, poses, np.linalg.inv(PRIOR.covariance([0, 1, 2])), [], np.zeros((3, 3)))
    for found, given in zip(solution.part_from_camera, poses, strict=True):
        np.testing.assert_allclose(found.matrix, given.matrix, atol=1e-12)


def test_placing_follows_the_frames(pair):
    scan, _ = pair
    placed = place(scan.clouds[0], scan.truth[0])
    assert placed.frame == "part"
    assert scan.distances_mm(np.asarray(placed.points_mm)).max() < 0.5
    with pytest.raises(FrameMismatch):
        place(placed, scan.truth[0])


def test_stations_differ_by_robot_and_guide_but_not_by_the_table():
    pose = RigidTransform.from_vector([0, 1.0, 0], [400.0, 0, 600.0], "base", "flange")
    other = RigidTransform.from_vector([0, 1.2, 0], [400.0, 0, 600.0], "base", "flange")
    states = [AxisReadback(pose, 10, 0), AxisReadback(pose, 10, 1), AxisReadback(pose, 50, 0), AxisReadback(other, 10, 0)]
    assert number_stations(states) == (0, 0, 1, 2)
