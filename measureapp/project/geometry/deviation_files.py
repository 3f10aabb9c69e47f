"""Files of deviations: sections as CSV or JSON, the coloured nominal as PLY."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import InputError
from measureapp.inspection.surface.deviation_map import DeviationMap
from measureapp.inspection.surface.section import Section
from measureapp.project.atomic import replacing, write_json, write_text
from measureapp.project.geometry.ply import write_ply

COLUMNS = ("section", "curve", "number", "x_mm", "y_mm", "z_mm", "deviation_mm")


def write_sections(path: Path, sections: Sequence[Section], alignment: str) -> None:
    """Write sections as CSV (one line per point; nominal points have no deviation) or JSON, by the file extension; raises InputError."""
    if path.suffix.lower() == ".json":
        write_json(path, {"schema_version": 1, "alignment": alignment, "sections": [_document(one) for one in sections]})
    elif path.suffix.lower() == ".csv":
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(COLUMNS)
        table.writerows(row for one in sections for row in _rows(one))
        write_text(path, text.getvalue())
    else:
        raise InputError(f"Sections cannot be written as {path}.", "Name a file that ends in .csv or .json.")


def _document(one: Section) -> dict[str, Any]:
    return {
        "name": one.name,
        "nominal_mm": [np.round(curve, 6).tolist() for curve in one.nominal],
        "measured_mm": np.round(one.measured_mm, 6).tolist(),
        "deviations_mm": np.round(one.deviations_mm, 6).tolist(),
    }


def _rows(one: Section) -> Iterator[list[Any]]:
    for number, curve in enumerate(one.nominal, start=1):
        for place in curve:
            yield [one.name, "nominal", number, *(f"{value:.6f}" for value in place), ""]
    for place, off in zip(one.measured_mm, one.deviations_mm, strict=True):
        yield [one.name, "measured", 1, *(f"{value:.6f}" for value in place), f"{off:.6f}"]


def write_deviation_map(path: Path, made: DeviationMap, colours: FloatArray, alignment: str) -> None:
    """Write the nominal as PLY with `deviation_mm`, `measured` (1 or 0) and a colour per vertex; raises InputError for another extension."""
    if path.suffix.lower() != ".ply":
        raise InputError(f"{path} does not end in .ply.", "Name a .ply file for the coloured nominal.")
    places = made.mesh.vertices_mm.astype(np.float32)
    shades = np.round(255 * np.clip(colours, 0, 1)).astype(np.uint8)
    vertex = {
        **{name: places[:, k] for k, name in enumerate("xyz")},
        "deviation_mm": made.distances_mm.astype(np.float32),
        "measured": made.measured.astype(np.uint8),
        **{name: shades[:, k] for k, name in enumerate(("red", "green", "blue"))},
    }
    with replacing(path) as beside:
        write_ply(beside, [f"alignment {alignment}"], {"vertex": vertex, "face": {"vertex_indices": made.mesh.triangles}})
