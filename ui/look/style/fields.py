"""Line edits, combo boxes and spin boxes."""

from __future__ import annotations

from PySide6.QtCore import QRect, QSize
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QStyle,
    QStyleOption,
    QStyleOptionComboBox,
    QStyleOptionSpinBox,
    QWidget,
)

from ui.look.style.ink import Ink

State = QStyle.StateFlag
Part = QStyle.SubControl
ARROWS_PX = 28
PADDING_PX = 7
SPIN_MARGIN_PX = 6  # of the text within the line edit of a spin box
HEIGHT_PX = 32


def draw_field(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw the box of an editor."""
    if is_bare(widget):
        return
    state = option.state
    if widget is not None and widget.property("invalid"):
        border = "verdict_fail"
    elif state & State.State_HasFocus:
        border = "accent"
    else:
        border = "faint" if state & State.State_MouseOver and state & State.State_Enabled else "line"
    ink.box(painter, option.rect, "surface", border)


def is_bare(widget: QWidget | None) -> bool:
    """Return whether a line edit lies within another editor, which draws its box."""
    return isinstance(widget, QLineEdit) and (isinstance(widget.parent(), QAbstractSpinBox | QComboBox) or not widget.hasFrame())


def is_plain(widget: QWidget | None) -> bool:
    """Return whether a spin box has no arrows."""
    bare = isinstance(widget, QAbstractSpinBox) and widget.buttonSymbols() == QAbstractSpinBox.ButtonSymbols.NoButtons
    return bare or (widget is not None and bool(widget.property("plain")))


def draw_spin_box(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw a spin box; its line edit draws the number."""
    assert isinstance(option, QStyleOptionSpinBox)
    draw_field(ink, option, painter, widget)
    if is_plain(widget):
        return
    enabled = bool(option.state & State.State_Enabled)
    for part, direction, step in (
        (Part.SC_SpinBoxUp, "up", QAbstractSpinBox.StepEnabledFlag.StepUpEnabled),
        (Part.SC_SpinBoxDown, "down", QAbstractSpinBox.StepEnabledFlag.StepDownEnabled),
    ):
        can_step = enabled and bool(option.stepEnabled & step)
        ink.chevron(painter, spin_box_part(option.rect, part, widget), direction, "soft" if can_step else "line")


def spin_box_part(rect: QRect, part: QStyle.SubControl, widget: QWidget | None) -> QRect:
    """Return where a part of a spin box lies."""
    plain = is_plain(widget)
    if part == Part.SC_SpinBoxEditField:
        return rect.adjusted(1, 1, -1 if plain else -ARROWS_PX - 1, -1)
    if part == Part.SC_SpinBoxFrame:
        return rect
    if plain:
        return QRect()
    half = rect.height() // 2
    up = QRect(rect.right() - ARROWS_PX, rect.top() + 2, ARROWS_PX, half - 2)
    return up if part == Part.SC_SpinBoxUp else QRect(up.left(), rect.top() + half, ARROWS_PX, half - 2)


def draw_combo_box(ink: Ink, option: QStyleOption, painter: QPainter, widget: QWidget | None) -> None:
    """Draw a combo box; its label is drawn apart."""
    assert isinstance(option, QStyleOptionComboBox)
    draw_field(ink, option, painter, widget)
    enabled = bool(option.state & State.State_Enabled)
    ink.chevron(painter, combo_box_part(option.rect, Part.SC_ComboBoxArrow), "down", "soft" if enabled else "line")


def combo_box_part(rect: QRect, part: QStyle.SubControl) -> QRect:
    """Return where a part of a combo box lies."""
    if part == Part.SC_ComboBoxEditField:
        return rect.adjusted(PADDING_PX + 1, 1, -ARROWS_PX, -1)
    if part == Part.SC_ComboBoxArrow:
        return QRect(rect.right() - ARROWS_PX, rect.top(), ARROWS_PX, rect.height())
    return rect


def line_edit_size(contents: QSize) -> QSize:
    """Return the size of a line edit."""
    return QSize(contents.width() + 2 * PADDING_PX, max(contents.height(), HEIGHT_PX))


def combo_box_size(contents: QSize) -> QSize:
    """Return the size of a combo box."""
    return QSize(contents.width() + PADDING_PX + 5 + ARROWS_PX, max(contents.height() + 2, HEIGHT_PX))


def spin_box_size(contents: QSize, widget: QWidget | None) -> QSize:
    """Return the size of a spin box."""
    room = 2 if is_plain(widget) else ARROWS_PX + 2
    return QSize(contents.width() + room + 4, max(contents.height(), HEIGHT_PX))
