"""The journey in a real X window with the native VTK widget; a program of its own, for tests run without a screen."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from tests.ui.heartbeat import Heartbeat
from tests.ui.journey.test_journey import Journey, write_quarter_rig
from tests.ui.journey.user import User
from ui.app import build

SIZE = (1280, 720)
POLL_MS = 20
SOON_MS = 250  # after a page was opened


class Loop:
    """Waits with the event loop turning, as pytest-qt's qtbot does."""

    def wait(self, milliseconds: int) -> None:
        """Let the event loop turn for a time."""
        loop = QEventLoop()
        QTimer.singleShot(milliseconds, loop.quit)
        loop.exec()

    def waitUntil(self, until: Callable[[], bool], *, timeout: int) -> None:  # noqa: N802
        """Let the event loop turn until something is true. Raises TimeoutError."""
        end = time.monotonic() + timeout / 1000
        while not until():
            if time.monotonic() > end:
                raise TimeoutError
            self.wait(POLL_MS)


def keep(window: QWidget, file: Path, heart: Heartbeat) -> None:
    """Store what the screen shows of the window."""
    with heart.pause():
        assert QApplication.primaryScreen().grabWindow(window.winId()).save(str(file))


def main(folder: Path) -> None:
    """Go the whole way, and keep what the screen showed on the pages Clouds and Inspect."""
    application = QApplication([])
    built = build(application)
    built.window.resize(*SIZE)
    built.window.show()
    with Heartbeat() as heart:
        loop = Loop()
        user = User(loop, heart, "x-window")
        journey = Journey(built, user, write_quarter_rig(folder / "quarter.toml"))
        journey.begin()
        journey.connect()
        journey.calibrate()
        journey.plan()
        journey.scan()
        journey.results(folder)
        for name in ("clouds", "inspection"):
            built.window.show_page(name)
            user.wait(lambda: not built.controllers.drawing.queue.busy, 60.0, f"picture of {name}")
            stage = built.window.pages[name].view.stage
            user.wait(lambda stage=stage: stage is not None and stage.is_resting and stage.scene.is_complete, 60.0, f"points of {name}")
            keep(built.window, folder / f"{name}.png", heart)
        for name in ("clouds", "inspection"):  # the pages share one window of VTK, which must not show the former page's picture
            built.window.show_page(name)
            loop.wait(SOON_MS)
            keep(built.window, folder / f"{name}_soon.png", heart)
        kinds = {type(widget).__name__ for widget in built.window.findChildren(QWidget)}
        print(f"platform {application.platformName()}, native {'NativeView' in kinds}", flush=True)  # noqa: T201
    print(heart.report(5), file=sys.stderr)  # noqa: T201
    assert built.window.close()
    assert built.controllers.end(60_000)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
