"""Images of the calibration board in files: one list per camera, in the same order."""

from __future__ import annotations

import glob
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from measureapp.arrays import ImageArray
from measureapp.errors import InputError
from measureapp.project.images import read_image
from measureapp.project.tables import natural_order


@dataclass(frozen=True, slots=True)
class BoardImages:
    """Image files per camera; the n-th of every camera shows the same board position."""

    files: dict[str, tuple[Path, ...]]

    @property
    def cameras(self) -> tuple[str, ...]:
        """Camera names as given."""
        return tuple(self.files)

    @property
    def positions(self) -> int:
        """Number of board positions."""
        return len(next(iter(self.files.values())))

    def path(self, camera: str, position: int) -> Path:
        """Return the file of one camera at one position."""
        return self.files[camera][position]

    def size_px(self, camera: str) -> tuple[int, int]:
        """Return width and height of a camera's first image."""
        height, width = read_image(self.files[camera][0]).shape[:2]
        return width, height

    def each(self) -> Iterator[tuple[str, int, ImageArray]]:
        """Read the images one by one; raises InputError for one that cannot be read or has another size."""
        for camera, paths in self.files.items():
            size: tuple[int, ...] | None = None
            for position, path in enumerate(paths):
                image = read_image(path)
                if size is not None and image.shape[:2] != size:
                    raise InputError(
                        f"{path} is {image.shape[1]} × {image.shape[0]} px; earlier images of camera {camera!r} are "
                        f"{size[1]} × {size[0]} px.",
                        "Use the same resolution for all images of a camera.",
                    )
                size = image.shape[:2]
                yield camera, position, image


def find_board_images(options: Sequence[str]) -> BoardImages:
    """Find the images given by options ``camera=GLOB``, each list sorted by name.

    Raises
    ------
    InputError
        An option without a camera name, a pattern that matches nothing, or lists of different lengths.
    """
    files: dict[str, tuple[Path, ...]] = {}
    for option in options:
        name, separator, pattern = option.partition("=")
        if not separator or not name or not pattern:
            raise InputError(f"--images {option!r} names no camera.", "Write --images left='folder/left*.png'.")
        if name in files:
            raise InputError(f"--images names camera {name!r} twice.", "Give one pattern per camera.")
        files[name] = tuple(sorted((Path(path) for path in glob.glob(pattern)), key=lambda path: natural_order(str(path))))  # noqa: PTH207
        if not files[name]:
            raise InputError(f"No image matches {pattern!r} for camera {name!r}.", "Check the folder and quote the pattern.")
    if not files:
        raise InputError("No images were given.", "Write --images left='folder/left*.png'.")
    counts = {name: len(paths) for name, paths in files.items()}
    if len(set(counts.values())) > 1:
        listed = ", ".join(f"{name}: {count}" for name, count in counts.items())
        raise InputError(f"The cameras have different numbers of images ({listed}).", "Give one image of every camera per board position.")
    return BoardImages(files)
