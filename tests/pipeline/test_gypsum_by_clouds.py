"""The gypsum part on the rig of the paper, calibrated and scanned without images: its dimensions do not follow the robot's errors."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of, view_uncertainty
from measureapp.data.cloud import StitchedCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.viewpoints import plan_around_part
from measureapp.register.place import stations
from measureapp.register.stitch import stitch
from measureapp.simulate.parts import make_part
from tests.calibrate.paper_rig import RIG, calibrated
from tests.register.conftest import seen
from tests.register.test_stitch import best_fit

SEEDS = range(1, 9)
STEP_MM, NOISE_MM = 0.8, 0.02
FACES = {"a": (0, 90.0), "b": (1, 70.0), "c": (1, 30.0)}  # axis of the drawing, and how far the two faces lie from it


def errors_mm(truth: list[RigidTransform], poses: list[RigidTransform], clouds) -> FloatArray:
    """Return by how much a, b and c are too long by poses alone."""
    samples = [np.asarray(cloud.points_mm)[::3] for cloud in clouds]
    true = np.vstack([pose.apply(sample) for pose, sample in zip(truth, samples, strict=True)])
    placed = np.vstack([pose.apply(sample) for pose, sample in zip(poses, samples, strict=True)])
    off = best_fit(placed, true).apply(placed) - true
    on_walls = (true[:, 2] > 3) & (true[:, 2] < 47)
    return np.array(
        [
            sum(sign * off[on_walls & (np.abs(sign * true[:, axis] - half) < 0.3), axis].mean() for sign in (1, -1))
            for axis, half in FACES.values()
        ]
    )


def scanned(seed: int) -> tuple[FloatArray, FloatArray, StitchedCloud]:
    """Return the errors of a, b and c by the axes and stitched, and what was stitched."""
    import open3d as o3d

    part = make_part("gypsum")
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(
        o3d.core.Tensor(np.asarray(part.mesh.vertices_mm, np.float32)), o3d.core.Tensor(np.asarray(part.mesh.triangles, np.uint32))
    )
    run = calibrated(seed, camera_errors=False, camera_prior_used=False)
    rng = np.random.default_rng([seed, 33])
    plan = plan_around_part(RIG, "gypsum", radius_mm=part.radius_mm, height_mm=part.height_mm, count=8)
    board_on_part = run.cell.truth.table_from_nominal.inverse() @ run.cell.truth.table_from_board
    truth, clouds, readbacks = [], [], []
    for name, readback, camera_from_board in run.cell.placed(tuple(plan)):
        matrix = (board_on_part @ camera_from_board.inverse()).matrix
        truth.append(RigidTransform(matrix, "part", "camera"))
        clouds.append(seen(scene, truth[-1], STEP_MM, NOISE_MM, rng, name))
        readbacks.append(readback)
    covariance = view_uncertainty(uncertainty_of(run.solution), readbacks).pose_covariance
    kinematic = [run.solution.calibration.part_from_camera(readback) for readback in readbacks]
    stitched = stitch(clouds, kinematic, stations=stations(readbacks), prior_covariance=covariance)
    placed = [placement.part_from_camera for placement in stitched.placements]
    return errors_mm(truth, kinematic, clouds), errors_mm(truth, placed, clouds), stitched


@pytest.mark.slow
def test_dimensions_do_not_follow_the_robots_errors() -> None:
    by_axes, stitched, parts = zip(*(scanned(seed) for seed in SEEDS), strict=True)
    assert np.sqrt(np.mean(np.square(by_axes))) > 0.010  # the robot repeats within 0.02 mm at 0.6 m from the part
    # of a face against the opposite one, by the noise and the errors that the pairs show
    sigma = np.sqrt(2) * max(placement.sigma_mm for part in parts for placement in part.placements)
    assert sigma < 0.010
    assert np.abs(stitched).max() < 3 * sigma
    assert np.sqrt(np.mean(np.square(stitched))) < np.sqrt(np.mean(np.square(by_axes))) / 3
    for part in parts:
        assert part.ring is not None
        assert part.ring.gap_mm < 3 * part.ring.sigma_mm and part.ring.sigma_mm < 0.0125
