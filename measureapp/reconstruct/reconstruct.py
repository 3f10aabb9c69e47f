"""From the phase maps of all cameras to one point cloud in the reference camera's frame."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import IntArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.progress import NoProgress, Progress
from measureapp.reconstruct.clean import CleanDepth, Partner, clean
from measureapp.reconstruct.coverage import coverage
from measureapp.reconstruct.match import DepthMap, match_view
from measureapp.reconstruct.rectified_grid import on_rectified_grid
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.triangulate import along_ray, points_on_rays


@dataclass(frozen=True, slots=True)
class PairFigures:
    """How well two cameras matched.

    `epipolar_rms_px`: the points of this pair alone, seen by the other cameras: rms distance, along the epipolar line, between the
    point's image and the place with the point's phase (differences beyond 3 px left out). It holds the calibration's errors and the
    phase noise. With two cameras vertical fringes say nothing across the epipolar lines: then it is None.
    """

    names: tuple[str, str]
    matched: int
    epipolar_rms_px: float | None


@dataclass(frozen=True, slots=True, eq=False)
class Reconstruction:
    """A cloud in frame ``camera`` and how it came about."""

    cloud: PointCloud
    pairs: tuple[PairFigures, ...]
    rejected: Mapping[str, int]  # reason -> count


def reconstruct(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    settings: ReconstructSettings | None = None,
    progress: Progress | None = None,
    rectifier: Rectifier | None = None,
) -> Reconstruction:
    """Match all pairs of cameras and intersect their rays.

    Every pixel of the reference camera gets at most one point: the least-squares solution of all cameras that see its phase there.
    Pixels of the next camera follow where no camera before it sees the surface, and so on.

    Parameters
    ----------
    phase_maps : one per camera of the calibration; cameras without a map are left out
    cameras : calibration of the images' cameras
    settings : None for the defaults
    progress : told after each camera; where the task can be cancelled
    rectifier : of this calibration, to share its maps between calls; None makes one

    Raises
    ------
    ReconstructError
        Fewer than two cameras, or images of another size, pitch or camera than calibrated.
    """
    settings = settings or ReconstructSettings()
    progress = progress or NoProgress()
    rectifier = rectifier or Rectifier(cameras)
    names = _usable_names(phase_maps, cameras)
    if settings.grid == "rectified" or (settings.grid == "auto" and len(names) == 2):
        return _on_rectified_grid(names, phase_maps, rectifier, settings, progress)
    return _reconstruct(names, phase_maps, rectifier, settings, progress)


def _on_rectified_grid(
    names: tuple[str, ...], phase_maps: Mapping[str, PhaseMap], rectifier: Rectifier, settings: ReconstructSettings, progress: Progress
) -> Reconstruction:
    """Reconstruct two cameras with the first one's phase taken to the rectified grid; pixels are named by the real image."""
    if len(names) != 2:
        raise ReconstructError(f"A rectified grid needs two cameras, not {len(names)}.", "Choose the grid of the images.")
    grid, turned = rectifier.rectified(names[0], names[1])
    maps = dict(phase_maps) | {names[0]: on_rectified_grid(phase_maps[names[0]], grid, settings.max_phase_step_rad)}
    made = _reconstruct(names, maps, turned, settings, progress)
    native = np.rint(grid.native[made.cloud.pixel[:, 0], made.cloud.pixel[:, 1]]).astype(np.int32)
    return replace(made, cloud=replace(made.cloud, pixel=native[:, ::-1]))


def _reconstruct(
    names: tuple[str, ...], phase_maps: Mapping[str, PhaseMap], rectifier: Rectifier, settings: ReconstructSettings, progress: Progress
) -> Reconstruction:
    views, clouds, rejected = [], [], Counter[str]()
    for number, name in enumerate(names[:-1]):
        progress.report(number, len(names) - 1, f"matching {name}")
        view = match_view(name, names[number + 1 :], phase_maps, rectifier, settings)
        cloud, reasons = _cloud_of(number, names, view, phase_maps, rectifier, settings)
        views.append(view)
        clouds.append(cloud)
        rejected.update({"unmatched": view.unmatched, "ambiguous": view.ambiguous, "contradicted": view.contradicted})
        rejected.update(reasons)
    progress.report(1, 1, "reconstructed")
    pairs = _pair_figures(names, views)
    return Reconstruction(_joined(clouds), pairs, {reason: int(count) for reason, count in rejected.items()})


