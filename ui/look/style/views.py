"""Rows of tables and trees, headers, scroll bars, progress bars, splitters and menus."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QIcon, QPainter
from PySide6.QtWidgets import (
    QStyle,
    QStyleOption,
    QStyleOptionHeader,
    QStyleOptionMenuItem,
    QStyleOptionProgressBar,
    QStyleOptionSlider,
    QStyleOptionViewItem,
    QTableView,
    QTreeView,
    QWidget,
)

from ui.look.style.ink import Ink

State = QStyle.StateFlag
Part = QStyle.SubControl
BAR_PX = 10
CELL_PX = 4  # room left and right of what a cell shows
HANDLE_PX = 32
MENU_PADDING_PX, MENU_ICON_PX = 24, 20
MENU_LINE_PX = 36
PROGRESS_PX = 6


def draw_item(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw the ground of one cell."""
    assert isinstance(option, QStyleOptionViewItem)
    if option.backgroundBrush.style() != Qt.BrushStyle.NoBrush:
        painter.fillRect(option.rect, option.backgroundBrush)
    if option.state & State.State_Selected:
        painter.fillRect(option.rect, ink.colour("accent_soft"))
    elif option.state & State.State_MouseOver and option.state & State.State_Enabled:
        painter.fillRect(option.rect, ink.colour("raised"))
    if isinstance(widget, QTableView | QTreeView):
        painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), ink.colour("line"))


def draw_row(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the ground of a whole row, left of its first cell."""
    if option.state & State.State_Selected:
        painter.fillRect(option.rect, ink.colour("accent_soft"))


def draw_header_section(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the ground of one heading."""
    painter.fillRect(option.rect, ink.colour("surface"))
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), ink.colour("line"))


