"""Software rendering of surfaces and clouds (splats) into a depth buffer, without a graphics system."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.mesh import Mesh

SUPERSAMPLING = 2
MARGIN = 1.06
SURFACE_COLOUR = np.array([0.74, 0.78, 0.80])
KEY_LIGHT = np.array([-0.45, 0.55, 0.70])  # in the view's frame: right, up, towards the viewer
FILL_LIGHT = np.array([0.70, 0.10, 0.70])
OUTLINE_JUMP = 0.012  # depth jump, as a share of the picture's height, that draws an outline
LARGEST_SPLAT_PX = 4


@dataclass(frozen=True, slots=True, eq=False)
class ViewDirection:
    """Viewing direction: azimuth counter-clockwise about z, elevation above the horizon."""

    azimuth_deg: float
    elevation_deg: float

    def axes(self) -> FloatArray:
        """Return the view's axes right, up and towards the viewer as rows (3, 3)."""
        azimuth, elevation = np.radians(self.azimuth_deg), np.radians(self.elevation_deg)
        right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
        back = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        return np.stack([right, np.cross(back, right), back])


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """Orthographic projection of the part onto the picture."""

    axes: FloatArray
    centre: FloatArray  # (3,) in the view's frame
    mm_per_px: float
    width: int
    height: int

    @classmethod
    def around(cls, points_mm: FloatArray, direction: ViewDirection, width: int, height: int) -> Frame:
        """Frame all ``points_mm`` with a margin."""
        axes = direction.axes()
        seen = points_mm @ axes.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        extent = np.maximum(high - low, 1e-6) * MARGIN
        return cls(axes, (low + high) / 2, max(extent[0] / width, extent[1] / height), width, height)

    def place(self, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return where points (N, 3) lie in the picture, as shares (N, 2) from its top left, and how near they are to the viewer (N,)."""
        seen = points_mm @ self.axes.T - self.centre
        right = 0.5 + seen[:, 0] / (self.mm_per_px * self.width)
        down = 0.5 - seen[:, 1] / (self.mm_per_px * self.height)
        return np.column_stack([right, down]), seen[:, 2]


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """What each pixel of a picture shows of a mesh; arrays of the H × W pixels, twice as fine as the finished picture."""

    frame: Frame
    depth: FloatArray  # (H, W), from a plane before the mesh; infinite beside it
    triangle: IntArray  # (H, W)
    weights: FloatArray  # (H, W, 3), of the triangle's corners

    @property
    def hit(self) -> BoolArray:
        """Whether a pixel shows the mesh (H, W)."""
        return np.isfinite(self.depth)


class SurfaceScene:
    """A mesh that is drawn several times."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self._used_mm = mesh.vertices_mm[np.unique(mesh.triangles)]
        self._origin = self._used_mm.mean(axis=0)
        self._normals: FloatArray | None = None

    @cached_property
    def _scene(self) -> Any:
        """The search structure for rays."""
        import open3d as o3d

        scene = o3d.t.geometry.RaycastingScene()
        vertices = (self.mesh.vertices_mm - self._origin).astype(np.float32)
        scene.add_triangles(o3d.core.Tensor.from_numpy(vertices), o3d.core.Tensor.from_numpy(self.mesh.triangles.astype(np.uint32)))
        return scene

    def see(self, direction: ViewDirection, width: int, height: int) -> Seen:
        """Find what each pixel of a picture of ``width`` × ``height`` shows."""
        from measureapp.report.kernels import draw_triangles

        frame = Frame.around(self._used_mm, direction, width * SUPERSAMPLING, height * SUPERSAMPLING)
        places = self.mesh.vertices_mm @ frame.axes.T - frame.centre
        near = float((self._used_mm @ frame.axes[2]).max() - frame.centre[2]) + 1.0
        column = places[:, 0] / frame.mm_per_px + frame.width / 2 - 0.5
        row = frame.height / 2 - 0.5 - places[:, 1] / frame.mm_per_px
        corners, size = np.column_stack([column, row, near - places[:, 2]]), (frame.height, frame.width)
        depth, triangle, weights = np.full(size, np.inf), np.zeros(size, np.int64), np.zeros((*size, 3))
        draw_triangles(corners, np.asarray(self.mesh.triangles, dtype=np.int64), depth, triangle, weights)
        return Seen(frame, depth, triangle, weights)

    def occluded(self, points_mm: FloatArray, towards: FloatArray, lift_mm: float) -> BoolArray:
        """Return which points (N, 3) the mesh hides from a viewer in direction ``towards``."""
        import open3d as o3d

        starts = points_mm - self._origin + lift_mm * towards
        rays = np.concatenate([starts, np.broadcast_to(towards, starts.shape)], axis=1).astype(np.float32)
        hidden: BoolArray = self._scene.test_occlusions(o3d.core.Tensor.from_numpy(rays)).numpy()
        return hidden

    def at_corners(self, seen: Seen, values: FloatArray) -> FloatArray:
        """Return values of vertices (V, K), interpolated at the pixels that show the mesh (N, K)."""
        corners = values[np.asarray(self.mesh.triangles)[seen.triangle[seen.hit]]]
        return np.einsum("nk,nkd->nd", seen.weights[seen.hit], corners)

    def normals_at(self, seen: Seen) -> FloatArray:
        """Return smooth normals (N, 3) at the pixels that show the mesh."""
        if self._normals is None:
            self._normals = _shading_normals(self.mesh)
        return np.einsum("nk,nkd->nd", seen.weights[seen.hit], self._normals[seen.triangle[seen.hit]])

    def picture(self, seen: Seen, colours: FloatArray | None = None, *, lit: bool = True) -> ImageArray:
        """Return the picture (H/2, W/2, 3) uint8 on white.

        Parameters
        ----------
        colours : (N, 3) in 0…1 of the pixels that show the mesh; None: one colour for all
        lit : False shows the colours as they are, for a scale beside them
        """
        colour = np.broadcast_to(SURFACE_COLOUR, (int(seen.hit.sum()), 3)) if colours is None else colours
        image = np.ones((*seen.depth.shape, 3), np.float32)
        image[seen.hit] = colour * _shade(self.normals_at(seen) @ seen.frame.axes.T)[:, None] if lit else colour
        return _finish(image, np.where(seen.hit, seen.depth, np.inf), seen.frame)


def surface_picture(
    mesh: Mesh, direction: ViewDirection, width: int = 680, height: int = 480, colours: FloatArray | None = None
) -> ImageArray:
    """Render a mesh, (height, width, 3) uint8 on white; ``colours`` (V, 3) in 0…1 per vertex, or one for all."""
    scene = SurfaceScene(mesh)
    seen = scene.see(direction, width, height)
    return scene.picture(seen, None if colours is None else scene.at_corners(seen, colours))


def cloud_picture(
    points_mm: FloatArray,
    normals: FloatArray | None,
    direction: ViewDirection,
    width: int = 680,
    height: int = 480,
    colours: FloatArray | None = None,
) -> ImageArray:
    """Render a cloud as small squares in a depth buffer, (height, width, 3) uint8 on white; ``colours`` (N, 3) in 0…1."""
    width, height = width * SUPERSAMPLING, height * SUPERSAMPLING
    frame = Frame.around(points_mm, direction, width, height)
    facing = np.ones(len(points_mm), bool) if normals is None else np.asarray(normals) @ frame.axes[2] > 0
    seen = points_mm[facing] @ frame.axes.T - frame.centre
    shade = np.full(len(seen), 0.9) if normals is None else _shade(np.asarray(normals, float)[facing] @ frame.axes.T)
    colour = (np.broadcast_to(SURFACE_COLOUR, (len(seen), 3)) if colours is None else colours[facing]) * shade[:, None]
    column = np.clip(np.rint(seen[:, 0] / frame.mm_per_px + width / 2).astype(int), 0, width - 1)
    row = np.clip(np.rint(height / 2 - seen[:, 1] / frame.mm_per_px).astype(int), 0, height - 1)
    nearest = _splat(row, column, seen[:, 2], frame)
    image = np.ones((height, width, 3), np.float32)
    filled = nearest >= 0
    image[filled] = colour[nearest[filled]]
    depth = np.full((height, width), np.inf)
    depth[filled] = -seen[nearest[filled], 2]
    return _finish(image, depth, frame)


def _shading_normals(mesh: Mesh) -> FloatArray:
    """Return smooth normals (T, 3, 3) at the corners of each triangle, not smoothed over creases.

    Neighbours are weighted by area and by the cosine to the triangle's own normal, so that those across an edge do not contribute:
    Σ area · n (n·own) = M own with one matrix M = Σ area · n nᵀ per vertex.
    """
    triangles = np.asarray(mesh.triangles)
    corners = mesh.vertices_mm[triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-12)
    own = cross / doubled
    products = np.einsum("ti,tj->tij", own, cross).reshape(-1, 9)
    sums = np.column_stack([np.bincount(triangles.ravel(), np.repeat(products[:, k], 3), len(mesh.vertices_mm)) for k in range(9)])
    smooth = np.einsum("tkij,tj->tki", sums.reshape(-1, 3, 3)[triangles], own)
    return (smooth / np.maximum(np.linalg.norm(smooth, axis=2, keepdims=True), 1e-30)).astype(np.float32)


def _shade(normals: FloatArray) -> FloatArray:
    """Return the brightness (N,) of surfaces with ``normals`` in the view's frame."""
    key = np.clip(normals @ (KEY_LIGHT / np.linalg.norm(KEY_LIGHT)), 0, 1)
    fill = np.clip(normals @ (FILL_LIGHT / np.linalg.norm(FILL_LIGHT)), 0, 1)
    return np.clip(0.34 + 0.62 * key + 0.18 * fill, 0, 1.12)


def _splat(row: IntArray, column: IntArray, towards: FloatArray, frame: Frame) -> IntArray:
    """Return the index (H, W) of the nearest point in each pixel, -1 for none; the squares are large enough to close the surface."""
    spacing = 1.3 * np.sqrt(frame.width * frame.height / 3 / max(len(row), 1))
    reach = int(np.clip(np.ceil(spacing), 1, LARGEST_SPLAT_PX))
    order = np.argsort(towards, kind="stable")  # far to near: the nearest is written last
    nearest = np.full((frame.height, frame.width), -1, np.int64)
    depth = np.full((frame.height, frame.width), -np.inf)
    for down in range(-reach, reach + 1):
        for across in range(-reach, reach + 1):
            r, c = row[order] + down, column[order] + across
            inside = (r >= 0) & (r < frame.height) & (c >= 0) & (c < frame.width)
            layer = np.full((frame.height, frame.width), -1, np.int64)
            layer[r[inside], c[inside]] = order[inside]
            layer_depth = np.where(layer >= 0, towards[layer], -np.inf)
            better = layer_depth > depth
            nearest[better], depth[better] = layer[better], layer_depth[better]
    return nearest


def _finish(image: FloatArray, depth_mm: FloatArray, frame: Frame) -> ImageArray:
    """Darken outlines, average down and convert to 8 bit."""
    far = float(np.max(depth_mm[np.isfinite(depth_mm)], initial=0.0)) + 0.2 * frame.height * frame.mm_per_px
    filled = np.where(np.isfinite(depth_mm), depth_mm, far)
    jump = OUTLINE_JUMP * frame.height * frame.mm_per_px
    outline = np.zeros(depth_mm.shape, bool)
    for axis in (0, 1):
        step = np.diff(filled, axis=axis)
        lower, upper = (slice(None, -1), slice(1, None)) if axis == 0 else ((slice(None), slice(None, -1)), (slice(None), slice(1, None)))
        outline[lower] |= step > jump
        outline[upper] |= step < -jump
    image[outline] *= 0.45
    size = SUPERSAMPLING
    averaged = image.reshape(frame.height // size, size, frame.width // size, size, 3).mean(axis=(1, 3))
    return np.clip(np.rint(averaged * 255), 0, 255).astype(np.uint8)


def png(image: ImageArray) -> bytes:
    """Return an image (H, W, 3) uint8 as PNG."""
    return cv2.imencode(".png", image[..., ::-1], [cv2.IMWRITE_PNG_COMPRESSION, 6])[1].tobytes()
