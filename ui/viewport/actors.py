"""VTK actors of the 3-D view: points, surfaces, lines and labels."""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the OpenGL classes
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingAnnotation import vtkCaptionActor2D
from vtkmodules.vtkRenderingCore import vtkActor, vtkPointGaussianMapper, vtkPolyDataMapper, vtkTextProperty

from ui.viewport.colouring import HATCH_SHADE, UNKNOWN
from ui.viewport.layers import Label, LineLayer, SurfaceLayer

LETTERS = Path("mpl-data") / "fonts" / "ttf" / "DejaVuSans.ttf"
LETTERS_PX, FONT_FILE = 13, 4  # VTK_FONT_FILE, which the Python wrapping lacks
HATCH_PERIOD_PX = 9.0
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
    data.GetPointData().SetScalars(numpy_to_vtk(colours))
    mapper, actor = vtkPointGaussianMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.SetScaleFactor(0.0)
    mapper.EmissiveOff()
    actor.SetMapper(mapper)
    actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().LightingOff()
    return actor


def surface_actor(layer: SurfaceLayer) -> vtkActor:
    """Return an actor of a lit surface; unmeasured vertices are hatched."""
    data = _poly_data(np.asarray(layer.vertices_mm, np.float32))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(layer.triangles, np.int64).ravel(), deep=True))
    data.SetPolys(cells)
    if layer.colours is not None:
        data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(layer.colours, np.uint8), deep=True))
    actor = _actor(_with_normals(data, layer))
    if layer.colours is not None:
        actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, HATCHED, False)
    actor.GetProperty().SetColor(*(value / 255 for value in layer.colour))
    actor.GetProperty().SetOpacity(layer.opacity)
    actor.GetProperty().SetAmbient(0.32)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def _with_normals(data: vtkPolyData, layer: SurfaceLayer) -> vtkPolyData:
    """Return the surface with its normals; missing ones are computed and split at edges."""
    if layer.normals is not None:
        data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(layer.normals, np.float32), deep=True))
        return data
    split = vtkPolyDataNormals()
    split.SetInputData(data)
    split.SetFeatureAngle(35.0)
    split.Update()
    return split.GetOutput()


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


def label_actor(label: Label) -> vtkCaptionActor2D:
    """Return an actor of a text on a leader line; opaque, so that progressive drawing gives the same picture."""
    actor = vtkCaptionActor2D()
    actor.SetCaption(label.text)
    actor.SetAttachmentPoint(*(float(value) for value in label.point_mm))
    actor.BorderOff()
    actor.LeaderOn()
    actor.ThreeDimensionalLeaderOff()
    actor.SetPosition(24, 32)
    actor.GetTextActor().SetTextScaleModeToNone()
    text = actor.GetCaptionTextProperty()
    set_letters(text)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()
    text.SetColor(*(value / 255 for value in label.colour))
    text.SetBackgroundColor(*(value / 255 for value in label.background))
    text.SetBackgroundOpacity(1.0)
    text.FrameOn()
    text.SetFrameColor(*(value / 255 for value in label.colour))
    actor.GetProperty().SetColor(*(value / 255 for value in label.colour))
    return actor


def set_letters(text: vtkTextProperty) -> None:
    """Set a readable font; VTK's default font lacks many characters."""
    letters = letters_file()
    if letters is None:
        text.SetFontFamilyToArial()
    else:
        text.SetFontFamily(FONT_FILE)
        text.SetFontFile(str(letters))
    text.SetFontSize(LETTERS_PX)


@cache
def letters_file() -> Path | None:
    """Return the font file of Matplotlib, which PyVista installs; None if it is missing."""
    found = find_spec("matplotlib")
    path = None if found is None or found.origin is None else Path(found.origin).parent / LETTERS
    return path if path is not None and path.is_file() else None


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
