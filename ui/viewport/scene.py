"""The content of one 3-D view: renderer, actors, and what of them is drawn in each frame."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  isort: skip  (registers what implements the renderer)

from ui.viewport.actors import line_actor, points_actor, surface_actor
from ui.viewport.camera import SceneCamera
from ui.viewport.clip_box import ClipBox
from ui.viewport.frame_budget import FrameBudget, LevelChoice
from ui.viewport.layers import LineLayer
from ui.viewport.point_index import PointIndex
from ui.viewport.point_size import point_size_px
from ui.viewport.prepared_surface import PreparedSurface, SurfacePart
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle
from ui.viewport.voxel_grid import Level

FRAMING_POINTS = 4_000
CLOSEST_MM, ROOM = 15.0, 1.8
SPLAT, LARGEST_SPLAT_PX = 1.5, 32.0  # size of the points of a level, in edges of its cubes
TRIANGLE_COST = 1.2  # of a triangle, in points
TRANSPARENT = 0.35
LIGHT_FROM = (-0.35, 0.5, 1.0)  # right, up and back of the focal point, in the frame of the eye


class Scene:
    """Clouds, surfaces and lines in one renderer; independent of the window that draws it."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.AddLight(_light())
        self.renderer.GradientBackgroundOn()
        self.camera = SceneCamera(self.renderer)
        self.budget, self.choice = FrameBudget(), LevelChoice()
        self.cloud = shuffle(())
        self.index: PointIndex | None = None
        self.clip: ClipBox | None = None
        self.is_transparent = self.has_edges = False
        self._surface: PreparedSurface | None = None
        self._blocks: list[vtkActor] = []  # of points
        self._parts: list[vtkActor] = []  # of the surface; drawn before the points
        self._lines: list[vtkActor] = []
        self._surface_proxy: vtkActor | None = None  # instead of the surface while the camera moves
        self._cloud_proxy: vtkActor | None = None  # instead of the points
        self._levels: list[tuple[Level, vtkActor]] = []
        self._costs = np.empty(0, np.int64)  # cumulative cost of the parts and the blocks, in points
        self._ends = np.empty(0, np.int64)  # cumulative number of points at the end of each block
        self._drawn = 0  # pieces drawn in the picture
        self._shown = slice(0, 0)  # pieces of the present frame
        self._size_px = 1.0
        self._moving, self._moving_cost = False, 0  # cost of a frame of the moving camera, in points
        self._extent: dict[str, np.ndarray] = {}

    @property
    def is_moving(self) -> bool:
        """Whether the camera is being moved."""
        return self._moving

    def set_background(self, top: tuple[float, float, float], bottom: tuple[float, float, float]) -> None:
        """Set the colours (0…1) of the background."""
        self.renderer.SetBackground(bottom)
        self.renderer.SetBackground2(top)

    def set_cloud(self, cloud: ShuffledCloud) -> None:
        """Replace the points; their index and their proxy are dropped."""
        self.cloud, self._extent["clouds"] = cloud, cloud.points_mm[:FRAMING_POINTS].astype(float)
        self._remove([*self._blocks, *(actor for _, actor in self._levels)])
        self.index, self._levels = None, []
        self.set_cloud_proxy(None)
        parts = cloud.blocks()
        self._ends = np.array([part.stop for part in parts], np.int64)
        self._blocks = self._add([points_actor(cloud.points_mm[part], cloud.colours[part]) for part in parts])
        self._begin_anew()

    def set_index(self, index: PointIndex) -> None:
        """Use what was prepared for the points; ignored if they have changed since."""
        if index.cloud is not self.cloud:
            return
        self._remove([actor for _, actor in self._levels])
        self.index, self.choice = index, LevelChoice()
        actors = self._add([points_actor(level.points_mm, level.colours) for level in index.levels])
        self._levels = list(zip(index.levels, actors, strict=True))

    def set_cloud_proxy(self, surface: PreparedSurface | None) -> None:
        """Draw this surface in place of the points while the camera moves."""
        self._remove([] if self._cloud_proxy is None else [self._cloud_proxy])
        part = None if surface is None else _coarse_part(surface)
        self._cloud_proxy = None if surface is None or part is None else self._add([surface_actor(part, surface.layer)])[0]

    def set_surface(self, surface: PreparedSurface | None) -> None:
        """Replace the surface."""
        self._remove([*self._parts, *([] if self._surface_proxy is None else [self._surface_proxy])])
        self._surface, self._parts, self._surface_proxy = surface, [], None
        self._extent["surface"] = np.empty((0, 3)) if surface is None else _subsample(surface.layer.vertices_mm)
        if surface is not None:
            self._parts = self._add([surface_actor(part, surface.layer) for part in surface.parts])
            if surface.proxy is not None:
                self._surface_proxy = self._add([surface_actor(surface.proxy, surface.layer)])[0]
            self.show_surface_as(transparent=self.is_transparent, edges=self.has_edges)
        self._begin_anew()

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Replace the lines."""
        lines = [line for layer in layers for line in layer.lines]
        self._extent["lines"] = np.concatenate([np.empty((0, 3)), *(_subsample(line) for line in lines)])
        self._remove(self._lines)
        self._lines = self._add([line_actor(layer) for layer in layers if layer.lines])

    def show_surface_as(self, *, transparent: bool, edges: bool) -> None:
        """Draw the surface transparent, or with the edges of its triangles."""
        self.is_transparent, self.has_edges = transparent, edges
        for actor in (*self._parts, *([] if self._surface_proxy is None else [self._surface_proxy])):
            opacity = 1.0 if self._surface is None else self._surface.layer.opacity
            actor.GetProperty().SetOpacity(min(opacity, TRANSPARENT) if transparent else opacity)
            actor.GetProperty().SetEdgeVisibility(edges)

    def set_clip(self, clip: ClipBox | None) -> None:
        """Hide what is outside a box; lines are clipped, too."""
        self.clip = clip
        for actor in self._all_actors():
            self._clip_actor(actor)

    def set_moving(self, moving: bool) -> None:
        """Draw what one frame has time for while the camera moves, everything at rest."""
        self._moving = moving

    def begin_picture(self) -> None:
        """Start a new picture: the next frame clears it and draws as much as its time allows."""
        self._set_preserved(False)
        self._drawn = 0
        bounds = self.bounds_mm()
        if self.camera.keep_framed:
            self.camera.reset([points for points in self._extent.values() if len(points)])
        self.camera.set_clipping_range(bounds)
        for actor in self._all_actors():
            actor.VisibilityOff()
        self._shown = slice(0, 0)
        if self._moving:
            self._show_moving()
        else:
            self._show_next(self.budget.points)
        for actor in self._lines:
            actor.VisibilityOn()
        self.renderer.SetUseFXAA(False)

    def go_on(self) -> None:
        """Continue the picture: the next frame adds more; see `is_complete`."""
        self._set_preserved(True)
        for actor in self._lines:
            actor.VisibilityOff()
        self._show_next(self.budget.points)

    def observe(self, seconds: float) -> None:
        """Learn from the time that the present frame took."""
        if not self._moving or not (self._levels or self._cloud_proxy):
            self.budget.observe(self.frame_points, seconds)
        elif self._cloud_proxy is None:
            self.choice.observe(seconds)

    @property
    def is_complete(self) -> bool:
        """Whether everything is drawn; during motion one frame is sufficient."""
        return self._moving or self._drawn >= len(self._pieces())

    @property
    def is_presentable(self) -> bool:
        """Whether the picture covers the part as well as one drawn during motion; until then the former picture is shown."""
        if self.is_complete:
            return True
        covers = self.picture_points * self._size_px**2 >= self.budget.points * self._moving_size_px() ** 2
        return self._drawn >= len(self._parts) and covers

    @property
    def frame_points(self) -> int:
        """Cost of the present frame, in points."""
        if self._moving:
            return self._moving_cost
        before = int(self._costs[self._shown.start - 1]) if self._shown.start else 0
        return (int(self._costs[self._shown.stop - 1]) if self._shown.stop else 0) - before

    @property
    def picture_points(self) -> int:
        """Number of points of the picture, including its earlier frames."""
        blocks = self._drawn - len(self._parts)
        return int(self._ends[blocks - 1]) if blocks > 0 else 0

    @property
    def moving_count(self) -> int:
        """Number of points of the picture of a moving camera; 0 for a surface."""
        return self._moving_cost if self._cloud_proxy is None and len(self.cloud) else 0

    def bounds_mm(self) -> list[float]:
        """Return the bounds of everything, including points not drawn yet, because all frames of a picture share one depth range."""
        boxes = [actor.GetBounds() for actor in (*self._parts, *self._lines)]
        corners = [*self.cloud.bounds_mm, *(np.array(box[end::2]) for box in boxes for end in (0, 1))]
        if not corners:
            return [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]
        low, high = np.min(corners, axis=0), np.max(corners, axis=0)
        return [float(value) for pair in zip(low, high, strict=True) for value in pair]

    def look_at(self, points_mm: np.ndarray) -> None:
        """Move the camera to these points (N, 3) without rotation, with a margin of at least `CLOSEST_MM`."""
        self.camera.keep_framed = False
        corners = np.stack(np.meshgrid(*[[-CLOSEST_MM, CLOSEST_MM]] * 3), axis=-1).reshape(-1, 3)
        middle = points_mm.mean(axis=0)
        box = np.array(self.bounds_mm()).reshape(3, 2)  # a margin beyond everything shown is useless
        roomy = np.clip(middle + ROOM * (points_mm - middle), box[:, 0], box[:, 1])
        self.camera.fill([points_mm, roomy, middle + corners])

    def _pieces(self) -> list[vtkActor]:
        return [*self._parts, *self._blocks]

    def _begin_anew(self) -> None:
        counts = np.diff(self._ends, prepend=0)
        triangles = [round(TRIANGLE_COST * actor.GetMapper().GetInput().GetNumberOfPolys()) for actor in self._parts]
        self._costs = np.cumsum(np.concatenate([np.array(triangles, np.int64), counts]))
        self._drawn, self._shown = 0, slice(0, 0)

    def _show_moving(self) -> None:
        """Show the proxies, or the finest subsample that there is time for, or the first blocks of points."""
        shown = [self._surface_proxy] if self._surface_proxy is not None else self._parts
        cost = sum(round(TRIANGLE_COST * actor.GetMapper().GetInput().GetNumberOfPolys()) for actor in shown)
        budget = max(self.budget.points - cost, 1)
        level = self._levels[self.choice.place(len(self._levels))] if self._levels else None
        if self._cloud_proxy is not None:
            shown, points = [*shown, self._cloud_proxy], 0
        elif level is not None:
            shown, points = [*shown, level[1]], len(level[0].points_mm)
            size = float(np.clip(SPLAT * level[0].cell_mm / self.camera.mm_per_px, 2.0, LARGEST_SPLAT_PX))
            level[1].GetProperty().SetPointSize(size)
        else:
            count = max(1, int(np.searchsorted(self._ends, budget, side="right")))
            self._set_size(self._blocks[:count], self._moving_size_px())
            shown, points = [*shown, *self._blocks[:count]], int(self._ends[min(count, len(self._ends)) - 1]) if len(self._ends) else 0
        self._moving_cost = points
        for actor in shown:
            actor.VisibilityOn()

    def _show_next(self, budget: int) -> None:
        """Make the next pieces visible; lines are drawn in the first frame only, whose depth buffer is kept."""
        pieces, first = self._pieces(), self._drawn == 0
        start = int(self._costs[self._drawn - 1]) if self._drawn else 0
        end = min(max(self._drawn + 1, int(np.searchsorted(self._costs, start + budget, side="right"))), len(pieces))
        for piece in pieces[self._shown]:
            piece.VisibilityOff()
        self._shown, self._drawn = slice(self._drawn, end), end
        if first:
            self._size_px = self._covering_size_px(len(self.cloud))
            self._set_size(self._blocks, self._size_px)
        for piece in pieces[self._shown]:
            piece.VisibilityOn()

    def _set_size(self, blocks: Sequence[vtkActor], size_px: float) -> None:
        self._size_px = size_px
        for block in blocks:
            block.GetProperty().SetPointSize(size_px)

    def _moving_size_px(self) -> float:
        return self._covering_size_px(min(self.budget.points, len(self.cloud)))

    def _covering_size_px(self, points: int) -> float:
        """Return the point size at which this number of points covers the visible part."""
        if not points:
            return 1.0
        return point_size_px(self.camera.pixels(self._extent["clouds"]), self.camera.size_px, points)

    def _set_preserved(self, preserved: bool) -> None:
        self.renderer.SetPreserveColorBuffer(preserved)
        self.renderer.SetPreserveDepthBuffer(preserved)

    def _all_actors(self) -> list[vtkActor]:
        proxies = [actor for actor in (self._surface_proxy, self._cloud_proxy) if actor is not None]
        return [*self._parts, *self._blocks, *self._lines, *proxies, *(actor for _, actor in self._levels)]

    def _add(self, actors: list[vtkActor]) -> list[vtkActor]:
        for actor in actors:
            actor.VisibilityOff()
            self._clip_actor(actor)
            self.renderer.AddActor(actor)
        return actors

    def _remove(self, actors: Sequence[vtkActor]) -> None:
        for actor in actors:
            self.renderer.RemoveActor(actor)

    def _clip_actor(self, actor: vtkActor) -> None:
        mapper = actor.GetMapper()
        mapper.RemoveAllClippingPlanes()
        if self.clip is not None and self.clip.is_on:
            mapper.SetClippingPlanes(_planes(self.clip))


def _planes(clip: ClipBox) -> vtkPlaneCollection:
    planes = vtkPlaneCollection()
    for face, middle in enumerate(clip.face_middles()):
        plane = vtkPlane()
        plane.SetOrigin(*(float(value) for value in middle))
        plane.SetNormal(*(float(value) for value in -clip.normal(face)))
        planes.AddItem(plane)
    return planes


def _coarse_part(surface: PreparedSurface) -> SurfacePart | None:
    return surface.proxy or (surface.parts[0] if surface.parts else None)


def _subsample(points: np.ndarray) -> np.ndarray:
    """Subsample points of which only the extent matters."""
    return np.asarray(points[:: max(1, len(points) // FRAMING_POINTS)], float)


def _light() -> vtkLight:
    """Return a light from above the left shoulder: from the eye itself, faces at equal angles, as of a box seen from a corner, look alike."""
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(*LIGHT_FROM)
    light.SetFocalPoint(0.0, 0.0, 0.0)
    return light
