"""The window stands before anything heavy is imported."""

from __future__ import annotations

import gc
import json
import logging
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from PySide6.QtWidgets import QWidget

from measureapp.errors import MeasureError
from measureapp.progress import NoProgress
from ui.app import keep_log
from ui.controllers import startup
from ui.shell.next_frame import NextFrame
from ui.workers.job import LOG, unexpected

ROOT = Path(__file__).resolve().parents[2]
HEAVY = ("vtk", "vtkmodules", "pyvista", "pyqtgraph", "open3d", "numba", "cv2", "scipy", "trimesh", "pydantic")
START = f"""
import json, linecache, sys, time
begin = time.perf_counter()
import ui
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from ui.app import build
application = QApplication([])
built = build(application)
built.window.show()
def idle():
    loaded = [name for name in {HEAVY!r} if name in sys.modules]
    print(json.dumps({{"seconds": time.perf_counter() - begin, "heavy": loaded, "sources": len(linecache.cache)}}))
    built.window.close()
    application.quit()
QTimer.singleShot(0, idle)
application.exec()
"""


def test_the_window_is_shown_before_any_heavy_library_is_imported(tmp_path):
    environment = {**os.environ, "HOME": str(tmp_path)}
    done = subprocess.run([sys.executable, "-c", START], cwd=ROOT, env=environment, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout.splitlines()[-1])
    assert told["heavy"] == []
    assert told["sources"] < 20  # else Qt for Python has read the source of every module
    assert told["seconds"] < 20.0  # on an idle machine about one second; the figure itself is in the README


def test_errors_of_the_program_are_written_to_the_log_that_the_message_names(tmp_path):
    path = tmp_path / "MeasureApp" / LOG
    root = logging.getLogger()
    before = list(root.handlers)
    keep_log(path)
    try:
        logging.getLogger("a room of the window").error("uncaught", exc_info=ValueError("seven"))
        assert "ValueError: seven" in path.read_text(encoding="utf-8")
        assert LOG in unexpected(ValueError("seven"), "It").hint
    finally:
        for handler in [one for one in root.handlers if one not in before]:
            root.removeHandler(handler)
            handler.close()


def test_open3d_is_imported_without_its_viewers_by_the_one_way_of_the_program(monkeypatch):
    called = []
    monkeypatch.setattr(startup, "open3d", lambda: called.append("open3d"))
    monkeypatch.setattr(startup, "WARM_UP", ("json", startup.OPEN3D))
    monkeypatch.setattr(startup.importlib, "import_module", called.append)
    startup.import_all(NoProgress())
    assert called == ["json", "open3d"]
    monkeypatch.setattr(startup, "WARM_UP", ("a_package_that_nobody_has",))
    with pytest.raises(MeasureError, match="a_package_that_nobody_has is missing"):
        startup.import_all(NoProgress())


def test_what_is_imported_meanwhile_is_never_searched_for_garbage():
    usual, frozen = gc.get_threshold(), gc.get_freeze_count()
    kept = []
    with startup.made_to_last():
        assert gc.get_threshold()[2] > 1000 * usual[2]
        kept.extend([one] for one in range(1000))
    assert gc.get_threshold() == usual
    assert gc.get_freeze_count() >= frozen + len(kept)


@pytest.mark.parametrize("can_be_read", [True, False])
def test_the_3_d_view_is_loaded_after_the_window_has_displayed_the_rig(can_be_read, application, window, qtbot, monkeypatch):
    def refuse(_job):
        raise MeasureError("The rig is damaged.", "Choose another one.")

    happened = []
    monkeypatch.setattr(startup, "load_graphics", lambda _job: happened.append("graphics") or "")
    monkeypatch.setattr(startup, "import_all", lambda _progress: None)
    monkeypatch.setattr(startup, "load_kernels", lambda _progress: None)
    if not can_be_read:
        monkeypatch.setattr(startup, "load_rig", refuse)
    window.show()
    qtbot.waitExposed(window)
    monkeypatch.setattr(window.header, "paintEvent", lambda _event: happened.append("picture"))
    controllers = application.controllers
    controllers.startup.rigLoaded.connect(lambda: happened.append("rig"))
    controllers.startup.begin()
    qtbot.waitUntil(lambda: "graphics" in happened and not controllers.preparing.queue.busy, timeout=10_000)
    after = happened[happened.index("rig") :]
    assert "picture" in after[: after.index("graphics")]


def test_a_window_that_is_not_shown_is_not_waited_for(qtbot):
    hidden = QWidget()
    qtbot.addWidget(hidden)
    frame = NextFrame(hidden)
    with qtbot.waitSignal(frame.drawn, timeout=1000):
        frame.wait()


def test_kernels_are_loaded_once_the_window_has_made_its_pages(application, window, qtbot, monkeypatch):
    made = []
    monkeypatch.setattr(startup, "load_graphics", lambda _job: "")
    monkeypatch.setattr(startup, "import_all", lambda _progress: None)
    monkeypatch.setattr("measureapp.pipeline.compile_apart.compile_apart", lambda _job: made.append(len(window.pages.made)))
    monkeypatch.setattr("measureapp.pipeline.warm_up.warm_up", lambda _progress: None)
    application.controllers.startup.begin()
    qtbot.waitUntil(lambda: made != [], timeout=20_000)
    assert made == [len(window.pages)]
    qtbot.waitUntil(lambda: not application.controllers.preparing.queue.busy, timeout=10_000)


def test_nothing_waits_behind_the_preparation_which_takes_minutes_at_the_first_start(application, window, qtbot, monkeypatch):
    began, done, reached = threading.Event(), threading.Event(), []

    def take_minutes(_progress):
        began.set()
        done.wait(60.0)

    monkeypatch.setattr(startup, "load_graphics", lambda _job: "")
    monkeypatch.setattr(startup, "import_all", lambda _progress: None)
    monkeypatch.setattr(startup, "load_kernels", take_minutes)
    controllers = application.controllers
    controllers.startup.begin()
    qtbot.waitUntil(began.is_set, timeout=20_000)
    controllers.background.run("Comparing with the nominal", lambda _job: "compared", reached.append, quiet=True)
    qtbot.waitUntil(lambda: reached == ["compared"], timeout=10_000)
    assert controllers.preparing.queue.busy
    qtbot.waitUntil(lambda: len(window.pages.made) == len(window.pages), timeout=20_000)  # in idle moments, once all packages are there
    done.set()
    qtbot.waitUntil(lambda: not controllers.preparing.queue.busy, timeout=10_000)
