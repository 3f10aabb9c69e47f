"""View cube in the upper right corner: shows the orientation, and a click on a face looks at it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF, QTransform

from ui.look.language.words import translated
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.style import OverlayStyle, use_letters

HALF_PX, CORNER_PX = 24.0, 52.0
LETTERS = 26  # units of the square in which a face's word is written
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Face:
    """One face: its word, its outward normal, and the direction that is up on it."""

    name: str
    word: str
    normal: Vector
    up: Vector


FACES = (
    Face("front", "Front", (0, -1, 0), (0, 0, 1)),
    Face("back", "Rear", (0, 1, 0), (0, 0, 1)),
    Face("left", "Left", (-1, 0, 0), (0, 0, 1)),
    Face("right", "Right", (1, 0, 0), (0, 0, 1)),
    Face("top", "Top", (0, 0, 1), (0, 1, 0)),
    Face("bottom", "Bottom", (0, 0, -1), (0, -1, 0)),
)


def face_corners(face: Face, camera: CameraView, style: OverlayStyle) -> QPolygonF:
    """Return the four corners of a face in the picture: upper left first, clockwise as seen from outside."""
    normal, up = np.array(face.normal, float), np.array(face.up, float)
    right = np.cross(up, normal)
    middle = cube_middle(camera, style)
    corners = []
    for across, along in ((-1, 1), (1, 1), (1, -1), (-1, -1)):
        place = camera.rotation @ (normal + across * right + along * up) * HALF_PX * style.scale
        corners.append(middle + QPointF(float(place[0]), -float(place[1])))
    return QPolygonF(corners)


def cube_middle(camera: CameraView, style: OverlayStyle) -> QPointF:
    """Return the middle of the cube in the picture."""
    return QPointF(camera.width - CORNER_PX * style.scale, CORNER_PX * style.scale)


def visible_faces(camera: CameraView) -> list[Face]:
    """Return the faces that are turned towards the viewer, the most oblique first."""
    towards = {face.name: float(camera.rotation[2] @ np.array(face.normal, float)) for face in FACES}
    return sorted((face for face in FACES if towards[face.name] > 0.02), key=lambda face: towards[face.name])


def face_at(place: QPointF, camera: CameraView, style: OverlayStyle) -> Face | None:
    """Return the face at a place of the picture."""
    for face in reversed(visible_faces(camera)):
        if face_corners(face, camera, style).containsPoint(place, Qt.FillRule.OddEvenFill):
            return face
    return None


def paint_cube(painter: QPainter, camera: CameraView, style: OverlayStyle, hovered: str = "") -> None:
    """Draw the visible faces with their words."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for face in visible_faces(camera):
        corners = face_corners(face, camera, style)
        towards = float(camera.rotation[2] @ np.array(face.normal, float))
        fill = QColor(style.accent) if face.name == hovered else QColor(style.surface)
        fill.setAlpha(150 if face.name == hovered else round(150 + 90 * towards))
        painter.setPen(QPen(style.faint, style.scale))
        painter.setBrush(fill)
        painter.drawPolygon(corners)
        _write(painter, face, corners, style, towards)
    painter.restore()


def _write(painter: QPainter, face: Face, corners: QPolygonF, style: OverlayStyle, towards: float) -> None:
    """Write a face's word in its plane; on a very oblique face it would be unreadable."""
    if towards < 0.35:
        return
    square = QPolygonF([QPointF(0, 0), QPointF(2 * LETTERS, 0), QPointF(2 * LETTERS, 2 * LETTERS), QPointF(0, 2 * LETTERS)])
    turned = QTransform.quadToQuad(square, corners)
    if not isinstance(turned, QTransform):
        return
    painter.save()
    painter.setTransform(turned, True)
    use_letters(painter, OverlayStyle(**{**style.__dict__, "scale": 1.0}), 14, bold=True)
    painter.setPen(style.text)
    width = painter.fontMetrics().horizontalAdvance(translated(face.word))
    if width > 2 * LETTERS - 4:  # longer words of other languages
        shrink = (2 * LETTERS - 4) / width
        painter.translate(LETTERS, LETTERS)
        painter.scale(shrink, shrink)
        painter.translate(-LETTERS, -LETTERS)
    painter.drawText(QPointF(LETTERS - width / 2, LETTERS + 5), translated(face.word))
    painter.restore()
