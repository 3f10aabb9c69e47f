"""Identification of the part of a project: `identification.json`, journalled like everything stored in it."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.identification import Identification
from measureapp.project.atomic import write_text
from measureapp.project.journal.state import Journal
from measureapp.project.text_document import read_model

IDENTIFICATION = "identification.json"


def read_identification(project: Path) -> Identification:
    """Read the identification of the project in the folder ``project``; an empty one if there is none.

    Raises
    ------
    Damaged
        It is not what was stored.
    StorageError
        It cannot be read.
    """
    path = project / IDENTIFICATION
    Journal(project).check(path)
    return read_model(path, Identification) if path.exists() else Identification()


def save_identification(project: Path, identification: Identification) -> None:
    """Store the identification in the folder ``project``. Raises StorageError."""
    write_text(project / IDENTIFICATION, identification.model_dump_json(indent=2))
