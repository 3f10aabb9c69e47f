"""Banner with the verdict on the whole part."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QLabel

from ui.look.look import Look
from ui.look.wording import several
from ui.widgets.basic import column, label, row

Verdict = Literal["pass", "fail", "not proven"]
SIGN_PX = 48


def verdict_on(verdicts: Sequence[str]) -> Verdict | None:
    """Combine verdicts on dimensions: fail if any fails, pass if all with a tolerance pass; None without any.

    >>> verdict_on(["pass", "not measured", "pass"]), verdict_on(["pass", "fail", "not proven"])
    ('not proven', 'fail')
    """
    decided = {verdict for verdict in verdicts if verdict != "no tolerance"}
    if not decided:
        return None
    return "fail" if "fail" in decided else "pass" if decided == {"pass"} else "not proven"


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
        count = sum(one == self._verdict if self._verdict == "fail" else one != "pass" for one in verdicts)
        self.word.setText((self._verdict or "").upper())
        passed = f"All {several(len(verdicts), 'dimension')} pass."
        open_ = f"{count} of {several(len(verdicts), 'dimension')} {'fail' if self._verdict == 'fail' else 'not proven or not measured'}."
        self.words.setText(passed if self._verdict == "pass" else open_)
        self.setAccessibleName(f"{self.word.text()}. {self.words.text()}")
        self._redraw()

    def _redraw(self) -> None:
        if self._verdict is not None:
            colour = "verdict_" + self._verdict.replace(" ", "_")
            self._sign.setPixmap(self._look.icon(self._verdict, colour).pixmap(QSize(SIGN_PX, SIGN_PX)))
            self.word.setStyleSheet(f"color: {self._look.theme.verdict(self._verdict).name()}")
