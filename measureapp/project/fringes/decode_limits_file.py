"""Limits of the pixels that a project decodes: `decode_limits.json`."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.decode_limits import DecodeLimits
from measureapp.project.atomic import write_text
from measureapp.project.journal.state import Journal
from measureapp.project.text_document import read_model

FILE = "decode_limits.json"


def read_decode_limits(project: Path) -> DecodeLimits:
    """Return the limits of the project in a folder; the usual ones where none were stored. Raises StorageError when the file is damaged."""
    path = project / FILE
    Journal(project).check(path)
    return read_model(path, DecodeLimits) if path.exists() else DecodeLimits()


def save_decode_limits(project: Path, limits: DecodeLimits) -> None:
    """Store the limits of the project in a folder. Raises StorageError."""
    write_text(project / FILE, limits.model_dump_json(indent=2))
