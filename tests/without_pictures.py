"""Projects processed without surface and pictures, which take most of the time and on which no dimension depends."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from measureapp.errors import RegistrationError
from measureapp.report.model import Pictures


@contextmanager
def without_pictures() -> Iterator[None]:
    """Let reports be written without their pictures."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("measureapp.report.drawing.Drawing.draw", lambda *_: Pictures())
        yield


@contextmanager
def without_surface_and_pictures() -> Iterator[None]:
    """Let processing end without a surface, as where memory is short, and reports be written without their pictures."""

    def refuse(*_: Any, **__: Any) -> None:
        raise RegistrationError("No surface in this test.", "See the tests of surfaces.")

    with without_pictures(), pytest.MonkeyPatch.context() as patch:
        patch.setattr("measureapp.pipeline.surface.reconstruct_surface", refuse)
        yield
