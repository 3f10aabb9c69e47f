"""Segmented control: a row of buttons, one of which is chosen."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QPushButton, QWidget

from ui.look.language.retranslating import remember
from ui.look.language.words import tr, translated


class Segments(QWidget):
    """Chooses one of a few named options: value(), setValue(name), valueChanged."""

    valueChanged = Signal(object)

    def __init__(
        self, options: dict[str, str], parent: QWidget | None = None, *, name: str = "", tips: Mapping[str, str] | None = None
    ) -> None:
        """``name``: accessible name of the choice; ``tips``: tooltips of options."""
        super().__init__(parent)
        self.setAccessibleName(translated(name))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        self._group = QButtonGroup(self)
        self._buttons: dict[str, QPushButton] = {}
        self._tips = dict(tips or {})
        last = len(options) - 1
        for place, (key, text) in enumerate(options.items()):
            made = QPushButton(translated(text))
            made.setCheckable(True)
            made.setAccessibleName(tr("{name}: {text}", name=name, text=text) if name else translated(text))
            made.setToolTip(translated(self._tips.get(key, "")))
            remember(made)
            made.setAutoDefault(False)
            made.setProperty("role", "segment")
            made.setProperty("place", "first" if place == 0 else "last" if place == last else "middle")
            made.setCursor(Qt.CursorShape.PointingHandCursor)
            self._group.addButton(made)
            self._buttons[key] = made
            layout.addWidget(made)
        next(iter(self._buttons.values())).setChecked(True)
        self._keep_focus_on_chosen()
        self._group.buttonClicked.connect(self._on_clicked)

    def value(self) -> str:
        """Return the name of the chosen option."""
        return next(name for name, made in self._buttons.items() if made.isChecked())

    def setValue(self, name: str) -> None:
        """Choose an option by name."""
        if name != self.value():
            self._buttons[name].setChecked(True)
            self._keep_focus_on_chosen()
            self.valueChanged.emit(name)

    def button(self, name: str) -> QPushButton:
        """Return the button of an option."""
        return self._buttons[name]

    def set_available(self, name: str, available: bool, why: str = "") -> None:
        """Enable or disable an option; ``why`` takes the place of its tooltip while it is disabled."""
        made = self._buttons[name]
        made.setEnabled(available)
        made.setToolTip(translated(self._tips.get(name, "") if available or not why else why))

    def showEvent(self, event: QShowEvent) -> None:
        """Set minimum widths so that labels are never cut; the fonts are known only when the widget is shown."""
        for made in self._buttons.values():
            made.ensurePolished()
            made.setMinimumWidth(made.sizeHint().width())
        super().showEvent(event)

    def _keep_focus_on_chosen(self) -> None:
        """Give the tab focus to the chosen option; the arrow keys move from there."""
        for made in self._buttons.values():
            made.setFocusPolicy(Qt.FocusPolicy.TabFocus if made.isChecked() else Qt.FocusPolicy.NoFocus)

    def _on_clicked(self) -> None:
        self._keep_focus_on_chosen()
        self.valueChanged.emit(self.value())
