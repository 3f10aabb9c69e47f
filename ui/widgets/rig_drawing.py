"""Drawing of the nominal rig in side view and top view."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.canvas import Canvas

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription

PLINTH = 180.0
HEAD_ABOVE = 0.55
FLOOR = "faint"


class RigDrawing(QWidget):
    """Shows guide, robot with reach, measuring head and table, to scale."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._rig: RigDescription | None = None
        self.setMinimumSize(480, 160)
        look.changed.connect(self.update)

    def show_rig(self, rig: RigDescription | None) -> None:
        """Show this rig."""
        self._rig = rig
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw both projections."""
        if self._rig is None:
            return
        painter = QPainter(self)
        half = self.width() / 2
        height = self.height() - 72
        self._side(painter, QRectF(24, 40, half - 40, height), self._rig)
        self._top(painter, QRectF(half + 16, 40, half - 40, height), self._rig)

    def _side(self, painter: QPainter, area: QRectF, rig: RigDescription) -> None:
        x, _, z = rig.table.centre_in_guide_mm
        radius, floor = rig.table.diameter_mm / 2, min(-PLINTH, z - 300)
        shoulder = rig.robot.shoulder_mm
        head = _head_side(rig)
        roof = max(head[1], shoulder[2]) + 300
        canvas = Canvas(painter, self._look.theme, area, QRectF(-330, floor - 60, x + radius + 420, roof - floor + 60))
        canvas.heading("Side view")
        canvas.pen("line", 2)
        canvas.line((-330, floor), (x + radius + 60, floor))
        _table_side(canvas, x, z, radius, floor)
        _robot_side(canvas, shoulder, head, floor)
        _sight(canvas, head, (x, z + 60), radius * 0.8, rig.standoff_mm)

    def _top(self, painter: QPainter, area: QRectF, rig: RigDescription) -> None:
        x, y, _ = rig.table.centre_in_guide_mm
        radius, (low, high) = rig.table.diameter_mm / 2, rig.guide.limits_mm
        bottom, top = min(low, y - radius) - 150, max(high, y + radius) + 150
        canvas = Canvas(painter, self._look.theme, area, QRectF(-330, bottom, x + radius + 420, top - bottom))
        canvas.heading("Top view")
        stand = min(max(y, low), high)
        canvas.pen("accent", 1.2, Qt.PenStyle.DashLine)
        canvas.fill("accent", 0.05)
        painter.setClipRect(QRectF(canvas.at(0, top).x(), 0, self.width(), self.height()))
        canvas.circle(0, stand, rig.robot.max_reach_mm)
        painter.setClipping(False)
        canvas.pen("faint", 1.2)
        canvas.fill("sunken")
        canvas.box(-140, low - 100, 140, high + 100)
        canvas.text(0, low - 100, tr("Guide {value:.0f} mm", value=high - low), offset=(28, 14), clear=True)
        canvas.pen("faint", 1.5)
        canvas.fill("raised")
        canvas.circle(x, y, radius)
        canvas.fill(None)
        canvas.circle(x, y, radius * 0.62)
        canvas.line((x - 40, y), (x + 40, y))
        canvas.line((x, y - 40), (x, y + 40))
        canvas.text(x + radius, y, tr("Table ⌀ {value:.0f} mm", value=2 * radius), offset=(8, 0), centre=False)
        _robot_top(canvas, stand, x - rig.standoff_mm * 0.85, y)


def _head_side(rig: RigDescription) -> tuple[float, float]:
    x, _, z = rig.table.centre_in_guide_mm
    return x - rig.standoff_mm * 0.85, z + 60 + rig.standoff_mm * HEAD_ABOVE


def _table_side(canvas: Canvas, x: float, z: float, radius: float, floor: float) -> None:
    canvas.pen("faint", 1.5)
    canvas.fill("raised")
    canvas.box(x - radius * 0.5, z - 60, x + radius * 0.5, floor)
    canvas.box(x - radius, z, x + radius, z - 60)
    canvas.pen("faint", 1.2, Qt.PenStyle.DashDotLine)
    canvas.line((x, floor), (x, z + 250))
    canvas.text(x, z + 250, "Table axis", offset=(8, -4), centre=False)


def _robot_side(canvas: Canvas, shoulder: tuple[float, float, float], head: tuple[float, float], floor: float) -> None:
    x, _, z = shoulder
    canvas.pen("faint", 1.5)
    canvas.fill("sunken")
    canvas.box(-260, 0, 260, floor)
    canvas.text(0, floor / 2, "Guide")
    canvas.fill("raised")
    canvas.box(-140, z * 0.6, 140, 0)
    elbow = ((x + head[0]) / 2 - 120, max(z, head[1]) + 260)
    canvas.pen("soft", 13)
    canvas.line((0, z * 0.6), (x, z), elbow, (head[0] - 90, head[1] + 50))
    canvas.pen("surface", 1.5)
    canvas.fill("soft")
    for joint in ((x, z), elbow, (head[0] - 90, head[1] + 50)):
        canvas.dot(*joint, 8)
    canvas.pen("accent", 14)
    canvas.line((head[0] - 60, head[1] - 90), (head[0] + 40, head[1] + 90))
    canvas.text(head[0] + 70, head[1] + 110, "Measuring head", offset=(8, -6), colour="accent_text", bold=True, centre=False)


def _sight(canvas: Canvas, head: tuple[float, float], goal: tuple[float, float], spread: float, standoff_mm: float) -> None:
    canvas.pen("accent", 1.0, Qt.PenStyle.DashLine)
    canvas.fill("accent", 0.08)
    canvas.polygon(head, (goal[0] - spread, goal[1] - 40), (goal[0] + spread, goal[1] + 30))
    canvas.text(goal[0] + spread, goal[1] + 30, f"{standoff_mm:.0f} mm", offset=(8, 0), colour="accent_text", centre=False)


def _robot_top(canvas: Canvas, stand: float, head_x: float, y: float) -> None:
    canvas.pen("soft", 12)
    canvas.line((0, stand), (head_x - 60, y))
    canvas.pen("surface", 1.5)
    canvas.fill("soft")
    canvas.dot(0, stand, 14)
    canvas.pen("accent", 14)
    canvas.line((head_x, y - 120), (head_x, y + 120))
    canvas.text(-140, stand, "Robot", offset=(-30, 0))
