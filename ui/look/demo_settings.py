"""What the demo measures, as the user sets it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Resolution = Literal["full", "half", "quarter"]


@dataclass(frozen=True)
class DemoSettings:
    """Part, image resolution, number of viewpoints, and the seed of the virtual rig's hidden errors."""

    part: str = "gypsum"
    resolution: Resolution = "half"
    viewpoints: int = 8
    seed: int = 1
