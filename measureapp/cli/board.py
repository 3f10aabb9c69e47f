"""`board export`: a calibration board to print."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import BoardChoice
from measureapp.cli.reply import JsonOption, reply


def register(app: typer.Typer) -> None:
    """Add the command group."""
    group = typer.Typer(help="Calibration boards.", no_args_is_help=True)

    @group.callback()
    def boards() -> None:
        """Calibration boards."""

    @group.command()
    @with_groups
    def export(
        out: Annotated[
            Path, typer.Option("--out", help="SVG file to write; print it at 100 % and measure its line of 100 mm.", dir_okay=False)
        ],
        board: BoardChoice,
        as_json: JsonOption = False,
    ) -> None:
        """Write a printable calibration board at true scale."""
        from measureapp.project.calibration.board_drawing import write_board

        description = board.description()
        write_board(out, description)
        document = {"board": description.model_dump(), "files": {"board": out}}
        reply(document, f"Board saved to {out}: {description.label}. Print it at 100 % and measure its line of 100 mm.", as_json)

    app.add_typer(group, name="board")
