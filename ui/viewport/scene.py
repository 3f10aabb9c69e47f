"""The contents of the 3-D view: one renderer, its actors and its camera."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the OpenGL classes
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingAnnotation import vtkCaptionActor2D
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProp, vtkRenderer

from ui.viewport.colouring import HATCH_SHADE, UNKNOWN
from ui.viewport.frame_budget import FrameBudget
from ui.viewport.layers import Label, LineLayer, SurfaceLayer
from ui.viewport.shuffled import ShuffledCloud, shuffled

FINE_FROM = 200_000  # points; fewer are drawn larger
FINE_POINT_PX, COARSE_POINT_PX = 2.0, 4.0
HATCH_PERIOD_PX = 9.0
IS_UNKNOWN = "all(lessThan(abs(vertexColorVSOutput.rgb - vec3({}, {}, {}) / 255.0), vec3(0.012)))".format(*UNKNOWN)
HATCHED = (  # stripes of the screen, so that what was not measured is told apart at every distance
    "//VTK::Color::Impl\n"
    f"  if ({IS_UNKNOWN} && mod(gl_FragCoord.x + gl_FragCoord.y, {HATCH_PERIOD_PX}) < {HATCH_PERIOD_PX / 2})\n"
    f"  {{ ambientColor *= {HATCH_SHADE}; diffuseColor *= {HATCH_SHADE}; }}\n"
)
OPENING_DIRECTION = (-1.0, -1.1, 0.85)
FRAMING_POINTS = 4_000
FILLED_SHARE = 0.86  # of the picture's width or height, whichever is reached first
PICK_REACH_PX = 5.0
PICK_CHUNK = 2_000_000


class Scene:
    """Clouds, surfaces, lines and labels in one renderer."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.GradientBackgroundOn()
        self.budget = FrameBudget()
        self._cloud = shuffled(())
        self._blocks: list[vtkActor] = []
        self._ends = np.empty(0, np.int64)  # how many points there are up to the end of each block
        self._bounds: tuple[np.ndarray, ...] = ()
        self._drawn = 0  # blocks that the picture has
        self._moving = False
        self._others: dict[str, list[vtkProp]] = {"surface": [], "lines": [], "labels": []}
        self._extent: dict[str, np.ndarray] = {}
        self.keep_framed = True  # until the user moves the camera

    def set_background(self, top: tuple[float, float, float], bottom: tuple[float, float, float]) -> None:
        """Set the colours (0…1) behind everything."""
        self.renderer.SetBackground(bottom)
        self.renderer.SetBackground2(top)

    def set_cloud(self, cloud: ShuffledCloud) -> None:
        """Show these points instead of those shown."""
        for block in self._blocks:
            self.renderer.RemoveActor(block)
        self._cloud, self._extent["clouds"] = cloud, _thinned(cloud.points_mm)
        parts = cloud.blocks()
        self._ends = np.array([part.stop for part in parts], np.int64)
        self._blocks = [_points_actor(cloud.points_mm[part], cloud.colours[part]) for part in parts]
        self._bounds = () if not len(cloud) else (cloud.points_mm.min(axis=0), cloud.points_mm.max(axis=0))
        for block in self._blocks:
            self.renderer.AddActor(block)

    def set_moving(self, moving: bool) -> None:
        """Draw only what one frame's time allows while the camera moves, everything when it rests."""
        self.keep_framed = self.keep_framed and not moving
        self._moving = moving

    def begin_picture(self) -> None:
        """Let the next frame erase what was drawn, and draw as many points as its time allows."""
        self._set_preserved(False)
        self._drawn = 0
        self._show_next(self.budget.points)
        if self.keep_framed:
            self.reset_camera()
        self.renderer.ResetCameraClippingRange(self._all_bounds())

    def go_on(self) -> None:
        """Let the next frame add points to the picture; see `is_complete`."""
        self._set_preserved(True)
        self._show_next(self.budget.points)

    @property
    def is_complete(self) -> bool:
        """Whether nothing is left to be drawn; while the camera moves, one frame is all there is."""
        return self._moving or self._drawn == len(self._blocks)

    @property
    def frame_points(self) -> int:
        """Return how many points the frame has."""
        return sum(int(block.GetMapper().GetInput().GetNumberOfPoints()) for block in self._blocks if block.GetVisibility())

    def _show_next(self, budget: int) -> None:
        """Make the next blocks visible, and what is no cloud in the first frame alone; labels lie over everything, so they come last."""
        start = int(self._ends[self._drawn - 1]) if self._drawn else 0
        end = max(self._drawn + 1, int(np.searchsorted(self._ends, start + budget, side="right")))
        end = min(end, len(self._blocks))
        size = self._point_size(int(self._ends[end - 1]) if end and self._moving else len(self._cloud))
        for place, block in enumerate(self._blocks):
            block.SetVisibility(self._drawn <= place < end)
            block.GetProperty().SetPointSize(size)
        first, self._drawn = self._drawn == 0, end
        for kind, props in self._others.items():
            for prop in props:
                prop.SetVisibility(self.is_complete if kind == "labels" else first)
        self.renderer.SetUseFXAA(self.budget.software and not self._moving and self.is_complete)

    def _point_size(self, points: int) -> float:
        """Return the size of points in pixels: the fewer stand for the part, the larger, so that it does not become transparent."""
        return float(np.clip(FINE_POINT_PX * np.sqrt(FINE_FROM / max(points, 1)), FINE_POINT_PX, COARSE_POINT_PX))

    def _set_preserved(self, preserved: bool) -> None:
        self.renderer.SetPreserveColorBuffer(preserved)
        self.renderer.SetPreserveDepthBuffer(preserved)

    def _all_bounds(self) -> list[float]:
        """Return the box of everything, the points that are not drawn yet included: all frames of a picture share one depth."""
        seen = self.renderer.ComputeVisiblePropBounds()
        corners = [*self._bounds]
        if seen[0] <= seen[1]:
            corners += [np.array(seen[0::2]), np.array(seen[1::2])]
        if not corners:
            return [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]
        low, high = np.min(corners, axis=0), np.max(corners, axis=0)
        return [float(value) for pair in zip(low, high, strict=True) for value in pair]

    def set_surface(self, layer: SurfaceLayer | None) -> None:
        """Show a surface instead of the one shown."""
        self._extent["surface"] = np.empty((0, 3)) if layer is None else _thinned(layer.vertices_mm)
        self._replace("surface", [] if layer is None or not len(layer.triangles) else [_surface_actor(layer)])

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Show these lines instead of those shown."""
        lines = [line for layer in layers for line in layer.lines]
        self._extent["lines"] = np.concatenate([np.empty((0, 3)), *(_thinned(line) for line in lines)])
        self._replace("lines", [_line_actor(layer) for layer in layers if layer.lines])

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Show these labels instead of those shown."""
        self._replace("labels", [_label_actor(label) for label in labels])

    def reset_camera(self) -> None:
        """Look at everything from the front, a little from above."""
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetPosition(OPENING_DIRECTION)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCamera()
        self._fill_picture()
        self.renderer.ResetCameraClippingRange()

    def pick(self, x_px: float, y_px: float) -> tuple[int, int] | None:
        """Return layer and place in the layer of the foremost point near a pixel of the picture; y counts from below."""
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

    def _projection(self) -> np.ndarray:
        camera = self.renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(self.renderer.GetTiledAspectRatio(), -1.0, 1.0)
        return np.array([[matrix.GetElement(line, place) for place in range(4)] for line in range(4)])

    def _fill_picture(self) -> None:
        """Move the camera so that what is shown fills the picture and lies in its middle."""
        shown = [points for points in self._extent.values() if len(points)]
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
        x, x_distance = _between(gap @ right, gap @ forward, half * width / height)
        y, y_distance = _between(gap @ up, gap @ forward, half)
        focus = focus + x * right + y * up
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*(focus - max(x_distance, y_distance, 1e-3) * forward))

    def _replace(self, kind: str, props: list[vtkProp]) -> None:
        for prop in self._others[kind]:
            self.renderer.RemoveViewProp(prop)
        self._others[kind] = props
        for prop in props:
            self.renderer.AddViewProp(prop)


