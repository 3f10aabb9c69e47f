"""Identify screen: serial number, order, remarks, operator; and what is known of a part that was measured before."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QLineEdit, QWidget

from ui.controllers.operator import OperatorController
from ui.controllers.operator_nouns import Entered, counted_run, verdict_of
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.verdict_words import loud
from ui.pages.operator.big import BigButton, big_card, big_label
from ui.pages.operator.cards import when_words
from ui.pages.operator.reasons import ReasonChoice
from ui.widgets.basic import column, row

NAMES = {"serial": "Serial number", "order": "Order", "remarks": "Remarks", "operator": "Your name"}
LONGEST = 200
AGAIN = "Measured {when}: {verdict}. Measure it again as run {number}? All runs are kept; without a reason the first one counts."
AGAIN_COUNTED = "Measured {when}: {verdict}; an earlier run counts: {counted}. Measure it again as run {number}? All runs are kept."


class IdentifyScreen(QWidget):
    """Fields for what identifies the part."""

    backClicked = Signal()
    resultAsked = Signal(object)  # SeriesRun
    edited = Signal()

    def __init__(self, look: Look, controller: OperatorController) -> None:
        super().__init__()
        self._controller = controller
        self.fields = {name: QLineEdit() for name in NAMES}
        self._names = {name: QLabel() for name in NAMES}
        form = QGridLayout()
        form.setHorizontalSpacing(24)
        form.setVerticalSpacing(4)
        for place, (name, field) in enumerate(self.fields.items()):
            field.setMaxLength(LONGEST)
            field.setAccessibleName(translated(NAMES[name]))
            field.textChanged.connect(self._show)
            field.textEdited.connect(self.edited)
            field.returnPressed.connect(self._enter)
            form.addWidget(self._names[name], 3 * (place // 2), place % 2)
            form.addWidget(field, 3 * (place // 2) + 1, place % 2)
        form.setRowMinimumHeight(2, 8)
        self.before = big_label("", "strong", wrap=True)
        self.result = BigButton("Show the result", look, "inspection")
        self.reasons = ReasonChoice(look)
        known = row(self.before, self.result, spacing=16)
        known.setStretch(0, 1)
        self.known = big_card(known, self.reasons, margin=16, spacing=12)
        self.missing = big_label("", "error", wrap=True)
        self.back = BigButton("Back", look, "unfold")
        self.next = BigButton("Next", look, "", "primary")
        self.next.setMinimumWidth(240)
        self.missing.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        buttons = row(self.back, self.missing, self.next, spacing=16)
        buttons.setStretch(1, 1)
        layout = column(form, self.known, 0, buttons, spacing=16)
        layout.setContentsMargins(24, 24, 24, 16)
        self.setLayout(layout)
        self.back.pressedOnce.connect(self.backClicked)
        self.next.pressedOnce.connect(self._go)
        self.result.pressedOnce.connect(self._ask_result)
        self.reasons.changed.connect(self._show)
        controller.enteredChanged.connect(self._take)
        controller.stock.changed.connect(self._show)

    def showEvent(self, event: QShowEvent) -> None:
        """Offer the last values, but never the last serial number."""
        super().showEvent(event)
        self.reasons.clear()
        self._take()
        self.fields["serial"].setFocus()

    def value(self) -> Entered:
        """Return what was entered."""
        return Entered(**{name: field.text().strip() for name, field in self.fields.items()})

    def _take(self) -> None:
        entered = self._controller.entered
        for name, field in self.fields.items():
            field.setText(getattr(entered, name))
        self._show()

    def _missing(self) -> list[str]:
        facts, value = self._controller.facts, self.value()
        required = () if facts is None else facts.required
        return [name for name in required if not getattr(value, name)]

    def _show(self) -> None:
        facts = self._controller.facts
        if facts is None:
            return
        for name, words in NAMES.items():
            self._names[name].setText(tr("{field} *", field=words) if name in facts.required else translated(words))
        missing = self._missing()
        runs = self._controller.runs_of(self.value().serial)
        self.known.setVisible(bool(runs))
        if runs:
            last, counted = runs[-1], counted_run(runs)
            again = {
                "when": when_words(last.measured_at),
                "verdict": loud(verdict_of(last)),
                "number": len(runs) + 1,
                "counted": loud(verdict_of(counted)),
            }
            words = tr(AGAIN, **again) if counted is last else tr(AGAIN_COUNTED, **again)
            self.before.setText(translated(words))
        self.next.setText(tr("Measure again") if runs else tr("Next"))
        unreasoned = bool(runs) and not self.reasons.value()
        self.next.setEnabled(not missing and not unreasoned)
        self.missing.setText(
            tr("Fill in the fields marked *.") if missing else tr("State why this part is measured again.") if unreasoned else ""
        )

    def _enter(self) -> None:
        """Go to the next empty field that is required, else on."""
        missing = self._missing()
        if missing:
            self.fields[missing[0]].setFocus()
        elif self.next.isEnabled():
            self._go()

    def _go(self) -> None:
        self._controller.identify(self.value(), self.reasons.value() if self.known.isVisibleTo(self) else "")

    def _ask_result(self) -> None:
        runs = self._controller.runs_of(self.value().serial)
        if runs:
            self.resultAsked.emit(runs[-1])
