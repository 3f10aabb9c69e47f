"""Pictures of the window to leaf through, in the folder that MEASUREAPP_SCREENSHOTS names: sizes, themes, languages."""

from __future__ import annotations

import os
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import pytest

FOLDER = os.environ.get("MEASUREAPP_SCREENSHOTS", "")
SIZES = ((1280, 720), (1600, 900), (1920, 1080))
ON_DEMAND = [
    pytest.mark.slow,
    pytest.mark.skipif(not FOLDER, reason="set MEASUREAPP_SCREENSHOTS to the folder that shall receive the pictures"),
]


@dataclass(frozen=True)
class Wall:
    """One size, theme and language of all pictures of a walk through the window."""

    size: tuple[int, int]
    shade: str
    language: str

    def dress(self, application: Any) -> None:
        """Change theme and language, and wait until everything on display followed."""
        application.look.set_shade(self.shade)
        application.settings.set_text("language", self.language)
        application.language.retranslation.finish()

    def keep(self, widget: Any, name: str) -> None:
        """Write a picture of a widget."""
        folder = Path(FOLDER)
        folder.mkdir(parents=True, exist_ok=True)
        assert widget.grab().save(str(folder / f"{name}-{self}.png"))

    def __str__(self) -> str:
        return f"{self.size[0]}x{self.size[1]}-{self.shade}-{self.language}"


every_wall = pytest.mark.parametrize("wall", [Wall(*one) for one in product(SIZES, ("light", "dark"), ("en", "zh_CN"))], ids=str)
