"""Options that several calibrations share."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_type_hints

import typer

from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.board import BoardDescription

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
CamerasOption = Annotated[Path | None, typer.Option("--cameras", help="Calibrated cameras (cameras.json).")]
OutOption = Annotated[Path | None, typer.Option("--out", help="File to write.")]
RobotPosesOption = Annotated[Path, typer.Option("--robot-poses", help="base_from_flange: name,x_mm,y_mm,z_mm,qw,qx,qy,qz.")]
BoardPosesOption = Annotated[Path | None, typer.Option("--board-poses", help="camera_from_board, with the names of the robot poses.")]
KINDS = {"": "checkerboard", "checkerboard": "checkerboard", "checker": "checkerboard", "charuco": "charuco", "circles": "circles"}
BOARD_OPTIONS = {
    "board": (BoardOption, None),
    "square_mm": (SquareOption, None),
    "marker_mm": (MarkerOption, None),
    "dictionary": (DictionaryOption, "5X5_250"),
    "diameter_mm": (DiameterOption, None),
}


@dataclass(frozen=True, slots=True)
class BoardChoice:
    """The board as the options of a command name it; checked when the board is asked for."""

    board: str | None = None
    square_mm: float | None = None
    marker_mm: float | None = None
    dictionary: str = "5X5_250"
    diameter_mm: float | None = None

    def description(self) -> BoardDescription:
        """Return the board. Raises InputError naming the option that is wrong or missing."""
        from pydantic import TypeAdapter, ValidationError

        from measureapp.data.board import AnyBoard
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
            made: BoardDescription = TypeAdapter(AnyBoard).validate_python(document)
        except ValidationError as error:
            raise InputError(f"--board {self.board}: {first_problem(error, 'the board')}.", "Correct the options of the board.") from error
        return made

    @staticmethod
    def _length(option: str, value: float | None, what: str, example: str) -> float:
        if value is None or not 0 < value < float("inf"):
            raise InputError(f"{option} must be a length above 0.", f"Give {what} in mm, such as {option} {example}.")
        return value


NO_BOARD = BoardChoice()


def with_board(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of the board in place of its parameter ``board``, which receives them as one `BoardChoice`."""
    hints = get_type_hints(command, include_extras=True)
    options = [
        inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=default, annotation=annotation)
        for name, (annotation, default) in BOARD_OPTIONS.items()
    ]
    parameters: list[inspect.Parameter] = []
    for name, parameter in inspect.signature(command).parameters.items():
        parameters += options if name == "board" else [parameter.replace(annotation=hints[name])]

    @functools.wraps(command)
    def wrapped(**given: Any) -> None:
        chosen = BoardChoice(**{name: given.pop(name) for name in BOARD_OPTIONS})
        command(**given, board=chosen)

    wrapped.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters} | {"return": None}
    wrapped.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    return wrapped
