"""Axes of charts are made one after the other, and not before the library that draws them is loaded: the window answers in between."""

from __future__ import annotations

import importlib
import weakref
from concurrent.futures import Future, ThreadPoolExecutor
from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from shiboken6 import isValid

if TYPE_CHECKING:
    from ui.charts.chart import Chart

LIBRARY = "ui.charts.plotting"
ASKED_EVERY_MS = 10  # whether the library is loaded


class Turns:
    """The charts in sight whose axes are to be made."""

    def __init__(self) -> None:
        self._charts: list[weakref.ref[Chart]] = []
        loading = ThreadPoolExecutor(1, "charts")
        self._library: Future[ModuleType] = loading.submit(importlib.import_module, LIBRARY)
        loading.shutdown(wait=False)
        self._timer = QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._take_next)

    def wait(self, chart: Chart) -> None:
        """Call ``chart.begin`` as soon as it is its turn."""
        if not any(one() is chart for one in self._charts):
            self._charts.append(weakref.ref(chart))
        self._timer.start(0)

    def _take_next(self) -> None:
        """Begin one chart."""
        if not self._library.done():
            self._timer.start(ASKED_EVERY_MS)
            return
        self._library.result()  # raises what kept it from being loaded
        while self._charts:
            chart = self._charts.pop(0)()
            if chart is not None and isValid(chart) and chart.begin():
                break
        if self._charts:
            self._timer.start(0)


@cache
def turns() -> Turns:
    """Return the turns of all charts of the program; called in the window's thread."""
    return Turns()
