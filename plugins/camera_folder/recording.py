"""The images of a folder, in order and by exposure."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from measureapp.arrays import ImageArray
from measureapp.data.model import first_problem
from measureapp.data.rig import CameraDescription
from measureapp.errors import InputError
from measureapp.project.images import read_image

from .settings import FolderSettings, Manifest


class Recording:
    """Image files in order; those with a known exposure are replayed at this exposure only.

    Raises
    ------
    InputError
        The folder, the manifest or a file is missing, no name fits the pattern, or a name has no exposure.
    """

    def __init__(self, settings: FolderSettings) -> None:
        self.folder = Path(settings.folder).expanduser().resolve()
        if not self.folder.is_dir():
            raise InputError(f"The folder {self.folder} of recorded images does not exist.", "Correct the setting folder.")
        listed = self._listed(settings.manifest) if settings.manifest else self._found(settings)
        exposures = {exposure_us for _, exposure_us in listed}
        if None in exposures and len(exposures) > 1:
            raise InputError(
                f"Some images of {self.folder / settings.manifest} have an exposure and some have none.", "Give every exposure."
            )
        self.by_exposure: dict[int | None, list[Path]] = {}
        for path, exposure_us in listed:
            self.by_exposure.setdefault(exposure_us, []).append(path)

    @property
    def exposures_us(self) -> tuple[int, ...]:
        """The exposures recorded, from short to long; empty where they are not known."""
        return tuple(sorted(exposure_us for exposure_us in self.by_exposure if exposure_us is not None))

    def paths(self, exposure_us: int) -> list[Path]:
        """Return the images to be replayed at this exposure."""
        return self.by_exposure.get(None) or self.by_exposure[exposure_us]

    def _found(self, settings: FolderSettings) -> list[tuple[Path, int | None]]:
        paths = sorted(path for path in self.folder.glob(settings.files) if path.is_file())
        if not paths:
            raise InputError(f"The folder {self.folder} has no file {settings.files}.", "Correct the setting files, or the folder.")
        if settings.order == "number":
            paths.sort(key=lambda path: [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", path.name)])
        return [(path, _exposure_us(path, settings.exposure_in_name)) for path in paths]

    def _listed(self, name: str) -> list[tuple[Path, int | None]]:
        path = self.folder / name
        try:
            manifest = Manifest.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"The manifest {path} cannot be read: {error}.", "Correct the setting manifest, or the file.") from error
        except tomllib.TOMLDecodeError as error:
            raise InputError(f"The manifest {path} is not valid TOML: {error}.", "Correct the line named.") from error
        except ValidationError as error:
            raise InputError(f"The manifest {path}: {first_problem(error, 'the manifest')}.", "Correct this field.") from error
        images = [(self.folder / image.file, image.exposure_us) for image in manifest.image]
        missing = [str(image) for image, _ in images if not image.is_file()]
        if missing:
            raise InputError(
                f"{len(missing)} images of {path} are missing, the first is {missing[0]}.", "Copy them, or correct the manifest."
            )
        return images


def _exposure_us(path: Path, pattern: str) -> int | None:
    if not pattern:
        return None
    found = re.search(pattern, path.name)
    if found is None:
        raise InputError(
            f"The name of {path} has no exposure by the pattern {pattern}.", "Rename it, or correct exposure_in_name or files."
        )
    groups = found.groupdict()
    try:
        return round(float(groups["us"])) if groups.get("us") else round(float(groups["ms"]) * 1000)
    except ValueError as error:
        raise InputError(f"The exposure in the name of {path} is not a number.", "Correct exposure_in_name.") from error


def read_pixels(path: Path, camera: CameraDescription) -> ImageArray:
    """Read an image of the size and depth of a camera.

    Raises
    ------
    InputError
        The file is missing or damaged, or its size or depth is another.
    """
    pixels = read_image(path)
    if pixels.shape != (camera.height_px, camera.width_px):
        raise InputError(
            f"Image {path} has {pixels.shape[1]} × {pixels.shape[0]} px, and camera {camera.name} {camera.width_px} × {camera.height_px} px.",
            "Correct the size in the rig description, or choose images of this camera.",
        )
    depth, brightest = np.uint8 if camera.bit_depth == 8 else np.uint16, int(pixels.max(initial=0))
    if pixels.dtype != depth or brightest > camera.saturation:
        found = f"levels up to {brightest}" if pixels.dtype == depth else f"{pixels.dtype.itemsize * 8}-bit pixels"
        raise InputError(
            f"Image {path} has {found}, which does not fit the {camera.bit_depth} bit of camera {camera.name}.",
            "Correct bit_depth in the rig description, or convert the images.",
        )
    return pixels
