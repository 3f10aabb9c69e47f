"""Projects that were opened last, in a small file below the user's home."""

from __future__ import annotations

from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from measureapp.data.model import Model
from measureapp.errors import StorageError
from measureapp.project.atomic import write_text

LARGEST = 12  # projects remembered


class RecentProject(Model):
    """One project, and when it was opened (ISO 8601)."""

    folder: str
    name: str
    opened: str


_LIST: TypeAdapter[tuple[RecentProject, ...]] = TypeAdapter(tuple[RecentProject, ...])


def recent_file() -> Path:
    """Return the file that remembers them."""
    return Path.home() / "MeasureApp" / "recent.json"


def recent_projects(file: Path) -> tuple[RecentProject, ...]:
    """Return the projects that are still there, the last one first; none if the file is missing or damaged."""
    return tuple(project for project in _read(file) if (Path(project.folder) / "project.json").is_file())


def remember_project(file: Path, folder: Path, name: str) -> None:
    """Put a project first in the list; a list that cannot be written is no reason not to open a project."""
    one = RecentProject(folder=str(folder.absolute()), name=name, opened=datetime.now(UTC).isoformat(timespec="seconds"))
    others = [project for project in _read(file) if project.folder != one.folder]
    with suppress(StorageError):
        write_text(file, _LIST.dump_json((one, *others)[:LARGEST], indent=2).decode())


def _read(file: Path) -> tuple[RecentProject, ...]:
    try:
        return _LIST.validate_json(file.read_bytes())
    except (OSError, ValidationError):
        return ()
