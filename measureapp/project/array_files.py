"""Reading of NumPy archives from disk, with a limit for what they unpack to."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

MOST_BYTES = 2**30


def read_npz(path: Path, most_bytes: int = MOST_BYTES) -> dict[str, Any]:
    """Read all arrays of an ``.npz``; objects are refused.

    Raises
    ------
    OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error
        The file is damaged, missing, or would unpack to more than ``most_bytes``.
    """
    with path.open("rb") as file:
        with zipfile.ZipFile(file) as archive:
            if sum(entry.file_size for entry in archive.infolist()) > most_bytes:
                raise ValueError(f"it unpacks to more than {most_bytes / 1e6:.0f} MB")
            for entry in archive.infolist():
                _require_fitting(archive, entry)
        file.seek(0)
        with np.load(file, allow_pickle=False) as arrays:
            return dict(arrays)


def _require_fitting(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> None:
    """Raise ValueError where an array announces more numbers than its file holds, before memory is reserved for them."""
    with archive.open(entry) as stream:
        version = np.lib.format.read_magic(stream)
        reader = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        shape, _, dtype = reader(stream)
    if math.prod(shape) * dtype.itemsize > entry.file_size:
        raise ValueError(f"its array {entry.filename} is cut off")
