"""Asks what a generated plan has to achieve."""

from __future__ import annotations

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QDialog, QSpinBox, QWidget

from ui.controllers.planning import PlanningController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, Form, column, label, row
from ui.widgets.number_field import NumberField
from ui.widgets.segments import Segments

HOW = (
    "Viewpoints are chosen by what cameras and projector are predicted to measure, and ordered so that the axes move little. "
    "The plan replaces the one shown; undo brings that back."
)
BY = {"coverage": "Coverage", "count": "Number of viewpoints"}
MOST = 500
WIDTH = 520


class GenerateDialog(QDialog):
    """Starts the generator; it runs in the status strip, where it can be cancelled."""

    partAsked = Signal()

    def __init__(self, look: Look, planning: PlanningController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Generate a plan"))
        self._planning = planning
        self.part = label("", wrap=True)
        self.choose = Button("Choose…", look, "file")
        self.choose.clicked.connect(self.partAsked)
        self.by = Segments(BY, name="Aim")
        self.coverage = NumberField()
        self.coverage.setRange(10.0, 100.0)
        self.coverage.setDecimals(1)
        self.coverage.setSuffix(tr(" % of what the rig can measure"))
        self.coverage.setValue(98.0)
        self.count = QSpinBox()
        self.count.setRange(1, MOST)
        self.count.setValue(26)
        self.count.setSuffix(tr(" viewpoints"))
        for spin in (self.coverage, self.count):
            spin.lineEdit().setTextMargins(6, 0, 0, 0)
        form = self._form = Form()
        form.add("Part", self._beside(self.part, self.choose))
        form.add("Until", self.by)
        form.add("", self.coverage)
        form.add("", self.count)
        self.start = Button("Generate", look, "grow", "primary")
        self.start.clicked.connect(self._generate)
        cancel = Button("Cancel", look)
        cancel.clicked.connect(self.reject)
        title, how = label("Generate a plan", "title"), label(HOW, "soft", wrap=True)
        self.setLayout(column(title, how, form, 0, row(0, cancel, self.start), margin=24, spacing=16))
        self.setMinimumWidth(WIDTH)
        self.by.valueChanged.connect(self._show)
        planning.part.changed.connect(self._show)
        self._show()

    @staticmethod
    def _beside(words: QWidget, button: QWidget) -> QWidget:
        pair = QWidget()
        layout = row(words, button)
        layout.setStretch(0, 1)
        pair.setLayout(layout)
        return pair

    @Slot()
    def _show(self) -> None:
        prepared = self._planning.part.prepared
        self.part.setText(
            tr("Choose the nominal of the part.") if prepared is None else f"{prepared.path.parent.name}/{prepared.path.name}"
        )
        self.start.setEnabled(prepared is not None)
        by_count = self.by.value() == "count"
        self._form.setRowVisible(self.coverage, not by_count)
        self._form.setRowVisible(self.count, by_count)

    @Slot()
    def _generate(self) -> None:
        by_count = self.by.value() == "count"
        self.accept()
        self._planning.generate(self.count.value() if by_count else None, self.coverage.value() / 100.0)
