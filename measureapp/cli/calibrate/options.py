"""Options common to several calibrations."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from measureapp.cli.reply import JsonOption, reply
from measureapp.data.json_values import jsonable
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.board import AnyBoard, BoardDescription

ImagesOption = Annotated[list[str] | None, typer.Option("--images", help="Images of one camera: name='pattern'; once per camera.")]
BoardOption = Annotated[
    str | None,
    typer.Option(
        "--board",
        help="Columns x rows of the board: 14x11 or charuco:14x11 (inner corners), circles:4x11 (staggered; circles in a row x rows).",
    ),
]
SquareOption = Annotated[
    float | None, typer.Option("--square-mm", help="Side of a square, mm; of a circle board the distance of neighbouring rows.")
]
MarkerOption = Annotated[float | None, typer.Option("--marker-mm", help="Side of a ChArUco board's markers, mm.")]
DictionaryOption = Annotated[str, typer.Option("--dictionary", help="Dictionary of a ChArUco board's markers, such as 5X5_250.")]
DiameterOption = Annotated[float | None, typer.Option("--diameter-mm", help="Diameter of a circle board's circles, mm.")]
CertificateOption = Annotated[
    Path | None, typer.Option("--certificate", help="Certificate of the board (TOML), or table of its certified marks (CSV).")
]
ClassOption = Annotated[
    Literal["printed", "glass", "ceramic"] | None,
    typer.Option("--board-class", help="How well the board's lengths are known without a certificate; not stated: as a printed one."),
]
BoardTemperatureOption = Annotated[
    str | None, typer.Option("--board-temperature", help="Of the board in these images in °C with its uncertainty (k = 2): 21.5±0.5.")
]
CamerasOption = Annotated[Path | None, typer.Option("--cameras", help="Calibrated cameras (cameras.json).")]
OutOption = Annotated[Path | None, typer.Option("--out", help="File to write.", dir_okay=False)]
RobotPosesOption = Annotated[Path, typer.Option("--robot-poses", help="base_from_flange: name,x_mm,y_mm,z_mm,qw,qx,qy,qz.")]
BoardPosesOption = Annotated[Path | None, typer.Option("--board-poses", help="camera_from_board, with the names of the robot poses.")]
KINDS = {"": "checkerboard", "checkerboard": "checkerboard", "checker": "checkerboard", "charuco": "charuco", "circles": "circles"}


@dataclass(frozen=True, slots=True)
class BoardChoice:
    """The board as the options of a command name it; checked when the description is requested."""

    board: BoardOption = None
    square_mm: SquareOption = None
    marker_mm: MarkerOption = None
    dictionary: DictionaryOption = "5X5_250"
    diameter_mm: DiameterOption = None
    certificate: CertificateOption = None
    board_class: ClassOption = None
    board_temperature: BoardTemperatureOption = None

    def description(self) -> BoardDescription:
        """Return the board with its lengths. Raises InputError naming the option that is wrong or missing."""
        from measureapp.project.calibration.certificate_file import with_lengths

        return with_lengths(self._grid(), self.certificate, self.board_class, self.board_temperature)

    def _grid(self) -> AnyBoard:
        from pydantic import TypeAdapter, ValidationError

        from measureapp.data.board import AnyBoard as AnyKind
        from measureapp.data.model import first_problem

        match = re.fullmatch(r"\s*(?:([A-Za-z]+):)?\s*(\d+)\s*[xX×]\s*(\d+)\s*", self.board or "")
        kind = KINDS.get((match[1] or "").lower()) if match else None
        if match is None or kind is None or int(match[3]) < 3 or int(match[2]) < (2 if kind == "circles" else 3):
            raise InputError(
                f"--board {self.board or ''!r} is not a board.",
                "Give its inner corners, at least 3 × 3, such as --board 14x11 or charuco:14x11, or its circles, such as circles:4x11.",
            )
        length = self._length("--square-mm", self.square_mm, "the side of a square", "12")
        document: dict[str, Any] = {"kind": kind, "columns": int(match[2]), "rows": int(match[3])}
        if kind == "circles":
            document |= {
                "spacing_mm": length,
                "diameter_mm": self._length("--diameter-mm", self.diameter_mm, "the diameter of a circle", "8"),
            }
        else:
            document |= {"square_mm": length}
        if kind == "charuco":
            name = self.dictionary.upper().removeprefix("DICT_")
            document |= {"marker_mm": self._length("--marker-mm", self.marker_mm, "the side of a marker", "9"), "dictionary": name}
        try:
            made: AnyBoard = TypeAdapter(AnyKind).validate_python(document)
        except ValidationError as error:
            raise InputError(f"--board {self.board}: {first_problem(error, 'the board')}.", "Correct the options of the board.") from error
        return made

    @staticmethod
    def _length(option: str, value: float | None, what: str, example: str) -> float:
        if value is None or not 0 < value < float("inf"):
            raise InputError(f"{option} must be a length above 0.", f"Give {what} in mm, such as {option} {example}.")
        return value


@dataclass(frozen=True, slots=True)
class BoardSource:
    """Images of a board taken by calibrated cameras."""

    images: ImagesOption = None
    cameras: CamerasOption = None
    board: BoardChoice = field(default_factory=BoardChoice)


@dataclass(frozen=True, slots=True)
class Answer:
    """How a command answers: a file if requested, and JSON or lines on standard output."""

    out: OutOption = None
    as_json: JsonOption = False

    def give(self, ctx: typer.Context, document: Mapping[str, Any], lines: Sequence[str], extra: Mapping[str, Any] | None = None) -> None:
        """Write the file, with ``extra`` before the answer and the provenance after it, and print the answer."""
        from measureapp.cli.calibrate.made_from import made_from
        from measureapp.project.atomic import write_json

        if self.out is not None:
            made = made_from(ctx, self.out)
            write_json(self.out, {"schema_version": 1, **jsonable(extra or {}), **jsonable(document), "made_from": made.document()})
        reply(document, "\n".join(lines), self.as_json)
