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


class Stalls:
    """Notes when this process did not run at all, on a computer that has other things to do: no driver can stop anything then."""

    def __init__(self) -> None:
        self._gaps: list[tuple[float, float]] = []
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._watch)

    def __enter__(self) -> Stalls:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ends.set()
        self._thread.join()

    def within(self, began: float, ended: float) -> float:
        """Return the seconds between two moments in which nothing ran."""
        return sum(max(0.0, min(ended, end) - max(began, start)) for start, end in self._gaps)

    def _watch(self) -> None:
        before = time.monotonic()
        while not self._ends.wait(0.005):
            now = time.monotonic()
            if now - before > 0.05:
                self._gaps.append((before, now))
            before = now


def until(condition: Callable[[], bool], timeout_s: float = 5.0) -> None:
    """Wait until a condition holds."""
    end = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.002)
