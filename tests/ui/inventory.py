"""What is alive in the process: widgets, timers, threads and VTK objects, to be compared before and after something is used."""

from __future__ import annotations

import gc
import threading
from collections import Counter

from PySide6.QtCore import QCoreApplication, QEvent, QThread, QTimer
from PySide6.QtWidgets import QApplication
from shiboken6 import getAllValidWrappers

LIBRARY_WIDGETS = ("QTipLabel",)
TURNS = 3


def inventory() -> Counter[str]:
    """Return how many objects of each class are alive, as ``kind class``; what only waits for its deletion is deleted first."""
    for _ in range(TURNS):
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
        gc.collect()
    found: Counter[str] = Counter()
    for widget in QApplication.allWidgets():
        name = widget.metaObject().className()
        if name not in LIBRARY_WIDGETS:
            found[f"widget {name}"] += 1
    for item in getAllValidWrappers():
        if isinstance(item, QTimer):
            found["timer QTimer"] += 1
        elif isinstance(item, QThread):
            found[f"thread {type(item).__name__}"] += 1
    for thread in threading.enumerate():
        if not isinstance(thread, threading._DummyThread):
            found[f"thread {type(thread).__name__}"] += 1
    for item in gc.get_objects():
        kind = type(item)
        if str(kind.__module__).startswith("vtkmodules") and not isinstance(item, type) and hasattr(kind, "GetClassName"):
            found[f"VTK {kind.__name__}"] += 1
    return found


def grown(before: Counter[str], after: Counter[str]) -> dict[str, str]:
    """Return what there is more of, as ``{"widget QLabel": "12 → 14"}``."""
    return {name: f"{before[name]} → {count}" for name, count in sorted(after.items()) if count > before[name]}
