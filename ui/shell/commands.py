"""The commands of the window, as entries of the list of actions."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Protocol

from ui.actions.actions import Action, Actions
from ui.controllers.controllers import Controllers
from ui.controllers.documents import FORMATS
from ui.look.language.words import tr
from ui.messages import CANCEL
from ui.pages.page import Page
from ui.pages.pages import Pages
from ui.pages.report import ReportPage
from ui.session import Session
from ui.shell.page_keys import page_keys
from ui.shell.project_menu import SAMPLES, ProjectMenu
from ui.shell.tour import Tour
from ui.widgets.properties_panel import PropertiesPanel


class Begins(Protocol):
    """A dialog."""

    def begin(self) -> None:
        """Show it in its present state."""


class CommandedWindow(Protocol):
    """What the commands need of the main window."""

    session: Session
    controllers: Controllers
    pages: Pages
    project_menu: ProjectMenu
    properties: PropertiesPanel
    messages: Begins
    settings_dialog: Begins
    shortcuts: Begins
    tour: Tour
    palette_: Begins

    @property
    def page(self) -> Page:
        """The workspace shown."""

    def show_page(self, name: str) -> None:
        """Show one workspace."""

    def show_help(self) -> None:
        """Show the help of the page."""

    def change_theme(self) -> None:
        """Change between light and dark."""

    def save_log(self) -> None:
        """Save what support needs."""

    def close(self) -> bool:
        """End the program."""


def register_commands(actions: Actions, window: CommandedWindow) -> None:
    """Register everything that the window itself can do."""
    session = window.session
    _register_project(actions, window)
    actions.register(
        Action(
            CANCEL,
            "Cancel the running job",
            window.controllers.jobs.cancel,
            "stop abort",
            why_not=lambda: "" if session.busy_with else NO_JOB,
        ),
        Action(
            "rig.stop",
            "Stop all axes, lamps and cameras",
            window.controllers.rig.stop,
            "halt emergency",
            shortcut="Esc",
            bound=False,
            for_operator=True,
        ),
        Action("messages", "Messages", window.show_messages, "warnings errors log", shortcut="Ctrl+M"),
        Action("log", "Save log for support…", window.save_log, "support zip versions"),
        Action("settings", "Settings…", window.show_settings, "language theme preferences options", shortcut="Ctrl+,"),
        Action("theme", "Change between light and dark", window.change_theme, "theme night dark light colours appearance"),
        Action("properties", "Show or hide the properties", window.properties.toggle, "panel side", shortcut="Ctrl+P"),
        Action("help", "Help for this page", window.show_help, "manual documentation", shortcut="F1"),
        Action("tour", "Take the tour", window.tour.begin, "first start introduction guide learn", why_not=_no_job(session)),
        Action("keys", "Shortcuts", window.show_shortcuts, "keyboard keys list", shortcut="?"),
        Action("palette", "Commands…", window.show_commands, "search find palette", shortcut="Ctrl+K"),
        Action("exit", "Exit", window.close, "quit end", shortcut="Ctrl+Q", for_operator=True),
    )
    for place, (name, word) in enumerate(window.pages.words.items()):
        actions.register(_page_action(window, name, word, place))
    actions.register(
        Action("demo", "Run the demo", window.controllers.demo.run, "virtual rig sample example", "rig", why_not=_no_job(session))
    )
    actions.register(*page_keys(window), *_exports(window))
    for name, words in SAMPLES.items():
        actions.register(
            Action(
                f"sample.{name}",
                tr("Open a sample: {words}", words=words),
                partial(window.controllers.project.open_sample, name),
                "example project learn",
                why_not=_no_job(session),
            )
        )


NO_JOB = "No job is running."
PAGE_KEYWORDS = {
    "rig": "page devices drivers connect camera robot projector",
    "calibration": "page board lens hand-eye axis guide uncertainty",
    "plan": "page viewpoints coverage path collision delete",
    "scan": "page measure start run capture exposure",
    "clouds": "page views points stitch register mesh holes filter",
    "inspection": "page dimension tolerance feature datum alignment deviation colour scale section delete nominal program",
    "report": "page pdf export document print series repeats header template",
}
EXPORT_KEYWORDS = "export save file report document excel"


def _no_job(session: Session) -> Callable[[], str]:
    def reason() -> str:
        return tr("{busy_with} is still running.", busy_with=session.busy_with) if session.busy_with else ""

    return reason


def _open_project(session: Session) -> Callable[[], str]:
    busy = _no_job(session)

    def reason() -> str:
        return "No project is open." if session.folder is None else busy()

    return reason


def _register_project(actions: Actions, window: CommandedWindow) -> None:
    session, menu = window.session, window.project_menu
    busy, project = _no_job(session), _open_project(session)
    actions.register(
        Action("project.new", "New project…", menu.new, "create make folder", shortcut="Ctrl+N", why_not=busy, icon="add"),
        Action("project.start", "New project from a template…", menu.start, "part program mpart", why_not=busy),
        Action("project.open", "Open project…", menu.open, "folder load", shortcut="Ctrl+O", why_not=busy, icon="open"),
        Action("project.copy", "Save a copy as…", menu.copy, "save as duplicate", shortcut="Ctrl+Shift+S", why_not=project),
        Action("project.template", "Save as a template…", menu.save_template, "mpart new", why_not=project),
        Action("project.close", "Close project", menu.close, "end", shortcut="Ctrl+W", why_not=project),
        Action("project.compute", "Recompute from the stored images", window.controllers.project.process, "process again", why_not=project),
        Action(
            "file.inspect",
            "Inspect a cloud or mesh…",
            menu.inspect_files,
            "ply stl file compare",
            shortcut="Ctrl+I",
            why_not=busy,
            icon="file",
        ),
    )


def _page_action(window: CommandedWindow, name: str, word: str, place: int) -> Action:
    def reason() -> str:
        return "" if window.session.role == "engineer" else "This page belongs to the engineer's role."

    return Action(
        f"page.{name}",
        tr("Go to {word}", word=word),
        lambda: window.show_page(name),
        PAGE_KEYWORDS[name],
        shortcut=tr("Ctrl+{value}", value=place + 1),
        why_not=reason,
        bound=False,
    )


def _exports(window: CommandedWindow) -> tuple[Action, ...]:
    """Return the documents that the Report page exports, which are wanted on every page."""

    def export(kind: str) -> None:
        page = window.pages["report"]
        assert isinstance(page, ReportPage)
        page.export(kind)

    def reason(kind: str) -> str:
        if window.session.measurement is None:
            return "No part has been measured."
        if busy := _no_job(window.session)():
            return busy
        return "" if window.controllers.documents.can_export(kind) else "The measurement has nothing of this kind."

    return tuple(
        Action(f"report.{kind}", f"{words}…", partial(export, kind), EXPORT_KEYWORDS, "report", why_not=partial(reason, kind))
        for kind, (words, *_) in FORMATS.items()
    )
