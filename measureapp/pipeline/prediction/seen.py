"""What the pixels of a camera see of the nominal, and where the projector lights it."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.calibration import CameraArrayCalibration, ProjectorCalibration
from measureapp.data.rig import RigDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.surface.nominal import NominalSurface

SHADOW_OFFSET_MM = 0.02  # start of a shadow ray above its surface
OUTLINE_POINTS = 9  # along each edge of the nominal's box, to find its place in an image
MARGIN_PX = 4
PIXELS_AT_ONCE = 500_000  # bounds the memory for full-size images


@dataclass(frozen=True, slots=True)
class Lens:
    """A camera or projector at its place: `nominal_from_lens` takes its frame to the nominal's."""

    pinhole: PinholeCamera
    nominal_from_lens: RigidTransform

    @property
    def position_mm(self) -> FloatArray:
        """The centre of projection, (3,)."""
        return np.asarray(self.nominal_from_lens.translation_mm)


@dataclass(frozen=True, slots=True, eq=False)
class SeenPixels:
    """The pixels of a camera that see the nominal, K of them."""

    row: IntArray  # (K,)
    column: IntArray  # (K,)
    points_mm: FloatArray  # (K, 3), in the nominal's frame
    cosine: FloatArray  # (K,), between the normal and the viewing ray
    projector_px: FloatArray  # (K, 2), column and row of the projector
    lit: BoolArray  # (K,), reached by the projector's light, inside its image
    irradiance: FloatArray  # (K,), of a matt surface, 1 facing the projector at the standoff


def projector_of(cameras: CameraArrayCalibration, rig: RigDescription) -> ProjectorCalibration:
    """Return the calibrated projector, or the one of the rig's description with its nominal pose."""
    if cameras.projector is not None:
        return cameras.projector
    drawn = rig.projector
    head_from_reference = rig.camera(rig.reference).head_from_camera.transform("head", "camera")
    reference_from_projector = head_from_reference.inverse() @ drawn.head_from_projector.transform("head", drawn.name)
    middle = (drawn.width_px - 1) / 2, (drawn.height_px - 1) / 2
    matrix = np.array([[drawn.focal_px, 0.0, middle[0]], [0.0, drawn.focal_px, middle[1]], [0.0, 0.0, 1.0]])
    return ProjectorCalibration(PinholeCamera(drawn.width_px, drawn.height_px, matrix, np.zeros(5)), reference_from_projector)


def see(surface: NominalSurface, camera: Lens, projector: Lens, standoff_mm: float) -> SeenPixels:
    """Cast a ray through every pixel of a camera, and one from each point hit to the projector."""
    row, column = _pixels_of_box(surface, camera)
    starts = range(0, max(len(row), 1), PIXELS_AT_ONCE)
    parts = [
        _see_pixels(surface, camera, projector, standoff_mm, (row[start : start + PIXELS_AT_ONCE], column[start : start + PIXELS_AT_ONCE]))
        for start in starts
    ]
    return SeenPixels(*(np.concatenate([getattr(part, field.name) for part in parts]) for field in fields(SeenPixels)))


def _see_pixels(
    surface: NominalSurface, camera: Lens, projector: Lens, standoff_mm: float, pixels_at: tuple[IntArray, IntArray]
) -> SeenPixels:
    row, column = pixels_at
    rays = camera.nominal_from_lens.rotate(camera.pinhole.rays(np.column_stack([column, row]).astype(float)))
    hits = surface.hits(np.broadcast_to(camera.position_mm, rays.shape), rays)
    triangle, normal = hits.triangles, surface.normals[hits.triangles]
    slope = np.einsum("nd,nd->n", normal, rays)
    kept = np.isfinite(hits.distances_mm) & (slope < 0)
    row, column, rays, triangle, normal, slope = (each[kept] for each in (row, column, rays, triangle, normal, slope))
    corner = surface.vertices_mm[surface.triangles[triangle, 0]]
    # the ray caster's single precision finds the triangle, double precision the point on it
    along = np.einsum("nd,nd->n", normal, corner - camera.position_mm) / slope
    points = camera.position_mm + along[:, None] * rays
    away = projector.position_mm - points
    distance = np.linalg.norm(away, axis=1)
    facing = np.einsum("nd,nd->n", normal, away) / distance
    pixels = projector.pinhole.project(projector.nominal_from_lens.inverse().apply(points))
    size = projector.pinhole.width_px, projector.pinhole.height_px
    lit = (facing > 0) & np.all((pixels > -0.5) & (pixels < np.array(size) - 0.5), axis=1)
    lit[lit] = ~_is_shadowed(surface, points[lit] + SHADOW_OFFSET_MM * normal[lit], projector.position_mm)
    irradiance = np.maximum(facing, 0.0) * (standoff_mm / distance) ** 2
    return SeenPixels(row, column, points, -slope, pixels, lit, irradiance)


def _is_shadowed(surface: NominalSurface, points_mm: FloatArray, light_mm: FloatArray) -> BoolArray:
    away = light_mm - points_mm
    distance = np.linalg.norm(away, axis=1)
    return np.asarray(surface.hits(points_mm, away / np.maximum(distance, 1e-9)[:, None]).distances_mm < distance)


def _pixels_of_box(surface: NominalSurface, camera: Lens) -> tuple[IntArray, IntArray]:
    """Return rows and columns (N,) of the pixels in the image box of the nominal."""
    width, height = camera.pinhole.width_px, camera.pinhole.height_px
    grid = np.stack(np.meshgrid(*np.linspace(surface.low_mm, surface.high_mm, OUTLINE_POINTS).T), axis=-1).reshape(-1, 3)
    outline = camera.nominal_from_lens.inverse().apply(grid)
    low, high = np.zeros(2, int), np.array([width, height])
    if outline[:, 2].max() <= 0:
        high = np.zeros(2, int)
    elif outline[:, 2].min() > 0:
        pixels = camera.pinhole.project(outline)
        low = np.clip(np.floor(pixels.min(axis=0)) - MARGIN_PX, 0, high).astype(int)
        high = np.clip(np.ceil(pixels.max(axis=0)) + MARGIN_PX, 0, high).astype(int)
    row, column = np.meshgrid(np.arange(low[1], high[1]), np.arange(low[0], high[0]), indexing="ij")
    return row.ravel(), column.ravel()
