"""Storage of raw fringe images and read-backs: permanent, checksummed, written once.

One folder per viewpoint: an uncompressed ``.npy`` per camera (the fastest durable format measured) and ``stack.json``, written
last, so that its absence marks an incomplete viewpoint.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from measureapp.arrays import read_only
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback, FringeStack, PatternSet
from measureapp.errors import StorageError
from measureapp.project.atomic import replacing, write_json
from measureapp.project.documents import conditions_document, conditions_from, readback_document, readback_from

RESERVE_BYTES = 500_000_000  # for results computed from the images
DESCRIPTION = "stack.json"


class FrameStore:
    """The fringe stacks of one project."""

    def __init__(self, folder: Path) -> None:
        self._folder = Path(folder)

    def list_stored(self) -> tuple[str, ...]:
        """Return the ids of the completely stored viewpoints, sorted."""
        return tuple(sorted(path.parent.name for path in self._folder.glob(f"*/{DESCRIPTION}")))

    def require_space(self, needed_bytes: int) -> None:
        """Check the free disk space. Raises StorageError when less than ``needed_bytes`` and a reserve are free."""
        place = self._folder.absolute()
        existing = next(folder for folder in (place, *place.parents) if folder.is_dir())
        free = shutil.disk_usage(existing).free
        if free < needed_bytes + RESERVE_BYTES:
            raise StorageError(
                f"{self._folder} has {free / 1e9:.1f} GB free; the images need {needed_bytes / 1e9:.1f} GB and {RESERVE_BYTES / 1e9:.1f} GB more.",
                "Free some space, choose another disk, or scan at a lower resolution.",
            )

    def store(self, stack: FringeStack) -> None:
        """Write ``stack`` durably and atomically; raises StorageError."""
        if stack.readback is None:
            raise StorageError(
                f"The stack of {stack.viewpoint_id} has no axis read-back.", "Store only stacks taken by a rig in a project."
            )
        folder = self._folder / stack.viewpoint_id
        checksums = {}
        for camera, images in stack.images.items():
            path = folder / f"{camera}.npy"
            with replacing(path) as temporary, temporary.open("wb") as file:
                np.save(file, images)
            checksums[path.name] = checksum(images)
        document = {
            "schema_version": 1,
            "viewpoint_id": stack.viewpoint_id,
            "patterns": stack.patterns.model_dump(mode="json"),
            "exposures_us": list(stack.exposures_us),
            "saturation": stack.saturation,
            "readback": readback_document(stack.readback),
            "conditions": conditions_document(stack.conditions),
            "approach": stack.approach,
            "checksums": checksums,
        }
        write_json(folder / DESCRIPTION, document)

    def load(self, viewpoint_id: str) -> FringeStack:
        """Load a stack, its images memory-mapped. Raises StorageError naming the damaged file."""
        folder = self._folder / viewpoint_id
        document = self._document(folder)
        try:
            images = {Path(name).stem: read_only_map(folder / name) for name in document["checksums"]}
            return FringeStack(
                viewpoint_id=document["viewpoint_id"],
                patterns=TypeAdapter(PatternSet).validate_python(document["patterns"]),
                exposures_us=tuple(document["exposures_us"]),
                images=images,
                saturation=int(document["saturation"]),
                readback=readback_from(document["readback"]),
                conditions=conditions_from(document.get("conditions")),
                approach=document.get("approach"),
            )
        except (KeyError, TypeError, ValueError) as error:
            raise StorageError(f"{folder / DESCRIPTION} does not describe a stack: {error}.", "Take this viewpoint again.") from error

    def conditions(self, viewpoint_id: str) -> Conditions | None:
        """Return the conditions of a stored stack without loading its images; None if they were not recorded."""
        return conditions_from(self._document(self._folder / viewpoint_id).get("conditions"))

    def readback(self, viewpoint_id: str) -> AxisReadback:
        """Return the read-back of a stored stack without loading its images. Raises StorageError when it is damaged."""
        folder = self._folder / viewpoint_id
        try:
            return readback_from(self._document(folder)["readback"])
        except (KeyError, TypeError, ValueError) as error:
            raise StorageError(f"{folder / DESCRIPTION} has no read-back: {error}.", "Take this viewpoint again.") from error

    def approach(self, viewpoint_id: str) -> str | None:
        """Return the id of the robot's approach of a stored stack without loading its images; None if it was not recorded."""
        approach: str | None = self._document(self._folder / viewpoint_id).get("approach")
        return approach

    def find_damage(self, viewpoint_id: str) -> tuple[str, ...]:
        """Compare all stored images of a viewpoint with their checksums; return the problems, in words."""
        folder = self._folder / viewpoint_id
        try:
            checksums = dict(self._document(folder)["checksums"])
        except StorageError as error:
            return (error.message.rstrip("."),)
        except (KeyError, TypeError, ValueError):
            return (f"{folder / DESCRIPTION} has no checksums",)
        problems = []
        for name, expected in checksums.items():
            path = folder / name
            if not path.is_file():
                problems.append(f"{path} is missing")
                continue
            try:
                found = checksum(read_only_map(path))
            except StorageError as error:
                problems.append(error.message.rstrip("."))
                continue
            if found != expected:
                problems.append(f"{path} differs from its stored checksum")
        return tuple(problems)

    def _document(self, folder: Path) -> Mapping[str, Any]:
        path = folder / DESCRIPTION
        try:
            return json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise StorageError(f"{path} cannot be read: {error}.", "Take this viewpoint again.") from error


def checksum(array: np.typing.NDArray[Any]) -> str:
    """Return the SHA-256 of the array's bytes."""
    return hashlib.sha256(np.ascontiguousarray(array).view(np.uint8).data).hexdigest()


def read_only_map(path: Path) -> Any:
    """Memory-map a ``.npy``. Raises StorageError when it is damaged or missing."""
    try:
        return read_only(np.load(path, mmap_mode="r", allow_pickle=False))
    except (OSError, ValueError, EOFError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Take this viewpoint again, or restore the file from a backup.") from error
