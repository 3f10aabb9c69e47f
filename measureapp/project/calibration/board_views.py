"""Stored images of the calibration board: a PNG per camera and the axis read-back, for solving a calibration again."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from datetime import datetime
from math import inf
from pathlib import Path

import cv2
import numpy as np

from measureapp.arrays import ImageArray, in_bands, read_only
from measureapp.data.board import BoardView
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback
from measureapp.data.rig import NAME
from measureapp.errors import FrameMismatch, InputError, StorageError
from measureapp.progress import Progress
from measureapp.project.atomic import replacing, replacing_together, write_json
from measureapp.project.documents import conditions_document, conditions_from, readback_document, readback_from
from measureapp.project.frame_store import checksum
from measureapp.project.images import read_image
from measureapp.project.journal.entries import Entry
from measureapp.project.text_document import check_version

FORMAT = 1
DESCRIPTION, STORED = "view.json", "board view stored"


def save(folder: Path, view: BoardView) -> None:
    """Write the images and the description of one viewpoint below ``folder``; it is there as a whole or not at all. Raises StorageError."""
    document = {
        "schema_version": 1,
        "viewpoint_id": view.viewpoint_id,
        "cameras": list(view.images),
        "readback": readback_document(view.readback),
        "conditions": conditions_document(view.conditions),
        "checksums": {camera: checksum(np.asarray(pixels)) for camera, pixels in view.images.items()},
    }
    with replacing_together(folder / view.viewpoint_id, Entry(STORED, {}, view.viewpoint_id), stale=("*.png",)) as place:
        for camera, pixels in view.images.items():
            encoded, data = cv2.imencode(".png", np.asarray(pixels))
            if not encoded:
                raise StorageError(f"The image of camera {camera} cannot be encoded.", "Take the view again.")
            with replacing(place / f"{camera}.png") as temporary:
                temporary.write_bytes(data.tobytes())
        write_json(place / DESCRIPTION, document)


def list_stored(folder: Path) -> tuple[str, ...]:
    """Return the ids of all complete views below ``folder``, sorted."""
    return tuple(path.parent.name for path in sorted(folder.glob(f"*/{DESCRIPTION}")))


def load_all(folder: Path, progress: Progress | None = None) -> tuple[BoardView, ...]:
    """Load all complete views below ``folder``, in the order of acquisition; cancelled between two views. Raises StorageError naming a damaged file."""
    described = _in_order(folder)

    def load(start: int, stop: int) -> list[BoardView]:
        if progress is not None:
            progress.check()
        return [_load(folder / one.viewpoint_id, one) for one in described[start:stop]]

    return tuple(view for views in in_bands(load, len(described), len(described)) for view in views)


def load_readbacks(folder: Path) -> dict[str, tuple[tuple[str, ...], AxisReadback]]:
    """Return cameras and read-back of all complete views in the order of acquisition, without the images. Raises StorageError."""
    return {one.viewpoint_id: (one.cameras, one.readback) for one in _in_order(folder)}


def find_damage(folder: Path) -> dict[str, tuple[str, ...]]:
    """Compare every image of the board below ``folder`` with its checksum; return the problems of each damaged view, in words."""
    problems = {viewpoint_id: _problems(folder / viewpoint_id) for viewpoint_id in list_stored(folder)}
    return {viewpoint_id: wrong for viewpoint_id, wrong in problems.items() if wrong}


@dataclass(frozen=True, slots=True)
class _Description:
    viewpoint_id: str
    cameras: tuple[str, ...]
    readback: AxisReadback
    checksums: dict[str, str]  # camera -> checksum of its pixels
    conditions: Conditions | None
    taken_s: float  # POSIX time of acquisition; -inf if unknown


def _problems(place: Path) -> tuple[str, ...]:
    wrong = []
    try:
        description = _load_description(place)
        for camera in description.cameras:
            if checksum(_image(place, camera)) != description.checksums.get(camera):
                wrong.append(f"{place / camera}.png differs from its stored checksum")
    except StorageError as error:
        wrong.append(error.message.rstrip("."))
    return tuple(wrong)


def _in_order(folder: Path) -> list[_Description]:
    """Return the descriptions in the order of acquisition, those without a time first and by id.

    The order shows when the robot approached a pose anew, with another error, and when it was stationary in between.
    """
    return sorted((_load_description(folder / viewpoint_id) for viewpoint_id in list_stored(folder)), key=lambda one: one.taken_s)


def _load(place: Path, description: _Description) -> BoardView:
    images = {camera: _image(place, camera) for camera in description.cameras}
    return BoardView(description.viewpoint_id, images, description.readback, description.conditions)


def _load_description(place: Path) -> _Description:
    path = place / DESCRIPTION
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        check_version(path, document, FORMAT)
        cameras, checksums = _names(document["cameras"]), dict(document.get("checksums", {}))
        readback, conditions = readback_from(document["readback"]), conditions_from(document.get("conditions"))
        taken_s = datetime.fromisoformat(conditions.taken_at).timestamp() if conditions is not None else -inf
        return _Description(document["viewpoint_id"], cameras, readback, checksums, conditions, taken_s)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError, FrameMismatch) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Take the view again.") from error


def _names(cameras: object) -> tuple[str, ...]:
    """Return names of cameras, which name files in the folder of a view. Raises ValueError for any others."""
    if not isinstance(cameras, list) or not all(isinstance(name, str) and re.fullmatch(NAME, name) for name in cameras):
        raise ValueError("its cameras are not names")
    return tuple(cameras)


def _image(place: Path, camera: str) -> ImageArray:
    try:
        return read_only(read_image(place / f"{camera}.png"))
    except InputError as error:
        raise StorageError(error.message, "Take the view again, or restore the file from a backup.") from error
