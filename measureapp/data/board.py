"""Descriptions of calibration boards, and the images taken of one."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Discriminator, Field, SerializerFunctionWrapHandler, Tag, model_serializer, model_validator

from measureapp.arrays import FloatArray, ImageArray, IntArray, read_only
from measureapp.data.certificate import BoardLengths
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback
from measureapp.data.model import Model

# name -> number of ArUco markers; OpenCV's names without DICT_
DICTIONARIES = {f"{bits}X{bits}_{count}": count for bits in (4, 5, 6, 7) for count in (50, 100, 250, 1000)} | {
    "APRILTAG_16H5": 30,
    "APRILTAG_25H9": 35,
    "APRILTAG_36H10": 2320,
    "APRILTAG_36H11": 587,
    "ARUCO_ORIGINAL": 1024,
}
LARGEST_CIRCLE = 0.9  # diameter over the distance of neighbouring centres; larger circles merge in the image


class BoardDescription(Model):
    """Base of all boards: marks in rows, numbered row by row.

    Frame `board`: origin at mark 0, x along a row, y along a column, z = 0 on a flat board; the printed side faces -z. The marks are
    the inner corners of a checkerboard or the centres of circles; the index of a mark is its id, so that an image may show a subset.
    """

    columns: int = Field(ge=2, description="marks along x")
    rows: int = Field(ge=3, description="marks along y")
    bow_mm: tuple[float, float, float] = Field(
        default=(0.0, 0.0, 0.0), description="deviation from flatness: coefficients of the `bow_terms`"
    )
    certified_mm: tuple[tuple[float, float, float], ...] | None = Field(
        default=None, description="position of every mark in frame `board`, as certified; none: the nominal grid"
    )
    displaced_mm: tuple[tuple[float, float], ...] | None = Field(
        default=None,
        description="displacement of every mark in x and y from where it is certified or else nominal, as the images of a calibration "
        "show it; none: not estimated",
    )
    lengths: BoardLengths | None = Field(
        default=None, description="class or certificate; none: nobody stated how well its lengths are known"
    )

    @model_validator(mode="after")
    def _certificate_is_complete(self) -> BoardDescription:
        if self.certified_mm is not None and len(self.certified_mm) != self.count:
            raise ValueError(f"certified_mm has {len(self.certified_mm)} marks, the {self.label} has {self.count}")
        if self.displaced_mm is not None and len(self.displaced_mm) != self.count:
            raise ValueError(f"displaced_mm has {len(self.displaced_mm)} marks, the {self.label} has {self.count}")
        return self

    @model_serializer(mode="wrap")
    def _without_empty_certificate(self, serialise: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Write what is known of marks and lengths only where it is: files without it keep the form they have always had."""
        written: dict[str, Any] = serialise(self)
        seldom = ("certified_mm", "displaced_mm", "lengths")
        return {name: value for name, value in written.items() if name not in seldom or value is not None}

    @property
    @abstractmethod
    def nominal_corners_mm(self) -> FloatArray:
        """The marks (columns·rows, 3) of the nominal grid, row by row."""

    @property
    def flat_corners_mm(self) -> FloatArray:
        """The marks (columns·rows, 3) without bow, row by row: as certified, else of the nominal grid; as warm as the board was.

        What images show of their displacement is added.
        """
        marks = self.nominal_corners_mm if self.certified_mm is None else np.array(self.certified_mm, float)
        marks = marks if self.lengths is None else marks * self.lengths.factor
        if self.displaced_mm is not None:
            marks[:, :2] += np.array(self.displaced_mm)
        return marks

    @property
    @abstractmethod
    def neighbour_mm(self) -> float:
        """Distance between neighbouring marks."""

    @property
    @abstractmethod
    def label(self) -> str:
        """Name of the board, as part of a sentence."""

    @property
    @abstractmethod
    def is_symmetric(self) -> bool:
        """Whether the board has a 180° symmetry, which leaves its pose ambiguous."""

    @property
    def count(self) -> int:
        """Number of marks."""
        return self.columns * self.rows

    @property
    def bow_terms(self) -> FloatArray:
        """The quadratic terms x², xy, y² of the marks (columns·rows, 3), with x, y from −1 to 1 over the longer side."""
        flat = self.flat_corners_mm[:, :2]
        centred = flat - flat.mean(axis=0)
        x, y = (centred / np.abs(centred).max()).T
        return np.column_stack([x * x, x * y, y * y])

    @property
    def corners_mm(self) -> FloatArray:
        """The marks (columns·rows, 3) of the bowed board, row by row."""
        corners = self.flat_corners_mm
        if any(self.bow_mm):
            corners[:, 2] += self.bow_terms @ np.array(self.bow_mm)
        return corners

    @property
    def middle_mm(self) -> FloatArray:
        """The centre (3,) of the box around the marks of the flat board."""
        corners = self.flat_corners_mm
        return np.asarray((corners.min(axis=0) + corners.max(axis=0)) / 2.0)

    def marks_mm(self, ids: IntArray | None = None) -> FloatArray:
        """Return the marks of ``ids`` (N, 3) on the bowed board; all of them without ids."""
        return self.corners_mm if ids is None else self.corners_mm[ids]


