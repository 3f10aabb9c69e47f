"""The current theme; widgets redraw on its signal."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor, QIcon
from PySide6.QtWidgets import QApplication

from ui.look.icons import IconSet
from ui.look.style.applying import apply
from ui.look.theme import Shade, Theme


class Look(QObject):
    """Holds the theme and applies it to the application."""

    changed = Signal()

    def __init__(self, shade: Shade = "light", parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.theme = Theme.load(shade)
        self._icons = IconSet(self._colour)

    def apply_theme(self) -> None:
        """Apply the current theme to the application."""
        application = QApplication.instance()
        if isinstance(application, QApplication):
            apply(application, self.theme)

    def set_shade(self, shade: Shade) -> None:
        """Change to the light or the dark theme."""
        if shade == self.theme.shade:
            return
        self.theme = Theme.load(shade)
        self.apply_theme()
        self.changed.emit()

    def icon(self, name: str, colour: str = "soft") -> QIcon:
        """Return an icon in a colour of the theme; it follows the theme by itself."""
        return self._icons.icon(name, colour)

    def _colour(self, token: str) -> QColor:
        return self.theme.colour(token)
