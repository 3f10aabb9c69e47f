"""Drawing in millimetres: mapping of a rectangle of the world to a rectangle of the widget."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from ui.look.language.words import translated
from ui.look.painting import set_letters
from ui.look.theme import Theme

GAP_PX = 4.0  # between texts


class Canvas:
    """One projection of a drawing; world x to the right, world y up."""

    def __init__(self, painter: QPainter, theme: Theme, area: QRectF, world: QRectF) -> None:
        self._painter, self.theme, self.area = painter, theme, area
        self.scale = min(area.width() / max(1.0, world.width()), area.height() / max(1.0, world.height()))
        self._centre, self._middle = world.center(), area.center()
        self._texts: list[QRectF] = []  # where texts were drawn
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)

    def at(self, x: float, y: float) -> QPointF:
        """Map a world point to the widget."""
        return QPointF(
            self._middle.x() + (x - self._centre.x()) * self.scale,
            self._middle.y() - (y - self._centre.y()) * self.scale,
        )

    def pen(self, colour: str | QColor, width: float = 1.5, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> None:
        """Set the outline colour, width and style."""
        pen = QPen(self.theme.colour(colour) if isinstance(colour, str) else colour, width, style)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        self._painter.setPen(pen)

    def fill(self, colour: str | QColor | None, opacity: float = 1.0) -> None:
        """Set the fill colour; None: no fill."""
        if colour is None:
            self._painter.setBrush(Qt.BrushStyle.NoBrush)
            return
        shade = QColor(self.theme.colour(colour) if isinstance(colour, str) else colour)
        shade.setAlphaF(opacity)
        self._painter.setBrush(shade)

    def line(self, *points: tuple[float, float]) -> None:
        """Draw a polyline."""
        self._painter.drawPolyline(QPolygonF([self.at(*point) for point in points]))

    def polygon(self, *points: tuple[float, float]) -> None:
        """Draw a closed shape."""
        self._painter.drawPolygon(QPolygonF([self.at(*point) for point in points]))

    def circle(self, x: float, y: float, radius_mm: float) -> None:
        """Draw a circle of this size in the world."""
        self._painter.drawEllipse(self.at(x, y), radius_mm * self.scale, radius_mm * self.scale)

    def dot(self, x: float, y: float, radius_px: float) -> None:
        """Draw a circle of this size in the widget."""
        self._painter.drawEllipse(self.at(x, y), radius_px, radius_px)

    def box(self, x0: float, y0: float, x1: float, y1: float) -> None:
        """Draw a slightly rounded rectangle between two corners."""
        self._painter.drawRoundedRect(QRectF(self.at(x0, y0), self.at(x1, y1)).normalized(), 3, 3)

    def text(
        self,
        x: float,
        y: float,
        words: str,
        *,
        colour: str = "soft",
        offset: tuple[float, float] = (0, 0),
        bold: bool = False,
        centre: bool = True,
        clear: bool = False,
    ) -> None:
        """Draw text at a world point with an offset in pixels, beside the texts drawn before; ``clear`` fills its background."""
        words = translated(words)
        set_letters(self._painter, self.theme.sizes["small"], bold=bold)
        self._painter.setPen(self.theme.colour(colour))
        place = self.at(x, y) + QPointF(*offset)
        box = QRectF(place.x() - (120 if centre else 0), place.y() - 10, 240, 20)
        side = Qt.AlignmentFlag.AlignHCenter if centre else Qt.AlignmentFlag.AlignLeft
        side |= Qt.AlignmentFlag.AlignVCenter
        tight = self._painter.boundingRect(box, side, words)
        shift = self._free_shift(tight)
        tight.translate(shift)
        self._texts.append(tight)
        if clear:
            self._painter.fillRect(tight, self.theme.colour("surface"))
        self._painter.drawText(box.translated(shift), side, words)

    def _free_shift(self, box: QRectF) -> QPointF:
        """Return the smallest shift by lines, else by half a width, that keeps a text clear of those before it; none if all are taken."""
        step, aside = box.height() + GAP_PX, box.width() / 2 + GAP_PX
        shifts = [QPointF(x, y) for x in (0, aside, -aside) for y in (0, step, -step, 2 * step, -2 * step)]
        around = box.adjusted(-GAP_PX, 0, GAP_PX, 0)
        free = (shift for shift in shifts if not any(around.translated(shift).intersects(other) for other in self._texts))
        return next(free, QPointF())

    def heading(self, words: str) -> None:
        """Draw the name of the projection in its corner."""
        set_letters(self._painter, self.theme.sizes["small"], bold=True)
        self._painter.setPen(self.theme.colour("soft"))
        self._painter.drawText(QPointF(self.area.left(), self.area.top() - 8), translated(words))
