"""Where the recorded data sets lie; they are not part of the project."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

DEFAULT = Path(__file__).resolve().parents[2] / "shared" / "data"


def recorded(name: str) -> Path:
    """Return the folder of a recorded set, or skip the test where it is absent."""
    folder = Path(os.environ.get("MEASUREAPP_TEST_DATA", DEFAULT)) / name
    if not folder.is_dir():
        pytest.skip(f"recorded set {name} is absent")
    return folder
