"""The texts on display: of widgets, menus, headers and tables."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QAbstractListModel, QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QAbstractItemView, QComboBox, QGroupBox, QLabel, QLineEdit, QTabBar, QWidget

MOST_ROWS = 30


def displayed_texts(top: QWidget) -> Iterator[tuple[str, str]]:
    """Return kind and text of what ``top`` and the widgets in it display or tell."""
    for widget in (top, *top.findChildren(QWidget)):
        if _is_of_charts(widget):
            continue
        kind = type(widget).__name__
        for text in (widget.toolTip(), widget.accessibleName(), widget.windowTitle() if widget.isWindow() else ""):
            yield f"{kind}.tip", text
        if isinstance(widget, QLabel | QAbstractButton):
            yield kind, getattr(widget, "words", "") if hasattr(widget, "set_words") else widget.text()
        elif isinstance(widget, QLineEdit):
            yield f"{kind}.placeholder", widget.placeholderText()
        elif isinstance(widget, QGroupBox):
            yield kind, widget.title()
        elif isinstance(widget, QTabBar):
            yield from ((kind, widget.tabText(place)) for place in range(widget.count()))
        elif isinstance(widget, QComboBox):
            yield from ((kind, widget.itemText(place)) for place in range(widget.count()))
        elif isinstance(widget, QAbstractItemView) and widget.model() is not None:
            yield from _cells(widget)
    for action in top.findChildren(QObject):
        if isinstance(action, QAction) and not _is_of_charts(action):
            yield "QAction", action.text()


def _cells(view: QAbstractItemView) -> Iterator[tuple[str, str]]:
    model, kind = view.model(), type(view).__name__
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for column in range(columns):
        yield f"{kind}.header", str(model.headerData(column, Qt.Orientation.Horizontal) or "")
        for row in range(min(model.rowCount(), MOST_ROWS)):
            yield kind, str(model.index(row, column).data() or "")


def _is_of_charts(one: QObject | None) -> bool:
    """Whether something belongs to the menus of the library of charts, which the window never shows."""
    while one is not None:
        if any(base.__module__.startswith("pyqtgraph") for base in type(one).__mro__):
            return True
        one = one.parent()
    return False
