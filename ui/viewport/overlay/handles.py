"""Painters of what belongs to a gesture: rectangle of the box zoom, centre of rotation, clip box."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ui.viewport.clip_box import ClipBox
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.style import OverlayStyle
from ui.viewport.overlay.triad import AXES

CENTRE_PX, HANDLE_PX, REACH_PX = 22.0, 7.0, 12.0


def paint_box_zoom(painter: QPainter, one: QPointF, other: QPointF, style: OverlayStyle) -> None:
    """Draw the rectangle that will fill the picture."""
    fill = QColor(style.accent)
    fill.setAlpha(40)
    painter.setPen(QPen(style.accent, 1.4 * style.scale, Qt.PenStyle.DashLine))
    painter.setBrush(fill)
    painter.drawRect(QRectF(one, other).normalized())


def paint_centre(painter: QPainter, camera: CameraView, centre_mm: np.ndarray, style: OverlayStyle) -> None:
    """Draw small axes at the centre of rotation."""
    middle = QPointF(*(float(value) for value in camera.pixels(centre_mm[None])[0]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for place, (_, colour) in enumerate(AXES):
        right, up = (float(value) * CENTRE_PX * style.scale for value in camera.rotation[:2, place])
        painter.setPen(QPen(colour, 2.0 * style.scale))
        painter.drawLine(middle - QPointF(right, -up), middle + QPointF(right, -up))


def paint_clip_handles(painter: QPainter, camera: CameraView, clip: ClipBox, style: OverlayStyle) -> None:
    """Draw the clip box with a handle on each face."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(style.accent, 1.0 * style.scale, Qt.PenStyle.DashLine))
    for edge in clip.edges():
        one, other = camera.pixels(edge)
        painter.drawLine(QPointF(*map(float, one)), QPointF(*map(float, other)))
    half = HANDLE_PX * style.scale
    painter.setPen(QPen(style.accent, 1.6 * style.scale))
    for face, (x, y) in enumerate(camera.pixels(clip.face_middles()).tolist()):
        towards = float(camera.rotation[2] @ clip.normal(face)) > 0
        painter.setBrush(style.accent if towards else style.surface)
        painter.drawRoundedRect(QRectF(x - half, y - half, 2 * half, 2 * half), 2 * style.scale, 2 * style.scale)


def clip_handle_at(place: QPointF, camera: CameraView, clip: ClipBox, style: OverlayStyle) -> int | None:
    """Return the face whose handle is at a place; of several the one nearest to the viewer."""
    middles = clip.face_middles()
    gaps = camera.pixels(middles) - np.array([place.x(), place.y()])
    near = np.flatnonzero(np.hypot(*gaps.T) <= REACH_PX * style.scale)
    return int(near[np.argmax((middles @ camera.rotation[2])[near])]) if len(near) else None


def dragged_face(clip: ClipBox, face: int, moved: QPointF, camera: CameraView) -> ClipBox:
    """Return the box after the handle of a face was dragged by a distance on the picture."""
    middle, normal = clip.face_middles()[face], clip.normal(face)
    ends = camera.pixels(np.stack([middle, middle + normal]))
    along = ends[1] - ends[0]  # pixels per mm
    square = float(along @ along)
    if square < 1e-6:  # the face is seen from the front: it cannot be moved in the picture
        return clip
    distance = float(along @ np.array([moved.x(), moved.y()])) / square
    axis = face // 2
    return clip.with_face(face, float(middle[axis] + normal[axis] * distance))
