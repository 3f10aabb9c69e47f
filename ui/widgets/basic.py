"""Basic widgets and layouts: labels with a role, buttons, cards."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent, QWheelEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QLayout,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ui.look.language.retranslating import remember
from ui.look.language.words import tr, translated
from ui.look.look import Look

TextRole = Literal["body", "title", "heading", "strong", "soft", "small", "caption", "figure", "field", "problem"]
COMPACT_WIDTH = 40  # px, of a button that shows its icon only
PART = " · "  # between the parts of a state, the most telling one last
ButtonRole = Literal["normal", "primary", "quiet", "message", "stop"]


def label(text: str = "", role: TextRole = "body", *, wrap: bool = False) -> QLabel:
    """Return a label; ``wrap`` allows several lines."""
    made = QLabel(translated(text))
    made.setTextFormat(Qt.TextFormat.PlainText)  # names come from files and people
    made.setProperty("role", role)
    made.setWordWrap(wrap)
    made.setTextInteractionFlags(Qt.TextInteractionFlag.NoTextInteraction)
    if wrap:
        made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
    remember(made)
    return made


class ElidedLabel(QLabel):
    """A label that is elided when there is too little space."""

    def __init__(self, text: str, role: TextRole | None = None, elide: Qt.TextElideMode = Qt.TextElideMode.ElideRight) -> None:
        super().__init__(translated(text))
        self.setTextFormat(Qt.TextFormat.PlainText)
        if role is not None:
            self.setProperty("role", role)
        self.words, self._elide = translated(text), elide
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        remember(self)

    def set_words(self, words: str) -> None:
        """Set the text."""
        self.words = translated(words)
        self.setToolTip(self.words)
        self._fit()
        self.updateGeometry()

    def sizeHint(self) -> QSize:
        """Return the room that the whole text needs."""
        self.ensurePolished()  # in its final letters
        return QSize(self.fontMetrics().horizontalAdvance(self.words) + 6, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        """Return the room for a few letters."""
        return QSize(40, super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Elide the text to the new width."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        self.setText(self.fontMetrics().elidedText(self.words, self._elide, max(40, self.width() - 2)))


class TailLabel(QLabel):
    """A label of parts joined by “ · ”, of which only the last is shown where there is too little room."""

    def __init__(self, text: str = "") -> None:
        super().__init__(translated(text))
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.words = translated(text)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    def set_words(self, words: str) -> None:
        """Set the text."""
        self.words = translated(words)
        self._fit()
        self.updateGeometry()

    def sizeHint(self) -> QSize:
        """Return the size of the whole text."""
        return QSize(self._width(self.words), super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        """Return the size of the last part."""
        return QSize(self._width(self._tail()), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show as much as there is room for."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        self.setText(self.words if self._width(self.words) <= self.width() else self._tail())

    def _tail(self) -> str:
        return self.words.rpartition(PART)[2]

    def _width(self, text: str) -> int:
        return self.fontMetrics().horizontalAdvance(text) + 2


class Button(QPushButton):
    """A push button with an icon that follows the theme."""

    def __init__(self, text: str, look: Look, icon: str = "", role: ButtonRole = "normal", tip: str = "") -> None:
        super().__init__(f"\u2009{translated(text)}" if icon and text else translated(text))
        self._look, self._icon, self._role, self._words, self._tip = look, icon, role, text, tip
        self.setAccessibleName(translated(text) or translated(tip))
        self.setProperty("role", role)
        self.setToolTip(translated(tip))
        remember(self)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAutoDefault(False)  # Enter in a dialog triggers its default button only
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setIconSize(QSize(20, 20))
        look.changed.connect(self._redraw)
        self._redraw()

    def allow_compact(self) -> None:
        """Require room for the icon only; `set_compact` shows it without text before the text would be cut."""
        self.setMinimumWidth(COMPACT_WIDTH)

    def set_compact(self, compact: bool) -> None:
        """Show the icon without text, with the text in the tooltip."""
        self.setText("" if compact else f"\u2009{translated(self._words)}")
        self.setToolTip(tr("{words}: {tip:lower}", words=self._words, tip=self._tip) if compact else translated(self._tip))

    def set_icon(self, name: str) -> None:
        """Set the icon."""
        self._icon = name
        self._redraw()

    def _redraw(self) -> None:
        if self._icon:
            self.setIcon(self._look.icon(self._icon, "accent_on" if self._role in ("primary", "stop") else "soft"))


def scrolled(content: QWidget, width: int = 0) -> QScrollArea:
    """Return a scroll area around ``content``, which is never wider than it; ``width``: fixed, room for the scroll bar included."""
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setWidget(content)
    if width:
        area.setFixedWidth(width)
    return area


class CalmComboBox(QComboBox):
    """A combo box that leaves the mouse wheel to the page unless it has the focus."""

    def __init__(self) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Choose with the wheel only after a click."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class Form(QFormLayout):
    """A form layout of labelled editors."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(*(() if parent is None else (parent,)))
        self.setContentsMargins(0, 0, 0, 0)
        self.setHorizontalSpacing(16)
        self.setVerticalSpacing(8)
        self.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)  # rather than cut a name

    def add(self, name: str | QLabel, editor: QWidget | QLayout) -> None:
        """Add an editor; a label as its name can be changed later."""
        named = QLabel(translated(name)) if isinstance(name, str) else name
        named.setProperty("role", "field")
        remember(named)
        self.addRow(named, editor)


def card(*parts: QWidget | QLayout | int, margin: int = 16, spacing: int = 8) -> QFrame:
    """Return a framed panel with its parts in a column; a number is a spacing, 0 a stretch."""
    frame = QFrame()
    frame.setObjectName("card")
    frame.setLayout(column(*parts, margin=margin, spacing=spacing))
    return frame


def column(*parts: QWidget | QLayout | int, margin: int = 0, spacing: int = 8) -> QVBoxLayout:
    """Return a vertical layout of parts."""
    layout = QVBoxLayout()
    _fill(layout, parts, margin, spacing)
    return layout


def row(*parts: QWidget | QLayout | int, margin: int = 0, spacing: int = 8) -> QHBoxLayout:
    """Return a horizontal layout of parts."""
    layout = QHBoxLayout()
    _fill(layout, parts, margin, spacing)
    return layout


def _fill(layout: QVBoxLayout | QHBoxLayout, parts: tuple[QWidget | QLayout | int, ...], margin: int, spacing: int) -> None:
    layout.setContentsMargins(margin, margin, margin, margin)
    layout.setSpacing(spacing)
    for part in parts:
        if isinstance(part, QWidget):
            layout.addWidget(part)
        elif isinstance(part, QLayout):
            layout.addLayout(part)
        elif part == 0:
            layout.addStretch(1)
        else:
            layout.addSpacing(part)


def clear(layout: QLayout) -> None:
    """Remove everything from a layout."""
    while (item := layout.takeAt(0)) is not None:
        widget, inner = item.widget(), item.layout()
        if widget is not None:
            widget.hide()
            widget.deleteLater()
        elif inner is not None:
            clear(inner)
