"""Detected corners of a camera calibration, stored so that it can be solved again without the images."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.sightings import ALL_MARKS, Rejection, Sighting
from measureapp.data.board import AnyBoard, BoardDescription
from measureapp.errors import InputError
from measureapp.project.atomic import write_json
from measureapp.project.text_document import reason_of

SCHEMA_VERSION = 1
BOARD: TypeAdapter[Any] = TypeAdapter(AnyBoard)


@dataclass(frozen=True, slots=True, eq=False)
class CameraInputs:
    """Input of a camera calibration, with the image files of the observations."""

    problem: CameraArrayProblem
    images: Mapping[tuple[str, str], str]  # (camera, view) -> name of the file


def write_camera_inputs(path: Path, inputs: CameraInputs) -> None:
    """Write everything the solution depends on, with full floating-point precision."""
    problem = inputs.problem
    document = {
        "schema_version": SCHEMA_VERSION,
        "board": problem.board.model_dump(mode="json") | {"kind": getattr(problem.board, "kind", "checkerboard")},
        "reference": problem.reference,
        "sizes_px": {name: list(size) for name, size in problem.sizes_px.items()},
        "distortion_count": problem.distortion_count,
        "free_bow": problem.free_bow,
        "free_marks": problem.free_marks,
        "sightings": [
            {"camera": one.camera, "view": one.view, "image": inputs.images[one.camera, one.view], "corners_px": one.corners_px.tolist()}
            | ({} if len(one.ids) == problem.board.count else {"ids": one.ids.tolist()})
            | ({} if one.sigma_px is None else {"sigma_px": one.sigma_px.tolist()})
            | ({"edge_px": one.edge_px} if one.edge_px else {})
            for one in problem.sightings
        ],
        "rejected": [
            {"camera": one.camera, "view": one.view, "image": inputs.images[one.camera, one.view], "reason": one.reason}
            for one in problem.rejected
        ],
    }
    write_json(Path(path), document)


def read_camera_inputs(path: Path) -> CameraInputs:
    """Read what `write_camera_inputs` wrote.

    Raises
    ------
    InputError
        The file cannot be read, or a field is missing or invalid.
    """
    path = Path(path)
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        if document["schema_version"] != SCHEMA_VERSION:
            raise ValueError(f"schema_version is {document['schema_version']!r}, not {SCHEMA_VERSION}")
        board = BOARD.validate_python(document["board"])
        problem = CameraArrayProblem(
            board=board,
            reference=str(document["reference"]),
            sizes_px={str(name): (int(width), int(height)) for name, (width, height) in document["sizes_px"].items()},
            sightings=tuple(_sighting_from(entry, board) for entry in document["sightings"]),
            rejected=tuple(Rejection(str(one["camera"]), str(one["view"]), str(one["reason"])) for one in document["rejected"]),
            distortion_count=int(document["distortion_count"]),
            free_bow=bool(document["free_bow"]),
            free_marks=bool(document.get("free_marks", True)),
        )
        _require_whole(problem)
        entries = [*document["sightings"], *document["rejected"]]
        return CameraInputs(problem, {(str(one["camera"]), str(one["view"])): str(one["image"]) for one in entries})
    except OSError as error:
        raise InputError(
            f"{path} cannot be read: {error.strerror or error}.", "Give a file written by `measureapp calibrate cameras`."
        ) from error
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError(
            f"{path} does not hold the corners of a camera calibration: {reason_of(error)}.", "Detect the corners again."
        ) from error


def _require_whole(problem: CameraArrayProblem) -> None:
    """Raise ValueError for inconsistent parts of a file."""
    for camera, size in problem.sizes_px.items():
        if min(size) < 1:
            raise ValueError(f"images of {camera} are {size[0]} × {size[1]} px")
    for one in problem.sightings:
        if one.camera not in problem.sizes_px:
            raise ValueError(f"the size of the images of {one.camera} is not there")
        if np.any((one.ids < 0) | (one.ids >= problem.board.count)):
            raise ValueError(_not_of(one.camera, one.view, problem.board))


def _not_of(camera: str, view: str, board: BoardDescription) -> str:
    return f"corners of {camera} in view {view} are not those of the {board.label}"


def _sighting_from(entry: dict[str, Any], board: BoardDescription) -> Sighting:
    corners = np.array(entry["corners_px"], float)
    if not np.all(np.isfinite(corners)):
        raise ValueError(f"corners of {entry['camera']} in view {entry['view']} are not numbers")
    if "ids" not in entry and len(corners) != board.count:
        raise ValueError(_not_of(entry["camera"], entry["view"], board))
    ids = np.array(entry["ids"], np.int64) if "ids" in entry else ALL_MARKS
    sigma = np.array(entry["sigma_px"], float) if "sigma_px" in entry else None
    return Sighting(str(entry["camera"]), str(entry["view"]), corners, ids, sigma, float(entry.get("edge_px", 0.0)))
