"""Navigation rail: the pages in the order of the workflow."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QSizePolicy, QToolButton, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import column


class Rail(QFrame):
    """A button with icon and label per page; the page shown is marked."""

    chosen = Signal(str)

    def __init__(self, look: Look, entries: dict[str, str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("rail")
        self.setMinimumWidth(look.theme.sizes["rail"])
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)  # as wide as its longest word
        self._look = look
        self._group = QButtonGroup(self)
        self.buttons: dict[str, QToolButton] = {}
        for place, (name, word) in enumerate(entries.items()):
            self.buttons[name] = self._entry(name, word, place)
        self.setLayout(column(*self.buttons.values(), 0, margin=8, spacing=4))
        look.changed.connect(self._redraw)
        self._redraw()

    def choose(self, name: str) -> None:
        """Mark one page."""
        self.buttons[name].setChecked(True)
        self._redraw()

    def _entry(self, name: str, word: str, place: int) -> QToolButton:
        made = QToolButton()
        made.setText(translated(word))
        made.setProperty("role", "rail")
        made.setCheckable(True)
        made.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        made.setIconSize(QSize(24, 24))
        made.setFixedHeight(64)
        made.setMinimumWidth(72)
        made.setSizePolicy(QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
        made.setCursor(Qt.CursorShape.PointingHandCursor)
        made.setToolTip(tr("{word} (Ctrl+{value})", word=word, value=place + 1))
        made.setShortcut(tr("Ctrl+{value}", value=place + 1))
        made.clicked.connect(lambda: self.chosen.emit(name))
        self._group.addButton(made)
        return made

    def _redraw(self) -> None:
        for name, made in self.buttons.items():
            made.setIcon(self._look.icon(name, "accent_text" if made.isChecked() else "soft"))
