"""Ray-casting renderer: one ray per camera pixel and one shadow ray to the projector."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, sqrt
from typing import Any

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.geometry.marker_cells import marker_cells
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate import kernels
from measureapp.simulate.options import LightSettings
from measureapp.simulate.part import Part

PIXELS_AT_ONCE = 2**19
SHADOW_OFFSET_MM = 0.02
FLOOR = 0.004  # black level, share of full scale
WHITE, BLACK = 0.85, 0.06  # albedo of the board's print
MARGIN_PX, MARGIN_SHARE = 3.0, 0.005  # around the image box of an object
OUTLINE_SAMPLES = 9
PIXEL_BLUR_PX = sqrt(1.0 / 12.0)  # standard deviation of the uniform distribution over a pixel


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorLight:
    """The projector as the light source of a scene."""

    pinhole: PinholeCamera
    scene_from_projector: RigidTransform
    standoff_mm: float

    @property
    def position(self) -> FloatArray:
        """Position of the light source, (3,)."""
        return np.array(self.scene_from_projector.translation_mm)

    @property
    def from_scene(self) -> FloatArray:
        """Transform from scene to projector, (4, 4)."""
        return np.array(self.scene_from_projector.inverse().matrix)


class Surface:
    """A part ready for ray casting; its scene is the nominal frame.

    Rays go through the pixel centres, so the blur by the pixel width remains to be applied (``width_px``).
    """

    width_px = PIXEL_BLUR_PX

    def __init__(self, part: Part) -> None:
        corners = part.mesh.vertices_mm[part.mesh.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self._corner = np.ascontiguousarray(corners[:, 0])
        self._normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        self._material = part.material.astype(np.int64)
        self._materials = np.array([[m.albedo, m.gloss, m.sharpness] for m in part.materials])
        self._bounds = part.mesh.vertices_mm.min(axis=0), part.mesh.vertices_mm.max(axis=0)
        self._scene, self._tensor = _ray_scene(part)

    def illuminate(self, camera: PinholeCamera, scene_from_camera: RigidTransform, light: ProjectorLight, out: FloatArray) -> None:
        """Compute the light map ``out`` (H, W, 4): projector column and row (NOT_LIT in shadow), reflected light, albedo; else 0."""
        out[:] = 0.0
        low, high = self._bounds
        outline = np.stack(np.meshgrid(*np.linspace(low, high, OUTLINE_SAMPLES).T), axis=-1).reshape(-1, 3)
        box = image_box(camera, scene_from_camera.inverse(), outline)
        if box is None:
            return
        pose = np.array(scene_from_camera.matrix)
        rows_at_once = max(1, PIXELS_AT_ONCE // int(box[3] - box[2]))
        for first in range(box[0], box[1], rows_at_once):
            stripe = np.array([first, min(first + rows_at_once, box[1]), box[2], box[3]])
            rays = np.empty(((stripe[1] - stripe[0]) * (stripe[3] - stripe[2]), 6), np.float32)
            light_map = np.empty((len(rays), 4), np.float32)
            kernels.in_bands(kernels.pixel_rays, 0, len(rays), stripe, *lens_parameters(camera), pose, rays)
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
            out,
            shadow_rays,
        )
        kernels.in_bands(kernels.darken_shadows, 0, len(rays), self._hidden(shadow_rays), out)

    def _triangles(self, rays: FloatArray) -> IntArray:
        return self._scene.cast_rays(self._tensor(rays))["primitive_ids"].numpy()

    def _hidden(self, shadow_rays: FloatArray) -> BoolArray:
        return self._scene.test_occlusions(self._tensor(shadow_rays), tnear=0.0, tfar=1.0).numpy()


def _ray_scene(part: Part) -> tuple[Any, Callable[[FloatArray], Any]]:
    import open3d

    tensor: Callable[[Any], Any] = open3d.core.Tensor.from_numpy
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(tensor(part.mesh.vertices_mm.astype(np.float32)), tensor(part.mesh.triangles.astype(np.uint32)))
    return scene, tensor


class PrintedBoard:
    """A board on a slightly bowed plate; its scene is the board frame. The printed pattern is averaged over the pixels already."""

    width_px = 0.0

    def __init__(self, board: BoardDescription, bow_mm: float) -> None:
        self._board = board
        self._layout, self._cells = _print_layout(board)
        middle = board.middle_mm[:2]
        self._bow = np.array([-bow_mm, *middle, float(np.linalg.norm(middle))])  # the printed side faces -z

    def corners_mm(self) -> FloatArray:
        """The true marks (N, 3) of the bowed board."""
        corners = self._board.corners_mm.copy()
        height, x, y, radius = self._bow
        corners[:, 2] = height * (1.0 - ((corners[:, 0] - x) ** 2 + (corners[:, 1] - y) ** 2) / radius**2)
        return corners

    def illuminate(self, camera: PinholeCamera, scene_from_camera: RigidTransform, light: ProjectorLight, out: FloatArray) -> None:
        """Compute the light map ``out`` as `Surface.illuminate` does; the board casts no shadows."""
        out[:] = 0.0
        margin, (right, bottom) = 2 * self._layout[1], self._board.flat_corners_mm[:, :2].max(axis=0)
        x = np.linspace(-margin, right + margin, OUTLINE_SAMPLES)
        y = np.linspace(-margin, bottom + margin, OUTLINE_SAMPLES)
        outline = np.stack(np.meshgrid(x, y, [0.0]), axis=-1).reshape(-1, 3)
        box = image_box(camera, scene_from_camera.inverse(), outline)
        if box is None or scene_from_camera.translation_mm[2] >= 0.0:
            return
        kernels.in_bands(
            kernels.light_board,
            box[0],
            box[1],
            box,
            *lens_parameters(camera),
            np.array(scene_from_camera.matrix),
            light.position,
            light.from_scene,
            *lens_parameters(light.pinhole),
            light.standoff_mm,
            self._layout,
            self._cells,
            np.array([WHITE, BLACK]),
            self._bow,
            out,
        )


def _print_layout(board: BoardDescription) -> tuple[FloatArray, ImageArray]:
    """Return layout and marker cells of the printed pattern for `kernels.light_board`."""
    none = np.zeros((1, 1, 1, 1), np.uint8)
    if isinstance(board, CirclesDescription):
        return np.array([board.diameter_mm, board.spacing_mm, board.columns, board.rows, 0.0], float), none
    if isinstance(board, CharucoDescription):
        cells = marker_cells(board.columns, board.rows, board.dictionary, board.legacy_pattern)
        return np.array([0.0, board.square_mm, board.columns, board.rows, board.marker_mm], float), cells
    assert isinstance(board, CheckerboardDescription)
    return np.array([0.0, board.square_mm, board.columns, board.rows, 0.0], float), none


def image_box(camera: PinholeCamera, camera_from_scene: RigidTransform, outline_mm: FloatArray) -> IntArray | None:
    """Return first row, end row, first and end column of the image box of ``outline_mm`` (N, 3); None when it is not visible."""
    points = camera_from_scene.apply(outline_mm)
    if points[:, 2].min() <= 0.0:
        whole = np.array([0, camera.height_px, 0, camera.width_px])
        return whole if points[:, 2].max() > 0.0 else None
    pixels = camera.project(points)
    margin = MARGIN_PX + MARGIN_SHARE * camera.width_px
    low = np.maximum(np.floor(pixels.min(axis=0) - margin), 0)
    high = np.minimum(np.ceil(pixels.max(axis=0) + margin), [camera.width_px, camera.height_px])
    return np.array([low[1], high[1], low[0], high[0]], np.int64) if np.all(low < high) else None


def lens_parameters(pinhole: PinholeCamera) -> tuple[FloatArray, FloatArray]:
    """Return (fx, fy, cx, cy) and (k1, k2, p1, p2, k3) for the kernels."""
    m = pinhole.matrix
    coefficients = np.zeros(5)
    coefficients[: len(pinhole.distortion)] = pinhole.distortion
    return np.array([m[0, 0], m[1, 1], m[0, 2], m[1, 2]]), coefficients


def project_images(images: ImageArray | FloatArray, settings: LightSettings) -> FloatArray:
    """Apply response, black level and defocus of the projector to images (n, h, w), levels 0…255 or floats 0…1; light 0…1, float32."""
    levels = images.astype(np.float32) / (255.0 if images.dtype == np.uint8 else 1.0)
    light = settings.black + (1.0 - settings.black) * levels**settings.gamma
    return np.stack([_blur(image, settings.defocus_px) for image in light.astype(np.float32)])


def expose(light: FloatArray, pattern: FloatArray | None, exposure_us: int, settings: LightSettings, width_px: float = 0.0) -> FloatArray:
    """Compute the mean image (H, W) float32, relative to full scale, from the light map of `Surface.illuminate`.

    Parameters
    ----------
    light : (H, W, 4) float32
    pattern : (h, w) light of the projector; None for the head lamp, which illuminates beyond the projector's field
    width_px : standard deviation of the pixel aperture if ``light`` is sampled at pixel centres
    """
    mean = np.empty(light.shape[:2], np.float32)
    scale = exposure_us / settings.reference_exposure_us
    shown = np.zeros((2, 2), np.float32) if pattern is None else pattern * np.float32(settings.projector)
    lamp = settings.lamp if pattern is None else 0.0
    kernels.in_bands(kernels.expose, 0, mean.size, light.reshape(-1, 4), shown, lamp, settings.ambient, scale, FLOOR, mean.reshape(-1))
    return _blur(mean, hypot(settings.lens_blur_px, width_px))


def _blur(image: FloatArray, sigma_px: float) -> FloatArray:
    if sigma_px == 0.0:
        return image
    size = 2 * max(1, round(3.0 * sigma_px)) + 1 if sigma_px > 0.6 else 3
    return np.asarray(cv2.GaussianBlur(image, (size, size), sigma_px, borderType=cv2.BORDER_REPLICATE))
