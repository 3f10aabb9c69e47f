"""A feature control frame as a picture that follows what is chosen, and the symbols of the characteristics as icons."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QIcon, QPainter, QPaintEvent, QPen, QPixmap
from PySide6.QtWidgets import QWidget

from measureapp.data.control_frame import ControlFrame
from ui.look.look import Look
from ui.viewport.overlay.control_frame import CELL_PX, frame_width, paint_frame, symbol_path
from ui.viewport.overlay.style import OverlayStyle

MARGIN_PX, ICON_PX, ICON_INSET_PX, SHARPNESS = 6, 16, 2, 2


class FramePicture(QWidget):
    """Draws one frame as the table and the report draw it."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.frame: ControlFrame | None = None
        self.setFixedHeight(int(CELL_PX) + 2 * MARGIN_PX)
        look.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Return room for the whole frame."""
        width = 0.0 if self.frame is None else frame_width(self.frame, OverlayStyle.of(self._look.theme))
        return QSize(int(width) + 2 * MARGIN_PX, self.height())

    def show_frame(self, frame: ControlFrame | None) -> None:
        """Draw this frame; None: nothing."""
        self.frame = frame
        self.setAccessibleName("" if frame is None else " | ".join((frame.characteristic, *frame.words())))
        self.updateGeometry()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the frame."""
        if self.frame is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        style, theme = OverlayStyle.of(self._look.theme), self._look.theme
        paint_frame(painter, self.frame, QPointF(MARGIN_PX + 0.5, MARGIN_PX + 0.5), style, theme.colour("text"))


def symbol_icon(characteristic: str, look: Look) -> QIcon:
    """Return the symbol of a characteristic in the colour of texts."""
    picture = QPixmap(SHARPNESS * ICON_PX, SHARPNESS * ICON_PX)
    picture.setDevicePixelRatio(SHARPNESS)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(look.theme.colour("text"), 1.4))
    side = ICON_PX - 2 * ICON_INSET_PX
    painter.drawPath(symbol_path(characteristic, QRectF(ICON_INSET_PX, ICON_INSET_PX, side, side)))
    painter.end()
    return QIcon(picture)
