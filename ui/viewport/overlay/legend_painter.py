"""Painter of the legend: for the window and for printed pictures."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QBrush, QColor, QImage, QPainter, QPen, QPolygonF

from ui.look.language.words import translated
from ui.look.wording import NOTHING, percent, quantity
from ui.viewport.colouring import HATCH_SHADE, UNKNOWN
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.legend_layout import BEYOND, BRACKET, LINE, LegendLayout, digits_of, ticks
from ui.viewport.overlay.style import OverlayStyle, use_letters

BARS = 48
LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
RIGHT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight
ABOVE, BELOW = "›", "‹"  # marks of the colours beyond the range


def paint_legend(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    """Draw a legend at its place."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(style.line, style.scale))
    painter.setBrush(style.panel)
    painter.drawRoundedRect(layout.panel, 6 * style.scale, 6 * style.scale)
    _paint_header(painter, legend, layout, style)
    _paint_histogram(painter, legend, layout, style)
    _paint_bar(painter, legend, layout, style)
    _paint_numbers(painter, legend, layout, style)
    _paint_tolerance(painter, legend, layout, style)
    if legend.fractions is not None:
        _paint_footer(painter, legend, layout, style)
    painter.restore()


def _paint_header(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    line = LINE * style.scale
    box = QRectF(layout.header.left(), layout.header.top(), layout.header.width(), line)
    use_letters(painter, style, bold=True)
    painter.setPen(style.text)
    painter.drawText(box, LEFT, translated(legend.quantity))
    use_letters(painter, style)
    painter.setPen(style.soft)
    painter.drawText(box.translated(0, line), LEFT, f"[{legend.unit}]")
    if legend.note:
        metrics = painter.fontMetrics()
        words = metrics.elidedText(translated(legend.note), Qt.TextElideMode.ElideRight, int(box.width()))
        painter.drawText(box.translated(0, 2 * line), LEFT, words)


def _paint_histogram(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    if legend.histogram is None:
        return
    counts = legend.histogram.on(legend.low, legend.high, BARS)
    largest = float(counts.max())
    if largest <= 0:
        return
    box, step = layout.histogram, layout.histogram.height() / BARS
    colours = legend.colours(legend.low + (np.arange(BARS) + 0.5) / BARS * legend.span)
    painter.setPen(Qt.PenStyle.NoPen)
    for place, count in enumerate(counts):
        length = box.width() * float(count) / largest
        bar = QRectF(box.right() - length, box.bottom() - (place + 1) * step, length, max(step - 0.5, 0.5))
        painter.setBrush(style.faint)
        painter.drawRect(bar)
        painter.setBrush(QColor(*(int(value) for value in colours[place])))
        painter.drawRect(bar.adjusted(0.6, 0.3, -0.6, -0.3))


def _paint_bar(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    bar = layout.bar
    rows = max(2, int(2 * bar.height()))
    colours = np.ascontiguousarray(legend.colours(legend.high - (np.arange(rows) + 0.5) / rows * legend.span))
    image = QImage(colours.data, 1, rows, 3, QImage.Format.Format_RGB888)
    painter.drawImage(bar, image)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(style.faint, style.scale))
    painter.drawRect(bar)
    _paint_beyond(painter, legend, layout, style)


def _paint_beyond(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    """Draw the darker colours beyond the range, with their marks."""
    bar, height = layout.bar, (BEYOND - 2) * style.scale
    reach = max(legend.span, 1e-9)
    for value, top, mark in ((legend.high + reach, bar.top() - height - 1, ABOVE), (legend.low - reach, bar.bottom() + 1, BELOW)):
        if legend.ramp == "growing" and mark == BELOW:
            continue
        box = QRectF(bar.left(), top, bar.width(), height)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(*(int(part) for part in legend.colours(np.array([value]))[0])))
        painter.drawRect(box)
        painter.setPen(QPen(QColor(255, 255, 255), 1.4 * style.scale))
        middle, reach_px = box.center(), 2.6 * style.scale
        up = -1.0 if mark == ABOVE else 1.0
        painter.drawPolyline(
            QPolygonF(
                [
                    middle + QPointF(-1.4 * reach_px, -up * 0.5 * reach_px),
                    middle + QPointF(0, up * 0.7 * reach_px),
                    middle + QPointF(1.4 * reach_px, -up * 0.5 * reach_px),
                ]
            )
        )


def _paint_numbers(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    digits, bar, line = digits_of(legend), layout.bar, LINE * style.scale
    left = bar.right() + (BRACKET + 8.0) * style.scale
    use_letters(painter, style, bold=True)
    painter.setPen(style.text)
    signed = legend.low < 0
    for value in (legend.low, legend.high):
        box = QRectF(left, layout.y_of(value) - line / 2, layout.panel.right() - left - 2, line)
        painter.drawText(box, LEFT, quantity(value, "", digits, signed=signed and value != 0))
        painter.drawLine(QPointF(bar.right(), layout.y_of(value)), QPointF(bar.right() + 3 * style.scale, layout.y_of(value)))
    use_letters(painter, style)
    painter.setPen(style.soft)
    for value in ticks(legend, QSizeF(1.6 * line, bar.height())):
        if min(abs(layout.y_of(value) - layout.y_of(end)) for end in (legend.low, legend.high)) < 1.1 * line:
            continue
        box = QRectF(left, layout.y_of(value) - line / 2, layout.panel.right() - left - 2, line)
        painter.drawText(box, LEFT, quantity(value, "", digits, signed=signed and value != 0))
        painter.drawLine(QPointF(bar.right(), layout.y_of(value)), QPointF(bar.right() + 3 * style.scale, layout.y_of(value)))


def _paint_tolerance(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    """Draw the tolerance as a bracket right of the bar; an end beyond the range has no foot."""
    if legend.tolerance is None:
        return
    start, end = legend.tolerance
    x, foot = layout.bar.right() + (BRACKET - 1.0) * style.scale, 4.0 * style.scale
    top, bottom = max(layout.y_of(end), layout.bar.top()), min(layout.y_of(start), layout.bar.bottom())
    if top > bottom:
        return
    painter.setPen(QPen(style.accent, 2.0 * style.scale))
    painter.drawLine(QPointF(x, top), QPointF(x, bottom))
    for value, y in ((end, top), (start, bottom)):
        if legend.low <= value <= legend.high:
            painter.drawLine(QPointF(x - foot, y), QPointF(x, y))


def _paint_footer(painter: QPainter, legend: Legend, layout: LegendLayout, style: OverlayStyle) -> None:
    found, line = legend.fractions, LINE * style.scale
    assert found is not None
    known = legend.tolerance is not None
    rows = (
        ("Inside", percent(found.inside) if known else NOTHING),
        ("Below", percent(found.below) if known else NOTHING),
        ("Above", percent(found.above) if known else NOTHING),
        ("No data", percent(found.no_data)),
    )
    use_letters(painter, style)
    for place, (name, number) in enumerate(rows):
        box = QRectF(layout.footer.left(), layout.footer.top() + place * line, layout.footer.width(), line)
        if name == "No data":
            _paint_hatched(painter, QRectF(box.left(), box.top() + 3 * style.scale, 14 * style.scale, line - 6 * style.scale))
            painter.setPen(style.soft)
            painter.drawText(box.adjusted(20 * style.scale, 0, 0, 0), LEFT, translated(name))
        else:
            painter.setPen(style.soft)
            painter.drawText(box, LEFT, translated(name))
        painter.setPen(style.text)
        painter.drawText(box, RIGHT, number)


def _paint_hatched(painter: QPainter, box: QRectF) -> None:
    grey = QColor(*(int(value) for value in UNKNOWN))
    painter.setPen(Qt.PenStyle.NoPen)
    for brush in (QBrush(grey), QBrush(grey.darker(round(100 / HATCH_SHADE)), Qt.BrushStyle.BDiagPattern)):
        painter.setBrush(brush)
        painter.drawRect(box)
