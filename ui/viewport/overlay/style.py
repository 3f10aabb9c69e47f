"""Colours and sizes of what is painted over a picture."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from PySide6.QtCore import QSizeF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from ui.look.theme import Theme, font

VERDICTS = ("pass", "fail", "not proven", "not measured")
PANEL_ALPHA = 232


@dataclass(frozen=True)
class OverlayStyle:
    """Colours of the theme; ``scale`` enlarges letters and lines, for printed pictures."""

    text: QColor
    soft: QColor
    faint: QColor
    line: QColor
    surface: QColor
    accent: QColor
    verdicts: Mapping[str, QColor]
    scale: float = 1.0

    @classmethod
    def of(cls, theme: Theme, scale: float = 1.0) -> OverlayStyle:
        """Return the style of a theme."""
        names = ("text", "soft", "faint", "line", "surface", "accent")
        return cls(*(theme.colour(name) for name in names), {verdict: theme.verdict(verdict) for verdict in VERDICTS}, scale)

    @property
    def panel(self) -> QColor:
        """Colour behind texts; the picture shows through slightly."""
        made = QColor(self.surface)
        made.setAlpha(PANEL_ALPHA)
        return made

    def font(self, size_px: float = 12.0, *, bold: bool = False) -> QFont:
        """Return the font of a size at scale 1."""
        return _font(max(6, round(size_px * self.scale)), bold)

    def measure(self, words: str, size_px: float = 12.0, *, bold: bool = False) -> QSizeF:
        """Return width and height of one line of text."""
        return QSizeF(*_measured(words, max(6, round(size_px * self.scale)), bold))


def use_letters(painter: QPainter, style: OverlayStyle, size_px: float = 12.0, *, bold: bool = False) -> None:
    """Set the font of the following texts."""
    painter.setFont(style.font(size_px, bold=bold))


@lru_cache(maxsize=64)
def _font(size_px: int, bold: bool) -> QFont:
    return font(size_px, bold=bold)


@lru_cache(maxsize=4096)
def _measured(words: str, size_px: int, bold: bool) -> tuple[float, float]:
    metrics = QFontMetricsF(_font(size_px, bold))
    return metrics.horizontalAdvance(words), metrics.height()
