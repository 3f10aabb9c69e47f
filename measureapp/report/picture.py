"""Software rendering of surfaces (ray casting) and clouds (splatting into a depth buffer), without a graphics system."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
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
class _Frame:
    """Orthographic mapping between the part and the picture."""

    axes: FloatArray
    centre: FloatArray  # (3,) in the view's frame
    mm_per_px: float
    width: int
    height: int

    @classmethod
    def around(cls, points_mm: FloatArray, direction: ViewDirection, width: int, height: int) -> _Frame:
        """Frame all ``points_mm`` with a margin."""
        axes = direction.axes()
        seen = points_mm @ axes.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        extent = np.maximum(high - low, 1e-6) * MARGIN
        return cls(axes, (low + high) / 2, max(extent[0] / width, extent[1] / height), width, height)


def surface_picture(
    mesh: Mesh, direction: ViewDirection, width: int = 680, height: int = 480, colours: FloatArray | None = None
) -> ImageArray:
    """Render a mesh, (height, width, 3) uint8 on white; ``colours`` (V, 3) in 0…1 per vertex, or one for all."""
    width, height = width * SUPERSAMPLING, height * SUPERSAMPLING
    frame = _Frame.around(mesh.vertices_mm[np.unique(mesh.triangles)], direction, width, height)
    depth, triangle, weights = _cast_rays(mesh, frame)
    hit = np.isfinite(depth)
    image = np.ones((height, width, 3), np.float32)
    seen, share = triangle[hit], weights[hit]
    normals = np.einsum("nk,nkd->nd", share, _shading_normals(mesh)[seen])
    colour = SURFACE_COLOUR if colours is None else np.einsum("nk,nkd->nd", share, colours[np.asarray(mesh.triangles)[seen]])
    image[hit] = colour * _shade(normals @ frame.axes.T)[:, None]
    return _finish(image, np.where(hit, depth, np.inf), frame)


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
    frame = _Frame.around(points_mm, direction, width, height)
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


def _cast_rays(mesh: Mesh, frame: _Frame) -> tuple[FloatArray, IntArray, FloatArray]:
    """Return depth (H, W), triangle (H, W) and barycentric weights (H, W, 3) of the first hit of each pixel."""
    import open3d as o3d

    scene: Any = o3d.t.geometry.RaycastingScene()
    vertices = (mesh.vertices_mm @ frame.axes.T - frame.centre).astype(np.float32)
    scene.add_triangles(o3d.core.Tensor.from_numpy(vertices), o3d.core.Tensor.from_numpy(np.asarray(mesh.triangles).astype(np.uint32)))
    start = float(vertices[:, 2].max()) + 1.0
    rays = np.zeros((frame.height, frame.width, 6), np.float32)
    rays[..., 0] = (np.arange(frame.width) + 0.5 - frame.width / 2) * frame.mm_per_px
    rays[..., 1] = ((frame.height / 2 - 0.5 - np.arange(frame.height)) * frame.mm_per_px)[:, None]
    rays[..., 2], rays[..., 5] = start, -1.0
    answer = scene.cast_rays(o3d.core.Tensor.from_numpy(rays))
    uv = answer["primitive_uvs"].numpy()
    weights = np.concatenate([1 - uv.sum(axis=-1, keepdims=True), uv], axis=-1)
    return answer["t_hit"].numpy(), answer["primitive_ids"].numpy(), weights


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


def _splat(row: IntArray, column: IntArray, towards: FloatArray, frame: _Frame) -> IntArray:
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


def _finish(image: FloatArray, depth_mm: FloatArray, frame: _Frame) -> ImageArray:
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
