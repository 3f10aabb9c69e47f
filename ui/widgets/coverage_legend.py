"""Legend of what is predicted to be measured, below the picture."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QFrame, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import clear, column, label, row
from ui.widgets.not_measured import SWATCH, HatchedSwatch

IN_A_LINE = 2  # swatches, so that the smallest window has room for them
Swatch = tuple[tuple[int, int, int] | None, str]  # a colour, None: hatched; and what it means


class CoverageLegend(QWidget):
    """A sentence and colour samples with texts; hidden while there is nothing to say."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.words, self._lines = label("", "strong", wrap=True), column(spacing=4)
        self.setLayout(column(self.words, self._lines, spacing=4, margin=4))
        look.changed.connect(self.update)
        self.hide()

    def show_swatches(self, swatches: Sequence[Swatch], words: str) -> None:
        """Show colours with their meaning after a sentence."""
        clear(self._lines)
        self.words.setText(translated(words))
        self.words.setVisible(bool(words))
        for first in range(0, len(swatches), IN_A_LINE):
            line = row(spacing=8)
            for colour, meaning in swatches[first : first + IN_A_LINE]:
                line.addWidget(HatchedSwatch() if colour is None else _plain(colour))
                line.addWidget(label(meaning, "small"))
                line.addSpacing(4)
            line.addStretch(1)
            self._lines.addLayout(line)
        self.setVisible(bool(words or swatches))


def _plain(colour: tuple[int, int, int]) -> QFrame:
    sample = QFrame()
    sample.setFixedSize(*SWATCH)
    sample.setStyleSheet(f"background: rgb({colour[0]}, {colour[1]}, {colour[2]}); border: none; border-radius: 3px;")
    return sample
