"""Names of several projects that belong together."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from measureapp.errors import InputError


def unique_names(folders: Sequence[Path], why_once: str) -> list[str]:
    """Return the names of the folders, with their parents where names occur twice.

    Parameters
    ----------
    why_once : why a folder given twice is refused, a sentence

    Raises
    ------
    InputError
        A folder is given twice.
    """
    resolved = [Path(os.path.realpath(folder)) for folder in folders]  # unlike `Path.resolve`, not refused where links form a loop
    twice = [path for number, path in enumerate(resolved) if path in resolved[:number]]
    if twice:
        raise InputError(f"{twice[0]} is named twice.", why_once)
    depth = 1
    while len({path.parts[-depth:] for path in resolved}) < len(resolved):
        depth += 1
    return ["-".join(path.parts[-depth:]) for path in resolved]
