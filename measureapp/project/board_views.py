"""Sightings of the calibration board on disk: a PNG per camera and the read-back, so that any calibration can be solved again."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np

from measureapp.arrays import read_only
from measureapp.data.board import BoardView
from measureapp.errors import StorageError
from measureapp.project.atomic import replacing, write_json
from measureapp.project.documents import readback_document, readback_from

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
    }
    write_json(place / DESCRIPTION, document)


def load_all(folder: Path) -> tuple[BoardView, ...]:
    """Return all finished sightings below ``folder``, sorted by id. Raises StorageError naming a damaged file."""
    return tuple(_load(path.parent) for path in sorted(folder.glob(f"*/{DESCRIPTION}")))


def _load(place: Path) -> BoardView:
    path = place / DESCRIPTION
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        readback = readback_from(document["readback"])
        cameras = document["cameras"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Take the view again.") from error
    images = {}
    for camera in cameras:
        pixels = cv2.imread(str(place / f"{camera}.png"), cv2.IMREAD_UNCHANGED)
        if pixels is None:
            raise StorageError(f"{place / camera}.png cannot be read.", "Take the view again.")
        images[camera] = read_only(pixels)
    return BoardView(document["viewpoint_id"], images, readback)
