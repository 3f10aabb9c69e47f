"""Icons of one set (Phosphor), one stroke width, drawn as vectors in the theme's colours."""

from __future__ import annotations

from collections.abc import Callable
from weakref import ref

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPixmap

NAMES = {
    "rig": "robot",
    "calibration": "crosshair",
    "plan": "map-trifold",
    "scan": "aperture",
    "clouds": "circles-three-plus",
    "inspection": "ruler",
    "report": "file-text",
    "run": "play",
    "pause": "pause",
    "skip": "skip-forward",
    "cancel": "x-circle",
    "stop": "hand-palm",
    "connect": "link",
    "disconnect": "link-break",
    "live": "video-camera",
    "home": "house-line",
    "minus": "minus",
    "plus": "plus",
    "open": "folder-open",
    "file": "cube",
    "add": "plus-circle",
    "again": "arrows-clockwise",
    "export": "download-simple",
    "pdf": "file-pdf",
    "fit": "corners-out",
    "holes": "image-square",
    "images": "stack",
    "profile": "chart-line",
    "labels": "tag",
    "section": "knife",
    "filter": "funnel",
    "grow": "arrows-out",
    "eye": "eye",
    "hidden": "eye-slash",
    "keyboard": "keyboard",
    "light": "sun",
    "dark": "moon",
    "help": "question",
    "devices": "share-network",
    "disk": "hard-drives",
    "person": "user",
    "fold": "caret-right",
    "unfold": "caret-left",
    "pass": "check",
    "fail": "x",
    "not proven": "question",
    "not measured": "minus",
    "no tolerance": "circle",
    "info": "info",
    "warning": "warning",
    "error": "warning-circle",
    "messages": "list",
    "remove": "trash",
    "undo": "arrow-u-up-left",
    "redo": "arrow-u-up-right",
    "hand-eye": "link",
    "axis": "arrows-clockwise",
    "guide": "arrows-left-right",
    "copy": "copy",
    "ungroup": "arrows-out-simple",
    "up": "arrow-up",
    "down": "arrow-down",
    "camera": "camera",
}
FAINT = QColor(138, 149, 156, 120)  # of a disabled icon, on either theme


class IconSet:
    """Icons that take their colour from the theme when they are painted; the drawing of each colour and size is kept."""

    def __init__(self, colour_of: Callable[[str], QColor]) -> None:
        """``colour_of``: returns the present colour of a token."""
        self._colour_of = colour_of
        self._icons: dict[tuple[str, str], QIcon] = {}
        self._drawn: dict[tuple[str, int, int, int], QPixmap] = {}

    def icon(self, name: str, token: str) -> QIcon:
        """Return one icon of the set in the colour of a token."""
        found = self._icons.get((name, token))
        if found is None:
            found = self._icons[name, token] = QIcon(ThemedIcon(self, NAMES[name], token))
        return found

    def pixmap(self, glyph: str, token: str, width: int, height: int, *, enabled: bool) -> QPixmap:
        """Return the drawing of a glyph; sizes in pixels of the device."""
        colour = self._colour_of(token) if enabled else FAINT
        key = (glyph, colour.rgba(), width, height)
        found = self._drawn.get(key)
        if found is None:
            found = self._drawn[key] = _drawn(glyph, colour, width, height)
        return found


class ThemedIcon(QIconEngine):
    """Paints one glyph in the present colour of a token, as long as its set exists."""

    def __init__(self, icons: IconSet, glyph: str, token: str) -> None:
        super().__init__()
        self._icons = ref(icons)  # the set holds the icon through Qt, where no collection finds the circle
        self._glyph, self._token = glyph, token

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        """Paint the icon."""
        ratio = painter.device().devicePixelRatioF()
        size = QSize(round(rect.width() * ratio), round(rect.height() * ratio))
        painter.drawPixmap(rect, self.pixmap(size, mode, state))

    def pixmap(self, size: QSize, mode: QIcon.Mode, _state: QIcon.State) -> QPixmap:
        """Return the icon as a picture."""
        icons = self._icons()
        if icons is None:
            return QPixmap()
        return icons.pixmap(self._glyph, self._token, size.width(), size.height(), enabled=mode != QIcon.Mode.Disabled)


def _drawn(glyph: str, colour: QColor, width: int, height: int) -> QPixmap:
    import qtawesome

    pixmap = QPixmap(width, height)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    qtawesome.icon(f"ph.{glyph}", color=colour).paint(painter, QRect(0, 0, width, height))
    painter.end()
    return pixmap
