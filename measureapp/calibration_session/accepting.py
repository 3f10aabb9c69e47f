"""Accepting a calibration: solved afresh, dated, written with its provenance; and reading such a result again."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from datetime import UTC, datetime
from pathlib import Path
from statistics import median
from typing import Any

from measureapp.calibrate.draft.draft import Known
from measureapp.calibrate.draft.estimate import Calibrated
from measureapp.calibrate.draft.verdict import require_solution
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of
from measureapp.calibration_session.session import CalibrationSession
from measureapp.calibration_session.snapshot import Snapshot
from measureapp.data.calibration import (
    CameraArrayCalibration,
    HandEye,
    LinearGuide,
    ProjectorCalibration,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.errors import FrameMismatch, InputError
from measureapp.progress import Progress
from measureapp.project.atomic import write_json
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from measureapp.project.documents import (
    axis_from,
    guide_from,
    hand_eye_from,
    link_document,
    rig_calibration_document,
    rig_calibration_from,
)
from measureapp.project.folder import ProjectFolder
from measureapp.project.text_document import reason_of

CAMERAS, RIG, PROJECT = "cameras.json", "rig.json", "project.json"
HINT = "Name a session, a result that was accepted, a cameras.json, or a project with a calibrated rig."
SCHEMA_VERSION = 1
COLLECTED = ("calibrate", "collect")  # how the arguments of a collected result begin
LINKS: Mapping[str, tuple[type[Any], Callable[[Mapping[str, Any]], Any]]] = {
    "hand_eye": (HandEye, hand_eye_from),
    "guide": (LinearGuide, guide_from),
    "axis": (RotationAxis, axis_from),
}
"""Results that are a single link of the rig: the field of the file that holds one, its noun, and how it is read."""


def accept(
    session: CalibrationSession,
    target: Path,
    progress: Progress | None = None,
    *,
    valid_days: float | None = None,
    temperature_c: float | None = None,
) -> Calibrated:
    """Solve a session afresh and write the result.

    Parameters
    ----------
    target : a file for cameras, projector (with its cameras), axis, hand-eye and guide; for the rig a project, or a folder for cameras.json and rig.json
    valid_days : after which it expires
    temperature_c : when the images were taken; default: the median of what was measured with them

    Raises
    ------
    CalibrationError
        The observations do not determine the result.
    StorageError
        It cannot be written.
    """
    session.solve_with_parts(progress, afresh=True)
    return keep(session.snapshot(), target, valid_days=valid_days, temperature_c=temperature_c)


def keep(snapshot: Snapshot, target: Path, *, valid_days: float | None = None, temperature_c: float | None = None) -> Calibrated:
    """Write the last solution of a session as `accept` does, where it was just solved afresh.

    Raises
    ------
    CalibrationError
        Nothing was solved yet.
    StorageError
        It cannot be written.
    """
    solved, kind = require_solution(snapshot.draft), snapshot.setup.kind
    entered = [one for one in snapshot.observations if one.id in solved.of]
    inputs = {f"{one.id} {camera}": image.checksum for one in entered for camera, image in one.images.items()}
    warm = [one.temperature_c for one in entered if one.temperature_c is not None]
    result, target = kind.result(solved), Path(target)
    provenance = Provenance(
        datetime.now(UTC).isoformat(timespec="seconds"),
        kind.method(result),
        inputs,
        temperature_c=temperature_c if temperature_c is not None or not warm else median(warm),
        valid_days=valid_days,
        arguments=(*COLLECTED, kind.name, "--session", snapshot.folder.name),
        folder=_relative_folder(snapshot.folder.parent, _place_of(result, target)),
    )
    if isinstance(result, CameraArrayCalibration):
        result = replace(result, provenance=provenance)
        write_cameras(target, result)
    elif isinstance(result, ProjectorCalibration):
        result = replace(result, provenance=provenance)
        write_cameras(target, replace(solved.cameras, projector=result))
    elif isinstance(result, RigCalibration):
        result = replace(result, provenance=provenance)
        _write_rig(result, solved.solution, target)
    else:
        write_json(target, _link(result, provenance))
    return result


def accept_result(snapshot: Snapshot, merged: Known, place: Path, project: Path | None, *, valid_days: float | None = None) -> Known:
    """Save a result that was just evaluated and return the calibration in use, dated.

    Parameters
    ----------
    merged : what is calibrated with the result, by `Kind.merge`
    place : folder for the result itself, next to its session
    project : whose calibration it becomes; None: the rig, where one is calibrated, is written to ``place``, to be offered again

    Raises
    ------
    StorageError
        It cannot be written.
    """
    kind = snapshot.setup.kind
    kept = keep(snapshot, (project or place) if not kind.file else place / kind.file, valid_days=valid_days)
    if isinstance(kept, RigCalibration):
        return Known(kept.cameras, kept)
    cameras = kept if isinstance(kept, CameraArrayCalibration) else merged.cameras
    if isinstance(kept, ProjectorCalibration) and cameras is not None:
        cameras = replace(cameras, projector=kept)
    if merged.rig is None or cameras is None:
        return Known(cameras)
    rig = replace(merged.rig, cameras=cameras)
    if project is None:
        write_rig(rig, place)
    else:
        opened = ProjectFolder.open(project)
        with opened.lock():
            opened.save_calibration(rig)
    return Known(cameras, rig)


def write_rig(rig: RigCalibration, folder: Path) -> None:
    """Write a rig as `read_result` reads it: cameras.json and rig.json. Raises StorageError."""
    write_cameras(folder / CAMERAS, rig.cameras)
    write_json(folder / RIG, rig_calibration_document(rig))


def read_result(path: Path) -> Calibrated:
    """Read an earlier result: what `accept` wrote, a cameras.json, or the rig of a project.

    Raises
    ------
    InputError
        There is none; names the file.
    """
    path = Path(path)
    if path.is_dir():
        if (path / PROJECT).is_file():
            path = path / "calibration"
        document = read_document(path / RIG)
        return _build(path / RIG, lambda: rig_calibration_from(document, read_cameras(path / CAMERAS)))
    document = read_document(path)
    found = next((name for name in LINKS if name in document), None)
    return read_cameras(path) if found is None else _build(path, lambda: LINKS[found][1](document[found]))


def _place_of(result: Calibrated, target: Path) -> Path:
    """The folder in which the files of a result lie."""
    if not isinstance(result, RigCalibration):
        return target.parent
    return target / "calibration" if (target / PROJECT).is_file() else target


def _relative_folder(folder: Path, place: Path) -> str:
    try:
        return Path(os.path.relpath(folder.resolve(), place.resolve())).as_posix()
    except ValueError:  # another drive
        return folder.resolve().as_posix()


def _write_rig(result: RigCalibration, solution: object, target: Path) -> None:
    if (target / PROJECT).is_file():
        uncertainty = uncertainty_of(solution) if isinstance(solution, RigSolution) else None
        project = ProjectFolder.open(target)
        with project.lock():
            project.save_calibration(result, uncertainty)
        return
    write_rig(result, target)


def _link(result: Any, provenance: Provenance) -> dict[str, Any]:
    name = next(name for name, (noun, _) in LINKS.items() if isinstance(result, noun))
    document = {"schema_version": SCHEMA_VERSION, name: link_document(result), "provenance": asdict(provenance)}
    if isinstance(result, HandEye):  # the field that `calibrate guide --hand-eye` and `calibrate collect --hand-eye` read
        document["flange_from_camera"] = result.flange_from_camera.matrix.tolist()
    return document


def read_document(path: Path) -> Any:
    """Read a stored calibration as JSON. Raises InputError."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", HINT) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not JSON: {reason_of(error)}.", HINT) from error
    if not isinstance(document, dict):
        raise InputError(f"{path} holds no calibration.", HINT)
    return document


def _build(path: Path, make: Callable[[], Calibrated]) -> Calibrated:
    try:
        return make()
    except (KeyError, TypeError, ValueError, AttributeError, FrameMismatch) as error:
        raise InputError(f"{path} holds no calibration: {error}.", HINT) from error
