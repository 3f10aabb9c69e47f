"""Process of the second screen: ``python -m ui.second_screen list`` or ``… serve --width 912 --height 1140 --name DP-2``.

``list`` prints the screens as JSON. ``serve`` covers one and follows the commands on its standard input (`server.py`) until that ends.
"""

from __future__ import annotations

import argparse
import json
import sys
import threading
from collections.abc import Sequence

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication

from measureapp.errors import MeasureError
from ui.second_screen.screens import ScreenChoice, describe, find_screen
from ui.second_screen.server import Server
from ui.second_screen.window import PatternWindow

QUIT = '{"id": 0, "do": "quit"}'


class Commands(QObject):
    """Lines of the standard input, delivered to the thread of the window."""

    received = Signal(str)

    def start(self) -> None:
        """Begin to read, on a thread that ends with the process: a driver that dies closes the line, and the window goes."""
        threading.Thread(target=self._read, name="commands", daemon=True).start()

    def _read(self) -> None:
        with open(0, "rb", buffering=0, closefd=False) as lines:  # unbuffered: no lock is held at the end of the process
            for line in lines:
                self.received.emit(line.decode("utf-8", errors="replace"))
        self.received.emit(QUIT)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the process; returns its exit code."""
    options = _options(arguments)
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(Qt.HighDpiScaleFactorRoundingPolicy.PassThrough)
    application = QGuiApplication(["measureapp-second-screen"])
    if options.task == "list":
        _write(json.dumps([describe(screen) for screen in application.screens()], ensure_ascii=False))
        return 0
    try:
        choice = ScreenChoice(options.name, options.manufacturer, options.model, options.serial)
        screen = find_screen(application.screens(), choice)
        window = PatternWindow(screen, options.width, options.height)
    except MeasureError as error:
        _write(json.dumps({"event": "refused", "kind": type(error).__name__, "error": error.message, "hint": error.hint}))
        return 2
    server = Server(screen, window, options.width, options.height, _write)
    commands = Commands()
    commands.received.connect(server.receive, Qt.ConnectionType.QueuedConnection)
    window.showFullScreen()
    QTimer.singleShot(0, server, server.greet)
    commands.start()
    code = application.exec()
    window.destroy()
    return code


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m ui.second_screen", description="Patterns on a second screen.")
    tasks = parser.add_subparsers(dest="task", required=True)
    tasks.add_parser("list", help="print the screens")
    serve = tasks.add_parser("serve", help="cover a screen and follow the commands on the standard input")
    serve.add_argument("--width", type=int, required=True, help="of the patterns, px")
    serve.add_argument("--height", type=int, required=True, help="of the patterns, px")
    for part in ("name", "manufacturer", "model", "serial"):
        serve.add_argument(f"--{part}", default="", help=f"{part} of the screen")
    return parser.parse_args(arguments)


def _write(line: str) -> None:
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
