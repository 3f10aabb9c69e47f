"""Strip at the bottom: parts since the start of the shift, and the last verdicts."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel

from ui.controllers.operator_nouns import ShiftCount
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import percent
from ui.pages.operator.big import BigButton, big_label
from ui.widgets.basic import clear, row

DOT_PX, COUNT_PX = 20, 24
HEIGHT = 56


class ShiftStrip(QFrame):
    """Numbers of the shift, each verdict by sign, colour and name; and a button for keys on the screen."""

    keyboardClicked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("operator-strip")
        self.setFixedHeight(HEIGHT)
        self._look = look
        self._shown: tuple[ShiftCount, datetime] | None = None
        self.since = big_label("", "soft")
        self.counts = {name: big_label("", "count") for name in ("pass", "fail", "not proven")}
        self.yields = big_label("", "soft")
        self._signs = {name: QLabel() for name in self.counts}
        self._last, self._dots = big_label("Last", "soft"), row(spacing=4)
        counts = [widget for name, shown in self.counts.items() for widget in (self._signs[name], shown)]
        keyboard = self.keyboard = BigButton("Keyboard", look, "keyboard", "quiet")
        keyboard.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the field that is typed into keeps it
        keyboard.clicked.connect(self.keyboardClicked)
        layout = row(self.since, 16, *counts, 16, self.yields, 0, self._last, self._dots, 16, keyboard, spacing=8)
        layout.setContentsMargins(24, 0, 24, 0)
        self.setLayout(layout)
        look.changed.connect(self._redraw)

    def show_shift(self, count: ShiftCount, since: datetime) -> None:
        """Show the numbers of a shift that began at ``since``."""
        if self._shown == (count, since):
            return  # asked every minute: signs that are made anew would flicker
        self._shown = count, since
        self.since.setText(tr("Since {since:%H:%M}: {count}", since=since, count=_parts(count.parts)))
        numbers = {"pass": count.passed, "fail": count.failed, "not proven": count.open}
        names = {"pass": "{n} pass", "fail": "{n} fail", "not proven": "{n} not proven"}
        for name, shown in self.counts.items():
            shown.setText(tr(names[name], n=numbers[name]))
        self.yields.setText(
            ""
            if count.first_pass_yield is None
            else tr("First-pass yield {first_pass_yield}", first_pass_yield=percent(count.first_pass_yield, 0))
        )
        self.setAccessibleName(", ".join([self.since.text(), *(shown.text() for shown in self.counts.values()), self.yields.text()]))
        self._redraw()

    def _redraw(self) -> None:
        for name, sign in self._signs.items():
            sign.setPixmap(self._look.icon(name, "verdict_" + name.replace(" ", "_")).pixmap(QSize(COUNT_PX, COUNT_PX)))
        clear(self._dots)
        last = () if self._shown is None else self._shown[0].last
        self._last.setVisible(bool(last))
        for verdict in last:
            dot = QLabel()
            dot.setPixmap(self._look.icon(verdict, "verdict_" + verdict.replace(" ", "_")).pixmap(QSize(DOT_PX, DOT_PX)))
            dot.setAccessibleName(translated(verdict))
            self._dots.addWidget(dot)


def _parts(count: int) -> str:
    """Return the number of parts in a text of its own: other languages count parts with another word than they name one."""
    return tr("{count} part" if count == 1 else "{count} parts", count=count)
