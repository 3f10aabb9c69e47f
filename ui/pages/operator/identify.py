"""Identify screen: serial number, order, remarks, operator; and what is known of a part that was measured before."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFormLayout, QLabel, QLineEdit, QWidget

from ui.controllers.operator import OperatorController
from ui.controllers.operator_nouns import Entered, counted_run, verdict_of
from ui.look.look import Look
from ui.pages.operator.big import BigButton, big_card, big_label
from ui.pages.operator.cards import when_words
from ui.pages.operator.reasons import ReasonChoice
from ui.widgets.basic import column, row

NAMES = {"serial": "Serial number", "order": "Order", "remarks": "Remarks", "operator": "Your name"}
LONGEST = 200


class IdentifyScreen(QWidget):
    """Fields for what identifies the part."""

    backClicked = Signal()
    resultAsked = Signal(object)  # SeriesRun

    def __init__(self, look: Look, controller: OperatorController) -> None:
        super().__init__()
        self._controller = controller
        self.fields = {name: QLineEdit() for name in NAMES}
        self._names = {name: QLabel() for name in NAMES}
        form = QFormLayout()
        form.setHorizontalSpacing(24)
        form.setVerticalSpacing(12)
        for name, field in self.fields.items():
            field.setMaxLength(LONGEST)
            field.setAccessibleName(NAMES[name])
            field.textChanged.connect(self._show)
            field.returnPressed.connect(self._enter)
            form.addRow(self._names[name], field)
        self.before = big_label("", "strong", wrap=True)
        self.result = BigButton("Show the result", look, "inspection")
        self.reasons = ReasonChoice(look)
        self.known = big_card(self.before, self.reasons, row(self.result, 0))
        self.missing = big_label("", "error", wrap=True)
        self.back = BigButton("Back", look, "unfold")
        self.next = BigButton("Next", look, "", "primary")
        self.next.setMinimumWidth(240)
        self.title = big_label("", "title")
        layout = column(self.title, form, self.known, 0, row(self.back, 0, self.missing, self.next, spacing=16), spacing=16)
        layout.setContentsMargins(24, 24, 24, 16)
        self.setLayout(layout)
        self.back.pressedOnce.connect(self.backClicked)
        self.next.pressedOnce.connect(self._go)
        self.result.pressedOnce.connect(self._ask_result)
        self.reasons.changed.connect(self._show)
        controller.enteredChanged.connect(self._take)
        controller.shelfChanged.connect(self._show)

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
        self.title.setText(facts.name)
        for name, words in NAMES.items():
            self._names[name].setText(f"{words} *" if name in facts.required else words)
        missing = self._missing()
        runs = self._controller.runs_of(self.value().serial)
        self.known.setVisible(bool(runs))
        if runs:
            last, counted = runs[-1], counted_run(runs)
            again = {"when": when_words(last.measured_at), "verdict": verdict_of(last).upper(), "number": len(runs) + 1}
            words = "Measured {when}: {verdict}. Measure it again as run {number}? All runs are kept.".format(**again)
            if counted is not last:
                words += " The first run counts: {verdict}.".format(verdict=verdict_of(counted).upper())
            self.before.setText(words)
        self.next.setText("Measure again" if runs else "Next")
        unreasoned = bool(runs) and not self.reasons.value()
        self.next.setEnabled(not missing and not unreasoned)
        self.missing.setText(
            "Fill in the fields marked *." if missing else "State why this part is measured again." if unreasoned else ""
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
