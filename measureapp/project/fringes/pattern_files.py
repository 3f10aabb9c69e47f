"""Files of pattern sets: definitions in TOML or JSON, images as PNG for a real projector."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import tau
from pathlib import Path
from typing import Any

import cv2
from pydantic import ValidationError

from measureapp.arrays import ImageArray
from measureapp.data.fringe import PatternSet, PhaseShiftGroup
from measureapp.data.model import first_problem
from measureapp.data.pattern_sets import make_pattern_sets
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import replacing, write_json, write_text
from measureapp.project.text_document import read_toml_or_json

LEAST_PROJECTOR_PX, MOST_PROJECTOR_PX = 64, 8192
LIST, SKELETON = "patterns.json", "MANIFEST.toml"


def read_pattern_set(name_or_path: str, width_px: int, height_px: int) -> PatternSet:
    """Return the predefined set of this name for a projector, or the one defined in a TOML or JSON file.

    A file contains the fields of a `PatternSet`: name, projector_px, projector_rows, shift_sign and groups; or it is the
    `patterns.json` of an export.

    Raises
    ------
    InputError
        The name is unknown, the file cannot be read or has an invalid field, or the projector's size is invalid.
    """
    check_size(width_px, height_px)
    path = Path(name_or_path)
    if not path.suffix:
        named = make_pattern_sets(width_px, height_px)
        if name_or_path not in named:
            raise InputError(f"There is no pattern set {name_or_path!r}.", f"Give a file, or one of: {', '.join(named)}.")
        return named[name_or_path]
    document = read_toml_or_json(path, "a pattern set", "Give a pattern set as TOML or JSON.")
    if isinstance(document, dict) and isinstance(document.get("patterns"), dict):
        document = document["patterns"]
    try:
        return PatternSet.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the pattern set')}.", "Correct this field.") from error


def check_size(width_px: int, height_px: int) -> None:
    """Raise InputError for an invalid projector size."""
    if not (min(width_px, height_px) >= LEAST_PROJECTOR_PX and max(width_px, height_px) <= MOST_PROJECTOR_PX):
        raise InputError(
            f"A projector of {width_px} × {height_px} px is not supported.",
            f"Give {LEAST_PROJECTOR_PX} to {MOST_PROJECTOR_PX} px for width and height.",
        )


def export_patterns(
    folder: Path, patterns: PatternSet, images: ImageArray, response_name: str | None, cameras: Sequence[str], exposures_us: Sequence[int]
) -> list[Path]:
    """Write numbered PNG images, `patterns.json` that describes them, and a `MANIFEST.toml` for recordings of them.

    Parameters
    ----------
    images : (P, height, width) uint8, from `pattern_images`
    response_name : projector response for which they are corrected; None: not corrected
    cameras, exposures_us : for the manifest, which expects the image of pattern 7 at <camera>/<exposure_us>/007.png

    Raises
    ------
    StorageError
        The folder cannot be written to, or contains something else.
    """
    folder = Path(folder)
    foreign = [file.name for file in folder.iterdir() if not _ours(file)] if folder.is_dir() else []
    if foreign:
        raise StorageError(f"{folder} contains another file: {sorted(foreign)[0]}.", "Give a new or empty folder.")
    shown = list(describe_images(patterns))
    files = []
    for entry, image in zip(shown, images, strict=True):
        file = folder / str(entry["file"])
        with replacing(file) as temporary:
            if not cv2.imwrite(str(temporary), image):
                raise StorageError(f"{file} cannot be written.", "Free some space or choose another folder.")
        files.append(file)
    height, width = images.shape[1:]
    document = {
        "schema_version": 1,
        "projector": {"width_px": width, "height_px": height, "corrected_for": response_name},
        "patterns": patterns.model_dump(mode="json"),
        "images": shown,
    }
    write_json(folder / LIST, document)
    write_text(folder / SKELETON, manifest_skeleton(patterns, cameras, exposures_us))
    for left_over in set(folder.glob("[0-9][0-9][0-9].png")) - set(files):
        left_over.unlink()
    return files


def describe_images(patterns: PatternSet) -> Iterator[dict[str, Any]]:
    """Describe every image in the order of projection: file, kind, direction, and pitch, step and shift, or plane."""
    number = 0
    for group in patterns.groups:
        for n in range(group.count):
            entry: dict[str, Any] = {"file": f"{number:03d}.png", "kind": group.kind, "direction": group.direction}
            if isinstance(group, PhaseShiftGroup):
                shift = patterns.shift_sign * tau * n / group.steps
                entry |= {"pitch_px": group.pitch_px, "step": n, "steps": group.steps, "shift_rad": shift}
            else:
                entry |= {"plane": n, "planes": group.planes, "complementary": group.complementary and n == group.planes - 1}
            yield entry
            number += 1


def manifest_skeleton(patterns: PatternSet, cameras: Sequence[str], exposures_us: Sequence[int]) -> str:
    """Return a MANIFEST.toml for recordings of these patterns."""
    lines = [
        "# Recordings of the patterns in this folder. Store the image of pattern 007 as <camera>/<exposure_us>/007.png, and",
        "# add `saturation`, the grey level of a saturated pixel, for images of more than 8 bit.",
        f"shift_sign = {patterns.shift_sign}",
        f"projector_px = {patterns.projector_px}",
        *([f"projector_rows = {patterns.projector_rows}"] if patterns.projector_rows else []),
    ]
    for exposure_us in exposures_us:
        lines += ["", "[[exposure]]", f"exposure_us = {exposure_us}"]
        number = 0
        for group in patterns.groups:
            lines += ["", "  [[exposure.group]]", f'  kind = "{group.kind}"', f'  direction = "{group.direction}"']
            if isinstance(group, PhaseShiftGroup):
                lines += [f"  pitch_px = {group.pitch_px!r}", f"  steps = {group.steps}"]
            else:
                lines += [f"  planes = {group.planes}", f"  complementary = {str(group.complementary).lower()}"]
            lines.append("  [exposure.group.images]")
            for camera in cameras:
                listed = ", ".join(f'"{camera}/{exposure_us}/{number + n:03d}.png"' for n in range(group.count))
                lines.append(f"  {camera} = [{listed}]")
            number += group.count
    return "\n".join(lines) + "\n"


def _ours(file: Path) -> bool:
    return file.name in (LIST, SKELETON) or (file.suffix == ".png" and file.stem.isdigit() and len(file.stem) == 3)
