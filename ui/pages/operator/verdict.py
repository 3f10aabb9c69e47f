"""Verdict screen: sign and word over the whole width, the worst dimensions, the part, and what comes next."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QWidget

from measureapp.data.verdicts import part_verdict
from ui.controllers.controllers import Controllers
from ui.look.icons import IconSet
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.verdict_words import loud, summary_words
from ui.pages.operator.big import BigButton, big_card, big_label, short_label
from ui.pages.operator.part_view import PartView
from ui.pages.operator.style import letters_on
from ui.pages.operator.worst import drawn, part_composer, seen_from, shown_dimensions, words_of
from ui.session import Session
from ui.widgets.basic import ElidedLabel, clear, column, row

SIGN_PX, WORD_PX = 96, 96
SIDE_WIDTH, PREFIX_WIDTH = 600, 160  # the latter of what stands before the name of a report
NEXT = {  # what an operator can do about a verdict
    "fail": "Put the part aside. If it was dirty or clamped wrongly, mend that and press Repeat.",
    "not proven": "Too close to a limit to decide. Clean the part and press Repeat, or put it aside and call the engineer.",
    "not measured": "Not everything could be measured. Clean the part, see that it lies right, and press Repeat.",
}
UNDECIDED = "The program has no tolerances, so nothing was decided. Call the engineer."
DRIFTED = "A camera has moved since the calibration: the values may be wrong. Call the engineer."


class VerdictBand(QFrame):
    """The verdict in its colour, with sign and word; never by colour alone."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.verdict = "not measured"
        self._icons = IconSet(lambda verdict: QColor(letters_on(verdict)))
        self.sign, self.word = QLabel(), QLabel()
        self.part, self.summary = ElidedLabel("", elide=Qt.TextElideMode.ElideMiddle), QLabel()
        self.summary.setTextFormat(Qt.TextFormat.PlainText)
        self.summary.setWordWrap(True)
        for label in (self.part, self.summary):
            label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        layout = row(self.sign, self.word, column(0, self.part, self.summary, 0, spacing=4), spacing=32)
        layout.setContentsMargins(40, 8, 24, 8)
        layout.setStretch(2, 1)
        self.setLayout(layout)
        self.setFixedHeight(SIGN_PX + 32)

    def show_verdict(self, verdict: str, part: str, summary: str) -> None:
        """Show a verdict, of which part, and the numbers of dimensions."""
        self.verdict = verdict
        letters, colour = letters_on(verdict), self._look.theme.verdict(verdict).name()
        self.setStyleSheet(
            f"VerdictBand {{ background: {colour}; border: none; }}"
            f"VerdictBand QLabel {{ color: {letters}; font-size: 24px; font-weight: 600; background: transparent; }}"
        )
        self.word.setStyleSheet(f"color: {letters}; font-size: {WORD_PX}px; font-weight: 800;")
        self.sign.setPixmap(self._icons.icon(verdict, verdict).pixmap(QSize(SIGN_PX, SIGN_PX)))
        self.word.setText(loud(verdict))
        self.part.set_words(part)
        self.summary.setText(translated(summary))
        self.setAccessibleName(f"{loud(verdict)}. {part}. {summary}")


class WorstCard(QFrame):
    """One dimension: sign, name, value, limit."""

    def __init__(self, look: Look, name: str, value: str, limit: str, verdict: str) -> None:
        super().__init__()
        self.setObjectName("operator-card")
        sign = QLabel()
        sign.setPixmap(look.icon(verdict, "verdict_" + verdict.replace(" ", "_")).pixmap(QSize(40, 40)))
        self.name = short_label(name, "heading")
        top = row(sign, self.name, 0, big_label(value, "value"))
        below = big_label(tr("{verdict}: {limit}", verdict=loud(verdict), limit=limit), "body", wrap=True)
        layout = column(top, below, spacing=0)
        layout.setContentsMargins(16, 6, 16, 8)
        self.setLayout(layout)


