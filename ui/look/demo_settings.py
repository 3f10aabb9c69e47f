"""Settings of the demo."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.data.length_unit import LengthUnit
from measureapp.data.sample_worlds import DEFAULT_WORLD
from ui.look.pattern_words import RECOMMENDED

Resolution = Literal["full", "half", "quarter"]


@dataclass(frozen=True)
class DemoSettings:
    """Settings of the demo: part, resolution, viewpoints, patterns, virtual rig."""

    part: str = "gypsum"  # a sample part, or a mesh file
    resolution: Resolution = "quarter"  # the first report counts; half shows what the algorithms reach
    viewpoints: int = 8
    seed: int = 1  # of the virtual rig's hidden errors
    patterns: str = RECOMMENDED  # name of the pattern set
    unit: LengthUnit = LengthUnit.MM  # of a mesh file
    world: str = DEFAULT_WORLD  # how well the virtual rig and the part are made
