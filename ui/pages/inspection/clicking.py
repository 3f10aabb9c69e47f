"""What clicks into the picture of a measured part do: measure distances, or grow features; one of them at a time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.controllers.growing import GrowingController
from ui.look.look import Look
from ui.pages.clicked_distance import DistanceTool
from ui.pages.inspection.grow_bar import GrowBar

if TYPE_CHECKING:
    from ui.look.theme import Theme
    from ui.viewport.layers import Label, LineLayer


class ClickingTools(QObject):
    """A tool for distances and one for features; either switches the other off."""

    def __init__(self, look: Look, growing: GrowingController, parent: QObject) -> None:
        super().__init__(parent)
        self._growing = growing
        self.distance, self.grow = DistanceTool(look, self), GrowBar(look, growing)
        self.grow.button.toggled.connect(lambda on: self.distance.button.setChecked(self.distance.is_on and not on))
        self.distance.button.toggled.connect(lambda on: self.grow.button.setChecked(self.grow.is_on and not on))

    @property
    def can_undo(self) -> bool:
        """Whether something that was clicked can be taken back."""
        return self.distance.can_undo or self.grow.last is not None

    def undo(self) -> None:
        """Take back the last point or distance; when none is left, the feature that grew last."""
        if self.distance.can_undo:
            self.distance.undo()
        else:
            self._growing.undo()

    def end(self) -> None:
        """Let clicks tell about points again."""
        for button in (self.distance.button, self.grow.button):
            button.setChecked(False)

    def lines(self, colour: tuple[int, int, int]) -> list[LineLayer]:
        """Return distances and features as lines."""
        return [*self.distance.lines(colour), *self.grow.lines(colour)]

    def labels(self, theme: Theme) -> list[Label]:
        """Return a label for each distance and feature."""
        return [*self.distance.labels(theme), *self.grow.labels(theme)]