class _SquaresDescription(BoardDescription):
    """A board of squares, described by its inner corners."""

    columns: int = Field(ge=3, description="inner corners along x")
    rows: int = Field(ge=3, description="inner corners along y")
    square_mm: float = Field(gt=0)

    @property
    def nominal_corners_mm(self) -> FloatArray:
        """The inner corners (columns·rows, 3) of the nominal grid, row by row."""
        return _places(self.columns, self.rows) * self.square_mm

    @property
    def neighbour_mm(self) -> float:
        """Side of a square."""
        return self.square_mm


class CheckerboardDescription(_SquaresDescription):
    """A plain checkerboard; the squares that touch corner 0 along the main diagonal are black."""

    kind: Literal["checkerboard"] = Field(default="checkerboard", exclude=True)  # files from before the other boards do not have it

    @property
    def label(self) -> str:
        """Name of the board, as part of a sentence."""
        return f"board of {self.columns} × {self.rows} corners"

    @property
    def is_symmetric(self) -> bool:
        """Both numbers of corners are even, or both odd."""
        return self.columns % 2 == self.rows % 2


class CharucoDescription(_SquaresDescription):
    """A ChArUco board: a checkerboard with ArUco markers in its white squares, which identify the corners."""

    kind: Literal["charuco"]
    marker_mm: float = Field(gt=0, description="side of a marker")
    dictionary: str = Field(default="5X5_250", description="ArUco dictionary: " + ", ".join(DICTIONARIES))
    legacy_pattern: bool = Field(
        default=False, description="layout of OpenCV before 4.6: even number of rows of squares, first square white"
    )

    @model_validator(mode="after")
    def _fits(self) -> CharucoDescription:
        if self.marker_mm >= self.square_mm:
            raise ValueError(f"markers of {self.marker_mm:g} mm do not fit into squares of {self.square_mm:g} mm")
        if self.dictionary not in DICTIONARIES:
            raise ValueError(f"there is no dictionary {self.dictionary!r}; there are {', '.join(DICTIONARIES)}")
        markers = (self.columns + 1) * (self.rows + 1) // 2
        if markers > DICTIONARIES[self.dictionary]:
            raise ValueError(f"the board needs {markers} markers, dictionary {self.dictionary} has {DICTIONARIES[self.dictionary]}")
        if self.legacy_pattern and self.rows % 2 == 0:
            raise ValueError("legacy_pattern applies only to an even number of rows of squares (an odd number of rows of corners)")
        return self

    @property
    def label(self) -> str:
        """Name of the board, as part of a sentence."""
        return f"ChArUco board of {self.columns} × {self.rows} corners"

    @property
    def is_symmetric(self) -> bool:
        """Never: every marker is unique."""
        return False


class CirclesDescription(BoardDescription):
    """Asymmetric circle grid, dark on white: circle j of row i is at ((2j + i mod 2)·spacing, i·spacing)."""

    columns: int = Field(ge=2, description="circles in a row")
    rows: int = Field(ge=3, description="rows of circles")
    kind: Literal["circles"]
    spacing_mm: float = Field(gt=0, description="distance of neighbouring rows; circles of one row are twice as far apart")
    diameter_mm: float = Field(gt=0)

    @model_validator(mode="after")
    def _fits(self) -> CirclesDescription:
        if self.diameter_mm > LARGEST_CIRCLE * self.neighbour_mm:
            raise ValueError(
                f"circles of {self.diameter_mm:g} mm are too close: at most {LARGEST_CIRCLE * self.neighbour_mm:.3g} mm at this spacing"
            )
        return self

    @property
    def nominal_corners_mm(self) -> FloatArray:
        """The circle centres (columns·rows, 3) of the nominal grid, row by row."""
        places = np.array(_places(self.columns, self.rows))
        places[:, 0] = 2 * places[:, 0] + places[:, 1] % 2
        return places * self.spacing_mm

    @property
    def neighbour_mm(self) -> float:
        """Distance to the nearest circle in the next row."""
        return self.spacing_mm * float(np.sqrt(2.0))

    @property
    def label(self) -> str:
        """Name of the board, as part of a sentence."""
        return f"grid of {self.columns} × {self.rows} circles"

    @property
    def is_symmetric(self) -> bool:
        """True for an even number of rows: then half a turn maps the grid onto itself."""
        return self.rows % 2 == 0


@cache
def _places(columns: int, rows: int) -> FloatArray:
    """Return column, row and 0 of every mark (columns·rows, 3), row by row; kept, because solvers ask for the marks thousands of times."""
    row, column = np.mgrid[0:rows, 0:columns]
    places: FloatArray = read_only(np.column_stack([column.ravel(), row.ravel(), np.zeros(row.size)]))
    return places


def _kind(board: Any) -> str:
    return str(board.get("kind", "checkerboard")) if isinstance(board, Mapping) else str(getattr(board, "kind", ""))


AnyBoard = Annotated[
    Annotated[CheckerboardDescription, Tag("checkerboard")]
    | Annotated[CharucoDescription, Tag("charuco")]
    | Annotated[CirclesDescription, Tag("circles")],
    Discriminator(_kind),
]
"""Any of the boards, discriminated by `kind`; without `kind` it is a checkerboard."""


@dataclass(frozen=True, slots=True, eq=False)
class BoardView:
    """Images of the board by all cameras at one viewpoint, with the axis read-back."""

    viewpoint_id: str
    images: Mapping[str, ImageArray]  # camera -> (height, width)
    readback: AxisReadback
    conditions: Conditions | None = None  # None where they were not recorded
