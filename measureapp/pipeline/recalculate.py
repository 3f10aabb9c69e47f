"""Recalculation of a calibration from the stored images of the board of a project or a session."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from measureapp.calibration_session.accepting import COLLECTED, keep, read_document
from measureapp.calibration_session.repeat import repeat_session
from measureapp.calibration_session.session import CalibrationSession
from measureapp.errors import InputError, StorageError
from measureapp.pipeline.calibrate import calibrate_from_views, checksums_of
from measureapp.pipeline.recording.learn import learn
from measureapp.pipeline.recording.stages import is_recording
from measureapp.progress import Progress
from measureapp.project.calibration.camera_file import cameras_document
from measureapp.project.differences import Difference, compare_documents
from measureapp.project.documents import rig_calibration_document
from measureapp.project.folder import ProjectFolder


@dataclass(frozen=True, slots=True)
class Recalculation:
    """The differences between a stored and a recalculated calibration."""

    differences: tuple[Difference, ...]
    numbers: int
    images: int


def recalculate_session(result: Path, progress: Progress) -> Recalculation:
    """Repeat detection and solution of the session from which a result was accepted, and compare; nothing is written.

    Parameters
    ----------
    result : the file, or for a rig the folder, that `calibration_session.accepting.accept` wrote

    Raises
    ------
    InputError, StorageError
        The session or an image is missing, or is not the one the calibration was made from.
    """
    stored = _documents(result)
    provenance = provenance_of(stored)
    place = (result if result.is_dir() else result.parent) / provenance["folder"] / provenance["arguments"][-1]
    with TemporaryDirectory() as folder:
        solved = repeat_session(CalibrationSession.open(place), provenance["inputs"], Path(folder) / "session", progress)
        written = Path(folder) / "result"
        keep(solved.snapshot(), written, valid_days=provenance.get("valid_days"), temperature_c=provenance.get("temperature_c"))
        found, numbers = compare_documents(stored, _documents(written))
    return Recalculation(found, numbers, len(provenance["inputs"]))


def is_collected(result: Path) -> bool:
    """Whether a result was accepted from a session of collecting."""
    return tuple(provenance_of(_documents(result)).get("arguments", ()))[:2] == COLLECTED


def provenance_of(document: Any) -> Mapping[str, Any]:
    """Return the provenance of a stored calibration; empty where it has none."""
    try:
        found = document.get("rig", document.get("projector", document))["provenance"]
    except (AttributeError, KeyError, TypeError):
        return {}
    return found if isinstance(found, Mapping) else {}


def _documents(result: Path) -> Any:
    """The stored numbers of a result: of one file, or of both files of a rig."""
    files = {name: result / f"{name}.json" for name in ("cameras", "rig")} if result.is_dir() else {"": result}
    documents = {name: read_document(file) for name, file in files.items()}
    documents.get("rig", {}).pop("checksum", None)  # of both files, with their date
    return documents if result.is_dir() else documents[""]


def recalculate_project(project: ProjectFolder, progress: Progress) -> Recalculation:
    """Solve a project's calibration from its stored images of the board and compare it with the stored one; nothing is written.

    Raises
    ------
    InputError
        The project has no calibration or no images of the board.
    StorageError
        An image is missing or not the one the calibration was made from.
    """
    stored, views = project.calibration(), project.board_views(progress)
    if stored is None or not views:
        missing = "calibration" if stored is None else "images of the board"
        raise InputError(f"{project.path} has no {missing}.", "Give a project that calibrated its rig, or calibrate first.")
    known, seen = dict(stored.provenance.inputs), checksums_of(views)
    expected = {name: known[name] for name in known if "/" in name}
    if not expected:
        raise InputError(f"The calibration of {project.path} does not name its images.", "Calibrate again with this version.")
    for name in (*expected, *seen):
        if expected.get(name) != seen.get(name):
            state = "is missing" if name not in seen else "was added later" if name not in expected else "has changed"
            raise StorageError(
                f"The image {name} of the board, from which {project.path} was calibrated, {state}.", "Restore it from a backup."
            )
    solved = (
        learn(project, progress).rig
        if is_recording(project)
        else calibrate_from_views(views, project.settings.board, project.rig(), progress).calibration
    )
    if solved is None:
        raise InputError(f"The board views of {project.path} do not determine a rig any more.", "Run `measureapp process PROJECT`.")
    documents = [{"cameras": cameras_document(one.cameras), "rig": rig_calibration_document(one)} for one in (stored, solved)]
    found, numbers = compare_documents(*documents)
    return Recalculation(found, numbers, len(seen))
