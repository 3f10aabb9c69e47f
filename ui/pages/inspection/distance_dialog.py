"""Asks for another distance of an offset plane or a point on an axis."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.pages.inspection.asking import ask_in
from ui.pages.inspection.create_bar import distance_field
from ui.widgets.basic import Button, label, row


class DistanceDialog(QDialog):
    """Takes a distance in mm."""

    chosen = Signal(float)

    def __init__(self, look: Look, name: str, distance_mm: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Distance"))
        self.field = distance_field()
        self.field.setValue(distance_mm)
        self.field.selectAll()
        self.use = Button("Change distance", look, "", "primary", "What depends on the feature is measured again; it can be undone")
        self.use.clicked.connect(self._use)
        ask_in(self, look, name, [row(label("Distance", "soft"), self.field, 0)], self.use)

    def _use(self) -> None:
        self.accept()
        self.chosen.emit(self.field.value())
