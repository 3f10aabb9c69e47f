"""Strip of thumbnails of observations with figure, verdict and reason."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QHelpEvent, QImage, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QScrollArea, QSizePolicy, QToolTip, QWidget

from ui.look.look import Look
from ui.look.painting import set_letters, write_elided

WIDTH, PICTURE, TEXT, GAP = 128, 80, 40, 8
STRIP_HEIGHT = PICTURE + TEXT + 24


@dataclass(frozen=True, eq=False)
class Thumbnail:
    """One observation."""

    id: str
    image: QImage
    figure: str  # its residual or status
    verdict: str  # "pass", "fail", "not proven", "not measured"
    name: str
    reason: str = ""
    removed: bool = False


class _Strip(QWidget):
    """Draws the thumbnails inside the scroll area."""

    chosen = Signal(str)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.thumbnails: tuple[Thumbnail, ...] = ()
        self.current = ""
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        look.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Return the size of all thumbnails."""
        return QSize(len(self.thumbnails) * (WIDTH + GAP), PICTURE + TEXT)

    def box(self, place: int) -> QRectF:
        """Return the rectangle of a thumbnail."""
        return QRectF(place * (WIDTH + GAP), 0, WIDTH, PICTURE + TEXT)

    def at(self, x: float) -> Thumbnail | None:
        """Return the thumbnail at a position along the strip."""
        place = int(x // (WIDTH + GAP))
        return self.thumbnails[place] if 0 <= place < len(self.thumbnails) and x % (WIDTH + GAP) <= WIDTH else None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the thumbnail under the mouse."""
        found = self.at(event.position().x())
        if found is not None:
            self.chosen.emit(found.id)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go to the next or the previous thumbnail."""
        step = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()))
        ids = [thumbnail.id for thumbnail in self.thumbnails]
        if step is None or not ids:
            super().keyPressEvent(event)
            return
        place = ids.index(self.current) + step if self.current in ids else 0
        self.chosen.emit(ids[min(max(0, place), len(ids) - 1)])

    def event(self, event: QEvent) -> bool:
        """Show the reason of the thumbnail under the mouse as a tooltip."""
        if isinstance(event, QHelpEvent):
            found = self.at(event.pos().x())
            QToolTip.showText(event.globalPos(), f"{found.name}: {found.reason or found.figure}" if found is not None else "", self)
            return True
        return super().event(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the visible thumbnails."""
        painter = QPainter(self)
        painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
        for place, thumbnail in enumerate(self.thumbnails):
            box = self.box(place)
            if box.intersects(QRectF(event.rect())):
                self._draw(painter, box, thumbnail)

    def _draw(self, painter: QPainter, box: QRectF, thumbnail: Thumbnail) -> None:
        theme = self._look.theme
        picture = QRectF(box.left(), box.top(), box.width(), PICTURE)
        frame = QPainterPath()
        frame.addRoundedRect(picture.adjusted(1, 1, -1, -1), 6, 6)
        painter.save()
        painter.setClipPath(frame)
        painter.fillRect(picture, theme.colour("sunken"))
        painter.setOpacity(0.25 if thumbnail.removed else 1.0)
        if not thumbnail.image.isNull():
            fitted = thumbnail.image.size().scaled(picture.size().toSize(), Qt.AspectRatioMode.KeepAspectRatioByExpanding)
            target = QRectF(0, 0, fitted.width(), fitted.height())
            target.moveCenter(picture.center())
            painter.drawImage(target, thumbnail.image)
        painter.restore()
        chosen = thumbnail.id == self.current
        painter.setPen(QPen(theme.colour("accent") if chosen else theme.verdict(thumbnail.verdict), 3 if chosen else 2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(frame)
        self._look.icon(thumbnail.verdict, "verdict_" + thumbnail.verdict.replace(" ", "_")).paint(
            painter, QRectF(box.left(), box.top() + PICTURE + 4, 18, 18).toRect()
        )
        words = box.adjusted(22, PICTURE + 3, 0, 0)
        self._write(painter, QRectF(words.left(), words.top(), words.width(), 18), thumbnail.figure, "text")
        below = QRectF(box.left(), words.top() + 18, box.width(), 18)
        self._write(painter, below, thumbnail.name, "soft")

    def _write(self, painter: QPainter, box: QRectF, words: str, colour: str) -> None:
        set_letters(painter, self._look.theme.sizes["small"])
        painter.setPen(self._look.theme.colour(colour))
        write_elided(painter, box, words)


class ThumbnailStrip(QScrollArea):
    """Thumbnails that scroll sideways; a click or the arrow keys choose one."""

    chosen = Signal(str)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._strip = _Strip(look)
        self.setWidget(self._strip)
        self.setFixedHeight(STRIP_HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.viewport().setAutoFillBackground(False)
        self._strip.setAutoFillBackground(False)
        self._strip.chosen.connect(self.chosen)

    @property
    def thumbnails(self) -> tuple[Thumbnail, ...]:
        """The thumbnails shown."""
        return self._strip.thumbnails

    @property
    def current(self) -> str:
        """The id of the chosen thumbnail."""
        return self._strip.current

    def show_thumbnails(self, thumbnails: Sequence[Thumbnail]) -> None:
        """Show these thumbnails; if the newest is visible, the strip scrolls to new ones."""
        bar = self.horizontalScrollBar()
        follows = bar.value() >= bar.maximum() - WIDTH
        grown = len(thumbnails) > len(self._strip.thumbnails)
        self._strip.thumbnails = tuple(thumbnails)
        self._strip.resize(self._strip.sizeHint())
        self._strip.update()
        if grown and follows:
            bar.setValue(bar.maximum())

    def choose(self, id_: str) -> None:
        """Mark one thumbnail and scroll to it."""
        self._strip.current = id_
        for place, thumbnail in enumerate(self._strip.thumbnails):
            if thumbnail.id == id_:
                middle = self._strip.box(place).center().toPoint()
                self.ensureVisible(middle.x(), middle.y(), WIDTH, 0)
        self._strip.update()
