"""Provenance of a calibration: the command, the folder it ran in and the checksums of every file it read."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import typer

from measureapp.errors import InputError

WRITTEN = {"out": "--out", "corners_out": "--corners-out", "uncertainty_map": "--uncertainty-map"}  # parameter -> option
NOT_REPEATED = ("--json",)


@dataclass(frozen=True, slots=True)
class MadeFrom:
    """The command and its inputs with checksums, for repeating a calibration."""

    arguments: tuple[str, ...] = ()  # of the command, without where it wrote to
    folder: str = "."  # in which it ran, relative to the folder of the file it wrote
    inputs: Mapping[str, str] = field(default_factory=dict)  # file relative to `folder` -> SHA-256

    def document(self) -> dict[str, Any]:
        """Return it as JSON."""
        return {"arguments": list(self.arguments), "folder": self.folder, "inputs": dict(self.inputs)}

    def require_same_inputs(self, folder: Path) -> None:
        """Raise InputError naming the first input that is missing or has changed."""
        for name, digest in self.inputs.items():
            path = folder / name
            if not path.is_file():
                raise InputError(f"{path} is missing; the calibration was made from it.", "Restore the file from a backup.")
            if digest_of(path) != digest:
                raise InputError(
                    f"{path} is not the file the calibration was made from: its checksum differs.",
                    "Restore the file from a backup, or calibrate anew.",
                )


def made_from(ctx: typer.Context, out: Path) -> MadeFrom:
    """Return the provenance of the file ``out`` that the running command writes."""
    folder = os.path.relpath(Path.cwd(), out.resolve().parent)
    return MadeFrom(_without_outputs(ctx.obj or ()), Path(folder).as_posix(), {name_of(path): digest_of(path) for path in _read(ctx)})


def made_from_document(document: Any, source: Path) -> MadeFrom:
    """Return the provenance of a stored calibration. Raises InputError where it has none."""
    try:
        entry = document.get("made_from") or document.get("projector", document)["provenance"]
        made = MadeFrom(tuple(map(str, entry["arguments"])), str(entry["folder"]), {str(k): str(v) for k, v in entry["inputs"].items()})
    except (KeyError, TypeError, AttributeError) as error:
        raise InputError(
            f"{source} has no record of its inputs.",
            "Give a file that a `calibrate` command of this version wrote, or a project's folder.",
        ) from error
    if not made.arguments or made.arguments[0] != "calibrate":
        raise InputError(f"{source} was not made by a `calibrate` command.", "Calibrate anew from the images.")
    return made


def name_of(path: Path) -> str:
    """Return a file's name relative to the current folder."""
    return Path(os.path.relpath(path)).as_posix()


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _read(ctx: typer.Context) -> Iterator[Path]:
    """Every file the command reads, once, in a stable order."""
    from measureapp.project.calibration.board_images import find_board_images
    from measureapp.project.fringes.manifest import manifest_files

    found: dict[Path, None] = {}
    for name, value in ctx.params.items():
        if name in WRITTEN:
            continue
        if name == "images" and value:
            found |= dict.fromkeys(path for paths in find_board_images(value).files.values() for path in paths)
        paths = [one for one in (value if isinstance(value, (list, tuple)) else [value]) if isinstance(one, Path) and not one.is_dir()]
        found |= dict.fromkeys(paths)
        if name == "manifests":
            found |= dict.fromkeys(file for path in paths for file in manifest_files(path))
    yield from found


def _without_outputs(arguments: Sequence[str]) -> tuple[str, ...]:
    """Return the arguments of a command without its outputs and the form of its answer."""
    kept, skip = [], False
    for argument in arguments:
        if skip:
            skip = False
        elif argument in WRITTEN.values():
            skip = True
        elif argument not in NOT_REPEATED and argument.partition("=")[0] not in WRITTEN.values():
            kept.append(argument)
    return tuple(kept)
