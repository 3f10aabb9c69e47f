"""Documents of repeated measurements in a folder."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.repeats import RepeatStudy
from measureapp.language.languages import ENGLISH
from measureapp.project.atomic import write_json
from measureapp.report.repeats.csv import write_repeats_csv
from measureapp.report.repeats.json_document import study_document
from measureapp.report.repeats.pdf import write_repeats_pdf


def write_repeats(study: RepeatStudy, folder: Path, language: str = ENGLISH) -> dict[str, Path]:
    """Write `repeats.pdf`, `.csv` and `.json` into ``folder``, each whole or not at all; the PDF is in ``language``. Raises StorageError."""
    as_json = folder / "repeats.json"
    write_json(as_json, study_document(study))
    return {
        "pdf": write_repeats_pdf(study, folder / "repeats.pdf", language),
        "csv": write_repeats_csv(study, folder / "repeats.csv"),
        "json": as_json,
    }
