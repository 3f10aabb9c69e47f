"""Clip box of a 3-D view: on or off, and its limits as numbers."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.viewport.clip_box import ClipBox
from ui.viewport.cloud_view import CloudView
from ui.widgets.basic import Button, label, row
from ui.widgets.number_fields import NumberFields

NAMES = ("x from", "x to", "y from", "y to", "z from", "z to")
DIGITS = 1


class ClipBar(QWidget):
    """Below a picture while its clip box is on; switched off, the box keeps its numbers."""

    def __init__(self, look: Look, view: CloudView, parent: QWidget) -> None:
        super().__init__(parent)
        self._view, self._page = view, parent
        self.fields = NumberFields(NAMES, "mm", DIGITS)
        self.around = Button("Everything", look, "fit", "quiet", "Set the box around everything")
        self.off = Button("Off", look, "", "quiet", "Switch the clip box off; its numbers are kept")
        self.setLayout(row(label("Clip box", "soft"), self.fields, self.around, self.off, 0, margin=8, spacing=8))
        self.fields.valueChanged.connect(self._take_numbers)
        self.around.clicked.connect(self._set_around)
        self.off.clicked.connect(self.toggle)
        view.clipAsked.connect(self.toggle)
        view.clipChanged.connect(self._show)
        self.hide()

    @Slot()
    def toggle(self) -> None:
        """Switch the box on or off; the first time it is set around everything."""
        stage, clip = self._view.stage, self._view.clip
        if stage is None:
            return
        if clip is None:
            self._set_around()
        else:
            self._set(ClipBox(clip.low_mm, clip.high_mm, not clip.is_on))

    def _set_around(self) -> None:
        stage = self._view.stage
        if stage is not None:
            bounds = np.array(stage.scene.bounds_mm()).reshape(3, 2)
            self._set(ClipBox.around(bounds.T))

    @Slot(object)
    def _take_numbers(self, numbers: tuple[float, ...]) -> None:
        low, high = tuple(numbers[0::2]), tuple(numbers[1::2])
        if len(numbers) == len(NAMES) and all(one < other for one, other in zip(low, high, strict=True)):
            self._set(ClipBox(low, high))  # type: ignore[arg-type]
        elif self._view.clip is not None:
            self._show(self._view.clip)

    def _set(self, clip: ClipBox) -> None:
        self._view.set_clip(clip)
        self._show(clip)

    @Slot(object)
    def _show(self, clip: ClipBox) -> None:
        self.fields.setValue([value for pair in zip(clip.low_mm, clip.high_mm, strict=True) for value in pair])
        self.setVisible(clip.is_on and self.parentWidget() is not self._page)  # a page may have no place for it
