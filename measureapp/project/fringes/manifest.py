"""`MANIFEST.toml`: description of recorded fringe images."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from os import cpu_count
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, ValidationError, model_validator

from measureapp.arrays import ImageArray, read_only
from measureapp.data.fringe import Direction, FringeStack, GrayCodeGroup, PatternGroup, PatternSet, PhaseShiftGroup
from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError
from measureapp.fringe.checks.stack import check_stack
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.project.images import read_image
from measureapp.project.text_document import read_toml

Images = dict[str, tuple[str, ...]]  # camera -> paths beside the manifest
NOT_GIVEN = -1.0
MOST_BEATING = 8  # greatest number of pitches for which the longest beat is searched


class PhaseShiftEntry(Model):
    """One group of phase-shifted sinusoids, with its pitch in projector pixels or its number of periods over the projector.

    Periods of vertical fringes extend over ``projector_px``, those of horizontal ones over ``projector_rows``.
    """

    kind: Literal["phase-shift"]
    direction: Direction = "vertical"
    pitch_px: float | None = Field(default=None, gt=2)
    periods: float | None = Field(default=None, gt=0)
    projector_px: int | None = Field(default=None, gt=0)
    steps: int | None = Field(default=None, ge=3, description="number of images expected")
    images: Images = Field(min_length=1)

    @model_validator(mode="after")
    def _has_one_pitch(self) -> PhaseShiftEntry:
        if (self.pitch_px is None) == (self.periods is None):
            raise ValueError("give either pitch_px or periods")
        return self


class GrayCodeEntry(Model):
    """Gray code planes, most significant bit first; with ``complementary`` the last one is shifted by half a period."""

    kind: Literal["gray-code"]
    direction: Direction = "vertical"
    complementary: bool = False
    projector_px: int | None = Field(default=None, gt=0)
    planes: int | None = Field(default=None, ge=1, description="number of images expected")
    images: Images = Field(min_length=1)


GroupEntry = Annotated[PhaseShiftEntry | GrayCodeEntry, Field(discriminator="kind")]


class ExposureEntry(Model):
    """All images of one exposure."""

    exposure_us: int = Field(gt=0)
    group: tuple[GroupEntry, ...] = Field(min_length=1)


class FringeManifest(Model):
    """Contents of the file.

    Without ``projector_px`` (``projector_rows`` for horizontal fringes) the phase extends over the beat of the pitches or the range
    of the Gray code.
    """

    shift_sign: Literal[-1, 1] = -1
    saturation: int | None = Field(default=None, gt=0, le=65536, description="grey level of a saturated pixel; needed for 16-bit images")
    projector_px: int | None = Field(default=None, gt=0)
    projector_rows: int | None = Field(default=None, gt=0)
    exposure: tuple[ExposureEntry, ...] = Field(min_length=1)


def read_manifest(path: Path) -> FringeStack:
    """Read the manifest and all its images.

    Raises
    ------
    InputError
        The manifest or an image cannot be read, a field is invalid or unknown, or images are missing, repeated or inconsistent.
    DecodeError
        The images do not determine the phase over the projector, or contradict the manifest: repeated, blank, exchanged.
    """
    path = Path(path)
    manifest = parse_manifest(path)
    exposures = _exposures(path, manifest)
    patterns, cameras = _layout(path, manifest, exposures)
    images = {camera: _read_camera(path, exposures, camera) for camera in cameras}
    stack = FringeStack(
        viewpoint_id=path.parent.resolve().name,
        patterns=patterns,
        exposures_us=tuple(entry.exposure_us for entry in exposures),
        images=images,
        saturation=_saturation(path, manifest, images),
    )
    check_stack(stack)
    return stack


def read_layout(path: Path) -> tuple[PatternSet, tuple[str, ...]]:
    """Read pattern set and camera names of a manifest without its images; raises as `read_manifest`."""
    manifest = parse_manifest(path)
    return _layout(path, manifest, _exposures(path, manifest))


def _exposures(path: Path, manifest: FringeManifest) -> list[ExposureEntry]:
    """Return the exposures from long to short, after checking that all have the same patterns."""
    exposures = [_vertical_first(entry) for entry in sorted(manifest.exposure, key=lambda entry: -entry.exposure_us)]
    _check_same(path, exposures)
    return exposures


def _layout(path: Path, manifest: FringeManifest, exposures: list[ExposureEntry]) -> tuple[PatternSet, tuple[str, ...]]:
    patterns = _patterns(path, manifest, exposures[0].group)
    check_determines_phase(patterns)
    return patterns, tuple(exposures[0].group[0].images)


def manifest_files(path: Path) -> tuple[Path, ...]:
    """Return all image files of a manifest. Raises InputError as `parse_manifest`."""
    return tuple(_files(path, list(parse_manifest(path).exposure)))


def parse_manifest(path: Path) -> FringeManifest:
    """Parse the manifest without its images; raises InputError."""
    document = read_toml(path, "Give the path of a MANIFEST.toml.")
    try:
        return FringeManifest.model_validate(document)
    except ValidationError as error:
        raise InputError(
            f"{path}: {first_problem(error, 'the file')}.", "Write the manifest as `measureapp decode --help` describes."
        ) from error


def _vertical_first(entry: ExposureEntry) -> ExposureEntry:
    """Return the exposure with its groups in the order of a `PatternSet`."""
    return entry.model_copy(update={"group": tuple(sorted(entry.group, key=lambda group: group.direction, reverse=True))})


def _check_same(path: Path, exposures: list[ExposureEntry]) -> None:
    """Raise InputError unless all exposures have the same groups, cameras and numbers of images, and no image occurs twice."""
    times = [entry.exposure_us for entry in exposures]
    if len(set(times)) < len(times):
        raise InputError(f"{path}: two exposures have the same exposure_us.", "Give each exposure once.")
    for entry in exposures:
        for number, (group, model) in enumerate(zip(entry.group, exposures[0].group, strict=False)):
            _check_group(f"{path}: exposure {entry.exposure_us} µs, group {number + 1}", group, model)
        if len(entry.group) != len(exposures[0].group):
            raise InputError(
                f"{path}: exposure {entry.exposure_us} µs has {len(entry.group)} groups, the first has {len(exposures[0].group)}.",
                "Record every pattern at every exposure.",
            )
        cameras = [set(group.images) for group in entry.group]
        if any(names != cameras[0] for names in cameras):
            raise InputError(
                f"{path}: the groups of exposure {entry.exposure_us} µs have different cameras.", "Name every camera in every group."
            )
    _check_files(path, exposures)


def _check_files(path: Path, exposures: list[ExposureEntry]) -> None:
    """Raise InputError for a missing image, or one that occurs twice by any path, before the first one is read."""
    files = list(_files(path, exposures))
    missing = [file for file in files if not file.exists()]
    if missing:
        others = f", and {len(missing) - 1} more of the {len(files)} images" if len(missing) > 1 else ""
        raise InputError(
            f"{path}: image {missing[0]} cannot be read: it does not exist{others}.",
            "Correct the paths, which are relative to the manifest's folder, or copy the images there.",
        )
    repeated = [file for file, count in Counter(file.resolve() for file in files).items() if count > 1]
    if repeated:
        raise InputError(f"{path} names the image {repeated[0]} more than once.", "Use every image once.")


def _check_group(place: str, group: PhaseShiftEntry | GrayCodeEntry, model: PhaseShiftEntry | GrayCodeEntry) -> None:
    counts = {camera: len(files) for camera, files in group.images.items()}
    if len(set(counts.values())) > 1:
        listed = ", ".join(f"{camera}: {count}" for camera, count in counts.items())
        raise InputError(f"{place} has different numbers of images ({listed}).", "Give every camera the same images.")
    least = 3 if group.kind == "phase-shift" else 1 + int(group.complementary)
    if min(counts.values()) < least:
        raise InputError(f"{place} has {min(counts.values())} images and needs at least {least}.", "Add the missing images.")
    stated = group.steps if group.kind == "phase-shift" else group.planes
    if stated is not None and set(counts.values()) != {stated}:
        word = "steps" if group.kind == "phase-shift" else "planes"
        raise InputError(f"{place} has {min(counts.values())} images but {word} = {stated}.", f"Name {stated} images, in order.")
    expected = {camera: len(files) for camera, files in model.images.items()}
    if counts != expected or group.model_copy(update={"images": {}}) != model.model_copy(update={"images": {}}):
        raise InputError(f"{place} differs from the group of the longest exposure.", "Record the same patterns at every exposure.")


def _files(path: Path, exposures: list[ExposureEntry]) -> Iterator[Path]:
    for entry in exposures:
        for group in entry.group:
            for files in group.images.values():
                yield from (path.parent / file for file in files)


def _patterns(path: Path, manifest: FringeManifest, entries: tuple[PhaseShiftEntry | GrayCodeEntry, ...]) -> PatternSet:
    upright, lying = ([entry for entry in entries if entry.direction == direction] for direction in ("vertical", "horizontal"))
    groups: tuple[PatternGroup, ...] = ()
    rows = columns = None
    if upright:
        columns, groups = _along(path, upright, manifest.projector_px, "projector_px")
    if lying:
        rows, across = _along(path, lying, manifest.projector_rows, "projector_rows")
        groups += across
    return PatternSet(
        name=path.name,
        projector_px=columns or manifest.projector_px or rows or 0,  # there is at least one group
        projector_rows=rows or manifest.projector_rows,
        groups=groups,
        shift_sign=manifest.shift_sign,
    )


def _along(
    path: Path, entries: list[PhaseShiftEntry | GrayCodeEntry], extent_px: int | None, word: str
) -> tuple[int, tuple[PatternGroup, ...]]:
    """Return the extent in columns or rows of the groups of one direction, and the groups."""
    of_groups = {entry.projector_px for entry in entries if entry.projector_px is not None}
    if of_groups and word != "projector_px":
        raise InputError(f"{path}: a group of horizontal fringes has projector_px.", f"Give {word}, at the top of the file.")
    given = of_groups | ({extent_px} if extent_px is not None else set())
    if len(given) > 1:
        raise InputError(f"{path} gives different {word}: {sorted(given)}.", "Give one value, at the top of the file.")
    extent_px = next(iter(given), None)
    groups = tuple(_group(path, entry, extent_px, word) for entry in entries)
    return extent_px or _unambiguous_px(path, groups), groups


def _group(path: Path, entry: PhaseShiftEntry | GrayCodeEntry, extent_px: int | None, word: str) -> PatternGroup:
    count = len(next(iter(entry.images.values())))
    if isinstance(entry, GrayCodeEntry):
        return GrayCodeGroup(planes=count, complementary=entry.complementary, direction=entry.direction)
    if entry.pitch_px is not None:
        return PhaseShiftGroup(pitch_px=entry.pitch_px, steps=count, direction=entry.direction)
    if extent_px is None:
        raise InputError(f"{path}: `periods` needs `{word}`, the length they extend over.", f"Add {word} at the top of the file.")
    pitch_px = extent_px / (entry.periods or NOT_GIVEN)
    if pitch_px <= 2:
        raise InputError(f"{path}: {entry.periods:g} periods over {extent_px} px give a pitch below 2 px.", f"Correct periods or {word}.")
    return PhaseShiftGroup(pitch_px=pitch_px, steps=count, direction=entry.direction)


def _unambiguous_px(path: Path, groups: tuple[PatternGroup, ...]) -> int:
    """Return the unambiguous range in columns or rows: that of the Gray code, or the longest beat of the pitches."""
    pitches = [group.pitch_px for group in groups if isinstance(group, PhaseShiftGroup)]
    if not pitches:
        raise InputError(f"{path} has no phase-shift group.", "Add the shifted sinusoids.")
    for group in groups:
        if isinstance(group, GrayCodeGroup):
            return int(2 ** (group.planes - int(group.complementary)) * min(pitches))
    if len(pitches) == 1:
        raise InputError(f"{path}: a single pitch of {pitches[0]:g} px leaves the period ambiguous.", "Add a second pitch or a Gray code.")
    if len(pitches) > MOST_BEATING:
        raise InputError(f"{path}: {len(pitches)} pitches need projector_px.", "Add projector_px (projector_rows for horizontal fringes).")
    frequencies = [abs(float(np.dot(factors, 1 / np.array(pitches)))) for factors in product((-1, 0, 1), repeat=len(pitches))]
    return int(1 / min(frequency for frequency in frequencies if frequency > 1e-9) + 1e-6)


def _read_camera(path: Path, exposures: list[ExposureEntry], camera: str) -> ImageArray:
    """Read the images of one camera into one array (exposures, patterns, height, width), in parallel."""
    files = [path.parent / file for entry in exposures for group in entry.group for file in group.images[camera]]
    first = read_image(files[0])
    stack = np.empty((len(exposures), len(files) // len(exposures), *first.shape), first.dtype)
    flat = stack.reshape(-1, *first.shape)
    flat[0] = first

    def read(number: int) -> None:
        image = read_image(files[number])
        _check_image(files[number], image, files[0], stack)
        flat[number] = image

    with ThreadPoolExecutor(cpu_count() or 1) as pool:
        list(pool.map(read, range(1, len(files))))
    return np.asarray(read_only(stack))


def _check_image(file: Path, image: ImageArray, first: Path, stack: ImageArray) -> None:
    height, width = stack.shape[2:]
    if image.shape != (height, width):
        raise InputError(
            f"Image {file} has {image.shape[1]} × {image.shape[0]} px, {first.name} has {width} × {height} px.",
            "Use images of one size for each camera.",
        )
    if image.dtype != stack.dtype:
        raise InputError(
            f"Image {file} has {image.dtype.itemsize * 8} bit, {first.name} has {stack.dtype.itemsize * 8} bit.",
            "Record all images with one bit depth.",
        )


def _saturation(path: Path, manifest: FringeManifest, images: dict[str, ImageArray]) -> int:
    depths = {array.dtype.itemsize * 8 for array in images.values()}
    if len(depths) > 1:
        raise InputError(f"{path}: the cameras have images of different bit depth.", "Record all images with one bit depth.")
    largest = 255 if depths == {8} else 65535
    if manifest.saturation is None:
        if depths == {8}:
            return 255
        raise InputError(f"{path}: 16-bit images need `saturation`.", "Add the grey level of a saturated pixel: 1023, 4095 or 65535.")
    if manifest.saturation > largest + 1:
        raise InputError(f"{path}: saturation = {manifest.saturation}, but the images have {depths.pop()} bit.", f"Give at most {largest}.")
    return manifest.saturation
