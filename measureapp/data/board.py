"""The calibration board, and a sighting of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.fringe import AxisReadback
from measureapp.data.model import Model


class CheckerboardDescription(Model):
    """A checkerboard by its inner corners; frame `board`: origin at the first corner, x along columns, y along rows, z = 0."""

    columns: int = Field(ge=3, description="inner corners along x")
    rows: int = Field(ge=3, description="inner corners along y")
    square_mm: float = Field(gt=0)

    @property
    def corners_mm(self) -> FloatArray:
        """The inner corners (columns·rows, 3), row by row."""
        y, x = np.mgrid[0 : self.rows, 0 : self.columns]
        return np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)]) * self.square_mm

    @property
    def is_symmetric(self) -> bool:
        """Whether the board looks the same after half a turn, so that its pose has two answers."""
        return self.columns % 2 == self.rows % 2


@dataclass(frozen=True, slots=True, eq=False)
class BoardView:
    """One sighting of the board by all cameras, with where every axis said it was."""

    viewpoint_id: str
    images: Mapping[str, ImageArray]  # camera -> (height, width)
    readback: AxisReadback