def draw_header_label(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the words of one heading, and the direction in which it sorts."""
    assert isinstance(option, QStyleOptionHeader)
    rect = option.rect.adjusted(5, 0, -5, 0)  # Fusion has kept 2 px free
    if option.sortIndicator != QStyleOptionHeader.SortIndicator.None_:
        ink.chevron(painter, QRect(rect.right() - 10, rect.top(), 12, rect.height()), "down" if _is_descending(option) else "up", "faint")
        rect.adjust(0, 0, -14, 0)
    words = option.fontMetrics.elidedText(option.text, Qt.TextElideMode.ElideRight, rect.width() + 1)
    painter.setPen(ink.colour("soft"))
    painter.drawText(rect, int(option.textAlignment | Qt.AlignmentFlag.AlignVCenter), words)


def _is_descending(option: QStyleOptionHeader) -> bool:
    return bool(option.sortIndicator == QStyleOptionHeader.SortIndicator.SortDown)


def header_size(option: QStyleOption) -> QSize:
    """Return the size that one heading needs."""
    assert isinstance(option, QStyleOptionHeader)
    words = option.fontMetrics.size(0, option.text)
    sorting = 14 if option.sortIndicator != QStyleOptionHeader.SortIndicator.None_ else 0
    return QSize(words.width() + 16 + sorting, words.height() + 17)


def draw_scroll_bar(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw a scroll bar: its handle only."""
    assert isinstance(option, QStyleOptionSlider)
    if option.maximum <= option.minimum:
        return
    handle = QRectF(scroll_bar_part(option, Part.SC_ScrollBarSlider)).adjusted(1, 1, -1, -1)
    warm = bool(option.state & State.State_MouseOver)
    ink.box(painter, handle, "faint" if warm else "line", "", 4.0)


def scroll_bar_part(option: QStyleOption, part: QStyle.SubControl) -> QRect:
    """Return where a part of a scroll bar lies."""
    assert isinstance(option, QStyleOptionSlider)
    rect, upright = option.rect, option.orientation == Qt.Orientation.Vertical
    room = rect.height() if upright else rect.width()
    span = option.maximum - option.minimum
    length = room if span <= 0 else max(min(HANDLE_PX, room), room * option.pageStep // max(1, span + option.pageStep))
    start = QStyle.sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition, room - length, option.upsideDown)
    if part == Part.SC_ScrollBarSlider:
        return _along(rect, start, length, upright)
    if part == Part.SC_ScrollBarSubPage:
        return _along(rect, 0, start, upright)
    if part == Part.SC_ScrollBarAddPage:
        return _along(rect, start + length, room - start - length, upright)
    return rect if part == Part.SC_ScrollBarGroove else QRect()


def _along(rect: QRect, start: int, length: int, upright: bool) -> QRect:
    if upright:
        return QRect(rect.left(), rect.top() + start, rect.width(), length)
    return QRect(rect.left() + start, rect.top(), length, rect.height())


def draw_progress_groove(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the ground of a progress bar."""
    ink.box(painter, option.rect, "sunken", "", min(3.0, option.rect.height() / 2))


def draw_progress(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw how far a progress bar is; without a total, half of it is filled."""
    assert isinstance(option, QStyleOptionProgressBar)
    span = option.maximum - option.minimum
    share = (option.progress - option.minimum) / span if span > 0 else 0.5
    if share > 0:
        rect = QRectF(option.rect)
        rect.setWidth(max(rect.height(), rect.width() * min(1.0, share)))
        ink.box(painter, rect, "accent", "", min(3.0, rect.height() / 2))


def draw_splitter(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the grip of a splitter, clearer under the mouse."""
    middle, warm = option.rect.center(), bool(option.state & State.State_MouseOver)
    upright = option.rect.height() > option.rect.width()
    size = QSize(3, 32) if upright else QSize(32, 3)
    grip = QRectF(middle.x() - size.width() / 2, middle.y() - size.height() / 2, size.width(), size.height())
    ink.box(painter, grip, "faint" if warm else "line", "", 1.5)


def menu_item_size(option: QStyleOption, contents: QSize) -> QSize:
    """Return the size of a line of a menu."""
    assert isinstance(option, QStyleOptionMenuItem)
    if option.menuItemType == QStyleOptionMenuItem.MenuItemType.Separator:
        return QSize(contents.width(), option.fontMetrics.height() + 12 if option.text else 9)
    gap = 24 if "\t" in option.text else 0
    return QSize(contents.width() + 2 * MENU_PADDING_PX + _icon_room(option) + gap, max(MENU_LINE_PX, contents.height() + 8))


def _icon_room(option: QStyleOptionMenuItem) -> int:
    has_mark = option.menuHasCheckableItems or option.maxIconWidth > 0
    return MENU_ICON_PX + 4 if has_mark else 0


def draw_menu_item(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw one line of a menu: mark or icon, words, shortcut, arrow of a submenu."""
    assert isinstance(option, QStyleOptionMenuItem)
    kind, enabled = option.menuItemType, bool(option.state & State.State_Enabled)
    if kind == QStyleOptionMenuItem.MenuItemType.Separator:
        _draw_separator(ink, option, painter)
        return
    if option.state & State.State_Selected and enabled:
        ink.box(painter, option.rect.adjusted(4, 1, -4, -1), "accent_soft", "", 4.0)
    rect = option.rect.adjusted(MENU_PADDING_PX // 2 + 4, 0, -MENU_PADDING_PX // 2 - 4, 0)
    _draw_mark(ink, option, painter, QRect(rect.left(), rect.top(), MENU_ICON_PX, rect.height()), enabled)
    rect.adjust(_icon_room(option), 0, 0, 0)
    words, _, keys = option.text.partition("\t")
    flags = Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextShowMnemonic | Qt.TextFlag.TextSingleLine
    painter.setFont(option.font)
    painter.setPen(ink.colour("text" if enabled else "faint"))
    painter.drawText(rect, int(flags | Qt.AlignmentFlag.AlignLeft), words)
    if keys:
        painter.setPen(ink.colour("soft" if enabled else "faint"))
        painter.drawText(rect, int(flags | Qt.AlignmentFlag.AlignRight), keys)
    if kind == QStyleOptionMenuItem.MenuItemType.SubMenu:
        ink.chevron(painter, QRect(rect.right() - 8, rect.top(), 12, rect.height()), "right")


def _draw_separator(ink: Ink, option: QStyleOptionMenuItem, painter: QPainter) -> None:
    rect = option.rect.adjusted(MENU_PADDING_PX // 2 + 4, 0, -MENU_PADDING_PX // 2 - 4, 0)
    if not option.text:
        painter.fillRect(QRect(option.rect.left() + 1, rect.center().y(), option.rect.width() - 2, 1), ink.colour("line"))
        return
    painter.setPen(ink.colour("soft"))
    painter.drawText(rect, int(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft), option.text)


def _draw_mark(ink: Ink, option: QStyleOptionMenuItem, painter: QPainter, rect: QRect, enabled: bool) -> None:
    if option.checkType != QStyleOptionMenuItem.CheckType.NotCheckable and option.checked:
        ink.check(painter, rect, "accent_text")
    elif not option.icon.isNull():
        corner = QPoint(rect.left(), rect.center().y() - MENU_ICON_PX // 2)
        option.icon.paint(
            painter, QRect(corner, QSize(MENU_ICON_PX, MENU_ICON_PX)), mode=QIcon.Mode.Normal if enabled else QIcon.Mode.Disabled
        )
