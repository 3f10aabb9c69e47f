"""Calibrations of a rig on disk. One is never changed: another takes its place, and the former stays beside it.

calibration/cameras.json, rig.json   the calibration in use
calibration/former/DAY-ID/           those before it
calibration/history.jsonl            what scans and board checks said about each, a line each, only ever added to
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from measureapp.data.calibration import RigCalibration
from measureapp.data.validity import CheckRecord
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_json
from measureapp.project.calibration.camera_file import cameras_document, read_cameras, write_cameras
from measureapp.project.documents import calibration_id, check_document, check_from, digest, rig_calibration_document, rig_calibration_from

CAMERAS, RIG, FORMER, HISTORY = "cameras.json", "rig.json", "former", "history.jsonl"
RIG_UNCERTAINTY = "rig_uncertainty.npz"  # what the calibration leaves open, where that was kept


def save(folder: Path, calibration: RigCalibration) -> None:
    """Keep a calibration; one made from other images is set aside, not overwritten."""
    _set_aside(folder, calibration)
    (folder / RIG_UNCERTAINTY).unlink(missing_ok=True)
    cameras, rig = cameras_document(calibration.cameras), rig_calibration_document(calibration)
    write_cameras(folder / CAMERAS, calibration.cameras)
    write_json(folder / RIG, {**rig, "checksum": _checksum(cameras, rig)})


def load(folder: Path) -> RigCalibration | None:
    """Return the calibration in use, if there is one.

    Raises
    ------
    StorageError
        It is damaged, or a file was changed since it was stored.
    """
    path = folder / RIG
    if not path.exists():
        return None
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        stored = document.pop("checksum", None)
        calibration = rig_calibration_from(document, read_cameras(folder / CAMERAS))
        found = _checksum(json.loads((folder / CAMERAS).read_text(encoding="utf-8")), document)
    except (OSError, KeyError, TypeError, ValueError, AttributeError) as error:
        raise StorageError(f"{path} does not hold a calibration: {error}.", "Calibrate again.") from error
    if stored is not None and stored != found:
        raise StorageError(
            f"The calibration in {folder} was changed after it was stored.", "Restore both of its files from a backup, or calibrate again."
        )
    return calibration


def record(folder: Path, line: CheckRecord) -> None:
    """Add a line to the history, unless it says what is there already; it is on disk when this returns."""
    if line in history(folder):
        return
    path = folder / HISTORY
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        torn = path.exists() and path.read_bytes()[-1:] not in (b"", b"\n")
        with path.open("a", encoding="utf-8") as file:
            file.write(("\n" if torn else "") + json.dumps(check_document(line), ensure_ascii=False) + "\n")
            file.flush()
            os.fsync(file.fileno())
    except OSError as error:
        raise StorageError(f"{path} cannot be written: {error.strerror or error}.", "Check the free space and the permissions.") from error


def history(folder: Path) -> tuple[CheckRecord, ...]:
    """Return all lines of the history, oldest first; a line that a power cut left half-written is passed over."""
    path = folder / HISTORY
    if not path.exists():
        return ()
    lines = []
    for text in path.read_text(encoding="utf-8", errors="replace").splitlines():
        try:
            lines.append(check_from(json.loads(text)))
        except (ValueError, TypeError, KeyError):
            continue
    return tuple(lines)


def _set_aside(folder: Path, coming: RigCalibration) -> None:
    try:
        there = load(folder)
    except (StorageError, InputError):
        there = None  # damaged: nothing that could serve again
    if there is None or calibration_id(there) == calibration_id(coming):
        return
    place = folder / FORMER / f"{there.provenance.created[:10] or 'undated'}-{calibration_id(there)}"
    place.mkdir(parents=True, exist_ok=True)
    for name in (CAMERAS, RIG, RIG_UNCERTAINTY):
        if (folder / name).exists():
            (folder / name).replace(place / name)


def _checksum(cameras: dict[str, Any], rig: dict[str, Any]) -> str:
    return digest({"cameras": cameras, "rig": rig})
