"""Arrays kept in a project with a hash of everything that they were computed from, by which alone they are found again.

No change of what they depend on can be missed; where they are damaged they are computed again.
"""

from __future__ import annotations

import hashlib
import zipfile
import zlib
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from measureapp.errors import StorageError
from measureapp.project.array_files import read_npz
from measureapp.project.atomic import replacing
from measureapp.project.documents import digest
from measureapp.project.inputs import fingerprint
from measureapp.project.journal.state import Journal

MADE_FROM = "made_from"


def hash_of(words: Mapping[str, Any], *arrays: npt.NDArray[Any] | None) -> str:
    """Return a hash of JSON values, of arrays with their shapes and types, and of the program."""
    given = [None if array is None else (array.dtype.str, array.shape) for array in arrays]
    found = hashlib.sha256(digest({"words": words, "arrays": given, "program": fingerprint()}).encode())
    for array in arrays:
        if array is not None:
            found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def read_kept(path: Path, journal: Journal, made_from: str) -> dict[str, npt.NDArray[Any]] | None:
    """Return what is kept in a file of a project; None where that was computed from something else, is damaged or not there."""
    try:
        journal.check(path)
        kept = read_npz(path)
        return kept if str(kept.pop(MADE_FROM)) == made_from else None
    except (StorageError, OSError, EOFError, ValueError, KeyError, TypeError, zipfile.BadZipFile, zlib.error):
        return None


def keep(path: Path, made_from: str, arrays: Mapping[str, npt.NDArray[Any]]) -> None:
    """Keep arrays in a file of a project, in place of what it kept; where it cannot be written, as in an archive, nothing is kept."""
    given: dict[str, Any] = {MADE_FROM: np.array(made_from), **arrays}
    with suppress(StorageError), replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(file, **given)
