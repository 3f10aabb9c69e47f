"""Software rendering of surfaces and clouds (splats) into a depth buffer, without a graphics system."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.open3d_library import open3d

SUPERSAMPLING = 2
MARGIN = 1.06
SURFACE_COLOUR = np.array([0.74, 0.78, 0.80])
KEY_LIGHT = np.array([-0.45, 0.55, 0.70])  # in the view's frame: right, up, towards the viewer
FILL_LIGHT = np.array([0.70, 0.10, 0.70])
OUTLINE_JUMP = 0.012  # depth jump, as a share of the picture's height, that draws an outline
LARGEST_SPLAT_PX = 4
PNG_LEVEL = 4  # of 9; higher ones take twice as long for 6 % less


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
        low, high = _extent(points_mm, axes)
        extent = np.maximum(high - low, 1e-6) * MARGIN
        return cls(axes, (low + high) / 2, max(extent[0] / width, extent[1] / height), width, height)

    def place(self, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return where points (N, 3) lie in the picture, as shares (N, 2) from its top left, and how near they are to the viewer (N,)."""
        seen = points_mm @ self.axes.T - self.centre
        right = 0.5 + seen[:, 0] / (self.mm_per_px * self.width)
        down = 0.5 - seen[:, 1] / (self.mm_per_px * self.height)
        return np.column_stack([right, down]), seen[:, 2]


@dataclass(frozen=True, eq=False)
class Seen:
    """What each pixel of a picture shows of a scene; arrays of the H × W pixels, twice as fine as the finished picture."""

    scene: SurfaceScene
    frame: Frame
    depth: FloatArray  # (H, W), from a plane before the mesh; infinite beside it
    triangle: IntArray  # (H, W)
    weights: FloatArray  # (H, W, 3), of the triangle's corners

    @property
    def hit(self) -> BoolArray:
        """Whether a pixel shows the mesh (H, W)."""
        return np.isfinite(self.depth)

    @cached_property
    def pixels(self) -> IntArray:
        """Flat indices (N,) of the pixels that show the mesh, row by row."""
        return np.flatnonzero(self.hit)

    @cached_property
    def shade(self) -> FloatArray:
        """Brightness (N,) of the pixels that show the mesh."""
        return _shade(self.scene.normals_at(self), self.frame)


