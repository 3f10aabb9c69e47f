"""The workspace of operator mode: bar, screens, messages, strip."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QKeySequence, QShortcut, QShowEvent
from PySide6.QtWidgets import QFrame, QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.operator_nouns import verdict_of
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.verdict_words import loud
from ui.pages.operator.bar import CallBar, OperatorBar
from ui.pages.operator.big import big_label
from ui.pages.operator.cards import when_words
from ui.pages.operator.details import DetailsScreen, ReportScreen, dimensions_of
from ui.pages.operator.home import HomeScreen
from ui.pages.operator.identify import IdentifyScreen
from ui.pages.operator.keyboard import KeyboardCaller, TouchKeyboard
from ui.pages.operator.load import LoadScreen
from ui.pages.operator.pin import PinScreen
from ui.pages.operator.repeat import RepeatScreen
from ui.pages.operator.run import RunScreen
from ui.pages.operator.scanner import Scanner
from ui.pages.operator.strip import ShiftStrip
from ui.pages.operator.style import operator_sheet
from ui.pages.operator.verdict import VerdictScreen
from ui.session import Session
from ui.widgets.basic import column, row

if TYPE_CHECKING:
    from measureapp.data.series import SeriesRun

CLOCK_MS = 60_000
RUNNING = "A measurement is running. Stop it before you close the window."


class OperatorWorkspace(QWidget):
    """Everything that an operator sees."""

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__()
        self.setObjectName("operator")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._look, self._session, self._controllers = look, session, controllers
        operator = controllers.operator
        self.bar, self.call, self.strip = OperatorBar(look, session), CallBar(look), ShiftStrip(look)
        self.words, self._words = self._message()
        self.home, self.identify = HomeScreen(look, operator), IdentifyScreen(look, operator)
        self.load, self.run = LoadScreen(look, operator), RunScreen(look, session, controllers)
        self.verdict, self.repeat = VerdictScreen(look, session, controllers), RepeatScreen(look)
        self.details, self.report = DetailsScreen(look), ReportScreen(look, session, controllers)
        self.pin = PinScreen(look, controllers.roles)
        self._of_step = {
            "home": self.home,
            "identify": self.identify,
            "load": self.load,
            "run": self.run,
            "verdict": self.verdict,
        }
        self.screens = QStackedWidget()
        for screen in (*self._of_step.values(), self.repeat, self.details, self.report, self.pin):
            self.screens.addWidget(screen)
        self.keyboard = TouchKeyboard(look)
        whole = column(self.bar, self.call, self.words, self.screens, self.keyboard, self.strip, spacing=0)
        whole.setStretch(3, 1)
        self.setLayout(whole)
        self.keys = KeyboardCaller(self, self.keyboard)
        self.scanner = Scanner(self._wants_codes, self)
        self._sheet_of = ""
        self._clock = QTimer(self)
        self._clock.setInterval(CLOCK_MS)
        self._clock.timeout.connect(self._show_shift)
        self._connect()

    def _message(self) -> tuple[QFrame, QWidget]:
        words = big_label("", "strong", wrap=True)
        frame = QFrame()
        frame.setObjectName("operator-words")
        layout = row(words)
        layout.setContentsMargins(16, 12, 16, 12)
        frame.setLayout(layout)
        outer = QFrame()
        around = column(frame)
        around.setContentsMargins(24, 16, 24, 0)
        outer.setLayout(around)
        outer.hide()
        self._frame = frame
        return outer, words

    def _connect(self) -> None:
        operator, roles = self._controllers.operator, self._controllers.roles
        operator.stepChanged.connect(self._show_step)
        operator.said.connect(self.say)
        operator.stock.changed.connect(self._show_shift)
        self.home.chosen.connect(operator.choose)
        self.identify.backClicked.connect(operator.go_back)
        self.identify.edited.connect(lambda: self.say(""))
        self.identify.resultAsked.connect(self._show_run)
        self.load.backClicked.connect(operator.go_back)
        self.load.startClicked.connect(operator.start)
        for screen in (self.load, self.run, self.verdict):
            screen.callClicked.connect(self._call)
        self.verdict.nextClicked.connect(operator.next_part)
        self.verdict.repeatClicked.connect(lambda: self._show(self.repeat))
        self.verdict.detailsClicked.connect(self._show_details)
        self.verdict.reportClicked.connect(lambda: self._show(self.report))
        self.repeat.repeatClicked.connect(operator.repeat)
        for reading in (self.repeat, self.details, self.report, self.pin):
            reading.backClicked.connect(self._return)
        self.bar.homeClicked.connect(operator.go_home)
        self.bar.engineerClicked.connect(roles.ask_engineer)
        roles.pinAsked.connect(lambda: self._show(self.pin))
        self.scanner.scanned.connect(operator.scan_code)
        self.strip.keyboardClicked.connect(self.keys.toggle)
        self._look.changed.connect(self._restyle)
        context = Qt.ShortcutContext.WidgetWithChildrenShortcut
        QShortcut(QKeySequence(Qt.Key.Key_Escape), self, self._escape, context=context)

    def showEvent(self, event: QShowEvent) -> None:
        """Style the workspace when it is first shown, and read what may have changed."""
        super().showEvent(event)
        self._restyle()
        self._clock.start()
        handle = self.window().windowHandle()
        if handle is not None:
            self.scanner.watch(handle)
        operator = self._controllers.operator
        self._show_step(operator.step)
        operator.stock.reload()

    def close_views(self) -> None:
        """Release the graphics memory."""
        self._clock.stop()
        self.run.view.close_view()
        self.verdict.view.close_view()

    def say(self, words: str, level: str = "info") -> None:
        """Show a sentence below the bar; an empty one hides it."""
        self._words.setText(translated(words))  # type: ignore[attr-defined]
        self._frame.setProperty("level", level)
        self._words.setProperty("op", "error" if level == "error" else "strong")
        for widget in (self._frame, self._words):
            widget.style().polish(widget)
        self.words.setVisible(bool(words))

    def ask(self, _title: str) -> None:
        """Say that the window is not closed while a measurement runs."""
        self.say(RUNNING, "error")

    def _restyle(self) -> None:
        if self.isVisible() and self._sheet_of != self._look.theme.shade:
            self._sheet_of = self._look.theme.shade
            self.setStyleSheet(operator_sheet(self._look.theme))

    def _show(self, screen: QWidget) -> None:
        self.screens.setCurrentWidget(screen)

    def _show_step(self, step: str) -> None:
        facts = self._controllers.operator.facts
        self.bar.show_step(self._controllers.operator.step, "" if facts is None else facts.name)
        self._show(self._of_step[step])

    def _return(self) -> None:
        self._show_step(self._controllers.operator.step)

    def _wants_codes(self) -> bool:
        return self.isVisible() and self.screens.currentWidget() in (self.home, self.identify, self.load)

    def _escape(self) -> None:
        """Esc stops what moves; else it leaves what is only read."""
        if self._controllers.operator.step == "run" and self._session.run.state != "idle":
            self._controllers.operator.run.stop()
        elif self.screens.currentWidget() in (self.repeat, self.details, self.report, self.pin):
            self._return()

    def _call(self) -> None:
        operator = self._controllers.operator
        facts, fault = operator.facts, operator.fault
        about = [] if facts is None else [" ".join((facts.name, operator.entered.serial)).strip() + "."]
        match operator.step:
            case "run":
                about += [self._session.run.cause if fault is None else fault.cause]
            case "load":
                about += operator.why_not()
            case "verdict":
                about += [tr("The verdict is {verdict}.", verdict=loud(self.verdict.band.verdict))]
        self.call.call(" ".join(about))

    def _show_details(self) -> None:
        inspection, entered = self._session.inspection, self._controllers.operator.entered
        facts = self._controllers.operator.facts
        title = " · ".join(filter(None, ("" if facts is None else facts.name, entered.serial)))
        self.details.show_dimensions(title, () if inspection is None else inspection.dimensions)
        self._show(self.details)

    def _show_run(self, run: SeriesRun) -> None:
        """Show the dimensions of an earlier run."""
        words = {"serial": run.identification.serial_number, "when": when_words(run.measured_at), "verdict": loud(verdict_of(run))}
        self.details.show_dimensions(tr("{serial}, measured {when}: {verdict}", **words), dimensions_of(run))
        self._show(self.details)

    def _show_shift(self) -> None:
        shelf = self._controllers.operator.shelf
        if shelf is not None:
            since = shelf.settings.shift_start(datetime.now().astimezone())
            self.strip.show_shift(self._controllers.operator.stock.shift(), since)
