"""Where the sessions of the wizards are kept: with the open project, else below the user's home."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from ui.controllers.collecting_nouns import Kept, Kind
from ui.session import Session

SESSIONS = Path("MeasureApp") / "calibrations"


def project_on_disk(session: Session) -> Path | None:
    """Return the folder of the open project, where it has been written."""
    folder = session.folder
    return folder if folder is not None and (folder / "project.json").is_file() else None


def sessions_folder(project: Path | None) -> Path:
    """Return the folder of all sessions."""
    return Path.home() / SESSIONS if project is None else project / "calibration" / "sessions"


def newest_kept(folder: Path, kind: Kind) -> Kept | None:
    """Return the newest session of this kind that holds views."""
    from measureapp.pipeline.collecting.collection import Collection

    for place in sorted(folder.glob(f"{kind}-*"), reverse=True):
        views = len(tuple((place / "observations").glob("*.json"))) if Collection.is_in(place) else 0
        if views:
            saved = datetime.fromtimestamp((place / "session.json").stat().st_mtime, UTC)
            return Kept(place, views, saved.isoformat())
    return None


def next_folder(folder: Path, kind: Kind) -> Path:
    """Return the folder for a new session of this kind."""
    numbers = [int(number) for place in folder.glob(f"{kind}-*") if (number := place.name.rpartition("-")[2]).isdigit()]
    return folder / f"{kind}-{max(numbers, default=0) + 1:03d}"
