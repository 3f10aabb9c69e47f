"""Large clouds on disk: the system takes them into memory where they are used, and out of it again where others need the room."""

from __future__ import annotations

import mmap
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.data.cloud import PointCloud

LARGE_BYTES = 16_000_000  # of a cloud; smaller ones stay in memory
ALIGNMENT = 64  # of every array in the file
ARRAYS = ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras")


def map_large(cloud: PointCloud, folder: Path) -> PointCloud:
    """Return the same cloud with its arrays in a temporary file in ``folder``, mapped into memory; a small one as it is.

    A scan of a large part has tens of millions of points, of which registration and merging look at a view at a time. The file has no
    name and is gone with the cloud. Where it cannot be written, the cloud stays in memory.
    """
    arrays = {name: np.asarray(getattr(cloud, name)) for name in ARRAYS}
    if sum(array.nbytes for array in arrays.values()) < LARGE_BYTES:
        return cloud
    starts: dict[str, int] = {}
    try:
        with tempfile.TemporaryFile(dir=folder) as file:
            for name, array in arrays.items():
                file.write(bytes(-file.tell() % ALIGNMENT))
                starts[name] = file.tell()
                file.write(array.data)
            file.flush()
            mapped = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)  # keeps the file open by itself
    except OSError:
        return cloud
    found: dict[str, Any] = {
        name: np.frombuffer(mapped, array.dtype, array.size, starts[name]).reshape(array.shape) for name, array in arrays.items()
    }
    return replace(cloud, **found)
