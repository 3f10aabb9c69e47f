"""A project's calibration solved again from its stored images of the board."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.errors import InputError, StorageError
from measureapp.pipeline.calibrate import calibrate_from_views, checksums_of
from measureapp.progress import Progress
from measureapp.project.calibration.camera_file import cameras_document
from measureapp.project.differences import Difference, compared
from measureapp.project.documents import rig_calibration_document
from measureapp.project.folder import ProjectFolder


@dataclass(frozen=True, slots=True)
class Again:
    """What came out."""

    differences: tuple[Difference, ...]
    numbers: int
    images: int


def calibration_again(project: ProjectFolder, progress: Progress) -> Again:
    """Solve a project's calibration from its stored images of the board and compare it with the stored one; nothing is written.

    Raises
    ------
    InputError
        The project has no calibration or no images of the board.
    StorageError
        An image is missing or not the one the calibration was made from.
    """
    stored, views = project.calibration(), project.board_views()
    if stored is None or not views:
        missing = "calibration" if stored is None else "images of the board"
        raise InputError(f"{project.path} has no {missing}.", "Give a project that calibrated its rig, or calibrate first.")
    known, seen = dict(stored.provenance.inputs), checksums_of(views)
    expected = {name: known[name] for name in known if "/" in name}
    if not expected:
        raise InputError(f"The calibration of {project.path} does not name its images.", "Calibrate again with this version.")
    for name in (*expected, *seen):
        if expected.get(name) != seen.get(name):
            state = "is missing" if name not in seen else "came later" if name not in expected else "is not the one it was"
            raise StorageError(
                f"The image {name} of the board, from which {project.path} was calibrated, {state}.", "Restore it from a backup."
            )
    solved = calibrate_from_views(views, project.settings.board, project.rig(), progress).rig.calibration
    documents = [{"cameras": cameras_document(one.cameras), "rig": rig_calibration_document(one)} for one in (stored, solved)]
    found, numbers = compared(*documents)
    return Again(found, numbers, len(seen))
