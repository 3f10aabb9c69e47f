"""Tiles of the viewpoints in scan order, with their states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QScrollArea, QSizePolicy, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.painting import set_letters, write_elided

WORDS = {
    "waiting": "Waiting",
    "moving": "Moving",
    "settling": "Settling",
    "capturing": "Capturing",
    "checking": "Checking",
    "storing": "Storing",
    "stored": "Stored",
    "processed": "Processed",
    "skipped": "Skipped",
    "failed": "Failed",
}
ACTIVE = ("moving", "settling", "capturing", "checking", "storing")
COLOURS = {
    "waiting": "faint",
    **dict.fromkeys(ACTIVE, "verdict_not_proven"),
    "stored": "accent",
    "processed": "verdict_pass",
    "skipped": "faint",
    "failed": "verdict_fail",
}
SIGNS = {
    **dict.fromkeys(ACTIVE, "scan"),
    "stored": "disk",
    "processed": "pass",
    "skipped": "skip",
    "failed": "fail",
    "moving": "again",
}
MOST_ROWS = 2  # visible at once in a `TileList`
TILE_WIDTH, TILE_HEIGHT, GAP = 152, 56, 8  # wide enough for "34–37 % decoded"


@dataclass(frozen=True)
class Tile:
    """One viewpoint."""

    name: str
    status: str
    note: str = ""
    figure: str = ""  # shown instead of the state, which colour and icon indicate


class ViewpointTiles(QWidget):
    """Draws tiles in rows of the available width; a click chooses one."""

    tileClicked = Signal(str)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.tiles: tuple[Tile, ...] = ()
        self.chosen = ""
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setToolTip(tr("Click a viewpoint to show its images"))
        look.changed.connect(self.update)

    def show_tiles(self, tiles: Sequence[Tile]) -> None:
        """Show these tiles."""
        grown = len(tiles) != len(self.tiles)
        self.tiles = tuple(tiles)
        if grown:
            self.updateGeometry()
        self.update()

    def choose(self, name: str) -> None:
        """Mark a tile; empty: none."""
        self.chosen = name
        self.update()

    def words(self) -> list[str]:
        """Return the state of each tile."""
        return [WORDS[tile.status] for tile in self.tiles]

    def hasHeightForWidth(self) -> bool:
        """The height depends on the width."""
        return True

    def heightForWidth(self, width: int) -> int:
        """Return the height of all rows."""
        rows = -(-len(self.tiles) // self._columns(width))
        return max(TILE_HEIGHT, rows * (TILE_HEIGHT + GAP) - GAP)

    def sizeHint(self) -> QSize:
        """Return the size of one row of four tiles."""
        width = max(self.width(), 4 * (TILE_WIDTH + GAP))
        return QSize(width, self.heightForWidth(width))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the tiles."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for place, tile in enumerate(self.tiles):
            self._draw(painter, self.box(place), tile)

    def box(self, place: int) -> QRectF:
        """Return the rectangle of a tile."""
        columns = self._columns(self.width())
        width = (self.width() - GAP * (columns - 1)) / columns
        line, column = divmod(place, columns)
        return QRectF(column * (width + GAP), line * (TILE_HEIGHT + GAP), width, TILE_HEIGHT)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the tile under the mouse."""
        for place, tile in enumerate(self.tiles):
            if self.box(place).contains(event.position()):
                self.tileClicked.emit(tile.name)

    def _columns(self, width: int) -> int:
        return max(1, min(max(1, len(self.tiles)), (width + GAP) // (TILE_WIDTH + GAP)))

    def _draw(self, painter: QPainter, box: QRectF, tile: Tile) -> None:
        theme = self._look.theme
        colour = theme.colour(COLOURS[tile.status])
        chosen = tile.name == self.chosen
        painter.setPen(QPen(theme.colour("accent" if chosen else "line"), 2.0 if chosen else 1.0))
        painter.setBrush(theme.colour("surface"))
        inset = 1.0 if chosen else 0.5
        painter.drawRoundedRect(box.adjusted(inset, inset, -inset, -inset), 6, 6)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawRoundedRect(QRectF(box.left() + 8, box.top() + 10, 4, box.height() - 20), 2, 2)
        words = box.adjusted(24, 8, -32, -8)
        self._write(painter, words, tile.name, "text", Qt.AlignmentFlag.AlignTop, theme.sizes["body"])
        state = f"{WORDS[tile.status]} · {tile.note}" if tile.note else tile.figure or WORDS[tile.status]
        self._write(painter, words.adjusted(0, 0, 24, 0), state, "soft", Qt.AlignmentFlag.AlignBottom, theme.sizes["small"])
        if tile.status in SIGNS:
            sign = QRectF(box.right() - 28, box.top() + 8, 18, 18).toRect()
            self._look.icon(SIGNS[tile.status], COLOURS[tile.status]).paint(painter, sign)

    def _write(self, painter: QPainter, box: QRectF, words: str, colour: str, edge: Qt.AlignmentFlag, size: int) -> None:
        set_letters(painter, size)
        painter.setPen(self._look.theme.colour(colour))
        write_elided(painter, box, words, edge | Qt.AlignmentFlag.AlignLeft)


class TileList(QScrollArea):
    """`ViewpointTiles` in at most two rows; more are scrolled to, and the one under way stays visible."""

    tileClicked = Signal(str)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._inner = ViewpointTiles(look)
        self._inner.tileClicked.connect(self.tileClicked)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(self._inner)
        self._fit()

    @property
    def tiles(self) -> tuple[Tile, ...]:
        """The tiles shown."""
        return self._inner.tiles

    @property
    def chosen(self) -> str:
        """Name of the chosen tile; empty: none."""
        return self._inner.chosen

    def choose(self, name: str) -> None:
        """Mark a tile; empty: none."""
        self._inner.choose(name)

    def words(self) -> list[str]:
        """Return the state of each tile."""
        return self._inner.words()

    def box(self, place: int) -> QRectF:
        """Return the rectangle of a tile within this widget."""
        return self._inner.box(place).translated(self._inner.pos().x(), self._inner.pos().y())

    def show_tiles(self, tiles: Sequence[Tile]) -> None:
        """Show these tiles."""
        self._inner.show_tiles(tiles)
        self._fit()
        active = next((place for place, tile in enumerate(tiles) if tile.status in ACTIVE), None)
        if active is not None:
            box = self._inner.box(active)
            self.ensureVisible(int(box.center().x()), int(box.center().y()), 0, TILE_HEIGHT // 2)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the tiles anew."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        most = MOST_ROWS * (TILE_HEIGHT + GAP) - GAP
        width = self.width()
        height = self._inner.heightForWidth(width)
        if height > most:
            width -= self.verticalScrollBar().sizeHint().width() + GAP
            height = self._inner.heightForWidth(width)
        self._inner.setFixedSize(max(TILE_WIDTH, width), height)
        self.setFixedHeight(min(height, most))
