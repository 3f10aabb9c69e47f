"""A part under the projector's light: one ray per camera pixel and one shadow ray to the projector."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.open3d_library import open3d
from measureapp.simulate import kernels
from measureapp.simulate.effects.bounce import MOST_CELLS, Bounce, Cells, Exchange, Places, bounce, exchange
from measureapp.simulate.optics import OUTLINE_SAMPLES, ProjectorLight, SeeingCamera, image_box, lens_parameters
from measureapp.simulate.part import Part

PIXELS_AT_ONCE = 2**19
SHADOW_OFFSET_MM = 0.02
PIXEL_BLUR_PX = sqrt(1.0 / 12.0)  # standard deviation of the uniform distribution over a pixel
SAMPLE = 400
CELL_PX = 10.0  # width of a cell of the projector's image; more where the part fills it
FLAT_COSINE = 0.05  # keeps the area that a grazing ray lights finite


class Surface:
    """A part ready for ray casting; its scene is the nominal frame.

    Rays go through the pixel centres, so the blur by the pixel width remains to be applied (``width_px``).
    """

    width_px = PIXEL_BLUR_PX

    def __init__(self, part: Part, depth_mm: float = 0.0) -> None:
        """Prepare a part whose material scatters light back from ``depth_mm`` below its surface."""
        self._depth_mm = depth_mm
        corners = part.mesh.vertices_mm[part.mesh.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self._middles = corners.mean(axis=1)
        self._corner = np.ascontiguousarray(corners[:, 0])
        self._normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        self._material = part.material.astype(np.int64)
        self._materials = np.array([[m.albedo, m.gloss, m.sharpness] for m in part.materials])
        self._bounds = part.mesh.vertices_mm.min(axis=0), part.mesh.vertices_mm.max(axis=0)
        self._scene, self._tensor = _ray_scene(part)

    def sample_mm(self) -> FloatArray:
        """Some points of the part, (N, 3)."""
        return self._middles[:: max(1, len(self._middles) // SAMPLE)]

    def illuminate(self, camera: SeeingCamera, scene_from_camera: RigidTransform, light: ProjectorLight, out: FloatArray) -> None:
        """Compute the light map ``out`` (H, W, 4): projector column and row (NOT_LIT in shadow), reflected light, albedo; else 0."""
        out[:] = 0.0
        low, high = self._bounds
        outline = np.stack(np.meshgrid(*np.linspace(low, high, OUTLINE_SAMPLES).T), axis=-1).reshape(-1, 3)
        box = image_box(camera.pinhole, scene_from_camera.inverse(), outline)
        if box is None:
            return
        pose = np.array(scene_from_camera.matrix)
        rows_at_once = max(1, PIXELS_AT_ONCE // int(box[3] - box[2]))
        for first in range(box[0], box[1], rows_at_once):
            stripe = np.array([first, min(first + rows_at_once, box[1]), box[2], box[3]])
            rays = np.empty(((stripe[1] - stripe[0]) * (stripe[3] - stripe[2]), 6), np.float32)
            light_map = np.empty((len(rays), 4), np.float32)
            kernels.in_bands(kernels.pixel_rays, 0, len(rays), stripe, *camera.parameters, pose, rays)
            self._illuminate_rays(rays, self._triangles(rays), light, light_map)
            out[stripe[0] : stripe[1], stripe[2] : stripe[3]] = light_map.reshape(stripe[1] - stripe[0], -1, 4)

    def _illuminate_rays(self, rays: FloatArray, triangles: IntArray, light: ProjectorLight, out: FloatArray) -> None:
        shadow_rays = np.empty_like(rays)
        kernels.in_bands(
            kernels.light_surface,
            0,
            len(rays),
            rays,
            triangles,
            self._corner,
            self._normals,
            self._material,
            self._materials,
            light.position,
            light.from_scene,
            *lens_parameters(light.pinhole),
            light.standoff_mm,
            SHADOW_OFFSET_MM,
            self._depth_mm,
            out,
            shadow_rays,
        )
        kernels.in_bands(kernels.darken_shadows, 0, len(rays), self._hidden(shadow_rays), out)

    def exchange(self, light: ProjectorLight) -> Exchange | None:
        """Return what the surface that the projector lights scatters to itself; None if nothing of it faces the rest."""
        coarse = self._cells(light, CELL_PX)
        size = CELL_PX * sqrt(max(1.0, len(coarse.rows) / MOST_CELLS))
        return exchange(coarse if size == CELL_PX else self._cells(light, size), self._hidden)

    def second_light(
        self, camera: SeeingCamera, scene_from_camera: RigidTransform, between: Exchange, light_map: FloatArray, strength: float
    ) -> Bounce:
        """Return the light that a camera sees by way of other surfaces."""
        pose = np.array(scene_from_camera.matrix)

        def places(rows: IntArray, columns: IntArray) -> Places:
            rays = np.empty((len(rows), 6), np.float32)
            for i, (row, column) in enumerate(zip(rows, columns, strict=True)):
                kernels.pixel_rays(0, 1, np.array([row, row + 1, column, column + 1]), *camera.parameters, pose, rays[i : i + 1])
            return self._places(rays)[0]

        return bounce(between, light_map, places, pose[:3, 3], self._hidden, strength)

    def _cells(self, light: ProjectorLight, size_px: float) -> Cells:
        """Divide the projector's image into cells of about ``size_px``, and return those that light the surface."""
        pinhole = light.pinhole
        grid = round(pinhole.height_px / size_px), round(pinhole.width_px / size_px)
        row, column = (index.ravel() for index in np.indices(grid))
        height, width = pinhole.height_px / grid[0], pinhole.width_px / grid[1]
        directions = light.scene_from_projector.rotate(pinhole.rays(np.column_stack([(column + 0.5) * width, (row + 0.5) * height]) - 0.5))
        rays = np.hstack([np.broadcast_to(light.position, directions.shape), directions]).astype(np.float32)
        places, distance = self._places(rays)
        met = np.isfinite(distance)
        places, distance = Places(*(values[met] for values in places)), distance[met]
        along_axis = directions[met] @ light.scene_from_projector.rotation[:, 2]
        solid_angle = along_axis**3 * width * height / (pinhole.matrix[0, 0] * pinhole.matrix[1, 1])
        cosine = np.maximum(-np.einsum("ij,ij->i", places.normals, directions[met]), FLAT_COSINE)
        irradiance = cosine * (light.standoff_mm / distance) ** 2
        area = solid_angle * distance**2 / cosine
        return Cells(grid, (pinhole.height_px, pinhole.width_px), row[met], column[met], places, area, places.materials[:, 0] * irradiance)

    def _places(self, rays: FloatArray) -> tuple[Places, FloatArray]:
        """Return where rays (N, 6) meet the surface, and after which distance (N,), infinite where they do not."""
        hit = self._scene.cast_rays(self._tensor(rays))
        distance = hit["t_hit"].numpy()
        triangles = np.minimum(hit["primitive_ids"].numpy(), len(self._normals) - 1)
        normals = self._normals[triangles]
        facing = np.sign(-np.einsum("ij,ij->i", normals, rays[:, 3:]))[:, None]
        points = rays[:, :3] + np.where(np.isfinite(distance), distance, 0.0)[:, None] * rays[:, 3:]
        return Places(points, normals * facing, self._materials[self._material[triangles]]), distance

    def _triangles(self, rays: FloatArray) -> IntArray:
        return self._scene.cast_rays(self._tensor(rays))["primitive_ids"].numpy()

    def _hidden(self, shadow_rays: FloatArray) -> BoolArray:
        return self._scene.test_occlusions(self._tensor(shadow_rays), tnear=0.0, tfar=1.0).numpy()


def _ray_scene(part: Part) -> tuple[Any, Callable[[FloatArray], Any]]:
    tensor: Callable[[Any], Any] = open3d().core.Tensor.from_numpy
    scene = open3d().t.geometry.RaycastingScene()
    scene.add_triangles(tensor(part.mesh.vertices_mm.astype(np.float32)), tensor(part.mesh.triangles.astype(np.uint32)))
    return scene, tensor
