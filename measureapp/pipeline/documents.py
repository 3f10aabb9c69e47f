"""JSON document and report files of a run."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from measureapp.data.measurement import Measurement, ViewResult
from measureapp.language.languages import ENGLISH
from measureapp.progress import NoProgress, Progress
from measureapp.project.atomic import write_json, write_text
from measureapp.project.documents import loop_closure_document
from measureapp.project.folder import ProjectFolder
from measureapp.project.results import MESH, STITCHED
from measureapp.report.csv import csv_text
from measureapp.report.json_document import measurement_document, report_document
from measureapp.report.pdf import write_pdf
from measureapp.report.project import compose_project


def write_reports(
    project: ProjectFolder,
    measurement: Measurement,
    language: str = ENGLISH,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> dict[str, Path]:
    """Write the report as PDF in ``language``, CSV and JSON, and return all files of the measurement."""
    model = compose_project(project, measurement, language=language, progress=progress)
    progress.check()
    write_pdf(model, project.report_pdf)
    write_text(project.report_csv, csv_text(model))
    write_json(project.report_json, report_document(model))
    files = {
        "stitched_cloud": project.results / STITCHED,
        "report_pdf": project.report_pdf,
        "report_csv": project.report_csv,
        "report_json": project.report_json,
    }
    return files | ({} if measurement.mesh is None else {"mesh": project.results / MESH})


def outcome_document(measurement: Measurement, files: Mapping[str, Path], seconds: Mapping[str, float]) -> dict[str, Any]:
    """Return the JSON answer of `process`, `scan` and `demo`; the demo adds the ground truth."""
    document = measurement_document(measurement)
    stitched = measurement.stitched
    figures = {view.viewpoint_id: view_figures(view) for view in measurement.views}
    document["views"] = [{**view, **figures.get(view["name"], {})} for view in document["views"]]
    document["stitch"] = {
        "points": len(stitched),
        "views_used": sum(placement.used for placement in stitched.placements),
        "largest_correction_mm": max((placement.correction_mm for placement in stitched.placements), default=0.0),
        "residual_mm": max((placement.residual_mm for placement in stitched.placements if placement.used), default=0.0),
        "ring": loop_closure_document(stitched.loop_closure),
        **dict(stitched.notes),
    }
    document["timings"] = {name: round(value, 3) for name, value in seconds.items()}
    document["files"] = {name: str(path) for name, path in files.items()}
    return document


def view_figures(view: ViewResult) -> dict[str, Any]:
    """Return the figures of decoding and matching of one view."""
    return {
        "decode": dict(view.decode),
        "pairs": list(view.pairs),
        "rejected": dict(view.rejected),
        "density": view.quality.density_per_mm2,
        "timings": dict(view.timings_s),
        "findings": list(view.findings),
    }
