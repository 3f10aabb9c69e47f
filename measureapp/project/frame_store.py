"""Storage of raw fringe images and read-backs: permanent, checksummed, written once.

One folder per viewpoint: a ``.npy`` per camera, (exposures, images, rows, columns), or ``.npy.zst`` once it was compressed (`raw_file`), and
``stack.json`` with patterns, exposures, read-back and the SHA-256 of every camera's pixels. A viewpoint is stored when the journal says so;
in projects of earlier versions, without a journal, when ``stack.json`` is there.
"""

from __future__ import annotations

import hashlib
import io
import json
import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from measureapp.arrays import read_only
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback, FringeStack, PatternSet
from measureapp.errors import Damaged, DiskFull, FrameMismatch, StorageError
from measureapp.project.documents import conditions_document, conditions_from, readback_document, readback_from
from measureapp.project.journal import disk, publish
from measureapp.project.journal.entries import Entry, FileState
from measureapp.project.journal.state import DROPPED, STORED, Journal, remedy
from measureapp.project.raw_file import COMPRESSED, read_compressed
from measureapp.project.text_document import check_version

RESERVE_BYTES = 500_000_000  # for results computed from the images
DESCRIPTION = "stack.json"
FORMAT = 1
IMAGE_FILE = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}\.npy")
RESTORE = "Take this viewpoint again, or restore the file from a backup."


