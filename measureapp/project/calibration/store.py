"""Storage of rig calibrations. A calibration is never changed: a new one replaces it, and the former one is archived.

calibration/cameras.json, rig.json   the calibration in use
calibration/former/DAY-ID/           earlier ones
calibration/history.jsonl            results of scans and board checks about each of them, one per line, append-only
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measureapp.data.calibration import RigCalibration
from measureapp.data.validity import CheckRecord
from measureapp.errors import FrameMismatch, InputError, StorageError
from measureapp.project.atomic import replacing, replacing_together, write_json
from measureapp.project.calibration.camera_file import cameras_document, read_cameras, write_cameras
from measureapp.project.calibration.rig_uncertainty_file import write_rig_uncertainty
from measureapp.project.documents import calibration_id, check_document, check_from, digest, rig_calibration_document, rig_calibration_from
from measureapp.project.journal.entries import Entry
from measureapp.project.text_document import check_version

if TYPE_CHECKING:
    from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty

CAMERAS, RIG, FORMER, HISTORY = "cameras.json", "rig.json", "former", "history.jsonl"
FORMAT = 2  # of the rig; version 1 has no error motions of the axes
MADE_FROM = "made_from"  # beside the numbers, which its value changes none of
STORED, ARCHIVED = "calibration stored", "calibration archived"
RIG_UNCERTAINTY = "rig_uncertainty.npz"  # uncertainty of the calibration, if stored


def save(folder: Path, calibration: RigCalibration, uncertainty: RigUncertainty | None = None, made_from: str = "") -> None:
    """Store a calibration and, if known, its uncertainty, all at once; one made from other images is archived first. Raises StorageError.

    ``made_from`` is a hash of everything that it was solved from; empty where it is not to be recognised.
    """
    _archive(folder, calibration)
    cameras, rig = cameras_document(calibration.cameras), rig_calibration_document(calibration)
    entry = Entry(STORED, {}, "", {"id": calibration_id(calibration)})
    with replacing_together(folder, entry, stale=(RIG_UNCERTAINTY,)) as staging:
        write_cameras(staging / CAMERAS, calibration.cameras)
        write_json(staging / RIG, {**rig, MADE_FROM: made_from, "checksum": _checksum(cameras, rig)})
        if uncertainty is not None:
            write_rig_uncertainty(staging / RIG_UNCERTAINTY, uncertainty)


def load(folder: Path) -> RigCalibration | None:
    """Load the calibration in use, if there is one.

    Raises
    ------
    StorageError
        It is damaged, or a file was modified since it was stored.
    """
    path = folder / RIG
    if not path.exists():
        return None
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        check_version(path, document, 1 if document.get("schema_version") == 1 else FORMAT)
        stored, _ = document.pop("checksum", None), document.pop(MADE_FROM, None)
        calibration = rig_calibration_from(document, read_cameras(folder / CAMERAS))
        found = _checksum(json.loads((folder / CAMERAS).read_text(encoding="utf-8")), document)
    except (OSError, KeyError, TypeError, ValueError, AttributeError, RecursionError, FrameMismatch) as error:
        raise StorageError(f"{path} does not hold a calibration: {error}.", "Calibrate again.") from error
    if stored is not None and stored != found:
        raise StorageError(
            f"The calibration in {folder} was modified after it was stored.", "Restore both of its files from a backup, or calibrate again."
        )
    return calibration


def made_from(folder: Path) -> str:
    """Return the hash of what the calibration in use was solved from; empty where it is not known."""
    try:
        return str(json.loads((folder / RIG).read_text(encoding="utf-8")).get(MADE_FROM, ""))
    except (OSError, ValueError, AttributeError, RecursionError):
        return ""


def record(folder: Path, line: CheckRecord) -> None:
    """Append a record to the history unless it is there already; it is on disk when this returns."""
    if line in history(folder):
        return
    path = folder / HISTORY
    with replacing(path) as temporary:
        former = path.read_bytes() if path.exists() else b""
        torn = former[-1:] not in (b"", b"\n")
        text = ("\n" if torn else "") + json.dumps(check_document(line), ensure_ascii=False) + "\n"
        temporary.write_bytes(former + text.encode("utf-8"))


def history(folder: Path) -> tuple[CheckRecord, ...]:
    """Return the history, oldest record first; an incomplete line, as after a power cut, is skipped."""
    path = folder / HISTORY
    if not path.exists():
        return ()
    lines = []
    for text in path.read_text(encoding="utf-8", errors="replace").splitlines():
        try:
            lines.append(check_from(json.loads(text)))
        except (ValueError, TypeError, KeyError, RecursionError):
            continue
    return tuple(lines)


def _archive(folder: Path, coming: RigCalibration) -> None:
    try:
        former = load(folder)
    except (StorageError, InputError):
        former = None  # damaged: not worth archiving
    if former is None or calibration_id(former) == calibration_id(coming):
        return
    place = folder / FORMER / f"{former.provenance.created[:10] or 'undated'}-{calibration_id(former)}"
    with replacing_together(place, Entry(ARCHIVED, {}, "", {"id": calibration_id(former)})) as staging:
        for name in (CAMERAS, RIG, RIG_UNCERTAINTY):
            if (folder / name).exists():
                shutil.copyfile(folder / name, staging / name)


def _checksum(cameras: dict[str, Any], rig: dict[str, Any]) -> str:
    return digest({"cameras": cameras, "rig": rig})
