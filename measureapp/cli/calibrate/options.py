"""Options that several calibrations share."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.board import CheckerboardDescription

ImagesOption = Annotated[list[str] | None, typer.Option("--images", help="Images of one camera: name='pattern'; once per camera.")]
BoardOption = Annotated[str | None, typer.Option("--board", help="Inner corners of the board: columns x rows, such as 14x11.")]
SquareOption = Annotated[float | None, typer.Option("--square-mm", help="Side of a square, mm.")]
CamerasOption = Annotated[Path | None, typer.Option("--cameras", help="Calibrated cameras (cameras.json).")]
OutOption = Annotated[Path | None, typer.Option("--out", help="File to write.")]
RobotPosesOption = Annotated[Path, typer.Option("--robot-poses", help="base_from_flange: name,x_mm,y_mm,z_mm,qw,qx,qy,qz.")]
BoardPosesOption = Annotated[Path | None, typer.Option("--board-poses", help="camera_from_board, with the names of the robot poses.")]


def board_of(board: str | None, square_mm: float | None) -> CheckerboardDescription:
    """Return the board of ``--board`` and ``--square-mm``. Raises InputError."""
    from measureapp.data.board import CheckerboardDescription

    match = re.fullmatch(r"\s*(\d+)\s*[xX×]\s*(\d+)\s*", board or "")
    if match is None or min(int(match[1]), int(match[2])) < 3:
        raise InputError(f"--board {board or ''!r} is not a board.", "Give its inner corners, at least 3 × 3, such as --board 14x11.")
    if square_mm is None or not 0 < square_mm < float("inf"):
        raise InputError("--square-mm must be a length above 0.", "Give the side of a square in mm, such as --square-mm 12.")
    return CheckerboardDescription(columns=int(match[1]), rows=int(match[2]), square_mm=square_mm)
