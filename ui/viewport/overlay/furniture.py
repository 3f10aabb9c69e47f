"""Everything painted over one picture, and what is under the mouse there."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from ui.viewport.layers import Label
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.cube import CORNER_PX, HALF_PX, face_at, paint_cube
from ui.viewport.overlay.flag import Flag, flag_size
from ui.viewport.overlay.flag_layout import Box, FlagPlaces, lay_out_flags
from ui.viewport.overlay.flag_painter import more_box, paint_flags, paint_more
from ui.viewport.overlay.label_painter import paint_labels
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.legend_layout import LegendLayout, lay_out_legend, part_at
from ui.viewport.overlay.legend_painter import paint_legend
from ui.viewport.overlay.scale_bar import paint_scale_bar
from ui.viewport.overlay.style import OverlayStyle, use_letters
from ui.viewport.overlay.triad import paint_triad

ROOMY_PX = (420.0, 300.0)  # smaller pictures have no cube and no scale bar
EDGE_PX, BOTTOM_PX, CUBE_PX = 12.0, 44.0, 108.0
NOTICE_PX, TRIAD_PX = 24.0, 56.0


@dataclass(eq=False)
class Furniture:
    """What is to be painted; the camera and the style are given with each picture."""

    legend: Legend | None = None
    flags: tuple[Flag, ...] = ()
    frame: str = ""  # name of the frame of the triad
    notices: tuple[str, ...] = ()  # upper left: "Clipped"
    progress: str = ""  # lower right, while not all points are shown
    corner: tuple[str, ...] = ()  # lower right, of printed pictures: part and date
    labels: tuple[Label, ...] = ()  # short texts beside their points
    is_visible: bool = True  # the furniture beside legend and flags
    has_flags: bool = True
    hidden: Collection[int] = ()  # flags whose anchor is behind the part
    chosen: str = ""  # key of the selected flag
    hovered: str = ""  # face of the cube
    moving: bool = False  # boxes of flags keep their places while the camera moves
    pinned: dict[str, tuple[float, float]] = field(default_factory=dict)  # middle of dragged boxes, as fractions of the picture
    _kept: FlagPlaces | None = None
    _kept_for: tuple[float, float] = (0.0, 0.0)

    def paint(self, painter: QPainter, camera: CameraView, style: OverlayStyle) -> None:
        """Paint everything over a picture of this camera."""
        if self.is_visible and is_roomy(camera, style):
            paint_triad(painter, camera, style, self.frame)
            panel = self.legend_layout(camera, style)
            paint_scale_bar(painter, camera, style, camera.width if panel is None else panel.panel.left())
            paint_cube(painter, camera, style, self.hovered)
        if self.flags and self.has_flags:
            self._paint_flags(painter, camera, style)
        if self.labels:
            left, _, width, _ = self.free(camera, style)
            paint_labels(painter, self.labels, camera, style, left + width)
        layout = self.legend_layout(camera, style)
        if self.legend is not None and layout is not None:
            paint_legend(painter, self.legend, layout, style)
        self._paint_notices(painter, camera, style)

    def legend_layout(self, camera: CameraView, style: OverlayStyle) -> LegendLayout | None:
        """Return where the legend is; None without one, or where the picture is too small for it."""
        if self.legend is None or not self.is_visible or not is_roomy(camera, style):
            return None
        return lay_out_legend(self.legend, camera.width, camera.height, style, (CUBE_PX - EDGE_PX) * style.scale)

    def free(self, camera: CameraView, style: OverlayStyle) -> Box:
        """Return the room that the furniture leaves for the part, as left, top, width and height."""
        if not self.is_visible or not is_roomy(camera, style):
            return 0.0, 0.0, camera.width, camera.height
        layout = self.legend_layout(camera, style)
        right = layout.panel.left() if layout is not None else camera.width
        top = (NOTICE_PX + 4.0) * style.scale * len(self.notices)
        return 0.0, top, right, camera.height - top - BOTTOM_PX * style.scale

    def flag_places(self, camera: CameraView, style: OverlayStyle) -> FlagPlaces:
        """Return where the boxes are; they stay where they are while the camera moves."""
        size = (camera.width, camera.height)
        if self.moving and self._kept is not None and self._kept_for == size:
            return self._kept
        anchors = camera.pixels(np.array([flag.anchor_mm for flag in self.flags], float).reshape(-1, 3))
        sizes = [(found.width(), found.height()) for found in (flag_size(flag, style) for flag in self.flags)]
        held = {}
        for index, flag in enumerate(self.flags):
            fraction = self.pinned.get(flag.key, flag.pinned)
            if fraction is not None:
                held[index] = (fraction[0] * camera.width, fraction[1] * camera.height)
        self._kept, self._kept_for = lay_out_flags(anchors, sizes, self._flag_room(camera, style), held, self._corner_px(style)), size
        return self._kept

    def forget_places(self) -> None:
        """Lay the flags out anew with the next picture."""
        self._kept = None

    def flag_at(self, place: QPointF, camera: CameraView, style: OverlayStyle) -> int | None:
        """Return the index of the flag whose box is at a place."""
        if not self.flags or not self.has_flags:
            return None
        boxes = self.flag_places(camera, style).boxes
        return next((index for index, box in reversed(boxes.items()) if QRectF(*box).contains(place)), None)

    def collapsed_at(self, place: QPointF, camera: CameraView, style: OverlayStyle) -> tuple[Flag, ...]:
        """Return the flags that had no room in the last picture if their number is at a place; none elsewhere."""
        collapsed = self._kept.collapsed if self._kept is not None and self.flags and self.has_flags else ()
        if not collapsed or not more_box(len(collapsed), self._more_corner(camera, style), style).contains(place):
            return ()
        return tuple(self.flags[index] for index in collapsed)

    def _more_corner(self, camera: CameraView, style: OverlayStyle) -> QPointF:
        left, top, width, height = self._flag_room(camera, style)
        return QPointF(left + width / 2, top + height)

    def legend_part_at(self, place: QPointF, camera: CameraView, style: OverlayStyle) -> str | None:
        """Return the handle of the legend at a place, ``"legend"`` elsewhere on it."""
        layout = self.legend_layout(camera, style)
        return None if layout is None or self.legend is None else part_at(self.legend, layout, place)

    def face_at(self, place: QPointF, camera: CameraView, style: OverlayStyle) -> str:
        """Return the name of the face of the cube at a place; empty beside it."""
        if not self.is_visible or not is_roomy(camera, style):
            return ""
        face = face_at(place, camera, style)
        return "" if face is None else face.name

    def _flag_room(self, camera: CameraView, style: OverlayStyle) -> Box:
        left, top, width, height = self.free(camera, style)
        edge = EDGE_PX * style.scale
        cube = (CORNER_PX + 2 * HALF_PX) * style.scale if self.is_visible and width == camera.width and is_roomy(camera, style) else 0.0
        return left + edge, top + edge, width - 2 * edge - cube, height - 2 * edge

    def _corner_px(self, style: OverlayStyle) -> float:
        return TRIAD_PX * style.scale if self.is_visible else 0.0

    def _paint_flags(self, painter: QPainter, camera: CameraView, style: OverlayStyle) -> None:
        places = self.flag_places(camera, style)
        anchors = camera.pixels(np.array([flag.anchor_mm for flag in self.flags], float).reshape(-1, 3))
        paint_flags(painter, self.flags, anchors, places, style, self.hidden, self.chosen)
        if places.collapsed:
            paint_more(painter, len(places.collapsed), self._more_corner(camera, style), style)

    def _paint_notices(self, painter: QPainter, camera: CameraView, style: OverlayStyle) -> None:
        use_letters(painter, style)
        top = 8.0 * style.scale
        for words in self.notices:
            size = style.measure(words)
            box = QRectF(8 * style.scale, top, size.width() + 16 * style.scale, NOTICE_PX * style.scale)
            painter.setPen(QPen(style.line, style.scale))
            painter.setBrush(style.panel)
            painter.drawRoundedRect(box, 4 * style.scale, 4 * style.scale)
            painter.setPen(style.text)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)
            top += box.height() + 4 * style.scale
        bottom = camera.height - 8.0 * style.scale
        painter.setPen(style.soft)
        for words in reversed((*self.corner, *([self.progress] if self.progress else []))):
            size = style.measure(words)
            painter.drawText(QPointF(camera.width - size.width() - 12 * style.scale, bottom), words)
            bottom -= size.height()


def is_roomy(camera: CameraView, style: OverlayStyle) -> bool:
    """Whether the picture is large enough for cube, scale bar and legend."""
    return camera.width >= ROOMY_PX[0] * style.scale and camera.height >= ROOMY_PX[1] * style.scale
