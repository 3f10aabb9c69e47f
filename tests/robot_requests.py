"""Robot drivers as tests load them: by path, from their plugin folder."""

from __future__ import annotations

import importlib
import threading
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import PRIVATE_PACKAGE, load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig


def connect_robot(plugin: str, **settings: Any) -> Any:
    """Connect the robot of a plugin, with the reference rig's description."""
    loaded = load_driver(None, plugin, "robot")
    return loaded.entry(DeviceRequest("robot", read_rig("paper"), loaded.settings.model_validate(settings), Links({})))


def plugin_module(plugin: str, name: str) -> ModuleType:
    """Import one module of a plugin."""
    load_driver(None, plugin, "robot")
    return importlib.import_module(f"{PRIVATE_PACKAGE}.{plugin}.{name}")


class Background:
    """Runs a call in a thread and keeps what it raised and when it ended."""

    def __init__(self, call: Callable[[], object]) -> None:
        self.error: BaseException | None = None
        self.ended_at = 0.0
        self._call = call
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        try:
            self._call()
        except (Exception, Cancelled) as error:
            self.error = error
        self.ended_at = time.monotonic()

    def wait(self, timeout_s: float = 20.0) -> BaseException | None:
        """Return what the call raised, after it ended."""
        self._thread.join(timeout_s)
        assert not self._thread.is_alive(), "the call still waits"
        return self.error


def until(condition: Callable[[], bool], timeout_s: float = 5.0) -> None:
    """Wait until a condition holds."""
    end = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.002)
