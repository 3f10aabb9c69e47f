"""The report as a self-contained HTML page."""

from __future__ import annotations

import base64
from pathlib import Path

from measureapp.project.atomic import write_text
from measureapp.report.model import Picture, ReportModel
from measureapp.report.printed import typst_document
from measureapp.resources import resource

TEMPLATE = "report/report.html"


def html_text(model: ReportModel) -> str:
    """Return the page; all data is escaped."""
    import jinja2

    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    template = environment.from_string(resource(TEMPLATE).read_text(encoding="utf-8"))
    pictures = [{"source": _inline(picture), "caption": picture.caption} for picture in model.pictures]
    maps = () if model.deviation is None else model.deviation.pictures
    return template.render(r=typst_document(model), pictures=pictures, deviation_sources=[_inline(picture) for picture in maps])


def write_html(model: ReportModel, path: Path) -> Path:
    """Write the page, whole or not at all, and return ``path``. Raises StorageError."""
    write_text(path, html_text(model))
    return path


def _inline(picture: Picture) -> str:
    return "data:image/png;base64," + base64.b64encode(picture.png).decode()
