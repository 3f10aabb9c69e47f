"""Run screen: one bar, the step in words, the growing cloud, Pause and Stop; after a fault what is kept and what to press."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QProgressBar, QScrollArea, QScroller, QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.operator_nouns import Fault
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import duration, rough_duration, sentence_case, with_hint
from ui.pages.layers import PlacedClouds, placements_of, view_layer
from ui.pages.operator.big import BigButton, HoldButton, big_card, big_label
from ui.pages.operator.part_view import PartView
from ui.pages.operator.time_left import SteadyTime
from ui.pages.viewport_page import Picture
from ui.session import Session
from ui.widgets.basic import column, row, scrolled
from ui.workers.job import Job

TICK_MS = 500
SIDE_WIDTH, FAULT_WIDTH = 400, 640
STEPS = {  # status of the present viewpoint
    "moving": "The rig moves",
    "settling": "The rig settles",
    "capturing": "Images are taken",
    "checking": "The images are checked",
    "storing": "The images are stored",
}
NO_CLOUD = "The measured points appear here when the first viewpoint is computed."
CALIBRATED_FIRST = "The rig is calibrated first"
NOT_EMERGENCY = "Stop is not an emergency stop."
CALL = "Call the engineer"
RESUME = "Resume: hold for 1 s"
KEPT = "{stored} of {planned} viewpoints are stored and kept."
NOTHING_KEPT = "No viewpoint was stored yet."
PRESS = "If the part has not been moved, hold Resume: the measurement goes on with {following}. If it has been moved, start again."
LOST = "The folder of this part is gone, with all that was stored in it."
PRESS_LOST = "When it is back, hold Resume. Otherwise start again."
FOR_ENGINEER = "For the engineer: {remedy}"
PRESS_PROCESS = "All viewpoints are stored. Hold Resume to compute the result, or start again."


class RunScreen(QWidget):
    """Progress of the measurement, or the fault that ended it."""

    callClicked = Signal()

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__()
        self._look, self._session, self._controllers = look, session, controllers
        self._time, self._share, self._note = SteadyTime(), 0.0, ""
        self._placed = PlacedClouds()
        self.view = PartView(look, session, controllers.drawing, nothing=NO_CLOUD)
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(tr("Progress of the measurement"))
        self.words, self.time = big_label("", "title", wrap=True), big_label("", "strong", wrap=True)
        self._panels = QStackedWidget()
        self._panels.addWidget(self._running(look))
        self._panels.addWidget(self._stopped(look))
        self._panels.setFixedWidth(SIDE_WIDTH)
        middle = row(big_card(self.view, margin=2), self._panels, spacing=16)
        middle.setStretch(0, 1)
        layout = column(self.words, self.bar, self.time, middle, spacing=12)
        layout.setContentsMargins(24, 24, 24, 16)
        layout.setStretch(3, 1)
        self.setLayout(layout)
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self._show_progress)
        self._connect()

    def _running(self, look: Look) -> QWidget:
        self.pause, self.go_on = BigButton("Pause", look, "pause"), BigButton("Go on", look, "run", "primary")
        self.stop = BigButton("Stop", look, "stop", "stop")
        self.help = BigButton(CALL, look, "person")
        self.paused = big_label("", "strong", wrap=True)
        panel = QWidget()
        layout = column(
            _readable(self.paused),
            self.pause,
            row(self.help, self.go_on, spacing=12),
            8,
            self.stop,
            big_label(NOT_EMERGENCY, "soft", wrap=True),
            spacing=16,
        )
        layout.setStretch(0, 1)
        panel.setLayout(layout)
        return panel

    def _stopped(self, look: Look) -> QWidget:
        self.cause, self.remedy = big_label("", "error", wrap=True), big_label("", "soft", wrap=True)
        self.kept, self.press = big_label("", "strong", wrap=True), big_label("", "body", wrap=True)
        self.resume = HoldButton(RESUME, look, "run")
        self.again, self.call = BigButton("Start again", look, "again"), BigButton(CALL, look, "person")
        self.home = BigButton("Part programs", look, "home")
        panel = QWidget()
        words = _readable(self.cause, self.kept, self.press, self.remedy)
        layout = column(words, self.resume, row(self.again, self.home, spacing=12), self.call, spacing=12)
        layout.setStretch(0, 1)
        panel.setLayout(layout)
        return panel

    def _connect(self) -> None:
        operator, session = self._controllers.operator, self._session
        self.pause.pressedOnce.connect(operator.run.pause)
        self.go_on.pressedOnce.connect(operator.run.go_on)
        self.stop.pressedOnce.connect(operator.run.stop)
        self.resume.held.connect(operator.run.resume)
        self.again.pressedOnce.connect(operator.start)
        self.home.pressedOnce.connect(operator.go_home)
        for call in (self.help, self.call):
            call.pressedOnce.connect(self.callClicked)
        operator.run.faultChanged.connect(self._show_state)
        operator.stepChanged.connect(self._begin)
        self._controllers.jobs.progressed.connect(self._take_progress)
        session.runChanged.connect(self._show_state)
        session.viewpointsChanged.connect(self._show_progress)
        session.cloudsChanged.connect(self._compose)

    def showEvent(self, event: QShowEvent) -> None:
        """Count the time while the screen is shown."""
        super().showEvent(event)
        self._timer.start()
        self._show_state()
        self._compose()

    def hideEvent(self, event: QHideEvent) -> None:
        """Count no longer."""
        super().hideEvent(event)
        self._timer.stop()

    def _begin(self, step: str) -> None:
        if step != "run":
            return
        operator = self._controllers.operator
        facts, shelf = operator.facts, operator.shelf
        usual = None if facts is None or shelf is None else shelf.settings.usual_seconds(facts.name)
        self._time, self._share, self._note = SteadyTime(usual), 0.0, ""
        self.resume.restore()
        self._show_state()

    def _take_progress(self, share: float, note: str) -> None:
        self._share, self._note = max(self._share, share), note
        self._show_progress()

    def _show_state(self) -> None:
        fault, run = self._controllers.operator.fault, self._session.run
        self._panels.setCurrentIndex(0 if fault is None else 1)
        for shown in (self.bar, self.time):
            shown.setVisible(fault is None)
        paused = run.state == "paused"
        self._panels.setFixedWidth(FAULT_WIDTH if paused or fault is not None else SIDE_WIDTH)
        self.help.setVisible(paused)
        self.pause.setVisible(not paused)
        self.go_on.setVisible(paused)
        self.paused.setText(with_hint(run.cause, run.remedy) if paused else "")
        if fault is not None:
            self._show_fault(fault)
        self._show_progress()

    def _show_fault(self, fault: Fault) -> None:
        self.cause.setText(translated(fault.cause))
        self.remedy.setText(tr(FOR_ENGINEER, remedy=translated(fault.remedy)))
        self.remedy.setVisible(bool(fault.remedy))
        kept, press = _kept_words(fault)
        self.kept.setText(kept)
        self.press.setText(press)
        self.resume.setVisible(bool(self.press.text()))  # images of a calibration are kept, too, before any viewpoint is stored
        self.resume.restore()

    def _show_buttons(self) -> None:
        """Offer what can be done now: a pause only while images are taken."""
        stopping = self._controllers.operator.run.is_stopping
        self.pause.setEnabled(self._session.run.state == "running" and self._controllers.scanning.is_taking and not stopping)
        self.stop.setEnabled(not stopping)

    def _show_progress(self) -> None:
        if not self.isVisible():
            return
        self._show_buttons()
        fault = self._controllers.operator.fault
        elapsed = self._controllers.operator.run.elapsed_s
        if fault is not None:
            self.words.setText(tr("The measurement has ended early"))
            self.time.setText("")
            return
        self.words.setText(translated(self._state_words()))
        self.bar.setValue(round(1000 * self._share))
        left = self._time.left(self._share, elapsed)
        words = {"elapsed": duration(elapsed), "left": "" if left is None else rough_duration(left)}
        self.time.setText(tr("{elapsed}, about {left} left", **words) if left is not None else tr("{elapsed} so far", **words))

    def _state_words(self) -> str:
        if self._controllers.operator.run.is_stopping:
            return "Stopping…"  # at once, although an image may still be on its way
        return {"paused": "Paused", "pausing": "Pausing…"}.get(self._session.run.state) or self._step_words()

    def _step_words(self) -> str:
        points = list(self._session.viewpoints.values())
        present = next((place for place, point in enumerate(points) if point.status in STEPS), None)
        if present is None and self._controllers.operator.run.calibrates and self._session.calibration is None:
            return CALIBRATED_FIRST
        if present is None:
            return sentence_case(self._note.partition(": ")[0]) or "The measurement is being prepared"
        words = {"step": STEPS[points[present].status], "number": present + 1, "all": len(points)}
        return tr("{step}: viewpoint {number} of {all}", **words)

    def _compose(self) -> None:
        if not self.isVisible():
            return
        views, theme, placed = self._session.views, self._look.theme, self._placed
        placements = placements_of(self._session.stitched)

        def compose(job: Job) -> Picture:
            layers = []
            for index, view in enumerate(views):
                job.check()
                layers.append(view_layer(theme, placed.get(view, placements.get(view.viewpoint_id), fine=True), index, "grey", None))
            return Picture(tuple(layers))

        self.view.compose(compose if views else None)


def _kept_words(fault: Fault) -> tuple[str, str]:
    """Return what is kept after a fault, and what to press."""
    if fault.is_lost:
        return translated(LOST), translated(PRESS_LOST)
    kept = tr(KEPT, stored=fault.stored, planned=fault.planned) if fault.stored else translated(NOTHING_KEPT)
    if fault.following:
        return kept, tr(PRESS, following=fault.following)
    return kept, translated(PRESS_PROCESS) if fault.stored else ""


def _readable(*words: QWidget) -> QScrollArea:
    """Return words that scroll where they are too many, such as those about a rig of which no device answers: buttons keep their room."""
    content = QWidget()
    content.setObjectName("clear")
    content.setLayout(column(*words, 0, spacing=12))
    area = scrolled(content)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    QScroller.grabGesture(area.viewport(), QScroller.ScrollerGestureType.TouchGesture)
    return area
