"""Arrays kept in a project with a hash of everything that they were computed from, by which alone they are found again.

No change of what they depend on can be missed; where they are damaged they are computed again.
"""

from __future__ import annotations

import hashlib
import zipfile
import zlib
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from measureapp.errors import StorageError
from measureapp.project.array_files import read_npz
from measureapp.project.atomic import replacing
from measureapp.project.documents import digest
from measureapp.project.inputs import fingerprint
from measureapp.project.journal.state import Journal

MADE_FROM = "made_from"
UNUSABLE = (StorageError, OSError, EOFError, ValueError, LookupError, TypeError, RecursionError, zipfile.BadZipFile, zlib.error)
Kept = TypeVar("Kept")


def hash_of(words: Mapping[str, Any], *arrays: npt.NDArray[Any] | None) -> str:
    """Return a hash of JSON values, of arrays with their shapes and types, and of the program."""
    given = [None if array is None else (array.dtype.str, array.shape) for array in arrays]
    found = hashlib.sha256(digest({"words": words, "arrays": given, "program": fingerprint()}).encode())
    for array in arrays:
        if array is not None:
            found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def read_kept(path: Path, journal: Journal, made_from: str, build: Callable[[Mapping[str, Any]], Kept]) -> Kept | None:
    """Return what ``build`` makes of the arrays kept in a file of a project; None where they were computed from something else.

    None, too, where they are damaged, are not there, or are not what ``build`` expects, as in a project from elsewhere.
    """
    try:
        journal.check(path)
        arrays = read_npz(path)
        return build(arrays) if str(arrays[MADE_FROM]) == made_from else None
    except UNUSABLE:
        return None


def keep(path: Path, made_from: str, arrays: Mapping[str, npt.NDArray[Any]]) -> None:
    """Keep arrays in a file of a project, in place of what it kept; where it cannot be written, as in an archive, nothing is kept."""
    given: dict[str, Any] = {MADE_FROM: np.array(made_from), **arrays}
    with suppress(StorageError), replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(file, **given)
