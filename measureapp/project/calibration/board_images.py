"""Images of the calibration board in files: one list per camera, in the same order."""

from __future__ import annotations

import glob
from collections.abc import Mapping, Sequence
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

    def sizes_px(self) -> dict[str, tuple[int, int]]:
        """Return camera -> (width, height) of its first image. Raises InputError where one cannot be read."""
        shapes = {camera: read_image(paths[0]).shape for camera, paths in self.files.items()}
        return {camera: (shape[1], shape[0]) for camera, shape in shapes.items()}

    def read(self, position: int, sizes_px: Mapping[str, tuple[int, int]], *, calibrated: bool = False) -> dict[str, ImageArray]:
        """Return camera -> image (H, W) of one board position.

        Parameters
        ----------
        sizes_px : camera -> (width, height) that its images must have
        calibrated : these are the sizes the cameras were calibrated for, not those of their first images

        Raises
        ------
        InputError
            One cannot be read or has another size.
        """
        images = {camera: read_image(paths[position]) for camera, paths in self.files.items()}
        for camera, image in images.items():
            width, height = sizes_px[camera]
            if image.shape == (height, width):
                continue
            given = f"{self.files[camera][position]} is {image.shape[1]} × {image.shape[0]} px"
            if calibrated:
                raise InputError(
                    f"{given}, camera {camera!r} was calibrated for {width} × {height} px.",
                    "Use the calibration of the camera that took the images.",
                )
            raise InputError(
                f"{given}; the first image of camera {camera!r} is {width} × {height} px.", "Give images of one camera at one resolution."
            )
        return images


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
