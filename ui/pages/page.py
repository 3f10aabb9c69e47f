"""Base of all pages: title, status line, actions and body."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from PySide6.QtCore import QObject, Qt, QTimer, Signal, SignalInstance, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.project import OPENING, OPENING_SAMPLE
from ui.look.look import Look
from ui.session import Session
from ui.widgets.basic import Button, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Properties

IDLE_MS, APART_MS = 300, 20  # until a page out of sight follows, and between two of its steps
SAMPLE = "gypsum"  # project offered where there is nothing to show
NOTHING_SELECTED = Properties("Properties", note="Select something to see its properties.")


class Page(QWidget):
    """A page; it shows its empty state until it has content."""

    name: ClassVar[str] = ""
    word: ClassVar[str] = ""
    wants_room: ClassVar[bool] = False  # in a small window the properties are folded
    shows_results: ClassVar[bool] = False  # of a measurement: without one the sample project is offered
    propertiesChanged = Signal(object)
    propertiesAsked = Signal()  # requests that a folded panel is opened

    def __init__(self, look: Look, session: Session, controllers: Controllers, empty: EmptyState) -> None:
        super().__init__()
        self.setObjectName("page")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.look, self.session, self.controllers, self.empty = look, session, controllers, empty
        self.properties = NOTHING_SELECTED
        self._owed: dict[Callable[[], object], None] = {}  # what was not shown while the page was out of sight, in order
        self._idle = QTimer(self)
        self._idle.setSingleShot(True)
        self._idle.timeout.connect(self._pay_one)
        self.title, self.state = label(self.word, "title"), label("", "soft", wrap=True)
        self.action_row = row(spacing=8)
        self.body = QWidget()
        self._stack = QStackedWidget()
        self._stack.addWidget(empty)
        self._stack.addWidget(self.body)
        names = column(self.title, self.state, spacing=0)
        top = row(names, 16, self.action_row, spacing=0)
        top.setStretch(0, 1)
        layout = column(top, self._stack, spacing=16)
        layout.setContentsMargins(24, 16, 24, 16)
        layout.setStretch(1, 1)
        self.setLayout(layout)
        empty.triggered.connect(controllers.demo.run)
        if self.shows_results:
            self.sample = Button("Open a sample", look, "open", "normal", "A part that was measured on the virtual rig")
            self.sample.clicked.connect(lambda: controllers.project.open_sample(SAMPLE))
            empty.add_quiet(self.sample)

    @property
    def is_empty(self) -> bool:
        """Whether the page has nothing to show."""
        return self._stack.currentWidget() is self.empty

    def show_filled(self, filled: bool) -> None:
        """Show the body, or the empty state; properties never outlive what they describe."""
        if not filled and self.properties is not NOTHING_SELECTED:
            self.show_properties(NOTHING_SELECTED)
        self._stack.setCurrentWidget(self.body if filled else self.empty)
        for place in range(self.action_row.count()):
            item = self.action_row.itemAt(place)
            widget = item.widget() if item is not None else None
            if widget is not None:
                widget.setVisible(filled)

    def follow(self, signal: SignalInstance, *shows: Callable[[], object]) -> None:
        """Call ``shows`` first and whenever ``signal`` is emitted: at once in sight, else once when the page comes into sight or nothing is running.

        To show at every event of a job what nobody sees would hold up the window. Results of a closed project are let go at once.
        """
        for show in shows:
            signal.connect(Following(self, show).take)
            self._owed[show] = None
        self._idle.start(IDLE_MS)

    def owe(self, show: Callable[[], object]) -> None:
        """Call ``show`` now, or later."""
        if self.isVisible() or (self.shows_results and self.session.is_letting_go):
            self._owed.pop(show, None)
            show()
        else:
            self._owed[show] = None
            self._idle.start(IDLE_MS)

    @Slot()
    def _pay_one(self) -> None:
        """Show one thing that was missed, so that there is little left to do when the page is opened; the end of a job starts this again."""
        if self._owed and not self.session.busy_with:
            show = next(iter(self._owed))
            del self._owed[show]
            show()
            self._idle.start(APART_MS)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what changed while the page was out of sight."""
        super().showEvent(event)
        owed, self._owed = self._owed, {}
        for show in owed:
            show()

    def say_running(self, heading: str, text: str) -> None:
        """Say on the empty page what the running job brings; one that reads a project calibrates, plans and measures nothing."""
        if self.session.busy_with in (OPENING, OPENING_SAMPLE):
            heading, text = "Opening the project…", "What it holds appears here."
        self.empty.say(heading, text, offer=False)

    def show_properties(self, properties: Properties) -> None:
        """Show these properties in the panel on the right."""
        self.properties = properties
        self.propertiesChanged.emit(properties)

    def act(self) -> None:
        """Perform the action of the properties."""

    def decide(self) -> None:
        """Perform the second action of the properties."""

    def close_page(self) -> None:
        """Release resources that must not outlive the window."""


class Following(QObject):
    """Tells a page that there is something to show; it goes with the page."""

    def __init__(self, page: Page, show: Callable[[], object]) -> None:
        super().__init__(page)
        self._page, self._show = page, show

    @Slot()
    def take(self) -> None:
        """Show it, now or later."""
        self._page.owe(self._show)
