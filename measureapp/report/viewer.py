"""The measured surface for the 3-D view of the HTML report: quantised, with the deviation at every vertex."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray
from measureapp.data.dimension import Verdict
from measureapp.data.feature import Feature
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.colour_scale import BEYOND_SHADE, GO, NO_GO, RAMPS, ColourScale
from measureapp.inspection.surface.deviation import Deviation
from measureapp.open3d_library import open3d
from measureapp.report.deviation_pictures import NEAR_MM
from measureapp.report.language import Words
from measureapp.report.model import ReportModel
from measureapp.report.part_pictures import flag_text, on_feature, placed_mesh
from measureapp.report.printed import printed_flag
from measureapp.report.words import COLOURS

MOST_TRIANGLES = 200_000
LARGEST = 32767
MISSING = -32768  # not measured
FILLS = 0.92  # share of the view's half height that the part's radius takes


def scene_text(document: dict[str, Any] | None) -> str:
    """Return a scene as JSON that can stand inside HTML; null where there is no surface."""
    return json.dumps(document).replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def scene_document(model: ReportModel, words: Words | None = None) -> dict[str, Any] | None:
    """Return points (16 bit), triangles, deviations (16 bit) and flags; None where there is no surface. Without ``words`` in English."""
    mesh = placed_mesh(model.measurement)
    if mesh is None or not len(mesh.triangles):
        return None
    simpler = simplify(mesh)
    used = simpler.vertices_mm[np.unique(simpler.triangles)]
    centre = (used.min(axis=0) + used.max(axis=0)) / 2
    radius = float(np.linalg.norm(used - centre, axis=1).max()) / FILLS
    scale = ColourScale(-1.0, 1.0) if model.deviation is None else model.deviation.scale
    unit = 10 * max(abs(scale.low), abs(scale.high)) / LARGEST
    values = np.full(len(simpler.vertices_mm), MISSING, np.int16)
    if model.compared is not None:
        found = deviation_at(simpler, model.compared)
        there = np.isfinite(found)
        values[there] = np.clip(np.rint(found[there] / unit), -LARGEST, LARGEST).astype(np.int16)
    points = np.clip(np.rint((simpler.vertices_mm - centre) / radius * LARGEST), -LARGEST, LARGEST).astype("<i2")
    return {
        "points": _text(points),
        "values": _text(values.astype("<i2")),
        "triangles": _text(np.asarray(simpler.triangles).astype("<u4")),
        "unit_mm": unit,
        "scale": _scale(scale),
        "coloured": model.compared is not None,
        "flags": _flags(model, mesh, centre, radius, words or Words()),
    }


def _scale(scale: ColourScale) -> dict[str, Any]:
    """Return the colour scale as nodes, so that the page can draw it on other ranges too."""
    ramp = RAMPS[scale.ramp]
    below, above = (ramp.above[::-1], ramp.below[::-1]) if scale.swapped else (ramp.below, ramp.above)
    return {
        "low": scale.low,
        "high": scale.high,
        "steps": scale.steps,
        "tolerance": scale.tolerance,
        "below": below.tolist(),
        "band": ramp.band.tolist(),
        "above": above.tolist(),
        "go": [GO.tolist(), NO_GO.tolist()] if scale.go_no_go else None,
        "beyond": BEYOND_SHADE,
    }


def simplify(mesh: Mesh) -> Mesh:
    """Return the mesh with at most `MOST_TRIANGLES`; what was not measured is known by the nearest vertex."""
    if len(mesh.triangles) <= MOST_TRIANGLES:
        return mesh
    o3d, centre = open3d(), mesh.vertices_mm.mean(axis=0)  # in single precision
    tensor = o3d.core.Tensor.from_numpy
    whole = o3d.t.geometry.TriangleMesh(
        tensor((mesh.vertices_mm - centre).astype(np.float32)), tensor(np.array(mesh.triangles, dtype=np.int64))
    )
    made = whole.simplify_quadric_decimation(1.0 - MOST_TRIANGLES / len(mesh.triangles))
    vertices, triangles = made.vertex.positions.numpy() + centre, made.triangle.indices.numpy()
    measured = None if mesh.measured is None else np.asarray(mesh.measured)[cKDTree(mesh.vertices_mm).query(vertices, workers=-1)[1]]
    return Mesh(vertices, triangles, mesh.frame, measured)


def deviation_at(mesh: Mesh, compared: Deviation) -> FloatArray:
    """Return the deviation at every vertex (V,), of the nearest measured point; NaN where nothing was measured."""
    distance, index = compared.tree.query(mesh.vertices_mm, distance_upper_bound=NEAR_MM, workers=-1)
    found = np.where(np.isfinite(distance), compared.distances_mm[np.minimum(index, len(compared.distances_mm) - 1)], np.nan)
    return found if mesh.measured is None else np.where(mesh.measured, found, np.nan)


def _flags(model: ReportModel, mesh: Mesh, centre: FloatArray, radius: float, words: Words) -> list[dict[str, Any]]:
    """Return one flag per dimension whose features are on the surface or in space; those that do not pass are always shown."""
    inspection = model.measurement.inspection
    features = {} if inspection is None else {feature.name: feature for feature in inspection.features}
    flags = []
    for row, dimension in enumerate(model.dimensions):
        own = [features[name] for name in dimension.features if name in features]
        if own:
            at = (_place(mesh, own[0]) - centre) / radius
            always = dimension.verdict not in (Verdict.PASS, Verdict.NO_TOLERANCE)
            text, colour = printed_flag(flag_text(dimension), words), COLOURS[dimension.verdict]
            flags.append({"row": row, "at": at.tolist(), "text": text, "colour": colour, "always": always})
    return flags


def _place(mesh: Mesh, feature: Feature) -> FloatArray:
    """Return a point of a feature on the surface, the nearest to the middle of its upper side; else the feature's own point."""
    points = mesh.vertices_mm[on_feature(mesh, feature)]
    if not len(points):
        return feature.point_mm
    middle = np.median(points, axis=0)
    return np.asarray(points[np.argmin(np.linalg.norm(points - middle, axis=1))])


def _text(array: np.typing.NDArray[Any]) -> str:
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode()
