"""What the demo measures, as the user sets it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.data.length_unit import LengthUnit
from ui.look.pattern_words import RECOMMENDED

Resolution = Literal["full", "half", "quarter"]


@dataclass(frozen=True)
class DemoSettings:
    """What the demo measures, and how."""

    part: str = "gypsum"  # a sample part, or a mesh file
    resolution: Resolution = "half"
    viewpoints: int = 8
    seed: int = 1  # of the virtual rig's hidden errors
    patterns: str = RECOMMENDED  # by its name
    unit: LengthUnit = LengthUnit.MM  # of the mesh file's lengths
