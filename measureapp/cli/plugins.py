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
        folder: Annotated[Path | None, typer.Option(help="Folder of the plugins; default: the program's and ~/MeasureApp/plugins.")] = None,
        allow: Annotated[str | None, typer.Option("--allow", metavar="ID", help="Allow this plugin to be loaded, as it is now.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """List the device drivers, with the reason for any that failed to load.

        A plugin that does not come with the program is loaded only after it was allowed; any change of its files withdraws that.
        """
        from measureapp.devices.plugin_loader import PluginRow, examine
        from measureapp.errors import InputError

        if folder is not None and not folder.is_dir():
            raise InputError(f"{folder} is not a folder.", "Name the folder that contains the plugin folders.")

        if allow is not None:
            reply(*_allowed(folder, allow), as_json)
            return

        rows = examine(folder)
        width = max((len(row.id) for row in rows), default=0)

        def line(row: PluginRow) -> str:
            words = f"NOT LOADED: {row.problem} {row.hint}" if row.problem else f"{row.name} ({', '.join(row.kinds)})"
            return f"{row.id:<{width}}  {row.version or '–':<7} {words}"

        document = {"plugins": [asdict(row) | {"loaded": not row.problem} for row in rows]}
        reply(document, "\n".join(line(row) for row in rows) or "There is no driver plugin.", as_json)


def _allowed(folder: Path | None, plugin_id: str) -> tuple[dict[str, str], str]:
    """Allow a plugin; return the JSON document and the sentence of the answer."""
    from measureapp.devices.plugin_loader import discover
    from measureapp.devices.plugin_permission import allow
    from measureapp.errors import InputError
    from measureapp.resources import user_plugin_folder

    rows = [row for row in discover(folder) if row.id == plugin_id]
    if not rows:
        raise InputError(f"There is no plugin {plugin_id} in {folder or user_plugin_folder()}.", "Name its --folder and its id.")
    found = next((row for row in rows if not row.allowed), rows[-1])
    if found.problem and found.allowed:
        raise InputError(f"{found.folder} cannot be allowed: {found.problem}", found.hint)
    digest = allow(found.folder)
    return {"allowed": plugin_id, "sha256": digest}, f"{plugin_id} in {found.folder} may be loaded as it is now (SHA-256 {digest[:16]}…)."
