"""`plugins`: list of device drivers."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.reply import JsonOption, reply


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def plugins(
        folder: Annotated[Path | None, typer.Option(help="Folder of the plugins; default: those shipped with the program.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """List the device drivers, with the reason for any that failed to load."""
        from measureapp.devices.plugin_loader import PluginRow, examine
        from measureapp.errors import InputError

        if folder is not None and not folder.is_dir():
            raise InputError(f"{folder} is not a folder.", "Name the folder that contains the plugin folders.")

        def line(row: PluginRow) -> str:
            start = f"{row.id:<20} {row.version or '–':<9} {', '.join(row.kinds) or '–':<13} "
            return start + (f"NOT LOADED: {row.problem} {row.hint}" if row.problem else row.name)

        rows = examine(folder)
        document = {"plugins": [asdict(row) | {"loaded": not row.problem} for row in rows]}
        reply(document, "\n".join(line(row) for row in rows) or "There is no driver plugin.", as_json)
