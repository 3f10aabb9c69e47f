"""Which part program a project was begun with, and whether it was released: `inspection/part_program.json`."""

from __future__ import annotations

import hashlib
from pathlib import Path

from measureapp.data.part_program import PartProgram, ProgramRecord
from measureapp.project.atomic import write_text
from measureapp.project.journal.state import Journal
from measureapp.project.part_program_file import is_released
from measureapp.project.text_document import read_model

FILE = "part_program.json"
MEASURED_BY = ("program.toml", "nominal.*")  # what a later edit of the project changes


def save_record(project: Path, program: PartProgram) -> None:
    """Note the part program of a project in the folder ``project``, whose files are stored already. Raises StorageError."""
    facts, release = program.facts, program.facts.release
    record = ProgramRecord(name=facts.name, sha256=_digest(project))
    if release is not None and is_released(program):
        record = record.model_copy(update={"revision": facts.revision, "by": release.by, "at": release.at})
    write_text(project / "inspection" / FILE, record.model_dump_json(indent=2))


def program_words(project: Path) -> str:
    """Return which part program a project follows, its revision and release, or that it was changed since; empty where none is known.

    Raises
    ------
    StorageError
        The file is damaged.
    """
    path = project / "inspection" / FILE
    Journal(project).check_once(path)
    if not path.exists():
        return ""
    record = read_model(path, ProgramRecord)
    if not record.revision:
        return f"{record.name}, not released"
    if record.sha256 != _digest(project):
        return f"{record.name}, changed after the release of revision {record.revision}"
    return f"{record.name}, revision {record.revision}, released by {record.by} on {record.at[:10]}"


def _digest(project: Path) -> str:
    folder, digest = project / "inspection", hashlib.sha256()
    for file in sorted(file for pattern in MEASURED_BY for file in folder.glob(pattern)):
        digest.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()
