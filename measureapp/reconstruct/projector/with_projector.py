"""Reconstruction with a calibrated projector as an inverse camera: with a single camera, or filling what only one camera sees."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PROJECTOR_BIT, PointCloud, concatenate_clouds
from measureapp.data.phase import PhaseMap
from measureapp.data.point_state import PointState
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.reconstruct.projector.fill import FillSettings, ProjectorAgreement, fill_with_projector
from measureapp.reconstruct.projector.lit_camera import LitCamera
from measureapp.reconstruct.projector.one_camera import measure_with_projector, reconstruct_with_projector
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorView:
    """A reconstruction with points of the projector."""

    reconstruction: Reconstruction
    agreement: Mapping[str, ProjectorAgreement]  # camera -> how far the projector's depths lie from those of the cameras
    points: int  # of the projector, marked by PROJECTOR_BIT


def reconstruct_view_with_projector(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    settings: ReconstructSettings | None = None,
    progress: Progress | None = None,
    rectifier: Rectifier | None = None,
    fill: FillSettings | None = None,
) -> ProjectorView:
    """Reconstruct the cameras' pairs, then let the projector fill pixels whose phase no other camera has; or use one camera and the projector alone.

    Parameters
    ----------
    phase_maps, cameras, settings, progress, rectifier : as for `reconstruct`
    fill : when the projector may fill; None for the defaults

    Raises
    ------
    ReconstructError
        The projector is not calibrated, or from `reconstruct` and `reconstruct_with_projector`.
    """
    settings, progress = settings or ReconstructSettings(), progress or NoProgress()
    rectifier = rectifier or Rectifier(cameras)
    seen = [name for name in cameras.names if name in phase_maps]
    if len(seen) == 1:
        return _alone(LitCamera.of(phase_maps[seen[0]], cameras, settings, rectifier))
    made = reconstruct(phase_maps, cameras, settings, PartOf(progress, 0.0, 0.8), rectifier)
    clouds, states, rejected = [made.cloud], dict(made.states), dict(made.rejected)
    agreement, added = {}, 0
    for name, state in made.states.items():
        progress.report(4, 5, f"filling {name}")
        depth, sigma = _depth_of(name, made.cloud, cameras, state.shape)
        lit = LitCamera.of(phase_maps[name], cameras, settings, rectifier)
        filled = fill_with_projector(depth, sigma, lit, state == PointState.UNMATCHED, fill)
        agreement[name] = filled.agreement
        clouds.append(filled.cloud)
        states[name] = read_only(np.where(filled.filled, np.uint8(PointState.VALID), state))
        rejected["unmatched"] = rejected.get("unmatched", 0) - len(filled.cloud)
        added += len(filled.cloud)
    return ProjectorView(replace(made, cloud=concatenate_clouds(clouds), states=states, rejected=rejected), agreement, added)


def _alone(lit: LitCamera) -> ProjectorView:
    made = reconstruct_with_projector(lit)
    return ProjectorView(
        Reconstruction(made.cloud, (), made.rejected, {lit.camera.name: made.state}, {lit.camera.name: made.max_sigma_mm}),
        {},
        len(made.cloud),
    )


def reconstruct_alone(
    phase_map: PhaseMap, cameras: CameraArrayCalibration | None = None, settings: ReconstructSettings | None = None
) -> Reconstruction:
    """Reconstruct a single camera: with a calibrated projector its points, without one an empty cloud.

    Parameters
    ----------
    cameras : the calibration; None where there is none

    Raises
    ------
    ReconstructError
        The camera is not in the calibration, or its images have another size.
    """
    if cameras is not None and cameras.projector is not None:
        made = measure_with_projector(LitCamera.of(phase_map, cameras, settings))
        return Reconstruction(made.cloud, (), made.rejected, {phase_map.camera: made.state}, {phase_map.camera: made.max_sigma_mm})
    state = np.where(phase_map.valid, np.uint8(PointState.UNMATCHED), np.uint8(PointState.NO_PHASE))
    nothing = np.zeros((0, 3))
    empty = PointCloud(
        nothing, nothing, np.zeros(0), np.zeros(0), np.zeros((0, 2), np.int32), np.zeros(0, np.uint8), "camera", phase_map.viewpoint_id
    )
    return Reconstruction(empty, (), {"unmatched": int(phase_map.valid.sum())}, {phase_map.camera: read_only(state)})


def _depth_of(name: str, cloud: PointCloud, cameras: CameraArrayCalibration, shape: tuple[int, ...]) -> tuple[FloatArray, FloatArray]:
    """Return depth and its standard deviation (H, W) of the points on the grid of one camera; 0 for none."""
    bit = 1 << cameras.names.index(name)
    first = cloud.cameras & ~np.uint8(PROJECTOR_BIT)
    own = (first & -first.astype(np.int16)) == bit  # the lowest bit is the camera that saw the point first
    points = cameras.cameras[name].reference_from_camera.inverse().apply(cloud.points_mm[own])
    rows, columns = cloud.pixel[own, 0], cloud.pixel[own, 1]
    depth, sigma = np.zeros(shape, np.float32), np.zeros(shape, np.float32)
    depth[rows, columns] = points[:, 2]
    sigma[rows, columns] = cloud.sigma_mm[own] * points[:, 2] / np.maximum(np.linalg.norm(points, axis=1), 1e-9)
    return depth, sigma
