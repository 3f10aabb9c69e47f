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

from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer, shuffled_prefix

MOVING_POINTS = 150_000
STILL_POINTS = 2_000_000
FINE_FROM = 200_000  # points; fewer are drawn larger
TWO_SIDED = "//VTK::Normal::Impl\n  if (normalVCVSOutput.z < 0.0) { normalVCVSOutput = -normalVCVSOutput; }\n"
OPENING_DIRECTION = (-1.0, -1.1, 0.85)


class Scene:
    """Clouds, surfaces, lines and labels in one renderer."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.GradientBackgroundOn()
        self.cloud_size = 0
        self._cloud: dict[str, vtkActor] = {}
        self._others: dict[str, list[vtkProp]] = {"surface": [], "lines": [], "labels": []}
        self.keep_framed = True  # until the user moves the camera

    def set_background(self, top: tuple[float, float, float], bottom: tuple[float, float, float]) -> None:
        """Set the colours (0…1) behind everything."""
        self.renderer.SetBackground(bottom)
        self.renderer.SetBackground2(top)

    def set_clouds(self, layers: Sequence[CloudLayer]) -> None:
        """Show these clouds instead of those shown; while the camera moves, a random part of them stands for all."""
        for actor in self._cloud.values():
            self.renderer.RemoveActor(actor)
        self._cloud = {}
        filled = [layer for layer in layers if len(layer.points_mm)]
        self.cloud_size = sum(len(layer.points_mm) for layer in filled)
        if not filled:
            return
        points = np.concatenate([np.asarray(layer.points_mm, np.float32) for layer in filled])
        colours = np.concatenate([np.asarray(layer.colours, np.uint8) for layer in filled])
        normals = None
        if all(layer.normals is not None for layer in filled):
            normals = np.concatenate([np.asarray(layer.normals, np.float32) for layer in filled])
        for name, budget in (("still", STILL_POINTS), ("moving", MOVING_POINTS)):
            chosen = shuffled_prefix(len(points), budget)
            part = slice(None) if chosen is None else chosen
            actor = _points_actor(points[part], colours[part], None if normals is None else normals[part])
            actor.GetProperty().SetPointSize(2.0 if len(points) > FINE_FROM else 3.0)
            self._cloud[name] = actor
            self.renderer.AddActor(actor)
        self.set_moving(False)

    def set_moving(self, moving: bool) -> None:
        """Show the small part of the clouds while the camera moves, all of them while it rests."""
        self.keep_framed = self.keep_framed and not moving
        for name, actor in self._cloud.items():
            actor.SetVisibility((name == "moving") == moving)

    def set_surface(self, layer: SurfaceLayer | None) -> None:
        """Show a surface instead of the one shown."""
        self._replace("surface", [] if layer is None or not len(layer.triangles) else [_surface_actor(layer)])

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Show these lines instead of those shown."""
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
        self.renderer.ResetCameraClippingRange()

    def _replace(self, kind: str, props: list[vtkProp]) -> None:
        for prop in self._others[kind]:
            self.renderer.RemoveViewProp(prop)
        self._others[kind] = props
        for prop in props:
            self.renderer.AddViewProp(prop)


def _points_actor(points: np.ndarray, colours: np.ndarray, normals: np.ndarray | None) -> vtkActor:
    data = _poly_data(points)
    cells = vtkCellArray()
    cells.SetData(1, numpy_to_vtkIdTypeArray(np.arange(len(points), dtype=np.int64), deep=True))
    data.SetVerts(cells)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(colours), deep=True))
    if normals is not None:
        data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(normals), deep=True))
    actor = _actor(data)
    if normals is None:
        actor.GetProperty().LightingOff()
    else:
        actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Normal::Impl", False, TWO_SIDED, False)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.7)
    return actor


def _surface_actor(layer: SurfaceLayer) -> vtkActor:
    data = _poly_data(np.asarray(layer.vertices_mm, np.float32))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(layer.triangles, np.int64).ravel(), deep=True))
    data.SetPolys(cells)
    if layer.colours is not None:
        data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(layer.colours, np.uint8), deep=True))
    shaded = vtkPolyDataNormals()
    shaded.SetInputData(data)
    shaded.SetFeatureAngle(35.0)
    shaded.Update()
    actor = _actor(shaded.GetOutput())
    actor.GetProperty().SetColor(*(value / 255 for value in layer.colour))
    actor.GetProperty().SetOpacity(layer.opacity)
    actor.GetProperty().SetAmbient(0.32)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


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
    actor.GetProperty().SetColor(*(value / 255 for value in label.colour))
    return actor


def _poly_data(points: np.ndarray) -> vtkPolyData:
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(places)
    return data


def _actor(data: vtkPolyData) -> vtkActor:
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    return actor
