"""Last step: the verdict in millimetres, every value with its standard deviation, and the changes."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QLabel, QScrollArea, QWidget

from ui.controllers.result import Result, ValueRow
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import NOTHING, keep_units, quantity
from ui.widgets.basic import Button, card, clear, column, label, row
from ui.widgets.data_table import Cell, DataTable, number
from ui.widgets.segments import Segments

HEADERS = ["Value", "Estimate", "Std. dev.", "True value", "Error", "Change"]  # six columns in the smallest window
TRUE, ERROR, CHANGE = 3, 4, 5
FAR = 3.0  # standard deviations
TRUTH_NOTE = "True values are known because the rig is simulated. The measurement never reads them."
CHECK_TIP = "Stop this check; the result does not change and can be accepted now"
SIDE, MARGIN, SCROLL_BAR = 312, 20, 14


class ResultPage(QWidget):
    """Shows one `Result`."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.verdict_sign, self.verdict = QLabel(), label("", "heading", wrap=True)
        self.verdict_sign.setFixedSize(QSize(40, 40))
        line = row(self.verdict_sign, self.verdict, spacing=12)
        line.setStretch(1, 1)
        self.groups = Segments({"": "All"})
        self._group_place = row(self.groups, 0)
        self.table = DataTable(look, HEADERS, numeric=range(1, 6), stretch=0)
        self.truth_note = label(TRUTH_NOTE, "small", wrap=True)
        self._facts = column(spacing=8)
        self.comparison = label("", "body", wrap=True)
        facts = card(label("How it was determined", "heading"), self._facts, margin=16)
        self.held_back, self.stop_check = label("", "body", wrap=True), Button("Stop", look, "cancel", "quiet", CHECK_TIP)
        self._held_back = card(label("Cross-validation", "heading"), self.held_back, row(self.stop_check, 0), margin=16)
        self._compared = card(label("Previous calibration", "heading"), self.comparison, margin=16)
        cards = QWidget()
        cards.setObjectName("clear")
        cards.setLayout(column(facts, self._held_back, self._compared, 0, self.truth_note, spacing=12))
        cards.setFixedWidth(SIDE)
        side = QScrollArea()
        side.setWidgetResizable(True)
        side.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        side.setFixedWidth(SIDE + SCROLL_BAR)
        side.setWidget(cards)
        side.viewport().setAutoFillBackground(False)
        left = column(self._group_place, self.table, spacing=8)
        left.setStretch(1, 1)
        middle = row(left, side, spacing=16)
        middle.setStretch(0, 1)
        whole = column(card(line, margin=12), middle, spacing=12)
        whole.setStretch(1, 1)
        self._whole, self.none = QWidget(), label("", "soft")
        self._whole.setLayout(whole)
        self.none.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setLayout(column(self.none, self._whole))
        self.show_none("")
        self._result: Result | None = None
        look.changed.connect(self._follow_look)

    def show_none(self, words: str) -> None:
        """Show the reason why there is no result."""
        self._result = None
        self.none.setText(translated(words))
        self.none.show()
        self._whole.hide()

    def show_result(self, result: Result) -> None:
        """Show a result, its first group of values first."""
        self._result = result
        self.none.hide()
        self._whole.show()
        self.verdict.setText(keep_units(result.verdict))
        self._show_sign()
        names = list(dict.fromkeys(one.estimate.group for one in result.rows))
        clear(self._group_place)
        self.groups = Segments({name: name for name in names})
        self.groups.valueChanged.connect(self._show_rows)
        self.groups.setVisible(len(names) > 1)
        self._group_place.addWidget(self.groups)
        self._group_place.addStretch(1)
        self.truth_note.setVisible(result.has_truth)
        self.table.setColumnHidden(TRUE, not result.has_truth)
        self.table.setColumnHidden(ERROR, not result.has_truth)
        self.table.setColumnHidden(CHANGE, not result.has_previous)
        self._show_facts(result)
        self.show_checked(result)
        self.comparison.setText(keep_units(result.comparison))
        self._compared.setVisible(bool(result.comparison))
        self._show_rows()

    def _show_facts(self, result: Result) -> None:
        clear(self._facts)
        for name, value in result.facts:
            self._facts.addLayout(row(label(name, "soft"), 0, label(value, "body")))
        for words in result.reasons:
            self._facts.addWidget(_paragraph(words))
        for view, reason in result.rejected:
            self._facts.addWidget(_paragraph(tr("View {view} rejected: {reason}", view=view, reason=reason)))

    def show_checking(self, share: float) -> None:
        """Show how far the check with views held back is."""
        self.held_back.setText(tr("Each view is predicted by a calibration without it: {quantity}", quantity=quantity(100 * share, "%", 0)))
        self._held_back.show()
        self.stop_check.show()

    def show_checked(self, result: Result | None) -> None:
        """Show the result of the check; nothing where it was stopped."""
        self.stop_check.hide()
        self._held_back.setVisible(result is not None and bool(result.held_back))
        if result is not None and result.held_back:
            self._result = result
            self.verdict.setText(keep_units(result.verdict))
            self._show_sign()
            self.held_back.setText(keep_units(result.held_back))

    def _show_rows(self) -> None:
        if self._result is not None:
            group = self.groups.value()
            self.table.set_rows([_cells(one) for one in self._result.rows if one.estimate.group == group])

    def _follow_look(self) -> None:
        """Follow a change of theme or language; paragraphs have the height of their words."""
        self._show_sign()
        if self._result is not None:
            self._show_facts(self._result)

    def _show_sign(self) -> None:
        if self._result is not None:
            sign = self._result.sign
            self.verdict_sign.setPixmap(self._look.icon(sign, "verdict_" + sign.replace(" ", "_")).pixmap(QSize(36, 36)))
            self.verdict_sign.setAlignment(Qt.AlignmentFlag.AlignCenter)


def _paragraph(words: str) -> QLabel:
    """A small text with its full height, which a layout does not ask a wrapped label for."""
    made = label(keep_units(words), "small", wrap=True)
    made.ensurePolished()
    made.setMinimumHeight(made.heightForWidth(SIDE - 2 * MARGIN))
    return made


def _cells(row_: ValueRow) -> list[Cell]:
    """One row; an error beyond three standard deviations is marked."""
    one, digits = row_.estimate, row_.digits
    error = None if row_.true is None else one.value - row_.true
    change = None if row_.previous is None else one.value - row_.previous
    far = error is not None and one.sigma > 0 and abs(error) > FAR * one.sigma
    tip = "" if error is None or not one.sigma else tr("{value:.1f} standard deviations", value=abs(error) / one.sigma)
    return [
        Cell(one.label, bold=True),
        number(quantity(one.value, one.unit, digits)),
        number(NOTHING if not one.sigma else f"± {quantity(one.sigma, one.unit, digits + 1)}"),
        number(quantity(row_.true, one.unit, digits)),
        Cell(quantity(error, one.unit, digits + 1, signed=True), "number", "not proven" if far else "", tip=tip),
        number(quantity(change, one.unit, digits + 1, signed=True)),
    ]
