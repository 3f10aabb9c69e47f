"""Guidance while collecting: what is still missing, in words and as gauges, and the present verdict."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import card, clear, column, label, row
from ui.widgets.gauges import Gauges, Level

WIDTH = 296
MOST_WORDS, MOST_GAUGES = 5, 7
LOW, MOST_IN_LOW = 620, 4  # px of the panel: the words have more room than the gauges in a small window


class GuidancePanel(QWidget):
    """Shows what to record next."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.setFixedWidth(WIDTH)
        self.heading = label("What is still missing", "heading")
        self._words = column(spacing=8)
        words = QWidget()
        words.setObjectName("clear")
        words.setLayout(self._words)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(words)
        scroll.viewport().setAutoFillBackground(False)
        self.gauges, self.rest = Gauges(look), label("", "small")
        self.so_far, self.working = label("", "strong", wrap=True), label("", "small", wrap=True)
        self.verdict = card(label("With these views", "caption"), self.so_far, self.working, margin=12, spacing=4)
        whole = card(self.heading, scroll, self.gauges, self.rest, margin=16, spacing=8)
        whole.layout().setStretch(1, 1)
        layout = column(whole, self.verdict, spacing=8)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.lines: tuple[str, ...] = ()
        look.changed.connect(self._redraw)

    def show_guidance(self, lines: Sequence[str], levels: Sequence[Level]) -> None:
        """Show what is missing; without lines nothing is."""
        same, self.lines = tuple(lines) == self.lines and self._words.count() > 0, tuple(lines)
        self.heading.setText(tr("What is still missing") if self.lines else tr("Nothing is missing"))
        most = MOST_IN_LOW if lines and self.height() < LOW else MOST_GAUGES
        shown = sorted(levels, key=lambda level: level.enough)[:most]
        self.gauges.show_levels([level for level in levels if level in shown])
        rest = len(levels) - len(shown)
        enough = all(level.enough for level in levels if level not in shown)
        self.rest.setText("" if not rest else tr("{rest} more have enough", rest=rest) if enough else tr("and {value} more", value=rest))
        self.rest.setVisible(bool(self.rest.text()))
        if not same:
            self._redraw()

    def show_verdict(self, words: str, working: str) -> None:
        """Show the verdict on the views collected so far, and why there is none."""
        self.so_far.setText(translated(words))
        self.working.setText(translated(working))
        self.so_far.setVisible(bool(words))
        self.working.setVisible(bool(working))
        self.verdict.setVisible(bool(words or working))

    def _redraw(self) -> None:
        clear(self._words)
        if not self.lines:
            self._words.addLayout(self._line("pass", "verdict_pass", "There are enough views. More of them improve the result slightly."))
        for text in self.lines[:MOST_WORDS]:
            self._words.addLayout(self._line("info", "accent", text))
        if len(self.lines) > MOST_WORDS:
            self._words.addWidget(label(tr("and {value} more", value=len(self.lines) - MOST_WORDS), "small"))
        self._words.addStretch(1)

    def _line(self, sign: str, colour: str, text: str) -> QHBoxLayout:
        picture = QLabel()
        picture.setPixmap(self._look.icon(sign, colour).pixmap(18, 18))
        picture.setAlignment(Qt.AlignmentFlag.AlignTop)
        made = row(picture, label(text, "body", wrap=True), spacing=8)
        made.setStretch(1, 1)
        return made
