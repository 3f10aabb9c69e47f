"""Care of a project as files on disk, also of one that does not open any more: verify it, accept changes, renew its journal."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from measureapp.errors import Damaged, InputError
from measureapp.progress import NoProgress, Progress
from measureapp.project import checks, takeover
from measureapp.project.calibration import board_views
from measureapp.project.folder_lock import lock_folder
from measureapp.project.frame_store import FrameStore
from measureapp.project.journal import publish, seal
from measureapp.project.journal.state import Journal

SETTINGS = "project.json"


def require_project(path: Path) -> None:
    """Raise InputError where a folder is no project."""
    if not Path(path).exists():
        raise InputError(
            f"The folder {path} does not exist.", "Check the path. If its disk was removed, connect it again; if it was moved, put it back."
        )
    if not (Path(path) / SETTINGS).is_file():
        raise InputError(f"{path} is not a MeasureApp project.", f"Name a folder that contains a {SETTINGS}.")


def verify(path: Path, progress: Progress = NoProgress()) -> checks.Verified:  # noqa: B008 - stateless
    """Compare every stored byte with its checksum, in a project of an earlier version those of all images; nothing is written.

    Raises
    ------
    InputError
        The folder is no project.
    StorageError
        It cannot be read.
    Cancelled
        From ``progress``.
    """
    path = Path(path)
    try:
        verified = checks.verify(path, Journal(path), progress)
    except Damaged as error:
        return checks.of_journal(error)
    if verified is not None:
        return verified
    require_project(path)
    frames, views = FrameStore(path / "stacks"), path / "calibration" / "views"
    problems = {viewpoint: frames.find_damage(viewpoint) for viewpoint in frames.list_stored()} | board_views.find_damage(views)
    return checks.of_images(path, (*frames.list_stored(), *board_views.list_stored(views)), problems)


def accept_changes(path: Path, names: Sequence[str]) -> None:
    """Enter files that were changed by hand in the journal.

    Raises
    ------
    InputError
        There is no such file, or it holds images or read-backs, which are never changed.
    StorageError
        The project is in use, or cannot be written to.
    """
    path = Path(path)
    require_project(path)
    for name in names:
        inside = ".." not in Path(name).parts and not Path(name).is_absolute() and name not in publish.OWN
        if not inside or name.startswith(("stacks/", "calibration/views/")) or not (path / name).is_file():
            raise InputError(
                f"{path / name} is not a file that can be accepted.", "Name a file of the project, such as inspection/program.toml."
            )
    with lock_folder(path):
        if Journal(path).contents() is None:
            takeover.take_over(path)
        publish.recover(path)
        for name in names:
            publish.accept(path, path / name)
        seal.write(path)


def renew_journal(path: Path) -> None:
    """Make a new journal from what is there; the former one is kept under another name. Raises InputError, StorageError."""
    path = Path(path)
    require_project(path)
    with lock_folder(path):
        takeover.renew(path)
        seal.write(path)
