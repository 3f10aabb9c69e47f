"""Drawing of the viewpoints around the part, in top view and by height."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.widgets.canvas import Canvas

STATUS_COLOURS = {
    "processed": "verdict_pass",
    "failed": "verdict_fail",
    "stored": "accent",
    "capturing": "verdict_not_proven",
    "moving": "verdict_not_proven",
}
Point = tuple[float, float, float]


@dataclass(frozen=True)
class Station:
    """Position and viewing direction of the measuring head relative to the part."""

    id: str
    position_mm: Point
    direction: Point
    status: str = "waiting"


class PlanDrawing(QWidget):
    """Shows viewpoints as numbered dots; a click selects one."""

    stationClicked = Signal(int)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._stations: tuple[Station, ...] = ()
        self._table_mm = 0.0
        self._chosen = -1
        self._places: list[tuple[float, float]] = []
        self.setMinimumSize(360, 320)
        look.changed.connect(self.update)

    def show_stations(self, stations: Sequence[Station], table_mm: float) -> None:
        """Show these viewpoints around a table of this diameter."""
        self._stations, self._table_mm = tuple(stations), table_mm
        self.update()

    def choose(self, place: int) -> None:
        """Mark one viewpoint."""
        self._chosen = place
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Select the viewpoint under the mouse."""
        where = event.position()
        count = len(self._stations)
        for place, (x, y) in enumerate(self._places):
            if hypot(where.x() - x, where.y() - y) < 16:
                self.stationClicked.emit(place % count)
                return

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw both projections."""
        if not self._stations:
            return
        painter = QPainter(self)
        self._places = []
        split = self.height() * 0.64
        self._from_above(painter, QRectF(24, 40, self.width() - 48, split - 56))
        self._by_height(painter, QRectF(24, split + 32, self.width() - 48, self.height() - split - 56))

    def _from_above(self, painter: QPainter, area: QRectF) -> None:
        reach = max(self._table_mm / 2, *(hypot(s.position_mm[0], s.position_mm[1]) for s in self._stations)) * 1.06
        canvas = Canvas(painter, self._look.theme, area, QRectF(-reach, -reach, 2 * reach, 2 * reach))
        canvas.heading("Head relative to the part, top view")
        self._table(canvas)
        self._draw(canvas, [((s.position_mm[0], s.position_mm[1]), (s.direction[0], s.direction[1])) for s in self._stations])

    def _by_height(self, painter: QPainter, area: QRectF) -> None:
        flat = [((hypot(s.position_mm[0], s.position_mm[1]), s.position_mm[2]), _inwards(s)) for s in self._stations]
        far = max(radius for (radius, _), _ in flat) * 1.1
        top = max(height for (_, height), _ in flat) * 1.1 + 40
        canvas = Canvas(painter, self._look.theme, area, QRectF(-self._table_mm / 2, -60, far + self._table_mm / 2, top + 60))
        canvas.heading("Distance from the axis and height")
        canvas.pen("faint", 1.5)
        canvas.fill("raised")
        canvas.box(-self._table_mm / 2, 0, self._table_mm / 2, -50)
        canvas.pen("faint", 1.2, Qt.PenStyle.DashDotLine)
        canvas.line((0, -50), (0, top))
        self._draw(canvas, flat)

    def _table(self, canvas: Canvas) -> None:
        canvas.pen("faint", 1.5)
        canvas.fill("raised")
        canvas.circle(0, 0, self._table_mm / 2)
        canvas.pen("line", 1)
        canvas.line((-self._table_mm / 2, 0), (self._table_mm / 2, 0))
        canvas.line((0, -self._table_mm / 2), (0, self._table_mm / 2))

    def _draw(self, canvas: Canvas, flat: list[tuple[tuple[float, float], tuple[float, float]]]) -> None:
        theme = self._look.theme
        length = 46 / canvas.scale
        order = sorted(range(len(flat)), key=lambda place: place == self._chosen)
        places = {}
        for place in order:
            ((x, y), (dx, dy)), station = flat[place], self._stations[place]
            colour: QColor = theme.colour(STATUS_COLOURS.get(station.status, "faint"))
            chosen = place == self._chosen
            canvas.pen(colour, 3 if chosen else 1.5)
            canvas.line((x, y), (x + dx * length, y + dy * length))
            canvas.pen(theme.colour("text") if chosen else theme.colour("surface"), 2)
            canvas.fill(colour)
            canvas.dot(x, y, 13 if chosen else 11)
            canvas.text(x, y, str(place + 1), colour="accent_on", bold=True)
            where = canvas.at(x, y)
            places[place] = (where.x(), where.y())
        self._places += [places[place] for place in range(len(flat))]


def _inwards(station: Station) -> tuple[float, float]:
    x, y, _ = station.position_mm
    radius = max(1.0, hypot(x, y))
    return (station.direction[0] * x + station.direction[1] * y) / radius, station.direction[2]
