"""Where the sessions of the wizards are kept: with the open project, else below the user's home."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from ui.controllers.collecting_nouns import StoredSession
from ui.session import Session

SESSIONS = Path("MeasureApp") / "calibrations"
RESULT, CAMERAS = "result", "cameras.json"  # in a session's folder: the result accepted without a project


def project_on_disk(session: Session) -> Path | None:
    """Return the folder of the open project, where it has been written."""
    folder = session.folder
    return folder if folder is not None and (folder / "project.json").is_file() else None


def sessions_folder(project: Path | None) -> Path:
    """Return the folder of all sessions."""
    return Path.home() / SESSIONS if project is None else project / "calibration" / "sessions"


def newest_session(folder: Path, kind: str) -> StoredSession | None:
    """Return the newest session of a kind (its name) that holds views."""
    from measureapp.calibration_session.session import CalibrationSession

    for place in sorted(folder.glob(f"{kind}-*"), reverse=True):
        views = len(tuple((place / "observations").glob("*.json"))) if CalibrationSession.is_in(place) else 0
        if views:
            saved = datetime.fromtimestamp((place / "session.json").stat().st_mtime, UTC)
            return StoredSession(place, views, saved.isoformat())
    return None


def newest_result() -> tuple[Path, str] | None:
    """Return the folder of the newest result accepted without a project, and when (ISO 8601)."""
    places = [path.parent for path in sessions_folder(None).glob(f"*/{RESULT}/{CAMERAS}")]
    newest = max(places, key=_write_time_s, default=None)
    return None if newest is None else (newest, datetime.fromtimestamp(_write_time_s(newest), UTC).isoformat())


def _write_time_s(place: Path) -> float:
    return (place / CAMERAS).stat().st_mtime


def next_folder(folder: Path, kind: str) -> Path:
    """Return the folder for a new session of this kind."""
    numbers = [int(number) for place in folder.glob(f"{kind}-*") if (number := place.name.rpartition("-")[2]).isdigit()]
    return folder / f"{kind}-{max(numbers, default=0) + 1:03d}"
