"""Asks for another distance of an offset plane or a point on an axis."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.inspection.create_bar import distance_field
from ui.widgets.basic import Button, column, label, row

WIDTH = 420


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
        self.use.setDefault(True)
        self.use.clicked.connect(self._use)
        cancel = Button("Cancel", look, "", "normal", "Change nothing")
        cancel.clicked.connect(self.reject)
        asked = row(label("Distance", "soft"), self.field, 0)
        self.setLayout(column(label(sentence_case(name), "heading"), asked, 8, row(0, cancel, self.use), margin=24))
        self.setFixedWidth(WIDTH)
        self.setModal(True)

    def _use(self) -> None:
        self.accept()
        self.chosen.emit(self.field.value())
