"""Cleaning of a depth map on the pixel grid: flying pixels, islands, outliers, grazing and uncertain points. Also its normals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.reconstruct import kernels
from measureapp.reconstruct.settings import ReconstructSettings

ONE_SURFACE_DEG = 80.0


@dataclass(frozen=True, slots=True, eq=False)
class CleanDepth:
    """What is left."""

    depth_mm: FloatArray  # (H, W) float32, 0 for none
    normals: FloatArray  # (H, W, 3) float32, in the camera's frame, towards it
    rejected: dict[str, int]  # reason -> count


@dataclass(frozen=True, slots=True, eq=False)
class LocalPlanes:
    """The plane through the window of every point."""

    normals: FloatArray  # (H, W, 3) float32
    residual_mm: FloatArray  # (H, W) float32, depth minus that of the plane
    neighbours: IntArray  # (H, W) uint8, points of the window on the same surface


@dataclass(frozen=True, slots=True, eq=False)
class Partner:
    """Another camera that takes part in points."""

    centre_mm: FloatArray  # (3,) in the frame of the camera whose depth map it is
    takes_part: BoolArray  # (H, W)


def clean(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    rays: FloatArray,
    spacing: float,
    partners: Sequence[Partner],
    settings: ReconstructSettings,
) -> CleanDepth:
    """Remove what cannot be trusted and count it by reason; each filter sees what the ones before it left.

    Parameters
    ----------
    depth_mm, sigma_mm : (H, W) float32, 0 where there is no point
    rays : (H, W, 2) float32, normalised image coordinates
    spacing : distance of neighbouring pixels in normalised coordinates
    partners : the other cameras; what one of them sees at a grazing angle is mostly the border of another surface
    """
    depth = depth_mm.copy()
    steepest = _steepest(settings)
    rejected: dict[str, int] = {}

    def reject(reason: str, bad: BoolArray) -> None:
        gone = bad & (depth > 0)
        rejected[reason] = int(gone.sum())
        depth[gone] = 0

    reject("uncertain", sigma_mm > settings.max_sigma_mm)
    planes = local_planes(depth, sigma_mm, rays, spacing, settings)
    reject("flying", planes.neighbours < settings.min_neighbours)
    edge_mm = settings.outlier_slope * settings.normal_radius_px * spacing * depth
    cosine = _cosine(planes.normals, rays)
    reject("outlier", np.abs(planes.residual_mm) * cosine > settings.outlier_sigmas * sigma_mm + edge_mm)
    reject("grazing", cosine < np.cos(np.radians(settings.max_incidence_deg)))
    for partner in partners:
        grazing = _cosine_from(partner.centre_mm, planes.normals, rays, depth) < np.cos(np.radians(settings.max_partner_incidence_deg))
        reject("grazing for a partner", grazing & partner.takes_part)
    reject("island", _islands(depth, sigma_mm, spacing, steepest) < settings.min_island_px)
    return CleanDepth(depth, local_planes(depth, sigma_mm, rays, spacing, settings).normals, rejected)


def local_planes(
    depth_mm: FloatArray, sigma_mm: FloatArray, rays: FloatArray, spacing: float, settings: ReconstructSettings
) -> LocalPlanes:
    """Fit a plane to the window of every point, over neighbours that no depth step parts from it."""
    shape = depth_mm.shape
    planes = LocalPlanes(np.empty((*shape, 3), np.float32), np.empty(shape, np.float32), np.empty(shape, np.uint8))
    steepest = _steepest(settings)
    radius = settings.normal_radius_px
    work: Callable[[int, int], None] = lambda start, stop: kernels.fit_planes(  # noqa: E731
        rays,
        depth_mm,
        sigma_mm,
        spacing,
        steepest,
        radius,
        max(1, radius // 2),
        start,
        stop,
        planes.normals,
        planes.residual_mm,
        planes.neighbours,
    )
    in_bands(work, shape[0])
    return planes


def _steepest(settings: ReconstructSettings) -> float:
    """Return the tangent of the steepest slope over which neighbours count as one surface."""
    return float(np.tan(np.radians(max(settings.max_incidence_deg, ONE_SURFACE_DEG))))


def _cosine(normals: FloatArray, rays: FloatArray) -> FloatArray:
    """Return the cosine of the angle between normal and viewing ray."""
    dot = normals[..., 0] * rays[..., 0] + normals[..., 1] * rays[..., 1] + normals[..., 2]
    return np.asarray(-dot / np.sqrt(1 + rays[..., 0] ** 2 + rays[..., 1] ** 2))


def _cosine_from(centre_mm: FloatArray, normals: FloatArray, rays: FloatArray, depth_mm: FloatArray) -> FloatArray:
    """Return the cosine of the angle between normal and the ray of a camera at ``centre_mm``."""
    x, y, z = (np.float32(value) for value in centre_mm)
    to_x, to_y, to_z = x - rays[..., 0] * depth_mm, y - rays[..., 1] * depth_mm, z - depth_mm
    dot = normals[..., 0] * to_x + normals[..., 1] * to_y + normals[..., 2] * to_z
    return np.asarray(dot / np.sqrt(to_x**2 + to_y**2 + to_z**2))


def _islands(depth_mm: FloatArray, sigma_mm: FloatArray, spacing: float, steepest: float) -> IntArray:
    size = np.empty(depth_mm.shape, np.int32)
    kernels.island_sizes(depth_mm, sigma_mm, spacing, steepest, size)
    return size
