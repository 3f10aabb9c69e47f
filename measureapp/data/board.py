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
    bow_mm: tuple[float, float, float] = Field(default=(0.0, 0.0, 0.0), description="departure from flat: factors of the `bow_terms`")

    @property
    def flat_corners_mm(self) -> FloatArray:
        """The inner corners (columns·rows, 3) of a perfectly flat board, row by row."""
        y, x = np.mgrid[0 : self.rows, 0 : self.columns]
        return np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)]) * self.square_mm

    @property
    def bow_terms(self) -> FloatArray:
        """The terms x², xy, y² of the corners (columns·rows, 3), with x, y from −1 to 1 over the longer side."""
        centred = self.flat_corners_mm[:, :2] - self.flat_corners_mm[:, :2].mean(axis=0)
        x, y = (centred / np.abs(centred).max()).T
        return np.column_stack([x * x, x * y, y * y])

    @property
    def corners_mm(self) -> FloatArray:
        """The inner corners (columns·rows, 3) with the board's bow, row by row."""
        corners = self.flat_corners_mm
        corners[:, 2] += self.bow_terms @ np.array(self.bow_mm)
        return corners

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
