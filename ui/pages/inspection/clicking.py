"""Tools operated by clicks in the picture of a measured part: distances, grown features and contours, one at a time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.controllers.contouring import ContouringController
from ui.controllers.growing import GrowingController
from ui.look.look import Look
from ui.pages.clicked_distance import DistanceTool
from ui.pages.inspection.contour_bar import ContourBar
from ui.pages.inspection.grow_bar import GrowBar

if TYPE_CHECKING:
    from ui.look.theme import Theme
    from ui.viewport.layers import Label, LineLayer


class ClickingTools(QObject):
    """A tool for distances, one for grown features and one for contours, mutually exclusive."""

    def __init__(
        self, look: Look, growing: GrowingController, contouring: ContouringController, contour: ContourBar, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._growing, self._contouring, self._contour = growing, contouring, contour
        self.distance, self.grow = DistanceTool(look, self), GrowBar(look, growing)
        self.grow.button.toggled.connect(lambda on: self.distance.button.setChecked(self.distance.is_on and not on))
        self.distance.button.toggled.connect(lambda on: self.grow.button.setChecked(self.grow.is_on and not on))
        for button in (self.distance.button, self.grow.button):
            button.toggled.connect(lambda on: contouring.cancel() if on else None)
        contouring.changed.connect(self._end_others)

    def _end_others(self) -> None:
        if self._contouring.is_on:
            for button in (self.distance.button, self.grow.button):
                button.setChecked(False)

    @property
    def can_undo(self) -> bool:
        """Whether a click can be undone."""
        return self._contouring.can_undo or self.distance.can_undo or self.grow.last is not None

    def undo(self) -> None:
        """Undo the last click of a contour, point or distance; without one, the last grown feature."""
        if self._contouring.can_undo:
            self._contouring.undo()
        elif self.distance.can_undo:
            self.distance.undo()
        else:
            self._growing.undo()

    def end(self) -> None:
        """Return to picking points by clicks."""
        self._contouring.cancel()
        for button in (self.distance.button, self.grow.button):
            button.setChecked(False)

    def lines(self, colour: tuple[int, int, int]) -> list[LineLayer]:
        """Return distances and features as lines."""
        return [*self.distance.lines(colour), *self.grow.lines(colour), *self._contour.lines(colour)]

    def labels(self, theme: Theme) -> list[Label]:
        """Return a label for each distance and feature."""
        return [*self.distance.labels(theme), *self.grow.labels(theme)]
