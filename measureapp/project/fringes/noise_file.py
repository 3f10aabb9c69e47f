"""Files of camera noise models, and the flat-field images they are estimated from."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

import numpy as np
from pydantic import Field, ValidationError

from measureapp.arrays import ImageArray
from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.noise.photon_transfer import NoiseEstimate
from measureapp.project.atomic import write_json
from measureapp.project.images import read_image

SAME_LEVEL, SAME_LEVEL_GREY = 0.02, 0.5  # greatest relative and absolute difference in brightness of images of one level
TAKE_FLATS = "Measure the noise again with `measureapp noise`."


class NoiseEntry(Model):
    """Noise model of one camera with its standard deviations and goodness of fit."""

    noise: CameraNoise
    saturation: float = Field(gt=0)
    gain_e_per_grey: float = Field(gt=0)
    gain_sd: float = Field(ge=0)
    full_well_sd_e: float = Field(ge=0)
    read_noise_sd_e: float = Field(ge=0)
    chi2: float = Field(ge=0)
    verdict: str
    accepted: bool


class NoiseFile(Model):
    """Contents of the file."""

    schema_version: Literal[1] = 1
    cameras: dict[str, NoiseEntry] = Field(min_length=1)


def entry_of(estimate: NoiseEstimate) -> NoiseEntry:
    """Return the entry of an estimate."""
    return NoiseEntry(**{name: getattr(estimate, name) for name in NoiseEntry.model_fields})


def write_noise(path: Path, estimates: Mapping[str, NoiseEstimate]) -> None:
    """Write the noise models of cameras, atomically. Raises StorageError."""
    write_json(path, NoiseFile(cameras={name: entry_of(estimate) for name, estimate in estimates.items()}).model_dump(mode="json"))


def read_noise(path: Path) -> dict[str, CameraNoise]:
    """Read the noise models of cameras.

    Raises
    ------
    InputError
        The file cannot be read, is not a noise file, or contains a model that was rejected.
    """
    try:
        file = NoiseFile.model_validate(json.loads(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Check the path.") from error
    except ValidationError as error:
        raise InputError(f"{path} is not a noise file: {first_problem(error, 'file')}.", TAKE_FLATS) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not JSON.", TAKE_FLATS) from error
    poor = [f"{name}: {entry.verdict}" for name, entry in file.cameras.items() if not entry.accepted]
    if poor:
        raise InputError(f"{path} contains noise models that do not fit their camera ({'; '.join(poor)}).", TAKE_FLATS)
    return {name: entry.noise for name, entry in file.cameras.items()}


def read_flats(pattern: str) -> dict[str, ImageArray]:
    """Read the images whose paths match ``pattern`` (with ``*``, ``?`` or ``**``), sorted by path.

    Raises
    ------
    InputError
        No file matches, or the images differ in size or bit depth.
    """
    root = Path(Path(pattern).anchor)
    files = sorted(str(file) for file in root.glob(str(Path(pattern).relative_to(root))) if file.is_file())
    if not files:
        raise InputError(f"No file matches {pattern}.", "Put the pattern in quotes and check the folder.")
    images = {file: read_image(Path(file)) for file in files}
    first = images[files[0]]
    for file, image in images.items():
        if image.shape != first.shape or image.dtype != first.dtype:
            raise InputError(f"Image {file} differs from {files[0]} in size or bit depth.", "Give the images of one camera.")
    return images


def brightness_levels(images: Mapping[str, ImageArray]) -> list[ImageArray]:
    """Group flat-field images by their mean into levels, (n ≥ 2, H, W) each.

    Raises
    ------
    InputError
        An image is the only one of its brightness; names it and the nearest.
    """
    means = {file: float(image.mean(dtype=np.float64)) for file, image in images.items()}
    ordered = sorted(images, key=lambda file: means[file])
    groups: list[list[str]] = []
    for file in ordered:
        start = means[groups[-1][0]] if groups else -1.0
        if groups and means[file] - start <= SAME_LEVEL * start + SAME_LEVEL_GREY:
            groups[-1].append(file)
        else:
            groups.append([file])
    for group in groups:
        if len(group) == 1:
            raise _single_image(group[0], ordered, means)
    return [np.stack([images[file] for file in group]) for group in groups]


def _single_image(file: str, ordered: Sequence[str], means: Mapping[str, float]) -> InputError:
    others = [other for other in ordered if other != file]
    if not others:
        return InputError(f"{file} is the only image.", "Take at least two images of each of several brightnesses.")
    nearest = min(others, key=lambda other: abs(means[other] - means[file]))
    return InputError(
        f"{file} is the only image of its brightness ({means[file]:.2f} grey levels); the nearest, {nearest}, has {means[nearest]:.2f}.",
        "Take at least two images of every brightness in constant light.",
    )