def _thinned(points: np.ndarray) -> np.ndarray:
    """Return some of the points, which stand for all where only their extent counts."""
    return np.asarray(points[:: max(1, len(points) // FRAMING_POINTS)], float)


def _between(across: np.ndarray, depth: np.ndarray, slope: float) -> tuple[float, float]:
    """Return where the camera stands across, and how far away, so that all points lie within a cone of this slope."""
    high, low = float(np.max(across - slope * depth)), float(np.min(across + slope * depth))
    return (high + low) / 2.0, (high - low) / (2.0 * slope)


def _points_actor(points: np.ndarray, colours: np.ndarray) -> vtkActor:
    data = _poly_data(points)
    cells = vtkCellArray()
    ends, places = np.array([0, len(points)], np.int32), np.arange(len(points), dtype=np.int32)
    cells.SetData(numpy_to_vtk(ends, deep=True), numpy_to_vtk(places, deep=True))
    data.SetVerts(cells)
    data.GetPointData().SetScalars(numpy_to_vtk(colours))
    actor = _actor(data)
    actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().LightingOff()
    return actor


def _surface_actor(layer: SurfaceLayer) -> vtkActor:
    data = _poly_data(np.asarray(layer.vertices_mm, np.float32))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(layer.triangles, np.int64).ravel(), deep=True))
    data.SetPolys(cells)
    if layer.colours is not None:
        data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(layer.colours, np.uint8), deep=True))
    actor = _actor(_shaded(data, layer))
    if layer.colours is not None:
        actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().SetColor(*(value / 255 for value in layer.colour))
    actor.GetProperty().SetOpacity(layer.opacity)
    actor.GetProperty().SetAmbient(0.32)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def _shaded(data: vtkPolyData, layer: SurfaceLayer) -> vtkPolyData:
    """Return the surface with its normals; where it brings none they are computed and split at edges."""
    if layer.normals is not None:
        data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(layer.normals, np.float32), deep=True))
        return data
    split = vtkPolyDataNormals()
    split.SetInputData(data)
    split.SetFeatureAngle(35.0)
    split.Update()
    return split.GetOutput()


