"""Painter of labels: short texts near their points, without overlap."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ui.viewport.layers import Label
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.label_layout import place_labels
from ui.viewport.overlay.style import OverlayStyle, use_letters

PADDING = 8.0


def paint_labels(painter: QPainter, labels: Sequence[Label], camera: CameraView, style: OverlayStyle, right: float) -> None:
    """Draw each label with a line to its point, left of the legend, which begins at ``right``."""
    anchors = camera.pixels(np.array([label.point_mm for label in labels], float))
    sizes = []
    for label in labels:
        size = style.measure(label.text, label.letters_px)
        sizes.append((round(size.width() + 2 * PADDING * style.scale), round(size.height() + PADDING * style.scale)))
    upward = np.column_stack([anchors[:, 0], camera.height - anchors[:, 1]])
    offsets = place_labels(upward, sizes, (round(right), round(camera.height)))
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    boxes = []
    for (x, y), (width, height), (across, up) in zip(anchors.tolist(), sizes, offsets, strict=True):
        boxes.append(QRectF(x + across, y - up - height, width, height))
    for label, (x, y), box in zip(labels, anchors.tolist(), boxes, strict=True):
        painter.setPen(QPen(QColor(*label.colour), 1.2 * style.scale))
        painter.drawLine(QPointF(x, y), _edge(box, x, y))
        painter.setBrush(QColor(*label.colour))
        painter.drawEllipse(QPointF(x, y), 2.5 * style.scale, 2.5 * style.scale)
    for label, box in zip(labels, boxes, strict=True):
        painter.setPen(QPen(QColor(*label.colour), style.scale))
        painter.setBrush(QColor(*label.background))
        painter.drawRoundedRect(box, 3 * style.scale, 3 * style.scale)
        use_letters(painter, style, label.letters_px)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, label.text)
    painter.restore()


def _edge(box: QRectF, x: float, y: float) -> QPointF:
    """Return the point of a box nearest to its anchor."""
    return QPointF(min(max(x, box.left()), box.right()), min(max(y, box.top()), box.bottom()))