class FrameStore:
    """The fringe stacks of one project."""

    def __init__(self, folder: Path, journal: Journal | None = None) -> None:
        self._folder = Path(folder)
        self._journal = journal or Journal(self._folder.parent)

    def list_stored(self) -> tuple[str, ...]:
        """Return the ids of the completely stored viewpoints, sorted."""
        contents = self._journal.contents()
        if contents is not None:
            return tuple(sorted(contents.viewpoints))
        return tuple(sorted(path.parent.name for path in self._folder.glob(f"*/{DESCRIPTION}")))

    def require_space(self, needed_bytes: int) -> None:
        """Check the free disk space. Raises DiskFull when less than ``needed_bytes`` and a reserve are free."""
        place = self._folder.absolute()
        existing = next(folder for folder in (place, *place.parents) if folder.is_dir())
        free = shutil.disk_usage(existing).free
        if free < needed_bytes + RESERVE_BYTES:
            raise DiskFull(
                f"{self._folder} has {free / 1e9:.1f} GB free; the images need {needed_bytes / 1e9:.1f} GB and {RESERVE_BYTES / 1e9:.1f} GB more.",
                "Free some space, choose another disk, or scan at a lower resolution.",
            )

    def store(self, stack: FringeStack) -> None:
        """Write ``stack`` durably and atomically; one of the same viewpoint is replaced at the end.

        Raises
        ------
        DiskFull, DiskFailed
            The stack is not stored, an earlier one of this viewpoint is untouched; storing can be repeated.
        StorageError
        """
        if stack.readback is None:
            raise StorageError(
                f"The stack of {stack.viewpoint_id} has no axis read-back.", "Store only stacks taken by a rig in a project."
            )
        project = self._folder.parent
        if not project.is_dir():
            raise publish.vanished(project)
        folder, staged = self._folder / stack.viewpoint_id, dict[Path, publish.Staged]()
        try:
            with disk.explained(folder):
                folder.mkdir(parents=True, exist_ok=True)
                disk.sync_folder(self._folder)
                for camera, images in stack.images.items():
                    with publish.staging(folder / f"{camera}.npy") as part:
                        staged[folder / f"{camera}.npy"] = publish.Staged(part, write_images(part, images))
                checksums = {path.name: one.state.sha256 for path, one in staged.items()}
                text = json.dumps(_document_of(stack, checksums), indent=2, allow_nan=False) + "\n"
                with publish.staging(folder / DESCRIPTION) as part:
                    staged[folder / DESCRIPTION] = publish.Staged(part, disk.write_hashed(part, b"", memoryview(text.encode())))
        except BaseException:
            publish.discard(one.part for one in staged.values())
            raise
        self._publish(stack.viewpoint_id, staged)

    def _publish(self, viewpoint_id: str, staged: Mapping[Path, publish.Staged]) -> None:
        contents = self._journal.contents()
        if contents is None:  # a folder without a journal: the description last
            for path, one in staged.items():
                with disk.explained(path):
                    disk.rename(one.part, path)
                    disk.sync_folder(path.parent)
            return
        former = [
            self._folder.parent / name for name, owner in contents.owner.items() if owner == viewpoint_id and name.startswith("stacks/")
        ]
        note = {"again": True} if viewpoint_id in contents.viewpoints else {}
        publish.publish(self._folder.parent, Entry(STORED, {}, viewpoint_id, note), staged, [path for path in former if path not in staged])

    def discard(self, viewpoint_id: str) -> None:
        """Remove a stored viewpoint, so that it can be taken again; the journal keeps that it was stored. Raises StorageError."""
        contents = self._journal.contents()
        if contents is None or viewpoint_id not in contents.viewpoints:
            raise StorageError(
                f"{self._folder.parent} has no viewpoint {viewpoint_id!r}.", f"Stored are: {', '.join(self.list_stored()) or 'none'}."
            )
        files = [
            self._folder.parent / name for name, owner in contents.owner.items() if owner == viewpoint_id and name.startswith("stacks/")
        ]
        publish.publish(self._folder.parent, Entry(DROPPED, {}, viewpoint_id), {}, files)

    def load(self, viewpoint_id: str, *, checked: bool = True) -> FringeStack:
        """Load a stack, its images memory-mapped, or decompressed.

        Parameters
        ----------
        checked : compare every byte with its checksum first; without, only where the images are looked at

        Raises
        ------
        Damaged
            Names the file, and what to do.
        StorageError
            The images were removed by choice, or cannot be read.
        """
        folder = self._folder / viewpoint_id
        document = self._document(folder)
        names = image_names(folder, document)
        if checked:
            self._check(viewpoint_id, document, names)
        try:
            return FringeStack(
                viewpoint_id=document["viewpoint_id"],
                patterns=TypeAdapter(PatternSet).validate_python(document["patterns"]),
                exposures_us=tuple(document["exposures_us"]),
                images={name.removesuffix(".npy"): read_images(folder / name) for name in names},
                saturation=int(document["saturation"]),
                readback=readback_from(document["readback"]),
                conditions=conditions_from(document.get("conditions")),
                approach=document.get("approach"),
            )
        except (KeyError, TypeError, ValueError, FrameMismatch) as error:
            raise StorageError(f"{folder / DESCRIPTION} does not describe a stack: {error}.", "Take this viewpoint again.") from error

    def conditions(self, viewpoint_id: str) -> Conditions | None:
        """Return the conditions of a stored stack without loading its images; None if they were not recorded."""
        return conditions_from(self._document(self._folder / viewpoint_id).get("conditions"))

    def readback(self, viewpoint_id: str) -> AxisReadback:
        """Return the read-back of a stored stack without loading its images. Raises StorageError when it is damaged."""
        folder = self._folder / viewpoint_id
        try:
            return readback_from(self._document(folder)["readback"])
        except (KeyError, TypeError, ValueError, FrameMismatch) as error:
            raise StorageError(f"{folder / DESCRIPTION} has no read-back: {error}.", "Take this viewpoint again.") from error

    def approach(self, viewpoint_id: str) -> str | None:
        """Return the id of the robot's approach of a stored stack without loading its images; None if it was not recorded."""
        approach: str | None = self._document(self._folder / viewpoint_id).get("approach")
        return approach

    def exposures_us(self, viewpoint_id: str) -> tuple[int, ...]:
        """Return the exposures of a stored stack, from long to short, without loading its images. Raises StorageError when it is damaged."""
        return tuple(int(exposure) for exposure in self._document(self._folder / viewpoint_id).get("exposures_us", ()))

    def find_damage(self, viewpoint_id: str) -> tuple[str, ...]:
        """Compare all stored images of a viewpoint with the checksums in its description; return the problems, in words."""
        folder = self._folder / viewpoint_id
        try:
            document = self._document(folder)
            names = image_names(folder, document)
        except StorageError as error:
            return (error.message.rstrip("."),)
        return tuple(filter(None, (_problem(folder / name, document["checksums"][name]) for name in names)))

    def _check(self, viewpoint_id: str, document: Mapping[str, Any], names: tuple[str, ...]) -> None:
        contents = self._journal.contents()
        folder = self._folder / viewpoint_id
        if contents is not None and viewpoint_id in contents.viewpoints:
            places = {name: f"stacks/{viewpoint_id}/{name}" for name in names}
            known = {name: [file for file in (place, f"{place}{COMPRESSED}") if file in contents.files] for name, place in places.items()}
            if not any(known.values()):
                raise StorageError(f"The images of {viewpoint_id} were removed to save space.", "Scan the part again to compute it anew.")
            for files in known.values():
                for file in files:
                    path = self._folder.parent / file
                    if not path.is_file():
                        raise Damaged(f"{path} is missing.", remedy(file, viewpoint_id))
                    self._journal.check(path)
            return
        for name in names:
            if problem := _problem(folder / name, document["checksums"][name]):
                raise Damaged(f"{problem}.", remedy(f"stacks/{viewpoint_id}/{name}", viewpoint_id))

    def _document(self, folder: Path) -> dict[str, Any]:
        """Read the description of a stack, which is what was stored. Raises StorageError."""
        path = folder / DESCRIPTION
        self._journal.check(path)
        try:
            document = json.loads(path.read_text(encoding="utf-8"))
            if not isinstance(document, dict):
                raise ValueError("it is no table")
        except (OSError, ValueError, RecursionError) as error:
            raise StorageError(f"{path} cannot be read: {error}.", "Take this viewpoint again.") from error
        check_version(path, document, FORMAT)
        return document


