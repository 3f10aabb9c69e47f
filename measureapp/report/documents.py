"""Report documents of a measurement: PDF, CSV, XLSX, JSON and HTML of one model."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Literal

from measureapp.project.atomic import write_json
from measureapp.project.file_names import safe_file_name
from measureapp.report.csv import write_csv
from measureapp.report.html import write_html
from measureapp.report.json_document import report_document
from measureapp.report.model import ReportModel
from measureapp.report.pdf import write_pdf
from measureapp.report.xlsx import write_xlsx

DocumentKind = Literal["pdf", "csv", "xlsx", "json", "html"]
ALL_KINDS: tuple[DocumentKind, ...] = ("pdf", "csv", "xlsx", "json", "html")


def write_documents(
    model: ReportModel, folder: Path, kinds: Iterable[DocumentKind] = ALL_KINDS, stem: str = "report"
) -> Mapping[DocumentKind, Path]:
    """Write `report.pdf`, `.csv`, `.xlsx`, `.json`, `.html` into ``folder``, each whole or not at all.

    Parameters
    ----------
    stem : of the files' names

    Raises
    ------
    StorageError
        A document cannot be written, or the template has an error.
    """
    return {kind: write_document(model, kind, folder / safe_file_name(stem, f".{kind}")) for kind in kinds}


def write_document(model: ReportModel, kind: DocumentKind, path: Path) -> Path:
    """Write one document, whole or not at all, and return ``path``. Raises StorageError."""
    writers: dict[DocumentKind, Callable[[ReportModel, Path], Path]] = {
        "pdf": write_pdf,
        "csv": write_csv,
        "xlsx": write_xlsx,
        "json": write_report_json,
        "html": write_html,
    }
    return writers[kind](model, path)


def write_report_json(model: ReportModel, path: Path) -> Path:
    """Write the report as JSON and return ``path``. Raises StorageError."""
    write_json(path, report_document(model))
    return path
