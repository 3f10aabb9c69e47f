"""Sightings of the calibration board on disk: a PNG per camera and the read-back, so that any calibration can be solved again."""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import datetime
from math import inf
from pathlib import Path

import cv2
import numpy as np

from measureapp.arrays import ImageArray, read_only
from measureapp.data.board import BoardView
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback
from measureapp.errors import FrameMismatch, InputError, StorageError
from measureapp.project.atomic import replacing, write_json
from measureapp.project.documents import conditions_document, conditions_from, readback_document, readback_from
from measureapp.project.frame_store import checksum
from measureapp.project.images import read_image

DESCRIPTION = "view.json"


def save(folder: Path, view: BoardView) -> None:
    """Write one sighting below ``folder``; its description last, so that a view without it was never finished."""
    place = folder / view.viewpoint_id
    for camera, pixels in view.images.items():
        encoded, data = cv2.imencode(".png", np.asarray(pixels))
        if not encoded:
            raise StorageError(f"The image of camera {camera} cannot be encoded.", "Take the view again.")
        with replacing(place / f"{camera}.png") as temporary:
            temporary.write_bytes(data.tobytes())
    document = {
        "schema_version": 1,
        "viewpoint_id": view.viewpoint_id,
        "cameras": list(view.images),
        "readback": readback_document(view.readback),
        "conditions": conditions_document(view.conditions),
        "checksums": {camera: checksum(np.asarray(pixels)) for camera, pixels in view.images.items()},
    }
    write_json(place / DESCRIPTION, document)


def stored(folder: Path) -> tuple[str, ...]:
    """Return the ids of all finished sightings below ``folder``, sorted."""
    return tuple(path.parent.name for path in sorted(folder.glob(f"*/{DESCRIPTION}")))


def load_all(folder: Path) -> tuple[BoardView, ...]:
    """Return all finished sightings below ``folder``, as they were taken. Raises StorageError naming a damaged file."""
    return tuple(_load(folder / one.viewpoint_id, one) for one in _as_taken(folder))


def readbacks(folder: Path) -> dict[str, tuple[tuple[str, ...], AxisReadback]]:
    """Return cameras and read-back of all finished sightings, as they were taken, without reading images. Raises StorageError."""
    return {one.viewpoint_id: (one.cameras, one.readback) for one in _as_taken(folder)}


def damaged(folder: Path) -> dict[str, tuple[str, ...]]:
    """Compare every image of the board below ``folder`` with its checksum; return what is wrong with which sighting, in words."""
    problems = {viewpoint_id: _problems(folder / viewpoint_id) for viewpoint_id in stored(folder)}
    return {viewpoint_id: wrong for viewpoint_id, wrong in problems.items() if wrong}


@dataclass(frozen=True, slots=True)
class _Description:
    viewpoint_id: str
    cameras: tuple[str, ...]
    readback: AxisReadback
    checksums: dict[str, str]  # camera -> of its pixels
    conditions: Conditions | None
    taken_s: float  # when, on the clock of the computer; -inf where it is not known


def _problems(place: Path) -> tuple[str, ...]:
    wrong = []
    try:
        described = _described(place)
        for camera in described.cameras:
            if checksum(_image(place, camera)) != described.checksums.get(camera):
                wrong.append(f"{place / camera}.png differs from what was stored")
    except StorageError as error:
        wrong.append(error.message.rstrip("."))
    return tuple(wrong)


def _as_taken(folder: Path) -> list[_Description]:
    """Return the descriptions in the order of their images, those without a time first and by id.

    The order says when the robot came to a pose anew, and with another error, and when it stood still meanwhile.
    """
    described = [_described(folder / viewpoint_id) for viewpoint_id in stored(folder)]
    return sorted(described, key=lambda one: one.taken_s)


def _load(place: Path, described: _Description) -> BoardView:
    images = {camera: _image(place, camera) for camera in described.cameras}
    return BoardView(described.viewpoint_id, images, described.readback, described.conditions)


def _described(place: Path) -> _Description:
    path = place / DESCRIPTION
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        cameras, checksums = tuple(document["cameras"]), dict(document.get("checksums", {}))
        readback, conditions = readback_from(document["readback"]), conditions_from(document.get("conditions"))
        taken_s = datetime.fromisoformat(conditions.taken_at).timestamp() if conditions is not None else -inf
        return _Description(document["viewpoint_id"], cameras, readback, checksums, conditions, taken_s)
    except (OSError, ValueError, KeyError, TypeError, FrameMismatch) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Take the view again.") from error


def _image(place: Path, camera: str) -> ImageArray:
    try:
        return read_only(read_image(place / f"{camera}.png"))
    except InputError as error:
        raise StorageError(error.message, "Take the view again, or restore the file from a backup.") from error
