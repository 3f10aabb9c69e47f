"""The board is searched for once in each image: many tests calibrate from the demo's images, and most of what they take is this search."""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

_found: dict[tuple[bytes, tuple[int, ...], str, str], Any] = {}


@contextmanager
def found_once() -> Iterator[None]:
    """Let sessions and automatic runs take what was found before in an image of the very same pixels; what was not found is searched again."""
    from measureapp.calibration_session import detection

    search = detection.find_board

    def find(image: Any, board: Any) -> Any:
        key = (hashlib.sha256(np.ascontiguousarray(image)).digest(), image.shape, image.dtype.str, board.model_dump_json())
        if key not in _found:
            _found[key] = search(image, board)
        return _found[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(detection, "find_board", find)
        yield


@contextmanager
def found_under_fringes_once() -> Iterator[None]:
    """Let sessions and `calibrate projector` take what was found before under the very same fringes, decoded; what was refused is decoded again."""
    from measureapp.calibration_session import detection
    from measureapp.pipeline import projector

    search, found = projector.detect_under_fringes, dict[tuple[str, ...], Any]()

    def find(stack: Any, view: str, board: Any, settings: Any, progress: Any) -> Any:
        pixels = {camera: hashlib.sha256(np.ascontiguousarray(images)).hexdigest() for camera, images in stack.images.items()}
        key = (repr(pixels), repr(stack.exposures_us), stack.patterns.model_dump_json(), view, board.model_dump_json(), repr(settings))
        if key not in found:
            found[key] = search(stack, view, board, settings, progress)
        return found[key]

    with pytest.MonkeyPatch.context() as patch:
        for user in (detection, projector):
            patch.setattr(user, "detect_under_fringes", find)
        yield


def keep_found(file: Path) -> None:
    """Write what was found, for the other processes of a run."""
    file.write_bytes(pickle.dumps(_found))


def take_found(file: Path) -> None:
    """Read what another process of this run found."""
    _found.update(pickle.loads(file.read_bytes()))


def forget_every(count: int) -> None:
    """Let every so many-th image be searched again."""
    for key in list(_found)[::count]:
        del _found[key]
