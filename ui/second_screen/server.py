"""Commands of a driver, one JSON object per line, and their replies.

=========== ======================================== =================================================
command     members                                  reply
=========== ======================================== =================================================
``load``    ``file``: bytes (count, height, width)   ``count``
``show``    ``index``, or ``level``: uniform grey     ``shown``: index, -1 for uniform light, -2 for dark
``state``                                            ``shown``
``quit``                                             none; the process ends
=========== ======================================== =================================================

Every command has a number ``id``, which its reply repeats. A refusal has ``error`` and ``hint``, and ``lost`` when the screen is gone.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Slot
from PySide6.QtGui import QGuiApplication, QScreen

from measureapp.arrays import ImageArray
from measureapp.errors import DeviceError, MeasureError
from ui.second_screen.screens import describe
from ui.second_screen.window import PatternWindow

DARK, PLAIN_LIGHT = -2, -1
Message = dict[str, Any]


class Server(QObject):
    """Carries out commands on one window, in the thread of the window.

    Parameters
    ----------
    write : called with every line of a reply
    """

    def __init__(self, screen: QScreen, window: PatternWindow, width_px: int, height_px: int, write: Callable[[str], None]) -> None:
        super().__init__()
        self._screen, self._window, self._write = screen, window, write
        self._size = (height_px, width_px)
        self._images: ImageArray = np.zeros((0, height_px, width_px), np.uint8)
        self._shown = DARK
        self._name, self._lost = screen.name(), ""
        application = QGuiApplication.instance()
        assert isinstance(application, QGuiApplication)
        application.screenRemoved.connect(self.forget)
        screen.geometryChanged.connect(self.change)
        screen.refreshRateChanged.connect(self.change)
        self._actions: dict[str, Callable[[Message], Message]] = {
            "load": self._load,
            "show": self._show,
            "state": lambda _: {"shown": self._shown},
        }

    def greet(self) -> None:
        """State that the window is there, and on which screen."""
        self._send({"event": "ready", "screen": describe(self._screen)})

    @Slot(str)
    def receive(self, line: str) -> None:
        """Carry out one command and reply; ``quit``, also sent at the end of all commands, ends the application."""
        number = None
        try:
            command = json.loads(line)
            number = command["id"]
            if command["do"] == "quit":
                QGuiApplication.quit()
                return
            if self._lost:
                raise DeviceError(self._lost, "Connect it again, then connect the rig again.")
            self._send({"id": number} | self._actions[command["do"]](command))
        except MeasureError as error:
            self._send({"id": number, "error": error.message, "hint": error.hint, "lost": bool(self._lost)})
        except (KeyError, TypeError, ValueError, OSError) as error:
            reason = f"The command {line.strip()[:120]} cannot be executed: {type(error).__name__}: {error}."
            self._send({"id": number, "error": reason, "hint": "Use driver and window of the same version.", "lost": False})

    @Slot(QScreen)
    def forget(self, screen: QScreen) -> None:
        """Hide the window when its screen is gone, so that no pattern appears on another one."""
        if screen is self._screen or screen.name() == self._name:
            self._lose(f"The screen {self._name} was disconnected.")

    @Slot()
    def change(self, *_: object) -> None:
        """Give up when the mode of the screen changes: pixels and times would be others."""
        self._lose(f"The mode of the screen {self._name} has changed.")

    def _lose(self, reason: str) -> None:
        if not self._lost:
            self._lost, self._shown = reason, DARK
            self._window.hide()
            self._send({"event": "lost", "error": reason, "hint": "Connect it again, then connect the rig again."})

    def _load(self, command: Message) -> Message:
        values = np.fromfile(Path(command["file"]), np.uint8)
        height, width = self._size
        self._images = values.reshape(-1, height, width)
        self._show({"level": 0})
        return {"count": len(self._images)}

    def _show(self, command: Message) -> Message:
        if "level" in command:
            self._window.display(np.full(self._size, command["level"], np.uint8))
            self._shown = PLAIN_LIGHT if command["level"] else DARK
        else:
            if not 0 <= command["index"] < len(self._images):
                raise DeviceError(f"There are {len(self._images)} images, and none is {command['index']}.", "Load the pattern set first.")
            self._window.display(self._images[command["index"]])
            self._shown = command["index"]
        return {"shown": self._shown}

    def _send(self, message: Message) -> None:
        self._write(json.dumps(message))
