"""Files of projector coordinates of board images: a NumPy archive."""

from __future__ import annotations

import zipfile
import zlib
from pathlib import Path

import numpy as np

from measureapp.calibrate.cameras.projector_sightings import ProjectorPixels
from measureapp.errors import StorageError
from measureapp.project.array_files import read_npz
from measureapp.project.atomic import replacing
from measureapp.project.frame_store import checksum


def checksum_of(lit: ProjectorPixels) -> str:
    """Return the SHA-256 of the arrays."""
    return checksum(np.concatenate([np.asarray(lit.pixels, np.float32), np.asarray(lit.sigma_px, np.float32)]))


def write_projector_pixels(path: Path, lit: ProjectorPixels) -> None:
    """Write an `.npz`, atomically. Raises StorageError."""
    with replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(file, corner_px=lit.corner_px, pixels=lit.pixels, sigma_px=lit.sigma_px)


def read_projector_pixels(path: Path) -> ProjectorPixels:
    """Read what `write_projector_pixels` wrote. Raises StorageError when the file is damaged or missing."""
    try:
        arrays = read_npz(path)
        column, row = (int(value) for value in arrays["corner_px"])
        return ProjectorPixels((column, row), arrays["pixels"], arrays["sigma_px"])
    except (OSError, KeyError, ValueError, EOFError, zipfile.BadZipFile, zlib.error) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore it from a backup, or take the position again.") from error