class VerdictScreen(QWidget):
    """What came out, and what to do now."""

    nextClicked = Signal()
    repeatClicked = Signal()
    detailsClicked = Signal()
    reportClicked = Signal()
    callClicked = Signal()

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__()
        self._look, self._session, self._operator = look, session, controllers.operator
        self.band = VerdictBand(look)
        self.view = PartView(look, session, controllers.drawing)
        self._cards = column(spacing=8)
        self.filed = big_label("", "soft", wrap=True)
        self.problem = big_label("", "error", wrap=True)
        self.advice = big_label("", "strong", wrap=True)
        side = QWidget()
        side.setFixedWidth(SIDE_WIDTH)
        layout = column(self._cards, 0, self.problem, self.filed, spacing=8)
        side.setLayout(layout)
        middle = row(side, big_card(self.view, margin=2), spacing=16)
        middle.setContentsMargins(24, 0, 24, 0)
        middle.setStretch(1, 1)
        whole = column(self.band, middle, row(24, self.advice, 24), self._buttons(look), spacing=12)
        whole.setStretch(1, 1)
        self.setLayout(whole)
        self._operator.run.began.connect(self.view.clear)
        self._operator.run.filedChanged.connect(self._show_filed)
        self._operator.stock.changed.connect(self._show_filed)
        look.changed.connect(self._show)

    def _buttons(self, look: Look) -> QWidget:
        self.next = BigButton("Next part", look, "run", "primary")
        self.next.setMinimumWidth(280)
        self.again = BigButton("Repeat", look, "again")
        self.details = BigButton("Details", look, "inspection")
        self.report = BigButton("Report", look, "report")
        self.call = BigButton("Call the engineer", look, "person")
        for button, signal in (
            (self.next, self.nextClicked),
            (self.again, self.repeatClicked),
            (self.details, self.detailsClicked),
            (self.report, self.reportClicked),
            (self.call, self.callClicked),
        ):
            button.pressedOnce.connect(signal)
        bar = QWidget()
        layout = row(self.call, 0, self.report, self.details, self.again, self.next, spacing=16)
        layout.setContentsMargins(24, 0, 24, 12)
        bar.setLayout(layout)
        return bar

    def showEvent(self, event: QShowEvent) -> None:
        """Show the newest result."""
        super().showEvent(event)
        self._show()
        self.next.setFocus()

    def _show(self) -> None:
        measurement = self._session.measurement
        if not self.isVisible() or measurement is None:
            return
        inspection = measurement.inspection
        dimensions = () if inspection is None else inspection.dimensions
        verdict = part_verdict(one.verdict for one in dimensions)
        facts, entered = self._operator.facts, self._operator.entered
        part = " · ".join(filter(None, ("" if facts is None else facts.name, entered.serial, entered.order)))
        self.band.show_verdict(str(verdict), part, summary_words([str(one.verdict) for one in dimensions]))
        clear(self._cards)
        for dimension in shown_dimensions(dimensions):
            words = words_of(dimension)
            self._cards.addWidget(WorstCard(self._look, words.name, words.value, words.limit, words.verdict))
        drift = measurement.validity.drift
        self._drifted = drift is not None and drift.status == "drifted"
        undecided = all(one.verdict == "no tolerance" for one in dimensions) and bool(dimensions)
        self.advice.setText(translated(UNDECIDED if undecided else NEXT.get(str(verdict), "")))
        self.advice.setVisible(bool(self.advice.text()) and not self._drifted)  # a camera that has moved is told as a problem
        self.view.compose(part_composer(measurement, self._look.theme.shade))
        if inspection is not None:
            self.view.mark(*drawn(inspection, self._look.theme))
            direction = seen_from(inspection)
            if direction is not None:
                self.view.look_from(direction)
        self._show_filed()

    def _show_filed(self) -> None:
        if not self.isVisible():
            return
        filed = self._operator.filed
        problems = [DRIFTED] if self._drifted else []
        problems += [filed.problem] if filed is not None and filed.problem else []
        self.problem.setText(translated("\n".join(problems)))
        self.problem.setVisible(bool(problems))
        words = "The result is being filed…"
        if filed is not None:
            name = "" if filed.report is None else filed.report.name
            shown = self.filed.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, SIDE_WIDTH - PREFIX_WIDTH)
            words = tr("Report filed: {name}", name=shown) if name else ""
            self.filed.setToolTip(name)
            if filed.run is not None and not self._operator.counts():
                words += "\nThe first run of this part counts."
        self.filed.setText(translated(words))
        self.filed.setVisible(bool(words))
