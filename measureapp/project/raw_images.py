"""What becomes of raw images: kept (always, unless a person decides otherwise), compressed without loss, or removed by choice."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from measureapp.errors import Damaged, InputError, StorageError
from measureapp.progress import Progress
from measureapp.project.frame_store import npy_head, read_images
from measureapp.project.journal import disk, publish
from measureapp.project.journal.entries import Entry, FileState
from measureapp.project.journal.state import Contents, Journal, remedy
from measureapp.project.raw_file import COMPRESSED, head_of, read_compressed, write_compressed

RAW = ".npy"
COMPRESS, EXPAND, REMOVE = "raw images compressed", "raw images expanded", "raw images removed"
THREADS = 2


@dataclass(frozen=True, slots=True)
class RawImages:
    """Images of one viewpoint on disk."""

    viewpoint_id: str
    state: str  # "raw", "compressed", "removed" or "mixed"
    bytes: int


def list_raw(journal: Journal) -> tuple[RawImages, ...]:
    """Return the state of the images of all stored viewpoints; raises StorageError."""
    contents = _require(journal)
    return tuple(_state(contents, viewpoint_id) for viewpoint_id in sorted(contents.viewpoints))


def compress(journal: Journal, viewpoint_id: str) -> None:
    """Compress the images of a viewpoint; the raw files go only when the compressed ones decode to the same bytes. Raises StorageError."""

    def one(raw: Path, known: FileState) -> tuple[Path, publish.Staged]:
        images = read_images(raw)
        target = raw.with_name(f"{raw.name}{COMPRESSED}")
        with publish.staging(target) as part:
            write_compressed(part, images, bytes.fromhex(known.head))
            if not np.array_equal(read_compressed(part), images):
                raise StorageError(
                    f"{raw} could not be compressed without loss, and stays as it is.", "Check memory and disk of the computer."
                )
            disk.sync_file(part)
            return target, publish.Staged(part, disk.state_of(part))

    _replace(journal, viewpoint_id, RAW, COMPRESS, one)


def expand(journal: Journal, viewpoint_id: str) -> None:
    """Turn compressed images into raw ones again, byte for byte. Raises StorageError."""

    def one(compressed: Path, _: FileState) -> tuple[Path, publish.Staged]:
        images = read_compressed(compressed)
        target = compressed.with_name(compressed.name.removesuffix(COMPRESSED))
        head = head_of(compressed) or npy_head(images)
        with publish.staging(target) as part:
            return target, publish.Staged(part, disk.write_hashed(part, head, images.reshape(-1).view(np.uint8).data))

    _replace(journal, viewpoint_id, COMPRESSED, EXPAND, one)


def remove_images(journal: Journal, viewpoint_id: str) -> None:
    """Remove the images of a viewpoint for good; read-backs and results stay, the journal keeps their hashes. Raises StorageError."""
    contents = _require(journal)
    files = [journal.project / name for name in _files(contents, viewpoint_id, (RAW, COMPRESSED))]
    if files:
        publish.publish(journal.project, Entry(REMOVE, {}, viewpoint_id), {}, files)


def for_all(journal: Journal, act: Callable[[Journal, str], None], progress: Progress) -> None:
    """Apply one of the above to every stored viewpoint; also the cancellation point. Raises StorageError, Cancelled."""
    viewpoints = sorted(_require(journal).viewpoints)
    for index, viewpoint_id in enumerate(viewpoints):
        progress.report(index, len(viewpoints), viewpoint_id)
        act(journal, viewpoint_id)
    progress.report(1, 1, "")


def _replace(
    journal: Journal, viewpoint_id: str, ending: str, kind: str, one: Callable[[Path, FileState], tuple[Path, publish.Staged]]
) -> None:
    contents = _require(journal)
    known = {name: contents.files[name] for name in _files(contents, viewpoint_id, (ending,))}
    if not known:
        return
    for name, state in known.items():
        if not journal.is_same(name, state):
            raise Damaged(f"{journal.project / name} is not what was stored.", remedy(name, viewpoint_id))
    staged: dict[Path, publish.Staged] = {}
    with ThreadPoolExecutor(THREADS, "raw images") as pool:
        made = [pool.submit(one, journal.project / name, state) for name, state in known.items()]
        try:
            with disk.explained(journal.project / "stacks" / viewpoint_id):
                for future in made:
                    target, ready = future.result()
                    staged[target] = ready
        except BaseException:
            publish.discard(future.result()[1].part for future in made if future.exception() is None)
            raise
    publish.publish(journal.project, Entry(kind, {}, viewpoint_id), staged, [journal.project / name for name in known])


def _files(contents: Contents, viewpoint_id: str, endings: tuple[str, ...]) -> list[str]:
    return [name for name in sorted(contents.files) if name.startswith(f"stacks/{viewpoint_id}/") and name.endswith(endings)]


def _state(contents: Contents, viewpoint_id: str) -> RawImages:
    raw, compressed = (_files(contents, viewpoint_id, (ending,)) for ending in (RAW, COMPRESSED))
    state = "mixed" if raw and compressed else "raw" if raw else "compressed" if compressed else "removed"
    return RawImages(viewpoint_id, state, sum(contents.files[name].size for name in (*raw, *compressed)))


def _require(journal: Journal) -> Contents:
    contents = journal.contents()
    if contents is None:
        raise InputError(f"{journal.project} has no journal yet.", "Process it once with this version.")
    return contents
