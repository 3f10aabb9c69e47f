"""VTK actors of points, surfaces and lines."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPointGaussianMapper, vtkPolyDataMapper

from ui.viewport.colouring import HATCH_SHADE, UNKNOWN
from ui.viewport.layers import LineLayer, SurfaceLayer
from ui.viewport.prepared_surface import SurfacePart

HATCH_PERIOD_PX = 9.0
AMBIENT, DIFFUSE = 0.36, 0.8
READ_AMBIENT, READ_DIFFUSE = 0.7, 0.3  # for colours of a scale: the hue means the same everywhere, and the shape is still seen
IS_UNKNOWN = "all(lessThan(abs(vertexColorVSOutput.rgb - vec3({}, {}, {}) / 255.0), vec3(0.012)))".format(*UNKNOWN)
HATCHED = (  # in screen space, so that unmeasured areas are recognisable at every distance
    "//VTK::Color::Impl\n"
    f"  if ({IS_UNKNOWN} && mod(gl_FragCoord.x + gl_FragCoord.y, {HATCH_PERIOD_PX}) < {HATCH_PERIOD_PX / 2})\n"
    f"  {{ ambientColor *= {HATCH_SHADE}; diffuseColor *= {HATCH_SHADE}; }}\n"
)


def points_actor(points: np.ndarray, colours: np.ndarray) -> vtkActor:
    """Return an actor of points (N, 3) with individual colours, unlit; VTK keeps references to both arrays.

    At scale factor 0 this mapper draws plain points and needs no cells, which saves eight bytes a point
    (VTK merge request 296).
    """
    data = _poly_data(points)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(colours)))
    mapper, actor = vtkPointGaussianMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.SetScaleFactor(0.0)
    mapper.EmissiveOff()
    actor.SetMapper(mapper)
    actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().LightingOff()
    return actor


def surface_actor(part: SurfacePart, layer: SurfaceLayer) -> vtkActor:
    """Return an actor of a part of a surface; unmeasured vertices are hatched."""
    data = _poly_data(np.asarray(part.vertices_mm, np.float32))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(part.triangles, np.int64).ravel(), deep=True))
    data.SetPolys(cells)
    data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(part.normals, np.float32), deep=True))
    if part.colours is not None:
        data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(part.colours, np.uint8), deep=True))
    actor = _actor(data)
    if part.colours is not None:
        actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().SetColor(*(value / 255 for value in layer.colour))
    actor.GetProperty().SetOpacity(layer.opacity)
    actor.GetProperty().SetAmbient(READ_AMBIENT if layer.to_read else AMBIENT)
    actor.GetProperty().SetDiffuse(READ_DIFFUSE if layer.to_read else DIFFUSE)
    return actor


def line_actor(layer: LineLayer) -> vtkActor:
    """Return an actor of polylines, drawn slightly in front of the surface below."""
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


def _poly_data(points: np.ndarray) -> vtkPolyData:
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points)))  # VTK keeps a reference to the array
    data.SetPoints(places)
    return data


def _actor(data: vtkPolyData) -> vtkActor:
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    return actor
