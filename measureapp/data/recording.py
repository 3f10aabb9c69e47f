"""`RECORDING.toml`: images and read-backs of another rig, from which a project is made."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import PurePosixPath, PureWindowsPath
from typing import Any, Literal

from pydantic import Field, TypeAdapter, ValidationError, field_validator, model_validator

from measureapp.data.board import AnyBoard
from measureapp.data.certificate import BoardClass
from measureapp.data.model import Model, first_problem
from measureapp.data.plan import FlangePose

AXES = ("base_from_flange", "guide_mm", "table_deg")
AXIS_WORDS = {"base_from_flange": "robot pose", "guide_mm": "guide position", "table_deg": "table angle"}
ID = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}")


class RecordedAxes(Model):
    """Read-backs of the axes at the time of recording; an axis that the rig does not have appears nowhere."""

    base_from_flange: FlangePose | None = None
    guide_mm: float | None = None
    table_deg: float | None = None

    @property
    def given(self) -> frozenset[str]:
        """Names of the axes with a read-back."""
        return frozenset(name for name in AXES if getattr(self, name) is not None)


class RecordedBoard(Model):
    """The calibration board, described as by the options of `calibrate`."""

    kind: Literal["checkerboard", "charuco", "circles"] = "checkerboard"
    inner_corners: tuple[int, int] | None = Field(default=None, description="columns and rows of a checkerboard or ChArUco board")
    circles: tuple[int, int] | None = Field(default=None, description="circles in a row, and rows, of a circle board")
    square_mm: float = Field(gt=0, description="side of a square; of a circle board the distance of neighbouring rows")
    marker_mm: float | None = Field(default=None, gt=0)
    dictionary: str | None = None
    legacy_pattern: bool | None = None
    diameter_mm: float | None = Field(default=None, gt=0)
    certificate: str | None = Field(default=None, description="table of the certified positions of the marks, or certificate in TOML")
    board_class: BoardClass | None = Field(default=None, description="how well its lengths are known, without a certificate")
    temperature: str | None = Field(default=None, description="of the board during the calibration in °C, such as 21.5±0.5 (k = 2)")

    @model_validator(mode="after")
    def _is_a_board(self) -> RecordedBoard:
        counts = "circles" if self.kind == "circles" else "inner_corners"
        if getattr(self, counts) is None:
            raise ValueError(f"a board of kind {self.kind!r} needs {counts} = [columns, rows]")
        own = {"charuco": ("marker_mm", "dictionary", "legacy_pattern"), "circles": ("diameter_mm",)}.get(self.kind, ())
        others = ("inner_corners", "circles", "marker_mm", "dictionary", "legacy_pattern", "diameter_mm")
        foreign = [name for name in others if getattr(self, name) is not None and name not in (*own, counts)]
        if foreign:
            raise ValueError(f"a board of kind {self.kind!r} has no {foreign[0]}")
        self.description()
        return self

    def description(self) -> AnyBoard:
        """Return the board with the marks of its nominal grid. Raises ValueError with the reason if there is no such board."""
        columns, rows = self.inner_corners or self.circles or (0, 0)
        document: dict[str, Any] = {"kind": self.kind, "columns": columns, "rows": rows}
        document["spacing_mm" if self.kind == "circles" else "square_mm"] = self.square_mm
        options = ("marker_mm", "dictionary", "legacy_pattern", "diameter_mm")
        document |= {name: getattr(self, name) for name in options if getattr(self, name) is not None}
        if self.dictionary is not None:
            document["dictionary"] = self.dictionary.upper().removeprefix("DICT_")
        try:
            made: AnyBoard = TypeAdapter(AnyBoard).validate_python(document)
        except ValidationError as error:
            raise ValueError(first_problem(error, "the board").removeprefix(f"{self.kind}.").removeprefix(f"{self.kind}: ")) from error
        return made


class RecordedBoardView(RecordedAxes):
    """Images of the board by all cameras at the same time."""

    images: dict[str, str] = Field(min_length=1, description="camera -> image")
    on_table: bool = Field(
        default=True, description="false: the board stands in the cell, or is held by hand where there are no read-backs"
    )


class RecordedViewpoint(RecordedAxes):
    """Fringe images of the part from one viewpoint."""

    id: str
    manifest: str

    @field_validator("id")
    @classmethod
    def _is_a_folder_name(cls, value: str) -> str:
        if not ID.fullmatch(value) or value.endswith("."):
            raise ValueError(
                f"{value!r} is no name of a folder: use letters, digits, '_', '-' and '.', at most 64, and no '.' at either end"
            )
        return value


class RecordedPart(Model):
    """Nominal and inspection program of the part."""

    nominal: str | None = None
    program: str | None = None


class Recording(Model):
    """Contents of the file; all paths are relative to it."""

    schema_version: Literal[1] = 1
    rig: str | None = Field(default=None, description="nominal description of the rig; not needed where the cameras are known")
    cameras: str | None = Field(default=None, description="cameras.json of calibrated cameras")
    board: RecordedBoard | None = None
    board_view: tuple[RecordedBoardView, ...] = ()
    viewpoint: tuple[RecordedViewpoint, ...] = ()
    part: RecordedPart = RecordedPart()

    @model_validator(mode="after")
    def _fits_together(self) -> Recording:
        if self.rig is None and self.cameras is None:
            raise ValueError("neither rig nor cameras is given: name a rig description, or the cameras.json of calibrated cameras")
        if not self.board_view and not self.viewpoint:
            raise ValueError("there is neither a [[board_view]] nor a [[viewpoint]]")
        if self.board_view and self.board is None:
            raise ValueError("there are board views, but no [board]")
        _refuse_twins([viewpoint.id for viewpoint in self.viewpoint])
        _refuse_absolute(self.paths())
        return self

    def paths(self) -> Iterator[tuple[str, str]]:
        """Yield place and path of every file that is named here; those named in manifests are not."""
        named = {"rig": self.rig, "cameras": self.cameras, "[part] nominal": self.part.nominal, "[part] program": self.part.program}
        named["[board] certificate"] = None if self.board is None else self.board.certificate
        yield from ((place, path) for place, path in named.items() if path is not None)
        for number, view in enumerate(self.board_view, 1):
            yield from ((f"[[board_view]] {number}, camera {camera!r}", path) for camera, path in view.images.items())
        yield from ((f"viewpoint {viewpoint.id!r}", viewpoint.manifest) for viewpoint in self.viewpoint)


def _refuse_twins(ids: Sequence[str]) -> None:
    """Raise ValueError for ids that name the same folder, also on a file system that ignores case."""
    folded = [one.casefold() for one in ids]
    twins = [one for one, key in zip(ids, folded, strict=True) if folded.count(key) > 1]
    if twins:
        raise ValueError(f"several viewpoints have the id {twins[0]!r} (capital and small letters count as equal)")


def _refuse_absolute(paths: Iterator[tuple[str, str]]) -> None:
    for place, path in paths:
        if not path.strip() or PurePosixPath(path).is_absolute() or PureWindowsPath(path).drive or PureWindowsPath(path).root:
            raise ValueError(f"{place}: {path!r} is no path relative to this file")