def _line_actor(layer: LineLayer) -> vtkActor:
    data = _poly_data(np.concatenate(layer.lines).astype(np.float32))
    lengths = [len(line) for line in layer.lines]
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.arange(sum(lengths), dtype=np.int64), deep=True),
    )
    data.SetLines(cells)
    actor = _actor(data)
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -66000.0)
    actor.GetProperty().SetColor(*(value / 255 for value in layer.colour))
    actor.GetProperty().SetLineWidth(layer.width)
    actor.GetProperty().LightingOff()
    return actor


def _label_actor(label: Label) -> vtkCaptionActor2D:
    actor = vtkCaptionActor2D()
    actor.SetCaption(label.text)
    actor.SetAttachmentPoint(*(float(value) for value in label.point_mm))
    actor.BorderOff()
    actor.LeaderOn()
    actor.ThreeDimensionalLeaderOff()
    actor.SetPosition(24, 32)
    actor.GetTextActor().SetTextScaleModeToNone()
    text = actor.GetCaptionTextProperty()
    text.SetFontFamilyToArial()
    text.SetFontSize(15)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()
    text.SetColor(*(value / 255 for value in label.colour))
    text.SetBackgroundColor(*(value / 255 for value in label.background))
    text.SetBackgroundOpacity(0.88)
    text.FrameOn()
    text.SetFrameColor(*(value / 255 for value in label.colour))
    actor.GetProperty().SetColor(*(value / 255 for value in label.colour))
    return actor


def _poly_data(points: np.ndarray) -> vtkPolyData:
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points)))  # VTK holds on to the array
    data.SetPoints(places)
    return data


def _actor(data: vtkPolyData) -> vtkActor:
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    return actor