class SurfaceScene:
    """A mesh that is drawn several times."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self._triangles: IntArray = np.asarray(mesh.triangles, dtype=np.int64)
        self._used_mm = mesh.vertices_mm[np.bincount(self._triangles.ravel(), minlength=len(mesh.vertices_mm)) > 0]
        self._origin = self._used_mm.mean(axis=0)
        self._seen: dict[tuple[ViewDirection, int, int], Seen] = {}  # several pictures of a report show one view

    @cached_property
    def _scene(self) -> Any:
        """The search structure for rays."""
        o3d = open3d()
        scene = o3d.t.geometry.RaycastingScene()
        vertices = (self.mesh.vertices_mm - self._origin).astype(np.float32)
        scene.add_triangles(o3d.core.Tensor.from_numpy(vertices), o3d.core.Tensor.from_numpy(self.mesh.triangles.astype(np.uint32)))
        return scene

    def see(self, direction: ViewDirection, width: int, height: int) -> Seen:
        """Return what each pixel of a picture of ``width`` × ``height`` shows; found once for each view."""
        view = direction, width, height
        if view not in self._seen:
            self._seen[view] = self._look(*view)
        return self._seen[view]

    def _look(self, direction: ViewDirection, width: int, height: int) -> Seen:
        from measureapp.report.kernels import draw_triangles

        frame = Frame.around(self._used_mm, direction, width * SUPERSAMPLING, height * SUPERSAMPLING)
        places = self.mesh.vertices_mm @ frame.axes.T - frame.centre
        near = _extent(self._used_mm, frame.axes)[1][2] - frame.centre[2] + 1.0
        column = places[:, 0] / frame.mm_per_px + frame.width / 2 - 0.5
        row = frame.height / 2 - 0.5 - places[:, 1] / frame.mm_per_px
        corners, size = np.column_stack([column, row, near - places[:, 2]]), (frame.height, frame.width)
        depth, triangle, weights = np.full(size, np.inf), np.zeros(size, np.int64), np.zeros((*size, 3))
        draw_triangles(corners, self._triangles, depth, triangle, weights)
        return Seen(self, frame, depth, triangle, weights)

    def occluded(self, points_mm: FloatArray, towards: FloatArray, lift_mm: float) -> BoolArray:
        """Return which points (N, 3) the mesh hides from a viewer in direction ``towards``."""
        tensor = open3d().core.Tensor.from_numpy
        starts = points_mm - self._origin + lift_mm * towards
        rays = np.concatenate([starts, np.broadcast_to(towards, starts.shape)], axis=1).astype(np.float32)
        hidden: BoolArray = self._scene.test_occlusions(tensor(rays)).numpy()
        return hidden

    def at_corners(self, seen: Seen, values: FloatArray) -> FloatArray:
        """Return values of vertices (V, K), interpolated at the pixels that show the mesh (N, K)."""
        return _interpolated(seen, values, self._triangles)

    def normals_at(self, seen: Seen) -> FloatArray:
        """Return smooth normals (N, 3) at the pixels that show the mesh."""
        return _interpolated(seen, self._normals, np.arange(self._triangles.size).reshape(-1, 3))

    @cached_property
    def _normals(self) -> FloatArray:
        """Smooth normals (3T, 3) at the corners of each triangle, not smoothed over creases.

        Neighbours are weighted by area and by the cosine to the triangle's own normal, so that those across an edge do not contribute:
        Σ area · n (n·own) = M own with one matrix M = Σ area · n nᵀ per vertex.
        """
        from measureapp.report.kernels import smooth_normals

        vertices, normals = self.mesh.vertices_mm, np.empty((self._triangles.size, 3))
        smooth_normals(vertices, self._triangles, np.zeros((len(vertices), 3, 3)), normals)
        return normals

    def picture(self, seen: Seen, colours: FloatArray | None = None, *, lit: bool = True) -> ImageArray:
        """Return the picture (H/2, W/2, 3) uint8 on white.

        Parameters
        ----------
        colours : (N, 3) in 0…1 of the pixels that show the mesh; None: one colour for all
        lit : False shows the colours as they are, for a scale beside them
        """
        colour = np.tile(SURFACE_COLOUR, (len(seen.pixels), 1)) if colours is None else colours
        shade = seen.shade if lit else np.ones(len(seen.pixels))
        return _finish(colour, shade, seen.depth, seen.frame)


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
    shade = np.full(len(seen), 0.9) if normals is None else _shade(np.asarray(normals, float)[facing], frame)
    colour = np.tile(SURFACE_COLOUR, (len(seen), 1)) if colours is None else colours[facing]
    column = np.clip(np.rint(seen[:, 0] / frame.mm_per_px + width / 2).astype(int), 0, width - 1)
    row = np.clip(np.rint(height / 2 - seen[:, 1] / frame.mm_per_px).astype(int), 0, height - 1)
    nearest = _splat(row, column, seen[:, 2], frame)
    filled = nearest >= 0
    shown = nearest[filled]
    depth = np.full((height, width), np.inf)
    depth[filled] = -seen[shown, 2]
    return _finish(colour[shown], shade[shown], depth, frame)


def _extent(points_mm: FloatArray, axes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the lowest and highest coordinates (3,) of points along axes; one axis at a time, as NumPy is slow along short rows."""
    along = [points_mm @ axis for axis in axes]
    return np.array([one.min() for one in along]), np.array([one.max() for one in along])


def _interpolated(seen: Seen, values: FloatArray, triangles: IntArray) -> FloatArray:
    """Return values (V, K) at the corners of triangles, interpolated at the pixels that show the mesh (N, K)."""
    from measureapp.report.kernels import interpolate

    made = np.empty((len(seen.pixels), values.shape[1]))
    interpolate(values, triangles, seen.pixels, seen.triangle.reshape(-1), seen.weights.reshape(-1, 3), made)
    return made


def _shade(normals: FloatArray, frame: Frame) -> FloatArray:
    """Return the brightness (N,) of surfaces with ``normals`` (N, 3)."""
    key, fill = (np.clip(normals @ (frame.axes.T @ light / np.linalg.norm(light)), 0, 1) for light in (KEY_LIGHT, FILL_LIGHT))
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


def _finish(colours: FloatArray, shade: FloatArray, depth_mm: FloatArray, frame: Frame) -> ImageArray:
    """Return the picture of coloured pixels (N, 3) and their brightness (N,) where there is a depth (H, W): with outlines, averaged down."""
    from measureapp.report.kernels import average

    height_mm = frame.height * frame.mm_per_px
    far = float(np.max(depth_mm, initial=0.0, where=np.isfinite(depth_mm))) + 0.2 * height_mm
    made = np.empty((frame.height // SUPERSAMPLING, frame.width // SUPERSAMPLING, 3), np.uint8)
    average(colours, shade, depth_mm, OUTLINE_JUMP * height_mm, far, SUPERSAMPLING, made)
    return made


def png(image: ImageArray) -> bytes:
    """Return an image (H, W, 3) uint8 as PNG."""
    return cv2.imencode(".png", image[..., ::-1], [cv2.IMWRITE_PNG_COMPRESSION, PNG_LEVEL])[1].tobytes()
