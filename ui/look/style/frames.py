"""Frames, panels and tool tips."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QAbstractScrollArea, QFrame, QScrollArea, QStyle, QStyleOption, QStyleOptionFrame, QWidget

from ui.look.style.ink import Ink
from ui.look.style.roles import FRAMES


def draw_frame(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw background and border of a frame by its name, or of a list, table or text."""
    if widget is None:
        return
    look = FRAMES.get(widget.objectName())
    if look is None:
        _draw_plain(ink, option, painter, widget)
        return
    rect = QRectF(option.rect)
    if look.edge:
        painter.fillRect(rect, ink.colour(look.fill))
        painter.fillRect(_edge(rect, look.edge), ink.colour(look.border))
    elif look.pill:
        ink.box(painter, rect, look.fill, look.border, rect.height() / 2)
    elif look.rounded:
        ink.box(painter, rect, look.fill, look.border)
    else:
        painter.fillRect(rect, ink.colour(look.fill))


def _draw_plain(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget) -> None:
    if not isinstance(option, QStyleOptionFrame) or option.frameShape == QFrame.Shape.NoFrame:
        return
    if isinstance(widget, QAbstractScrollArea) and not isinstance(widget, QScrollArea):
        focused = bool(option.state & QStyle.StateFlag.State_HasFocus)
        ink.box(painter, option.rect, "surface", "accent" if focused else "line")


def _edge(rect: QRectF, edge: str) -> QRectF:
    if edge == "top":
        return QRectF(rect.left(), rect.top(), rect.width(), 1)
    if edge == "bottom":
        return QRectF(rect.left(), rect.bottom() - 1, rect.width(), 1)
    if edge == "left":
        return QRectF(rect.left(), rect.top(), 1, rect.height())
    return QRectF(rect.right() - 1, rect.top(), 1, rect.height())


def draw_panel(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw the background of a plain widget that has ``WA_StyledBackground``."""
    look = FRAMES.get(widget.objectName()) if widget is not None else None
    if look is not None:
        draw_frame(ink, option, painter, widget)
    elif widget is not None and widget.objectName() in ("page", "pages"):
        painter.fillRect(option.rect, ink.colour("window"))


def draw_tip(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the panel of a tool tip."""
    painter.fillRect(option.rect, ink.colour("raised"))
    ink.box(painter, option.rect, "", "line", 0.0)


def draw_menu_panel(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the background of a menu."""
    painter.fillRect(option.rect, ink.colour("surface"))
    ink.box(painter, option.rect, "surface", "line", 0.0)
