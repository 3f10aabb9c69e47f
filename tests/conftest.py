"""Guards around every test: no screen is touched, nothing of the user is changed, nothing is left running or pressed."""

from __future__ import annotations

import gc
import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

# Before anything imports Qt: with a display in sight, VTK's X window ends the process under Qt's offscreen platform.
os.environ["QT_QPA_PLATFORM"] = "offscreen"
for name in ("DISPLAY", "WAYLAND_DISPLAY"):
    os.environ.pop(name, None)
# Before anything imports NumPy: threads that wait for each other over small matrices cost several times what these take.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import pytest  # noqa: E402

from measureapp.arrays import BAND_THREADS  # noqa: E402

pytest_plugins = ["room_times", "demo_first"]
GRACE_S = 2.0
LIBRARY_THREADS = ("pytest_timeout", "execnet", "tqdm", "IPythonHistory")  # kept by libraries, ended by them
NEW_MODULES = 100  # imported since, for which it pays to exclude what they hold from collection
_frozen_with = {"modules": 0}
LIBRARY_WIDGETS = ("QTipLabel",)  # the one tool tip Qt keeps


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[object]:
    """Collect no garbage while all test files are imported, which takes a quarter of that time and finds none."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()


def pytest_collection_finish() -> None:
    """Keep collections of garbage from looking through all test files and what they imported, 3 % of the time."""
    _freeze_modules()


@pytest.fixture(scope="session", autouse=True)
def _user_settings_untouched(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    home: Path = tmp_path_factory.mktemp("user")
    with pytest.MonkeyPatch.context() as patch:
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"):
            patch.setenv(name, str(home / name.lower()))
        yield


@pytest.fixture(scope="session")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The one demo of the whole suite, a `demo_fixture.Demo`; it runs when the first test of any process asks for it."""
    from demo_fixture import shared_demo
    from made_once import run_folder

    with shared_demo(run_folder(tmp_path_factory) / "demo", os.environ.get("PYTEST_XDIST_WORKER", "only")) as finished:
        yield finished


@pytest.fixture(autouse=True)
def _no_thread_is_left() -> Iterator[None]:
    before = set(threading.enumerate())
    yield
    left = _settled(lambda: [thread for thread in threading.enumerate() if thread not in before and _is_ours(thread)])
    if left:
        pytest.fail(f"The test left threads running: {', '.join(thread.name for thread in left)}", pytrace=False)


@pytest.fixture(autouse=True)
def _no_key_is_left_pressed(request: pytest.FixtureRequest) -> Iterator[None]:
    """Qt takes the modifiers of the last simulated click or key for pressed until the next one: a table then selects otherwise."""
    yield
    if "qapp" in request.fixturenames:
        from PySide6.QtCore import Qt
        from PySide6.QtTest import QTest
        from PySide6.QtWidgets import QApplication, QWidget

        if QApplication.keyboardModifiers() != Qt.KeyboardModifier.NoModifier:
            QTest.keyRelease(QWidget(), Qt.Key.Key_Shift)


@pytest.fixture(autouse=True)
def _no_window_thread_or_timer_of_qt_is_left(request: pytest.FixtureRequest) -> Iterator[None]:
    uses_qt = "qapp" in request.fixturenames
    windows_before = {id(window) for window in _windows()}
    running_before = {id(item) for item in _running()} if uses_qt else set()
    yield
    windows = _settled(lambda: [window for window in _windows() if id(window) not in windows_before])
    running = _settled(lambda: [item for item in _running() if id(item) not in running_before]) if uses_qt else []
    if windows or running:
        names = ", ".join(f"{type(item).__name__} {item.objectName()}".strip() for item in (*windows, *running))
        pytest.fail(f"The test left Qt objects alive: {names}", pytrace=False)


def _is_ours(thread: threading.Thread) -> bool:
    foreign = isinstance(thread, threading._DummyThread)  # a thread of Qt or C++ that once ran Python
    return thread.is_alive() and not foreign and not thread.name.startswith((*LIBRARY_THREADS, BAND_THREADS))


def _settled(leftovers: Callable[[], list[Any]]) -> list[Any]:
    """Return what is still there after a moment; what only waits for its deletion is deleted."""
    if not leftovers():
        return []
    gc.collect()
    end = time.monotonic() + GRACE_S
    while leftovers() and time.monotonic() < end:
        _deliver_deletions()
        time.sleep(0.01)
    left = leftovers()
    if not left:
        _freeze_modules()
    return left


def _freeze_modules() -> None:
    """Keep later collections from looking again and again through what imported modules hold, which takes half a second."""
    if len(sys.modules) >= _frozen_with["modules"] + NEW_MODULES:
        _frozen_with["modules"] = len(sys.modules)
        gc.collect()
        gc.freeze()


def _windows() -> list[Any]:
    """Return Qt's windows, where Qt is in use at all."""
    widgets = sys.modules.get("PySide6.QtWidgets")
    if widgets is None or widgets.QApplication.instance() is None:
        return []
    top = widgets.QApplication.topLevelWidgets()
    return [widget for widget in top if widget.parentWidget() is None and widget.metaObject().className() not in LIBRARY_WIDGETS]


def _running() -> list[Any]:
    """Return Qt's threads and timers that run."""
    core = sys.modules.get("PySide6.QtCore")
    if core is None:
        return []
    from shiboken6 import getAllValidWrappers

    # Of Qt's objects alone: to look through the whole heap takes a hundred times as long. By their types, of which there are
    # few: to ask each of the 14,000 objects of a window what it is an instance of takes twenty times as long.
    kinds = core.QThread, core.QTimer
    wrappers = getAllValidWrappers()
    sought = {kind for kind in set(map(type, wrappers)) if issubclass(kind, kinds)}
    found = [item for item in wrappers if type(item) in sought]
    main_thread = core.QCoreApplication.instance().thread() if core.QCoreApplication.instance() else None
    return [item for item in found if item is not main_thread and (item.isRunning() if isinstance(item, core.QThread) else item.isActive())]


def _deliver_deletions() -> None:
    core = sys.modules.get("PySide6.QtCore")
    if core is not None and core.QCoreApplication.instance() is not None:
        core.QCoreApplication.processEvents()
        core.QCoreApplication.sendPostedEvents(None, core.QEvent.Type.DeferredDelete.value)
