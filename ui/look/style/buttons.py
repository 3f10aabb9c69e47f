"""Push buttons, tool buttons, check boxes and radio buttons."""

from __future__ import annotations

from PySide6.QtCore import QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QIcon, QPainter
from PySide6.QtWidgets import QStyle, QStyleOption, QStyleOptionButton, QStyleOptionToolButton, QWidget

from ui.look.style.ink import Ink, rounded_on
from ui.look.style.roles import BUTTONS, ButtonLook

State = QStyle.StateFlag
MENU_ARROW_PX = 16
GAP_PX = 4
TEXT = Qt.TextFlag.TextShowMnemonic | Qt.TextFlag.TextSingleLine


def button_look(widget: QWidget | None) -> ButtonLook:
    """Return the look of a push button by its role."""
    role = widget.property("role") if widget is not None else None
    return BUTTONS.get(role or "normal", BUTTONS["normal"])


def button_size(contents: QSize, widget: QWidget | None) -> QSize:
    """Return the size of a push button with these contents."""
    look = button_look(widget)
    return QSize(contents.width() + 2 * look.padding_px + 2, max(contents.height() + 2, look.height_px))


def draw_button(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw a push button."""
    assert isinstance(option, QStyleOptionButton)
    look, state = button_look(widget), option.state
    enabled, checked = bool(state & State.State_Enabled), bool(state & State.State_On)
    fill, border = _ground(look, state)
    if widget is not None and widget.property("role") == "segment":
        _draw_segment(ink, option, painter, widget, fill)
    else:
        ringed = border == look.focus_border and bool(state & State.State_HasFocus)
        ink.box(painter, option.rect, fill, border, width=2.0 if ringed and state & State.State_KeyboardFocusChange else 1.0)
    text = look.checked_text if enabled and checked else look.text if enabled else "soft" if checked else "faint"
    _draw_contents(ink, option, painter, look, text)


def _ground(look: ButtonLook, state: QStyle.StateFlag) -> tuple[str, str]:
    """Return fill and border in this state."""
    if not state & State.State_Enabled:
        is_chosen = bool(state & State.State_On) and bool(look.checked_fill)  # what is chosen is seen also where it cannot be changed
        return ("line" if is_chosen else "sunken" if look.fill else "", "line" if look.border else "")
    border = look.focus_border if state & State.State_HasFocus else look.border
    if state & State.State_Sunken:
        return look.pressed_fill, border
    if state & State.State_On:
        return look.checked_fill, border
    if state & State.State_MouseOver:
        return look.hover_fill, border if state & State.State_HasFocus else look.hover_border
    return look.fill, border


def _draw_segment(ink: Ink, option: QStyleOptionButton, painter: QPainter, widget: QWidget, fill: str) -> None:
    """Draw one of a row of buttons that share their borders."""
    place, state = widget.property("place"), option.state
    first, last = place == "first", place == "last"
    checked, focused = bool(state & State.State_On), bool(state & State.State_HasFocus)
    border = "line" if not state & State.State_Enabled else "text" if focused else "accent" if checked else "line"
    rect = QRectF(option.rect).adjusted(0.5, 0.5, -0.5 if last or checked or focused else 0.5, -0.5)
    ink.shape(painter, rounded_on(rect, ink.corner, left=first, right=last), fill, border)


def _draw_contents(ink: Ink, option: QStyleOptionButton, painter: QPainter, look: ButtonLook, token: str) -> None:
    rect = option.rect.adjusted(look.padding_px, 0, -look.padding_px, 0)
    has_menu = bool(option.features & QStyleOptionButton.ButtonFeature.HasMenu)
    if has_menu:
        arrow = QRect(rect.right() - MENU_ARROW_PX + 5, rect.top(), MENU_ARROW_PX, rect.height())
        ink.chevron(painter, arrow, "down", token if token != "text" else "soft")
        rect.adjust(0, 0, -MENU_ARROW_PX + 4, 0)
    words = option.fontMetrics.size(TEXT, option.text).width() if option.text else 0
    icon = 0 if option.icon.isNull() else option.iconSize.width()
    gap = GAP_PX if icon and words else 0
    left = rect.left() if look.left else rect.left() + max(0, (rect.width() - icon - gap - words) // 2)
    if icon:
        mode = QIcon.Mode.Normal if option.state & State.State_Enabled else QIcon.Mode.Disabled
        top = rect.center().y() - option.iconSize.height() // 2 + 1
        option.icon.paint(painter, QRect(left, top, icon, option.iconSize.height()), Qt.AlignmentFlag.AlignCenter, mode)
        left += icon + gap
    if words:
        painter.setPen(ink.colour(token))
        box = QRect(left, rect.top(), max(words, rect.right() + 1 - left) if look.left else words + 1, rect.height())
        painter.drawText(box, int(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft | TEXT), option.text)


def draw_tool_button(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw a tool button; those of the rail have the icon above the word."""
    assert isinstance(option, QStyleOptionToolButton)
    state = option.state
    is_rail = widget is not None and widget.property("role") == "rail"
    checked, enabled = bool(state & State.State_On), bool(state & State.State_Enabled)
    fill = "accent_soft" if checked else "sunken" if state & State.State_MouseOver and enabled else ""
    ink.box(painter, option.rect, fill, "accent" if state & State.State_HasFocus else "")
    token = "faint" if not enabled else "accent_text" if checked else "soft" if is_rail else "text"
    mode = QIcon.Mode.Normal if enabled else QIcon.Mode.Disabled
    if is_rail or option.toolButtonStyle == Qt.ToolButtonStyle.ToolButtonTextUnderIcon:
        _draw_stacked(option, painter, ink.colour(token), checked, mode)
        return
    _draw_tool_contents(ink, option, painter, token, mode)


def _draw_stacked(option: QStyleOptionToolButton, painter: QPainter, colour: QColor, bold: bool, mode: QIcon.Mode) -> None:
    size, rect = option.iconSize, option.rect
    height = option.fontMetrics.height()
    top = rect.top() + max(2, (rect.height() - size.height() - 4 - height) // 2 + 1)
    option.icon.paint(painter, QRect(rect.center().x() - size.width() // 2, top, size.width(), size.height()), mode=mode)
    painter.save()
    font = QFont(option.font)
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    painter.setFont(font)
    painter.setPen(colour)
    box = QRect(rect.left(), top + size.height() + 4, rect.width(), height)
    painter.drawText(box, int(Qt.AlignmentFlag.AlignCenter | TEXT), option.text)
    painter.restore()


def _draw_tool_contents(ink: Ink, option: QStyleOptionToolButton, painter: QPainter, token: str, mode: QIcon.Mode) -> None:
    rect = option.rect.adjusted(5, 5, -5, -5)
    if option.arrowType != Qt.ArrowType.NoArrow:
        arrows = {Qt.ArrowType.DownArrow: "down", Qt.ArrowType.UpArrow: "up", Qt.ArrowType.RightArrow: "right"}
        ink.chevron(painter, rect, arrows.get(option.arrowType, "down"), token)
    elif not option.icon.isNull() and option.toolButtonStyle != Qt.ToolButtonStyle.ToolButtonTextOnly:
        beside = option.toolButtonStyle == Qt.ToolButtonStyle.ToolButtonTextBesideIcon and bool(option.text)
        spot = QRect(rect.left(), rect.top(), option.iconSize.width(), rect.height()) if beside else rect
        option.icon.paint(painter, spot, Qt.AlignmentFlag.AlignCenter, mode)
        if beside:
            _write(painter, rect.adjusted(option.iconSize.width() + GAP_PX, 0, 0, 0), option.text, ink.colour(token))
    else:
        _write(painter, rect, option.text, ink.colour(token))


def _write(painter: QPainter, rect: QRect, words: str, colour: QColor) -> None:
    painter.setPen(colour)
    painter.drawText(rect, int(Qt.AlignmentFlag.AlignCenter | TEXT), words)


def draw_check(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the box of a check box."""
    fill, border = _mark_ground(option)
    ink.box(painter, option.rect, fill, border, 4.0)
    if option.state & State.State_On:
        ink.check(painter, option.rect)
    elif option.state & State.State_NoChange:
        painter.fillRect(QRectF(option.rect.center().x() - 4, option.rect.center().y(), 9, 2), ink.colour("soft"))


def draw_radio(ink: Ink, option: QStyleOption, painter: QPainter, _widget: QWidget | None) -> None:
    """Draw the circle of a radio button."""
    fill, border = _mark_ground(option)
    radius = option.rect.width() / 2
    ink.box(painter, option.rect, fill, border, radius)
    if option.state & State.State_On:
        ink.box(painter, QRectF(option.rect).adjusted(5, 5, -5, -5), "accent_on", "", radius)


def _mark_ground(option: QStyleOption) -> tuple[str, str]:
    state = option.state
    enabled = bool(state & State.State_Enabled)
    if state & State.State_On:
        return ("accent", "accent") if enabled else ("faint", "faint")
    warm = enabled and bool(state & (State.State_HasFocus | State.State_MouseOver))
    return "surface", "accent" if warm else "faint" if enabled else "line"
