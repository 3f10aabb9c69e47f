"""Recorded images of the board in a folder: assignment of files to cameras and board positions."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from measureapp.data.fringe import AxisReadback
from measureapp.errors import InputError
from measureapp.project.calibration import board_views
from measureapp.project.tables import natural_order

ENDINGS = frozenset({".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp"})
ONLY_CAMERA = "camera"
HOW_TO_NAME = "Name the images by camera and number, such as left01.png and right01.png, or use one folder per camera."


@dataclass(frozen=True, slots=True, eq=False)
class RecordedPosition:
    """One position of the board."""

    name: str
    files: Mapping[str, Path]  # camera -> image; a camera may be missing
    readback: AxisReadback | None = None  # if it was recorded


def find_recorded(folder: Path) -> tuple[RecordedPosition, ...]:
    """Find the board positions recorded in ``folder``, in the natural order of their names.

    Supported layouts: board views of a project (with read-backs, in the order of acquisition), one folder per camera, and images
    named by camera and number, such as ``left01.png``; images of one number show the same position.

    Raises
    ------
    InputError
        There is no such folder, no image in it, or two images of the same camera and number.
    StorageError
        A board view of a project is damaged.
    """
    if not folder.is_dir():
        raise InputError(f"There is no folder {folder}.", "Choose the folder that holds the images of the board.")
    if board_views.list_stored(folder):
        return _of_project(folder)
    flat = _images_in(folder)
    named = flat or [path for place in sorted(folder.iterdir()) if place.is_dir() for path in _images_in(place)]
    if not named:
        raise InputError(f"There are no images in {folder}.", HOW_TO_NAME)
    positions: dict[str, dict[str, Path]] = defaultdict(dict)
    for path in named:
        camera, number = _camera_and_number(path, folder)
        if camera in positions[number]:
            raise InputError(f"{positions[number][camera].name} and {path.name} are both image {number} of camera {camera}.", HOW_TO_NAME)
        positions[number][camera] = path
    return tuple(RecordedPosition(number, positions[number]) for number in sorted(positions, key=natural_order))


def cameras_of(positions: tuple[RecordedPosition, ...]) -> tuple[str, ...]:
    """Return the names of all cameras, in order of appearance."""
    return tuple(dict.fromkeys(camera for position in positions for camera in position.files))


def _of_project(folder: Path) -> tuple[RecordedPosition, ...]:
    views = board_views.load_readbacks(folder)
    return tuple(
        RecordedPosition(name, {camera: folder / name / f"{camera}.png" for camera in cameras}, readback)
        for name, (cameras, readback) in views.items()
    )


def _images_in(folder: Path) -> list[Path]:
    found = [path for path in folder.iterdir() if path.is_file() and path.suffix.lower() in ENDINGS]
    return sorted(found, key=lambda path: natural_order(path.name))


def _camera_and_number(path: Path, folder: Path) -> tuple[str, str]:
    """Split a file name into camera and number; in a camera's own folder the whole name is the number."""
    if path.parent != folder:
        return path.parent.name, re.sub(rf"^{re.escape(path.parent.name)}[_\-. ]*", "", path.stem) or path.stem
    match = re.fullmatch(r"(.*?)[_\-. ]*(\d+)", path.stem)
    return (match[1] or ONLY_CAMERA, match[2]) if match else (ONLY_CAMERA, path.stem)
