"""Construction and start of the application."""

from __future__ import annotations

import logging
import os
import sys
from contextlib import suppress
from dataclasses import dataclass
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import NoReturn

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from measureapp.errors import MeasureError
from ui.controllers.controllers import Controllers
from ui.look.language.language import Language
from ui.look.look import Look
from ui.look.paths import demo_folder
from ui.look.theme import Shade, preferred_shade
from ui.main_window import MainWindow
from ui.session import Session
from ui.settings.settings import Settings, settings_file
from ui.workers.job import LOG, unexpected

_log = logging.getLogger(__name__)
LOG_BYTES = 1_000_000
SWITCH_S = 0.001  # the window draws in many short calls, each of which waits as long for the interpreter while a job computes
LAST_WAIT_MS = 60_000  # for threads still running after the window is closed: compiling the largest kernel takes half a minute


@dataclass(frozen=True)
class Application:
    """The singletons of the application."""

    settings: Settings
    look: Look
    language: Language
    session: Session
    controllers: Controllers
    window: MainWindow


def build(application: QApplication) -> Application:
    """Build session, controllers and window."""
    sys.setswitchinterval(SWITCH_S)
    settings = Settings(settings_file())
    look = Look(_shade(application, settings))
    look.apply_theme()
    language = Language(look)
    language.choose(settings.text("language"))
    session = Session(settings)
    controllers = Controllers(session)
    language.changed.connect(look.changed)  # what is painted is drawn anew
    window = MainWindow(look, session, controllers, settings)
    settings.changed.connect(lambda name: look.set_shade(_shade(application, settings)) if name == "theme" else None)
    settings.changed.connect(lambda name: language.choose(settings.text("language")) if name == "language" else None)
    session.appearanceChanged.connect(lambda: settings.set_text("role", session.role))
    return Application(settings, look, language, session, controllers, window)


def _shade(application: QApplication, settings: Settings) -> Shade:
    """Return the theme that the user has chosen, or that of the desktop."""
    chosen = settings.text("theme")
    return "dark" if chosen == "dark" else "light" if chosen == "light" else preferred_shade(application)


def run(project: Path | None = None, demo: bool = False) -> int:
    """Show the window and return the exit code; with ``demo`` the demo project is open.

    Raises
    ------
    MeasureError
        There is no display.
    """
    application = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(application, QApplication)
    application.setApplicationName("MeasureApp")
    application.setApplicationDisplayName("MeasureApp")
    built = build(application)
    keep_log(Path.home() / "MeasureApp" / LOG)
    sys.excepthook = Reporter(built.session)
    built.window.show()
    QTimer.singleShot(0, built.controllers.startup.begin)
    built.controllers.roles.begin(in_operator_mode=built.settings.text("role") == "operator")
    if project is not None:
        built.controllers.project.open(project)
    elif demo:
        open_demo(built)
    if project is None:
        built.window.tour.offer()
    code = application.exec()
    if not built.controllers.end(LAST_WAIT_MS):
        _leave(code)
    return code


def _leave(code: int) -> NoReturn:
    """Exit the process while a thread is still running; destroying the thread would abort the process instead."""
    logging.shutdown()
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    os._exit(code)


def keep_log(path: Path) -> None:
    """Log tracebacks to a file of limited size and to the terminal; if the file cannot be written, to the terminal only."""
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        handler = RotatingFileHandler(path, maxBytes=LOG_BYTES, backupCount=1, encoding="utf-8")
        handler.setLevel(logging.ERROR)
        handler.setFormatter(logging.Formatter("%(asctime)s %(name)s: %(message)s"))
        logging.getLogger().addHandler(handler)
        logging.getLogger().addHandler(logging.StreamHandler())


def open_demo(built: Application) -> None:
    """Open the existing demo project, or prepare a new one without starting it."""
    settings = built.controllers.demo.settings
    folder = demo_folder(settings)
    if (folder / "project.json").exists():
        built.controllers.project.open(folder)
    else:
        built.session.open_project(folder.name, settings.part, folder)


class Reporter:
    """Exception hook: reports uncaught errors in the window; the traceback goes to the log."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def __call__(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        """Report one error."""
        if issubclass(kind, KeyboardInterrupt):
            QApplication.quit()
            return
        reported = error if isinstance(error, MeasureError) else unexpected(error, "The last action")
        if reported is not error:
            _log.error("uncaught", exc_info=(kind, error, trace))
        self._session.tell(reported.message, reported.hint, "error")
