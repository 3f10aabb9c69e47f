"""Bar to grow features by clicking: shape, result and display."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from ui.controllers.growing import GrowingController, GrownFeature
from ui.look.look import Look
from ui.look.wording import millimetres, quantity
from ui.pages.inspection.dimension_rows import feature_group, feature_words
from ui.pages.inspection.outlines import outline
from ui.viewport.layers import Label, LineLayer
from ui.widgets.basic import Button, ElidedLabel, label, row
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.data.feature import Feature
    from ui.look.theme import Theme

SHAPES = {"plane": "Plane", "cylinder": "Cylinder", "sphere": "Sphere", "cone": "Cone"}
TIP = "Fit a plane, cylinder, sphere or cone around a point you click"
HINT = "Click a measured point"
COPY = "Copy its lines"
ADD = "Add to the inspection program"
NOTE = "Added to the inspection program, it is measured every time; its lines can also be copied to another program."


class GrowBar(QWidget):
    """Chooses the shape to grow; the controller holds the grown features."""

    changed = Signal()

    def __init__(self, look: Look, growing: GrowingController) -> None:
        super().__init__()
        self._growing = growing
        self.button = Button("Feature", look, "grow", "quiet", TIP)
        self.button.setCheckable(True)
        self.button.toggled.connect(self._show)
        self.shape = Segments(SHAPES, name="Shape to grow")
        self.words = ElidedLabel(HINT, "small")
        self.setLayout(row(label("Grow a", "soft"), self.shape, self.words, margin=8, spacing=12))
        self.layout().setStretch(2, 1)
        growing.changed.connect(self._tell)
        self._show()

    @property
    def is_on(self) -> bool:
        """Whether clicks are meant for growing."""
        return self.button.isChecked()

    @property
    def last(self) -> GrownFeature | None:
        """The last grown feature."""
        return self._growing.grown[-1] if self._growing.grown else None

    def click(self, place_mm: np.ndarray) -> None:
        """Grow the chosen shape from a point in the nominal's frame."""
        self._growing.grow(place_mm, self.shape.value())  # type: ignore[arg-type]

    def lines(self, colour: tuple[int, int, int]) -> list[LineLayer]:
        """Return the outlines of the grown features."""
        lines = tuple(line for one in self._growing.grown if len(line := outline(one.feature)))
        return [LineLayer(lines, colour, 3.5)] if lines else []

    def labels(self, theme: Theme) -> list[Label]:
        """Return a label for each grown feature."""
        text, surface = theme.colour("text"), theme.colour("surface")
        colours = (text.red(), text.green(), text.blue()), (surface.red(), surface.green(), surface.blue())
        return [Label(short_words(one.feature), np.asarray(one.seed_mm), *colours) for one in self._growing.grown]

    def properties(self) -> Properties:
        """Return the properties of the last grown feature."""
        if self.last is None:
            return Properties("Feature", note=f"{HINT}.")
        feature = self.last.feature
        angle = () if feature.half_angle_rad is None else (("Cone angle", quantity(float(np.degrees(2 * feature.half_angle_rad)), "°")),)
        place = Group("Coordinates", tuple((axis, millimetres(float(value))) for axis, value in zip("xyz", feature.point_mm, strict=True)))
        how = Group("Traceability", (*angle, ("", f"{feature.how[:1].upper()}{feature.how[1:]}.")))
        return Properties(feature.name.capitalize(), (feature_group(feature), place, how), NOTE, COPY, ADD)

    def _show(self) -> None:
        self.setVisible(self.button.isChecked())
        self._tell()

    def _tell(self) -> None:
        self.words.set_words(HINT if self.last is None else feature_words(self.last.feature))
        self.changed.emit()


def short_words(feature: Feature) -> str:
    """Return name and size of a feature, in characters that the 3-D view has."""
    size = f"form {millimetres(feature.form_error_mm)}" if feature.radius_mm is None else f"radius {millimetres(feature.radius_mm)}"
    return f"{feature.name}   {size}".replace("\u00a0", " ")
