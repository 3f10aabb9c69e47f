"""The report as a self-contained HTML page."""

from __future__ import annotations

import base64
from pathlib import Path

from measureapp.project.atomic import write_text
from measureapp.report.language import words_of
from measureapp.report.model import Picture, ReportModel
from measureapp.report.printed import typst_document
from measureapp.report.viewer import scene_document, scene_text
from measureapp.resources import resource

TEMPLATE, VIEWER = "report/report.html", "report/viewer.js"
MEDIA = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg", ".svg": "image/svg+xml"}


def html_text(model: ReportModel) -> str:
    """Return the page; all data is escaped."""
    import jinja2

    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    template = environment.from_string(resource(TEMPLATE).read_text(encoding="utf-8"))
    logo = model.details.template.logo
    words = words_of(model)
    pictures = [{"source": _inline(picture), "caption": words.said(picture.caption)} for picture in model.pictures]
    scene = scene_document(model, words)
    row_flags = {} if scene is None else {flag["row"]: number for number, flag in enumerate(scene["flags"])}
    maps = () if model.deviation is None else model.deviation.pictures
    return template.render(
        r=typst_document(model, words),
        t=words.tr,
        language=words.tag,
        pictures=pictures,
        deviation_sources=[_inline(picture) for picture in maps],
        logo="" if logo is None else f"data:{MEDIA[logo[0]]};base64,{base64.b64encode(logo[1]).decode()}",
        scene=scene_text(scene),
        row_flags=row_flags,
        viewer=resource(VIEWER).read_text(encoding="utf-8"),
    )


def write_html(model: ReportModel, path: Path) -> Path:
    """Write the page, whole or not at all, and return ``path``. Raises StorageError."""
    write_text(path, html_text(model))
    return path


def _inline(picture: Picture) -> str:
    return "data:image/png;base64," + base64.b64encode(picture.png).decode()
