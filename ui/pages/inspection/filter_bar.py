"""Chips that filter the table of dimensions by verdict, and a search field."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QLineEdit, QPushButton, QWidget

from ui.controllers.program_rows import DimensionRow
from ui.look.language.words import tr
from ui.look.look import Look
from ui.pages.inspection.dimension_filter import STALE
from ui.widgets.basic import row

CHIPS = {
    "fail": "{count} fail",
    "not proven": "{count} not proven",
    "not measured": "{count} not measured",
    "no tolerance": "{count} without tolerance",
    "pass": "{count} pass",
    STALE: "{count} stale",
}
SEARCH_WIDTH = 132


class FilterBar(QWidget):
    """Chooses which dimensions are shown: `chips()` and `words()`."""

    changed = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.buttons: dict[str, QPushButton] = {}
        for name in CHIPS:
            made = QPushButton()
            made.setIconSize(QSize(18, 18))
            made.setCheckable(True)
            made.setProperty("role", "quiet")
            made.setAutoDefault(False)
            made.toggled.connect(self.changed)
            self.buttons[name] = made
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Search"))
        self.search.setAccessibleName(tr("Search dimensions by name or kind"))
        self.search.setToolTip(tr("Show dimensions whose name or kind contains these words (Ctrl+F)"))
        self.search.setClearButtonEnabled(True)
        self.search.setMinimumWidth(SEARCH_WIDTH // 2)
        self.search.setMaximumWidth(SEARCH_WIDTH)
        self.search.textChanged.connect(self.changed)
        self.setLayout(row(*self.buttons.values(), 0, self.search, spacing=4))
        look.changed.connect(self._colour)
        self.show_rows(())

    def chips(self) -> frozenset[str]:
        """Return the chosen chips; none: all rows are shown."""
        return frozenset(name for name, made in self.buttons.items() if made.isChecked())

    def words(self) -> str:
        """Return what is searched for."""
        return self.search.text()

    def show_rows(self, rows: Sequence[DimensionRow]) -> None:
        """Count the rows of each chip; a chip without rows is hidden."""
        counts = Counter(STALE if one.is_outdated else one.verdict for one in rows)
        for name, made in self.buttons.items():
            made.setText(str(counts[name]))
            made.setAccessibleName(tr(CHIPS[name], count=counts[name]))
            made.setToolTip(tr("{chip}: show only these", chip=tr(CHIPS[name], count=counts[name])))
            if not counts[name]:
                made.setChecked(False)
            made.setVisible(counts[name] > 0)
        self.search.setVisible(len(rows) > 1)
        self._colour()

    def _colour(self) -> None:
        for name, made in self.buttons.items():
            made.setIcon(self._look.icon(*(("again", "soft") if name == STALE else (name, "verdict_" + name.replace(" ", "_")))))
