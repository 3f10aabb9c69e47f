"""Point-to-point distance tool: distance of two picked points, with uncertainty."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.look.look import Look
from ui.look.wording import NOTHING, millimetres, quantity
from ui.pages.layers import cross
from ui.viewport.layers import Label, LineLayer
from ui.widgets.basic import Button
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.view_errors import ViewErrors
    from ui.look.theme import Theme

FIRST, SECOND = "Click the first point", "Click the second point"
TIP = "Measure the distance between two points you click"
WHAT_IT_IS = "Distance of two single points. A dimension of the inspection program uses thousands of points and has a smaller uncertainty."


@dataclass(frozen=True, eq=False)
class ClickedPoint:
    """A picked measured point."""

    position_mm: np.ndarray  # (3,)
    sigma_mm: float
    view: str
    number: int | None = None  # number of its view in `errors`; None without an error model
    errors: ViewErrors | None = None  # of the stitched views, in the frame of the position
    scale_ppm: float = 0.0  # standard uncertainty of all lengths of the rig


@dataclass(frozen=True, eq=False)
class Distance:
    """Distance of two picked points."""

    first: ClickedPoint
    second: ClickedPoint
    length_mm: float
    uncertainty_mm: float | None  # k = 2; None where that of the points is not known

    @classmethod
    def between(cls, first: ClickedPoint, second: ClickedPoint) -> Distance:
        """Measure from one point to the other."""
        from measureapp.inspection.point_distance import point_distance
        from measureapp.inspection.settings import UncertaintySettings

        places, sigmas = np.stack([first.position_mm, second.position_mm]), (first.sigma_mm, second.sigma_mm)
        views = None if first.number is None or second.number is None else (first.number, second.number)
        settings = UncertaintySettings(scale_ppm=first.scale_ppm)
        length, uncertainty = point_distance(places, sigmas, first.view == second.view, settings, views, first.errors)
        return cls(first, second, length, uncertainty if min(sigmas) > 0 else None)

    @property
    def words(self) -> str:
        """Return value and uncertainty in one line."""
        if self.uncertainty_mm is None:
            return millimetres(self.length_mm).replace("\u00a0", " ")
        return f"{quantity(self.length_mm, '')} ± {millimetres(self.uncertainty_mm)}".replace("\u00a0", " ").strip()


class DistanceTool(QObject):
    """Collects picked points while its button is checked; distances stay until they are undone or the clouds change."""

    changed = Signal()

    def __init__(self, look: Look, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.button = Button("Measure", look, "inspection", "quiet", TIP)
        self.button.setCheckable(True)
        self.button.toggled.connect(self._begin)
        self.distances: list[Distance] = []
        self._first: ClickedPoint | None = None
        self._where: object = None

    @property
    def is_on(self) -> bool:
        """Whether clicks are meant for measuring."""
        return self.button.isChecked()

    @property
    def hint(self) -> str:
        """Return what to do next; empty while nothing is measured."""
        return "" if not self.is_on else FIRST if self._first is None else SECOND

    @property
    def can_undo(self) -> bool:
        """Whether there is something to undo."""
        return self._first is not None or bool(self.distances)

    def click(self, point: ClickedPoint) -> None:
        """Add a point: the first, or the second, which completes a distance."""
        if self._first is None:
            self._first = point
        else:
            self.distances.append(Distance.between(self._first, point))
            self._first = None
        self.changed.emit()

    @Slot()
    def undo(self) -> None:
        """Remove a single first point, or the last distance."""
        if self._first is not None:
            self._first = None
        elif self.distances:
            self.distances.pop()
        self.changed.emit()

    def keep_for(self, where: object) -> None:
        """Discard points of another cloud or alignment."""
        if where == self._where:
            return
        had_any = self._first is not None or bool(self.distances)
        self._where, self._first, self.distances = where, None, []
        if had_any:
            self.changed.emit()

    def lines(self, colour: tuple[int, int, int]) -> list[LineLayer]:
        """Return the distances as lines, with a cross at each point."""
        drawn = [np.stack([one.first.position_mm, one.second.position_mm]) for one in self.distances]
        points = [point for one in self.distances for point in (one.first, one.second)] + ([self._first] if self._first else [])
        crosses = [line for point in points for line in cross(point.position_mm)]
        return [LineLayer((*drawn, *crosses), colour, 3.0)] if drawn or crosses else []

    def labels(self, theme: Theme) -> list[Label]:
        """Return a label for each distance."""
        text, surface = theme.colour("text"), theme.colour("surface")
        colours = (text.red(), text.green(), text.blue()), (surface.red(), surface.green(), surface.blue())
        return [Label(one.words, (one.first.position_mm + one.second.position_mm) / 2.0, *colours) for one in self.distances]

    def properties(self) -> Properties:
        """Return the properties of the last distance."""
        if not self.distances:
            return Properties("Distance", note=f"{self.hint}." if self.hint else "")
        one = self.distances[-1]
        apart = one.second.position_mm - one.first.position_mm
        along = tuple((axis, millimetres(float(value), signed=True)) for axis, value in zip("xyz", apart, strict=True))
        ends = tuple(
            Group(name, (("View", point.view or NOTHING), ("Standard deviation σ", millimetres(point.sigma_mm))))
            for name, point in (("First point", one.first), ("Second point", one.second))
        )
        length = (("Distance", millimetres(one.length_mm)), ("Uncertainty (k = 2)", millimetres(one.uncertainty_mm)))
        return Properties("Distance", (Group("Result", (*length, *along)), *ends), WHAT_IT_IS)

    @Slot(bool)
    def _begin(self, _on: bool) -> None:
        self._first = None
        self.changed.emit()
