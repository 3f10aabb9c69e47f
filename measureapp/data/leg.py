"""One move of one axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.arrays import FloatArray
from measureapp.data.fringe import AxisReadback

Axis = Literal["table", "guide", "robot"]


@dataclass(frozen=True, slots=True, eq=False)
class Leg:
    """A move of one axis; the others stay."""

    axis: Axis
    goal: AxisReadback  # of all axes, after the move
    joints_rad: FloatArray | None = None  # (6,) of the robot at the goal; None: it chooses them itself
