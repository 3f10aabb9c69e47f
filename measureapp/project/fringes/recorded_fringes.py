"""Recorded fringes on the board: one manifest per board position."""

from __future__ import annotations

import glob
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from measureapp.data.fringe import FringeStack
from measureapp.errors import CalibrationError, InputError
from measureapp.project.fringes.manifest import read_layout, read_manifest
from measureapp.project.tables import natural_order

MANIFEST = "MANIFEST.toml"
HOW_TO_LAY = f"Use one folder per board position, with its images and a {MANIFEST} as written by `measureapp patterns export`."


@dataclass(frozen=True, slots=True, eq=False)
class RecordedFringes:
    """Recorded fringes of all board positions, in the natural order of their names."""

    manifests: tuple[Path, ...]
    cameras: tuple[str, ...]  # of the first position
    projector_px: tuple[int, int]  # width and height spanned by the fringes of the first position

    def read(self, position: int) -> FringeStack:
        """Read all images of one position. Raises InputError, DecodeError as `read_manifest`."""
        return read_manifest(self.manifests[position])

    def name(self, position: int) -> str:
        """Return the name of a position, which is that of its folder."""
        return self.manifests[position].resolve().parent.name


def fringes_in(folder: Path) -> RecordedFringes:
    """Find the board positions recorded in subfolders of ``folder``.

    Raises
    ------
    InputError
        There is no such folder, no manifest in it, or the first cannot be read.
    CalibrationError
        Its fringes run in one direction only.
    """
    if not folder.is_dir():
        raise InputError(f"There is no folder {folder}.", "Choose the folder that holds the fringe images of the board.")
    found = [*folder.glob(MANIFEST), *folder.glob(f"*/{MANIFEST}")]
    if not found:
        raise InputError(f"There is no {MANIFEST} in {folder} or its subfolders.", HOW_TO_LAY)
    return _read_recorded(found)


def fringes_named(patterns: Sequence[str]) -> RecordedFringes:
    """Find the board positions whose manifests match patterns such as ``fringes/*/MANIFEST.toml``; raises as `fringes_in`."""
    found: list[Path] = []
    for pattern in patterns:
        matching = [Path(path) for path in glob.glob(pattern)]  # noqa: PTH207
        if not matching:
            raise InputError(f"No manifest matches {pattern!r}.", "Check the folder and quote the pattern.")
        found += [path for path in matching if path not in found]
    return _read_recorded(found)


def _read_recorded(found: Sequence[Path]) -> RecordedFringes:
    manifests = tuple(sorted(found, key=lambda path: natural_order(str(path))))
    patterns, cameras = read_layout(manifests[0])
    if len(patterns.directions) < 2 or patterns.projector_rows is None:
        raise CalibrationError(
            f"{manifests[0]} has {patterns.directions[0]} fringes only; the projector calibration needs both directions.",
            "Record vertical and horizontal fringes at every position, for example a set named …-both of `measureapp patterns export`.",
        )
    return RecordedFringes(manifests, cameras, (patterns.projector_px, patterns.projector_rows))
