"""What results are computed from, as hashes, and whether that is still what the project holds."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from measureapp import __version__
from measureapp.project.documents import digest
from measureapp.project.journal.state import Contents

WORDS = {
    "calibration": "The results were computed with another calibration.",
    "noise": "The results were computed with another noise model of the cameras.",
    "limits": "The results were computed with other limits of the pixels.",
    "plan": "The scan plan was changed after the results were computed.",
    "program": "The results were computed with another inspection program.",
    "nominal": "The results were computed with another nominal.",
    "choices": "The results were computed with other choices of views.",
    "version": "The results were computed by version {was} of MeasureApp; this is version {now}.",
}
SIMULATION = "simulate"  # computes nothing of results, and may be missing
LIBRARIES = ("numpy", "numba", "scipy", "opencv-python-headless", "open3d")
OF_INSPECTION = ("program", "nominal", "choices")
FILES = {
    "calibration": ("calibration/cameras.json", "calibration/rig.json", "calibration/rig_uncertainty.npz"),
    "noise": ("calibration/noise.json",),
    "limits": ("decode_limits.json",),
    "plan": ("plan.json",),
    "program": ("inspection/program.toml",),
    "choices": ("view_choices.json",),
}


@cache
def fingerprint() -> str:
    """Return version and checksum of the program's sources and of the libraries that it computes with: equal ones compute equal numbers."""
    root, found = Path(__file__).parent.parent, hashlib.sha256()
    for source in sorted(one for one in root.rglob("*.py") if SIMULATION not in one.relative_to(root).parts):
        found.update(source.relative_to(root).as_posix().encode())
        found.update(source.read_bytes())
    for library in LIBRARIES:
        try:
            found.update(f"{library} {version(library)}".encode())
        except PackageNotFoundError:  # in a packed program, whose version stands for its libraries
            continue
    return f"{__version__} ({found.hexdigest()[:12]})"


def current_inputs(contents: Contents) -> dict[str, Any]:
    """Return a hash of everything that results depend on.

    Stacks are named by the hash of their description, which has the read-back and the hashes of all pixels, so that compressed images
    are the same as raw ones.
    """
    known = {name: state.sha256 for name, state in contents.files.items()}
    files: dict[str, tuple[str, ...]] = {
        **FILES,
        "nominal": tuple(sorted(name for name in known if name.startswith("inspection/nominal."))),
    }
    inputs: dict[str, Any] = {name: _hash_of(known, names) for name, names in files.items()}
    stacks = {viewpoint: known.get(f"stacks/{viewpoint}/stack.json", "") for viewpoint in sorted(contents.viewpoints)}
    return {**inputs, "stacks": stacks, "version": __version__}


def inspected_again(before: Mapping[str, Any], now: Mapping[str, Any]) -> dict[str, Any]:
    """Return the inputs of results of which only stitching or inspection was computed again, from clouds computed ``before``."""
    return {**now, **{name: value for name, value in before.items() if name not in OF_INSPECTION}}


def changes(before: Mapping[str, Any], now: Mapping[str, Any]) -> tuple[str, ...]:
    """Return in sentences what has changed since results were computed; nothing where they do not say what they were computed from."""
    if not before:
        return ()
    found = [
        words.format(was=before.get(name), now=now.get(name)) for name, words in WORDS.items() if before.get(name, "") != now.get(name, "")
    ]
    then, stacks = before.get("stacks", {}), now.get("stacks", {})
    for viewpoint in sorted({*then, *stacks}):
        if viewpoint not in stacks:
            found.append(f"Viewpoint {viewpoint} was removed after the results were computed.")
        elif viewpoint not in then:
            found.append(f"Viewpoint {viewpoint} is stored, but the results were computed without it.")
        elif then[viewpoint] != stacks[viewpoint]:
            found.append(f"The results were computed with other images of viewpoint {viewpoint}.")
    return tuple(found)


def _hash_of(known: Mapping[str, str], names: tuple[str, ...]) -> str:
    there = {name: known[name] for name in names if name in known}
    return digest(there) if there else ""