def _document_of(stack: FringeStack, checksums: Mapping[str, str]) -> dict[str, Any]:
    assert stack.readback is not None
    return {
        "schema_version": FORMAT,
        "viewpoint_id": stack.viewpoint_id,
        "patterns": stack.patterns.model_dump(mode="json"),
        "exposures_us": list(stack.exposures_us),
        "saturation": stack.saturation,
        "readback": readback_document(stack.readback),
        "conditions": conditions_document(stack.conditions),
        "approach": stack.approach,
        "checksums": dict(checksums),
    }


def image_names(folder: Path, document: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the names of the image files of a stack. Raises StorageError where it names none, or files outside its folder."""
    checksums = document.get("checksums")
    if not isinstance(checksums, dict):
        raise StorageError(f"{folder / DESCRIPTION} has no checksums.", RESTORE)
    for name in checksums:
        if not IMAGE_FILE.fullmatch(name):
            raise StorageError(f"{folder / DESCRIPTION} names {name!r}, which is no image file of this viewpoint.", RESTORE)
    return tuple(checksums)


def write_images(path: Path, images: np.typing.NDArray[Any]) -> FileState:
    """Write an array as ``.npy`` in blocks, hashing its pixels meanwhile, and sync the file. Raises OSError."""
    pixels = np.ascontiguousarray(images)
    return disk.write_hashed(path, npy_head(pixels), pixels.reshape(-1).view(np.uint8).data)


def npy_head(array: np.typing.NDArray[Any]) -> bytes:
    """Return what an ``.npy`` file begins with."""
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, np.lib.format.header_data_from_array_1_0(array))
    return head.getvalue()


def read_images(path: Path) -> Any:
    """Return the images of one camera, memory-mapped or decompressed. Raises StorageError when they are damaged or missing."""
    compressed = path.with_name(f"{path.name}{COMPRESSED}")
    return read_compressed(compressed) if compressed.is_file() and not path.is_file() else read_only_map(path)


def _problem(path: Path, expected: str) -> str:
    """Return in words how the images differ from their checksum; empty if they do not."""
    if not path.is_file() and not path.with_name(f"{path.name}{COMPRESSED}").is_file():
        return f"{path} is missing"
    try:
        return "" if checksum(read_images(path)) == expected else f"{path} differs from its stored checksum"
    except StorageError as error:
        return error.message.rstrip(".")


def checksum(array: np.typing.NDArray[Any]) -> str:
    """Return the SHA-256 of the array's bytes."""
    return hashlib.sha256(np.ascontiguousarray(array).view(np.uint8).data).hexdigest()


def read_only_map(path: Path) -> Any:
    """Memory-map a ``.npy``. Raises StorageError when it is damaged or missing."""
    try:
        return read_only(np.load(path, mmap_mode="r", allow_pickle=False))
    except (OSError, ValueError, EOFError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", RESTORE) from error