def _usable_names(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> tuple[str, ...]:
    strangers = [name for name in phase_maps if name not in cameras.cameras]
    if strangers:
        raise ReconstructError(
            f"Camera {strangers[0]!r} is not in the calibration, which knows {', '.join(cameras.names)}.",
            "Use the calibration of the cameras that took the images.",
        )
    names = tuple(name for name in cameras.names if name in phase_maps)
    if len(names) < 2:
        raise ReconstructError(f"{len(names)} calibrated camera has images; points need two.", "Add the images of a second camera.")
    for name in names:
        pinhole = cameras.cameras[name].pinhole
        height, width = phase_maps[name].phase_rad.shape
        if (width, height) != (pinhole.width_px, pinhole.height_px):
            raise ReconstructError(
                f"Camera {name!r} is calibrated for {pinhole.width_px} × {pinhole.height_px} px, its images have {width} × {height} px.",
                "Use the calibration of the camera and resolution that took the images.",
            )
    kinds = {(phase_maps[name].pitch_px, phase_maps[name].projector_px) for name in names}
    if len(kinds) > 1:
        raise ReconstructError("The phase maps of the cameras are of different pitches.", "Decode the images of one pattern set.")
    return names


def _cloud_of(
    number: int,
    names: tuple[str, ...],
    view: DepthMap,
    phase_maps: Mapping[str, PhaseMap],
    rectifier: Rectifier,
    settings: ReconstructSettings,
) -> tuple[PointCloud, Counter[str]]:
    """Take the points of the ``number``-th camera that no camera before it has."""
    name = names[number]
    rejected: Counter[str] = Counter()
    depth = view.depth_mm
    for earlier in names[:number]:
        seen = coverage(depth, phase_maps[name], phase_maps[earlier], rectifier, settings)
        rejected["contradicted"] += seen.contradicted
        depth = np.where(seen.new, depth, np.float32(0))
        if len(view.matched) == 1:  # the points are of one pair alone: what the earlier camera sees tests that pair
            view.shift_squares[0] += seen.shift_squares
            view.shift_counts[0] += seen.shift_count
    pinhole = rectifier.cameras.cameras[name].pinhole
    partners = _partners(name, names[number + 1 :], view, rectifier)
    cleaned = clean(depth, view.sigma_mm, rectifier.rays(name), 1.0 / float(pinhole.matrix[0, 0]), partners, settings)
    rejected.update(cleaned.rejected)
    return _points(number, names, view, cleaned, phase_maps[name], rectifier), rejected


def _partners(name: str, others: tuple[str, ...], view: DepthMap, rectifier: Rectifier) -> list[Partner]:
    cameras = rectifier.cameras.cameras
    camera_from_reference = cameras[name].reference_from_camera.inverse()
    return [
        Partner(
            camera_from_reference.apply(cameras[other].reference_from_camera.translation_mm), np.asarray((view.others >> place) & 1 == 1)
        )
        for place, other in enumerate(others)
    ]


def _points(
    number: int, names: tuple[str, ...], view: DepthMap, cleaned: CleanDepth, phase_map: PhaseMap, rectifier: Rectifier
) -> PointCloud:
    name, rays = names[number], rectifier.rays(names[number])
    keep = np.asarray(cleaned.depth_mm > 0)
    reference_from_camera = rectifier.cameras.cameras[name].reference_from_camera
    return PointCloud(
        points_mm=reference_from_camera.apply(points_on_rays(rays, cleaned.depth_mm, keep)),
        normals=reference_from_camera.rotate(cleaned.normals[keep]),
        sigma_mm=along_ray(rays, view.sigma_mm, keep),
        grey=np.clip(phase_map.grey[keep] / phase_map.saturation, 0.0, 1.0),
        pixel=np.argwhere(keep),
        cameras=_camera_bits(number, names, view.others[keep], rectifier.cameras.names),
        frame="camera",
        viewpoint_id=phase_map.viewpoint_id,
    )


def _camera_bits(number: int, names: tuple[str, ...], others: IntArray, order: tuple[str, ...]) -> IntArray:
    """Translate the bits of the other cameras of a match into bits in the order of the calibration."""
    bits = np.full(len(others), 1 << order.index(names[number]), np.uint8)
    for place, other in enumerate(names[number + 1 :]):
        bits |= (((others >> place) & 1) << order.index(other)).astype(np.uint8)
    return bits


def _pair_figures(names: tuple[str, ...], views: list[DepthMap]) -> tuple[PairFigures, ...]:
    figures = []
    for number, view in enumerate(views):
        for place, other in enumerate(names[number + 1 :]):
            seen = int(view.shift_counts[place])
            rms = float(np.sqrt(view.shift_squares[place] / seen)) if seen else None
            figures.append(PairFigures((names[number], other), view.matched[place], rms))
    return tuple(figures)


def _joined(clouds: list[PointCloud]) -> PointCloud:
    first = clouds[0]
    return PointCloud(
        points_mm=np.concatenate([cloud.points_mm for cloud in clouds]),
        normals=np.concatenate([cloud.normals for cloud in clouds]),
        sigma_mm=np.concatenate([cloud.sigma_mm for cloud in clouds]),
        grey=np.concatenate([cloud.grey for cloud in clouds]),
        pixel=np.concatenate([cloud.pixel for cloud in clouds]),
        cameras=np.concatenate([cloud.cameras for cloud in clouds]),
        frame=first.frame,
        viewpoint_id=first.viewpoint_id,
    )
