"""Banner with the verdict on the whole part."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QLabel

from measureapp.data.verdicts import part_verdict
from ui.look.look import Look
from ui.look.verdict_words import summary_words
from ui.widgets.basic import column, label, row

SIGN_PX = 48


def verdict_on(verdicts: Sequence[str]) -> str | None:
    """Combine verdicts on dimensions: the most severe decides; None without any.

    >>> verdict_on(["pass", "not measured", "pass"]), verdict_on(["pass", "fail", "not proven"])
    ('not measured', 'fail')
    """
    return str(part_verdict(verdicts)) if verdicts else None


class VerdictBanner(QFrame):
    """Shows the verdict by icon, word and colour, with the number of dimensions that do not pass."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("card")
        self._look, self._verdict = look, None
        self._sign, self.word, self.words = QLabel(), label("", "title"), label("", "soft", wrap=True)
        layout = row(self._sign, column(self.word, self.words, spacing=0), spacing=16)
        layout.setContentsMargins(16, 16, 16, 16)
        layout.setStretch(1, 1)
        layout.setAlignment(self._sign, Qt.AlignmentFlag.AlignVCenter)
        self.setLayout(layout)
        look.changed.connect(self._redraw)

    def show_verdicts(self, verdicts: Sequence[str]) -> None:
        """Show the combined verdict."""
        self._verdict = verdict_on(verdicts)
        self.word.setText((self._verdict or "").upper())
        self.words.setText(summary_words(verdicts))
        self.setAccessibleName(f"{self.word.text()}. {self.words.text()}")
        self._redraw()

    def _redraw(self) -> None:
        if self._verdict is not None:
            colour = "verdict_" + self._verdict.replace(" ", "_")
            self._sign.setPixmap(self._look.icon(self._verdict, colour).pixmap(QSize(SIGN_PX, SIGN_PX)))
            self.word.setStyleSheet(f"color: {self._look.theme.verdict(self._verdict).name()}")
