"""The 3-D scene: renderer, actors and camera."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderer

from ui.viewport.actors import label_actor, line_actor, points_actor, surface_actor
from ui.viewport.frame_budget import FrameBudget
from ui.viewport.label_layout import place_labels
from ui.viewport.layers import Label, LineLayer, SurfaceLayer
from ui.viewport.point_size import point_size_px
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle

OPENING_DIRECTION = (-1.0, -1.1, 0.85)
FRAMING_POINTS = 4_000
FILLED_SHARE = 0.86  # of the picture's width or height, whichever is reached first
CLOSEST_MM, ROOM = 15.0, 1.8
PICK_REACH_PX = 5.0
LABEL_PX = (7.6, 24)  # approximate width of a letter and height of a label
PICK_CHUNK = 2_000_000


class Scene:
    """Clouds, surfaces, lines and labels in one renderer."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.GradientBackgroundOn()
        self.budget = FrameBudget()
        self._cloud = shuffle(())
        self._blocks: list[vtkActor] = []
        self._ends = np.empty(0, np.int64)  # cumulative number of points at the end of each block
        self._bounds: tuple[np.ndarray, ...] = ()
        self._drawn = 0  # blocks drawn in the picture
        self._shown = slice(0, 0)  # blocks of the present frame
        self._size_px = 1.0
        self._moving = False
        self._others: dict[str, list[vtkProp]] = {"surface": [], "lines": [], "labels": []}
        self._extent: dict[str, np.ndarray] = {}
        self._labels: tuple[Label, ...] = ()
        self.keep_framed = True  # until the user moves the camera
        self._opening = OPENING_DIRECTION
        self._framed_mm: np.ndarray | None = None  # (N, 3), what the camera is opened on; None: everything

    def set_background(self, top: tuple[float, float, float], bottom: tuple[float, float, float]) -> None:
        """Set the colours (0…1) of the background."""
        self.renderer.SetBackground(bottom)
        self.renderer.SetBackground2(top)

    def set_cloud(self, cloud: ShuffledCloud) -> None:
        """Replace the points."""
        for block in self._blocks:
            self.renderer.RemoveActor(block)
        self._cloud, self._extent["clouds"] = cloud, cloud.points_mm[:FRAMING_POINTS].astype(float)
        parts = cloud.blocks()
        self._ends = np.array([part.stop for part in parts], np.int64)
        self._blocks = [points_actor(cloud.points_mm[part], cloud.colours[part]) for part in parts]
        self._bounds = cloud.bounds_mm
        self._drawn, self._shown = 0, slice(0, 0)
        for block in self._blocks:
            block.VisibilityOff()
            self.renderer.AddActor(block)

    def set_moving(self, moving: bool) -> None:
        """Draw only the points of one frame while the camera moves, all points at rest."""
        self.keep_framed = self.keep_framed and not moving
        self._moving = moving

    def turn(self, right_deg: float, up_deg: float) -> None:
        """Rotate the part to the right and up, as with the mouse."""
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(-right_deg)
        camera.Elevation(-up_deg)
        camera.OrthogonalizeViewUp()
        self.keep_framed = False

    def approach(self, times: float) -> None:
        """Zoom in by a factor."""
        self.renderer.GetActiveCamera().Dolly(times)
        self.keep_framed = False

    def begin_picture(self) -> None:
        """Start a new picture: the next frame clears it and draws as many points as its time allows."""
        self._set_preserved(False)
        self._drawn = 0
        if self.keep_framed:
            self.reset_camera()
        self._show_next(self.budget.points)
        self.renderer.ResetCameraClippingRange(self._all_bounds())
        if not self._moving:  # during motion labels keep their offsets
            self._place_labels()

    def go_on(self) -> None:
        """Continue the picture: the next frame adds points; see `is_complete`."""
        self._set_preserved(True)
        self._show_next(self.budget.points)

    @property
    def is_complete(self) -> bool:
        """Whether everything is drawn; during motion one frame is sufficient."""
        return self._moving or self._drawn == len(self._blocks)

    @property
    def is_presentable(self) -> bool:
        """Whether the picture covers the part as well as one drawn during motion; until then the former picture is shown."""
        return self.is_complete or self.picture_points * self._size_px**2 >= self.budget.points * self._moving_size_px() ** 2

    @property
    def frame_points(self) -> int:
        """Number of points of the present frame."""
        before = int(self._ends[self._shown.start - 1]) if self._shown.start else 0
        return self.picture_points - before

    def _show_next(self, budget: int) -> None:
        """Make the next blocks visible; surfaces and lines are drawn in the first frame only, whose depth buffer is kept."""
        first, start = self._drawn == 0, self.picture_points
        end = min(max(self._drawn + 1, int(np.searchsorted(self._ends, start + budget, side="right"))), len(self._blocks))
        for block in self._blocks[self._shown]:
            block.VisibilityOff()
        self._shown, self._drawn = slice(self._drawn, end), end
        if first:
            self._size_px = self._moving_size_px() if self._moving else self._covering_size_px(len(self._cloud))
        for block in self._blocks[self._shown]:
            block.VisibilityOn()
            block.GetProperty().SetPointSize(self._size_px)
        for prop in (*self._others["surface"], *self._others["lines"]):
            prop.SetVisibility(first)
        self.renderer.SetUseFXAA(
            self.budget.software and not self._blocks
        )  # with several frames it would smooth the same points repeatedly

    @property
    def picture_points(self) -> int:
        """Number of points of the picture, including its earlier frames."""
        return int(self._ends[self._drawn - 1]) if self._drawn else 0

    def _place_labels(self) -> None:
        if not self._labels:
            return
        places = self._pixels(np.array([label.point_mm for label in self._labels], float))
        sizes = [(round(LABEL_PX[0] * (len(label.text) + 1)), LABEL_PX[1]) for label in self._labels]
        for prop, (right, up) in zip(self._others["labels"], place_labels(places, sizes, self.renderer.GetSize()), strict=True):
            prop.SetPosition(right, up)

    def _pixels(self, points_mm: np.ndarray) -> np.ndarray:
        """Project points (N, 3) in front of the camera to the picture; y from the bottom."""
        matrix = self._projection()
        placed = points_mm @ matrix[:, :3].T + matrix[:, 3]
        return np.asarray((placed[:, :2] / placed[:, 3:] + 1.0) / 2.0 * self.renderer.GetSize())

    def _moving_size_px(self) -> float:
        return self._covering_size_px(min(self.budget.points, len(self._cloud)))

    def _covering_size_px(self, points: int) -> float:
        """Return the point size at which this number of points covers the visible part."""
        if not points:
            return 1.0
        return point_size_px(self._pixels(self._extent["clouds"]), self.renderer.GetSize(), points)

    def _set_preserved(self, preserved: bool) -> None:
        self.renderer.SetPreserveColorBuffer(preserved)
        self.renderer.SetPreserveDepthBuffer(preserved)

    def _all_bounds(self) -> list[float]:
        """Return the bounds of everything, including points not drawn yet, because all frames of a picture share one depth range."""
        boxes = [prop.GetBounds() for prop in (*self._others["surface"], *self._others["lines"])]
        corners = [*self._bounds, *(np.array(box[end::2]) for box in boxes for end in (0, 1))]
        if not corners:
            return [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]
        low, high = np.min(corners, axis=0), np.max(corners, axis=0)
        return [float(value) for pair in zip(low, high, strict=True) for value in pair]

    def set_surface(self, layer: SurfaceLayer | None) -> None:
        """Replace the surface."""
        self._extent["surface"] = np.empty((0, 3)) if layer is None else _subsample(layer.vertices_mm)
        self._replace("surface", [] if layer is None or not len(layer.triangles) else [surface_actor(layer)])

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Replace the lines."""
        lines = [line for layer in layers for line in layer.lines]
        self._extent["lines"] = np.concatenate([np.empty((0, 3)), *(_subsample(line) for line in lines)])
        self._replace("lines", [line_actor(layer) for layer in layers if layer.lines])

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Replace the labels."""
        self._labels = tuple(labels)
        self._replace("labels", [label_actor(label) for label in labels])

    def reset_camera(self) -> None:
        """Show everything, or what `frame` names, slightly from above."""
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetPosition(self._opening)
        camera.SetViewUp(0.0, 0.0, 1.0)
        bounds = self._all_bounds()
        self.renderer.ResetCamera(bounds)
        shown = [points for points in self._extent.values() if len(points)]
        self._fill_picture(shown if self._framed_mm is None else [self._framed_mm])
        self.renderer.ResetCameraClippingRange(bounds)

    def frame(self, points_mm: np.ndarray | None, direction: tuple[float, float, float]) -> None:
        """Open the camera on these points (N, 3) from a direction; None: on everything."""
        self._framed_mm, self._opening = points_mm, direction

    def look_at(self, points_mm: np.ndarray) -> None:
        """Move the camera to these points (N, 3) without rotation, with a margin of at least `CLOSEST_MM`."""
        self.keep_framed = False
        corners = np.stack(np.meshgrid(*[[-CLOSEST_MM, CLOSEST_MM]] * 3), axis=-1).reshape(-1, 3)
        middle = points_mm.mean(axis=0)
        box = np.array(self._all_bounds()).reshape(3, 2)  # a margin beyond everything shown is useless
        roomy = np.clip(middle + ROOM * (points_mm - middle), box[:, 0], box[:, 1])
        self._fill_picture([points_mm, roomy, middle + corners])

    def pick(self, x_px: float, y_px: float) -> tuple[int, int] | None:
        """Return layer and index in the layer of the foremost point near a pixel of the picture; y from the bottom."""
        size = np.array(self.renderer.GetSize(), np.float32)
        if not len(self._cloud) or not size.all():
            return None
        matrix, best, chosen = self._projection().astype(np.float32), np.inf, -1
        for start in range(0, len(self._cloud), PICK_CHUNK):
            homogeneous = self._cloud.points_mm[start : start + PICK_CHUNK] @ matrix[:, :3].T + matrix[:, 3]
            place = homogeneous[:, :3] / homogeneous[:, 3:]
            gap = (place[:, :2] + 1.0) / 2.0 * size - np.array([x_px, y_px], np.float32)
            near = np.flatnonzero((np.einsum("nd,nd->n", gap, gap) < PICK_REACH_PX**2) & (np.abs(place[:, 2]) <= 1.0))
            if len(near) and float(place[near, 2].min()) < best:
                best, chosen = float(place[near, 2].min()), start + int(near[np.argmin(place[near, 2])])
        return None if chosen < 0 else self._cloud.origin(chosen)

    def ray(self, x_px: float, y_px: float) -> tuple[np.ndarray, np.ndarray]:
        """Return origin and direction (3,) of the ray through a pixel of the picture; y from the bottom."""
        size = np.maximum(self.renderer.GetSize(), 1)
        x, y = 2.0 * np.array([x_px, y_px]) / size - 1.0
        ends = np.array([[x, y, -1.0, 1.0], [x, y, 1.0, 1.0]]) @ np.linalg.inv(self._projection()).T
        near, far = ends[:, :3] / ends[:, 3:]
        return near, (far - near) / np.linalg.norm(far - near)

    def _projection(self) -> np.ndarray:
        camera = self.renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(self.renderer.GetTiledAspectRatio(), -1.0, 1.0)
        return np.array([[matrix.GetElement(line, place) for place in range(4)] for line in range(4)])

    def _fill_picture(self, shown: Sequence[np.ndarray]) -> None:
        """Move the camera so that these points fill the picture, centred."""
        width, height = self.renderer.GetSize()
        if not shown or not width or not height:
            return
        camera = self.renderer.GetActiveCamera()
        focus, forward = np.array(camera.GetFocalPoint()), np.array(camera.GetDirectionOfProjection())
        right = np.cross(forward, camera.GetViewUp())
        right /= np.linalg.norm(right)
        up = np.cross(right, forward)
        gap = np.concatenate(shown) - focus
        half = np.tan(np.radians(camera.GetViewAngle()) / 2.0) * FILLED_SHARE
        x, x_distance = _fit_camera(gap @ right, gap @ forward, half * width / height)
        y, y_distance = _fit_camera(gap @ up, gap @ forward, half)
        focus = focus + x * right + y * up
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*(focus - max(x_distance, y_distance, 1e-3) * forward))

    def _replace(self, kind: str, props: list[vtkProp]) -> None:
        for prop in self._others[kind]:
            self.renderer.RemoveViewProp(prop)
        self._others[kind] = props
        for prop in props:
            self.renderer.AddViewProp(prop)


def _subsample(points: np.ndarray) -> np.ndarray:
    """Subsample points of which only the extent matters."""
    return np.asarray(points[:: max(1, len(points) // FRAMING_POINTS)], float)


def _fit_camera(across: np.ndarray, depth: np.ndarray, slope: float) -> tuple[float, float]:
    """Return lateral position and distance of the camera at which all points are within a cone of this slope."""
    high, low = float(np.max(across - slope * depth)), float(np.min(across + slope * depth))
    return (high + low) / 2.0, (high - low) / (2.0 * slope)
