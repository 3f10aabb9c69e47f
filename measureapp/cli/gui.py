"""`gui`: opens the window."""

from __future__ import annotations

import ctypes
import importlib
import importlib.util
import os
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply
from measureapp.errors import InputError

REPAIR = "Run `python3 installer/bootstrap.py run`, which installs what Qt needs."
FROM_TERMINAL = "All functions are also available without the window: see `measureapp --help`."


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def gui(
        project: Annotated[Path | None, typer.Argument(help="Project folder to open.")] = None,
        demo: Annotated[bool, typer.Option("--demo", help="Open with the demo project on the virtual rig.")] = False,
        reset_engineer_pin: Annotated[
            bool, typer.Option("--reset-engineer-pin", help="Remove the PIN of the engineer's role, if it is forgotten; opens no window.")
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Open the window."""
        if reset_engineer_pin:
            _reset_pin(as_json=as_json)
            return
        if project is not None and not (project / "project.json").is_file():
            raise InputError(f"{project} is not a project folder.", "Name a folder made by `measureapp demo` or `measureapp scan`.")
        check_screen()
        code = _window().run(project, demo)
        if as_json:
            reply({"closed": code == 0, "project": project}, "", as_json)
        raise typer.Exit(code)


def _reset_pin(*, as_json: bool) -> None:
    from measureapp.project.engineer_pin import pin_file, remove_pin

    removed = remove_pin(pin_file())
    words = "The PIN is removed: set a new one in operator mode's settings." if removed else "No PIN was set."
    reply({"pin_removed": removed}, words, as_json)


def check_screen() -> None:
    """Raise InputError if no window can be shown; Qt itself would abort the process."""
    if not sys.platform.startswith("linux") or "QT_QPA_PLATFORM" in os.environ or os.environ.get("WAYLAND_DISPLAY"):
        return
    display = os.environ.get("DISPLAY")
    if not display:
        raise InputError("There is no screen: neither DISPLAY nor WAYLAND_DISPLAY is set.", FROM_TERMINAL)
    try:
        answers = _x_server_answers()
    except OSError as error:
        raise InputError(f"Qt cannot start: {error}.", f"{REPAIR} {FROM_TERMINAL}") from error
    if not answers:
        raise InputError(f"The screen {display} named by DISPLAY does not answer.", f"Correct DISPLAY. {FROM_TERMINAL}")


def _x_server_answers() -> bool:
    """Return whether the X server can be reached; raises OSError naming a library missing for Qt's X plugin."""
    qt = importlib.util.find_spec("PySide6")
    for folder in (qt.submodule_search_locations or ()) if qt else ():
        for plugin in Path(folder).glob("Qt/plugins/platforms/libqxcb.so"):
            ctypes.CDLL(str(plugin))
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(xcb.xcb_connect(None, None))
    failed = xcb.xcb_connection_has_error(connection)
    xcb.xcb_disconnect(connection)
    return not failed


def _window() -> Any:
    """Import the module of the window by name, because the core must not depend on it."""
    try:
        importlib.import_module("PySide6.QtWidgets")
    except ImportError as error:
        raise InputError(f"Qt cannot start: {error}.", f"{REPAIR} {FROM_TERMINAL}") from error
    return importlib.import_module("ui.app")
