"""Storage of the filter chain of the stitched cloud: the filters, and how many of them each point passed."""

from __future__ import annotations

import json
import zipfile
import zlib
from dataclasses import asdict
from pathlib import Path

import numpy as np

from measureapp.data.cloud import StitchedCloud
from measureapp.errors import InputError, RegistrationError, StorageError
from measureapp.progress import Progress
from measureapp.project.array_files import read_npz
from measureapp.project.atomic import remove, replacing_together
from measureapp.project.geometry.files import write_cloud
from measureapp.project.journal.entries import Entry
from measureapp.register.clouds.filter_chain import Filter, FilterChain

STORED = "filters stored"
FILTERS, FILTERED = "filters.npz", "filtered_cloud.ply"
SCHEMA_VERSION = 1


def save_filters(folder: Path, chain: FilterChain, stitched: StitchedCloud) -> None:
    """Store the filters of ``stitched`` and the filtered cloud in ``folder``; raises StorageError when they cannot be written."""
    if not chain.filters:
        delete_filters(folder)
        return
    with replacing_together(folder, Entry(STORED)) as staging:
        write_cloud(staging / FILTERED, stitched.where(chain.kept_mask))
        filters = json.dumps([asdict(one) for one in chain.filters])
        with (staging / FILTERS).open("wb") as file:
            np.savez_compressed(file, schema_version=SCHEMA_VERSION, filters=filters, passed=chain.passed, cloud=_checksum(stitched))


def delete_filters(folder: Path) -> None:
    """Delete the filters and the filtered cloud; raises StorageError when they cannot be deleted."""
    remove(folder / FILTERS, folder / FILTERED)


def load_filters(folder: Path, stitched: StitchedCloud) -> FilterChain | None:
    """Load the filters of ``stitched``; None if there are none.

    Raises
    ------
    StorageError
        The file is damaged, has another format, or belongs to another cloud.
    """
    kept = _read(folder / FILTERS)
    if kept is None:
        return None
    chain, cloud = kept
    if len(chain.passed) != len(stitched) or cloud != _checksum(stitched) or not chain.kept_mask.any():
        raise unusable(folder / FILTERS, "belongs to another stitched cloud")
    return chain


def reapply_filters(folder: Path, stitched: StitchedCloud, progress: Progress) -> None:
    """Apply the stored filters of an earlier cloud to ``stitched``; they are deleted if no point passes or they cannot be read."""
    try:
        kept = _read(folder / FILTERS)
        chain = FilterChain.empty(0) if kept is None else FilterChain.build(kept[0].filters, stitched.points_mm, progress)
    except (StorageError, InputError, RegistrationError):
        chain = FilterChain.empty(0)
    save_filters(folder, chain, stitched)


def _read(path: Path) -> tuple[FilterChain, int] | None:
    """Read the filters and the checksum of their cloud."""
    if not path.exists():
        return None
    try:
        kept = read_npz(path)
        version, passed, cloud = int(kept["schema_version"]), np.asarray(kept["passed"], np.uint8), int(kept["cloud"])
        filters = tuple(Filter(one["kind"], tuple(one["numbers"])) for one in json.loads(str(kept["filters"])))
    except (OSError, EOFError, ValueError, KeyError, TypeError, RecursionError, zipfile.BadZipFile, zlib.error, InputError) as error:
        raise unusable(path, "cannot be read") from error
    if version != SCHEMA_VERSION:
        raise unusable(path, f"has format {version}; this version reads format {SCHEMA_VERSION}")
    return FilterChain(filters, passed), cloud


def unusable(path: Path, problem: str) -> StorageError:
    """Return the error for filters that cannot be used, which is no reason not to show the cloud."""
    return StorageError(f"{path} {problem}: the stitched cloud is shown unfiltered.", "Filter it again on the page Clouds.")


def _checksum(stitched: StitchedCloud) -> int:
    """Return a checksum of the points in single precision, which is the same for a cloud and its file."""
    return zlib.crc32(np.ascontiguousarray(stitched.points_mm, np.float32).tobytes())
