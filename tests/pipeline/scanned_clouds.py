"""A part on the rig of the paper, calibrated and scanned without images: true surfaces, sampled with stated noise and bent as the cameras err."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.calibrate.rig.cloud_errors import calibration_errors
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of, view_uncertainty
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.measurement import Alignment
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.viewpoints import plan_around_part
from measureapp.register.joint.pose_prior import PosePrior
from measureapp.register.place import number_stations
from measureapp.register.stitch import stitch
from measureapp.simulate.parts import make_part
from tests.calibrate.paper_rig import RIG, Cell, calibrated
from tests.register.conftest import seen


@dataclass(frozen=True)
class ScannedPart:
    """What a scan gave, and how it truly was."""

    truth: list[RigidTransform]  # nominal_from_camera
    kinematic: list[RigidTransform]
    clouds: list[PointCloud]
    stitched: StitchedCloud


def scanned_part(
    seed: int, name: str, *, step_mm: float, noise_mm: float, views: int = 8, camera_errors: bool = True, camera_prior_used: bool = True
) -> ScannedPart:
    """Calibrate rig ``seed``, scan a sample part with it and stitch."""
    import open3d as o3d

    part = make_part(name)
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(
        o3d.core.Tensor(np.asarray(part.mesh.vertices_mm, np.float32)), o3d.core.Tensor(np.asarray(part.mesh.triangles, np.uint32))
    )
    run = calibrated(seed, camera_errors=camera_errors, camera_prior_used=camera_prior_used)
    rng = np.random.default_rng([seed, 33])
    plan = plan_around_part(RIG, name, radius_mm=part.radius_mm, height_mm=part.height_mm, count=views)
    board_on_part = run.cell.truth.table_from_nominal.inverse() @ run.cell.truth.table_from_board
    truth, clouds, readbacks = [], [], []
    for view, readback, camera_from_board in run.cell.placed(tuple(plan)):
        truth.append(RigidTransform((board_on_part @ camera_from_board.inverse()).matrix, "part", "camera"))
        cloud = seen(scene, truth[-1], step_mm, noise_mm, rng, view)
        clouds.append(measured_with(cloud, run.cell.truth.calibration.cameras, run.cameras) if camera_errors else cloud)
        readbacks.append(readback)
    rig = uncertainty_of(run.solution)
    kinematic = [run.solution.calibration.part_from_camera(readback) for readback in readbacks]
    corners = np.stack(
        [np.min([c.points_mm.min(axis=0) for c in clouds], axis=0), np.max([c.points_mm.max(axis=0) for c in clouds], axis=0)]
    )
    stitched = stitch(
        clouds,
        kinematic,
        prior=PosePrior(
            number_stations(readbacks), view_uncertainty(rig, readbacks).pose_covariance, calibration_errors(rig, readbacks, corners)
        ),
    )
    return ScannedPart(truth, kinematic, clouds, stitched)


def measured_with(cloud: PointCloud, true: CameraArrayCalibration, found: CameraArrayCalibration) -> PointCloud:
    """Return the points as cameras see them that are calibrated wrongly: nearest to the rays of all that see them, by ``found``."""
    normal, right, seeing = np.zeros((len(cloud), 3, 3)), np.zeros((len(cloud), 3)), np.zeros(len(cloud), int)
    for name, camera in true.cameras.items():
        pixels = camera.pinhole.project(camera.reference_from_camera.inverse().apply(cloud.points_mm))
        inside = np.all((pixels > -0.5) & (pixels < np.array([camera.pinhole.width_px, camera.pinhole.height_px]) - 0.5), axis=1)
        place = found.cameras[name].reference_from_camera
        rays = place.rotate(found.cameras[name].pinhole.rays(pixels))
        across = (np.eye(3) - rays[:, :, None] * rays[:, None, :]) * inside[:, None, None]
        normal, right, seeing = normal + across, right + across @ place.translation_mm, seeing + inside
    kept = seeing >= 2
    return replace(cloud.where(kept), points_mm=np.linalg.solve(normal[kept], right[kept][..., None])[..., 0])


def placed_in_drawing(seed: int) -> Alignment:
    """Return where the part of rig ``seed`` truly stands: no time is spent on finding its features."""
    nominal_from_table = Cell.of(seed).truth.table_from_nominal.inverse()
    return Alignment("as it was put", RigidTransform(nominal_from_table.matrix, "nominal", "part"), 0.0)
