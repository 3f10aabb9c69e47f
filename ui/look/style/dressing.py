"""What a widget is given once, before it is first shown: fonts, colour roles, attributes."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractScrollArea,
    QDoubleSpinBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QListView,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QSpinBox,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTextBrowser,
    QToolButton,
    QWidget,
)

from ui.look.style import buttons, fields, views
from ui.look.style.roles import TEXTS
from ui.look.theme import Theme


def dress(widget: QWidget, theme: Theme) -> None:
    """Set font, colour role and attributes of a widget by its class, its name and its role."""
    if isinstance(widget, QLabel):
        _dress_label(widget, theme)
    elif isinstance(widget, QPushButton):
        if buttons.button_look(widget).bold:
            _set_font(widget, theme, "body", bold=True)
    elif isinstance(widget, QToolButton):
        if widget.property("role") == "rail":
            _set_font(widget, theme, "small")
    elif isinstance(widget, QLineEdit):
        widget.setAttribute(Qt.WidgetAttribute.WA_Hover)
        widget.update()
    elif isinstance(widget, QSpinBox | QDoubleSpinBox):
        right = fields.SPIN_MARGIN_PX if fields.is_plain(widget) else 0
        widget.lineEdit().setTextMargins(fields.SPIN_MARGIN_PX, 0, right, 0)
    elif isinstance(widget, QProgressBar):
        if widget.minimumHeight() <= views.PROGRESS_PX:
            widget.setFixedHeight(views.PROGRESS_PX)
    elif isinstance(widget, QAbstractScrollArea):
        _dress_scroll_area(widget, theme)
    elif widget.objectName() == "clear":
        widget.setAutoFillBackground(False)


def _dress_label(label: QLabel, theme: Theme) -> None:
    policy = label.sizePolicy()
    if label.wordWrap() and not policy.hasHeightForWidth():
        policy.setHeightForWidth(True)
        label.setSizePolicy(policy)
    parent = label.parent()
    role = "chip" if isinstance(parent, QWidget) and parent.objectName() == "chip" else label.property("role")
    if role == "chip":
        _set_font(label, theme, "small")
        return
    look = TEXTS.get(role)
    if look is None:
        return
    if look.size != "body" or look.bold:
        _set_font(label, theme, look.size, bold=look.bold)
    label.setForegroundRole(look.colour)
    if look.least_height:
        label.setMinimumHeight(theme.sizes[look.least_height])


def _dress_scroll_area(area: QAbstractScrollArea, theme: Theme) -> None:
    if isinstance(area, QHeaderView):
        _set_font(area, theme, "small", bold=True)
        return
    viewport = area.viewport()
    if isinstance(area, QScrollArea):
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        viewport.setAutoFillBackground(False)
        inner = area.widget()
        if inner is not None and inner.objectName() == "clear":
            inner.setAutoFillBackground(False)
        return
    if isinstance(area, QTextBrowser):
        area.document().setDocumentMargin(16)
    if isinstance(area, QAbstractItemView | QTextBrowser | QPlainTextEdit):
        viewport.setAutoFillBackground(False)
        viewport.setAttribute(Qt.WidgetAttribute.WA_Hover)
    if isinstance(area, QListView) and area.metaObject().className() == "QComboBoxListView":
        area.setItemDelegate(PopupDelegate(area))


def _set_font(widget: QWidget, theme: Theme, size: str, *, bold: bool = False) -> None:
    font = QFont()
    font.setPixelSize(theme.sizes[size])
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    widget.setFont(font)


class PopupDelegate(QStyledItemDelegate):
    """Gives the lines of an opened combo box the height of a control."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Any) -> QSize:
        """Return the size of one line."""
        size = super().sizeHint(option, index)
        return QSize(size.width() + 8, max(size.height(), fields.HEIGHT_PX))
