"""The report as PDF, typeset by Typst."""

from __future__ import annotations

from pathlib import Path

from measureapp.project.atomic import replacing
from measureapp.report.language import words_of
from measureapp.report.model import ReportModel
from measureapp.report.printed import picture_files, typst_document
from measureapp.report.typeset import Typeset, typeset


def write_pdf(model: ReportModel, path: Path) -> Path:
    """Write the report as PDF, whole or not at all, and return ``path``.

    Raises
    ------
    StorageError
        The file cannot be written, or the template has an error, which is named.
    """
    document = pdf_bytes(model)
    with replacing(path) as temporary:
        temporary.write_bytes(document)
    return path


def pdf_bytes(model: ReportModel) -> bytes:
    """Return the report as PDF. Raises StorageError when the template has an error, which is named."""
    return typeset(_document(model), "pdf")[0]


def page_images(model: ReportModel, ppi: float = 110.0) -> tuple[bytes, ...]:
    """Return the pages of the report as PNG. Raises StorageError when the template has an error, which is named."""
    return typeset(_document(model), "png", ppi)


def _document(model: ReportModel) -> Typeset:
    words = words_of(model)
    return Typeset(model.details.template.layout_file, typst_document(model, words), picture_files(model), model.details.created_at, words)
