"""The texts on display: of widgets, menus, headers and tables; of charts; and those that Python code paints."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QAbstractItemModel, QAbstractListModel, QAbstractTableModel, QModelIndex, QObject, Qt
from PySide6.QtGui import QAction, QPainter
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QComboBox,
    QDoubleSpinBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QSpinBox,
    QTabBar,
    QWidget,
)

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
        elif isinstance(widget, QSpinBox | QDoubleSpinBox):
            yield f"{kind}.suffix", widget.suffix()
        elif isinstance(widget, QGroupBox):
            yield kind, widget.title()
        elif isinstance(widget, QTabBar):
            yield from ((kind, widget.tabText(place)) for place in range(widget.count()))
        elif isinstance(widget, QComboBox):
            yield from ((kind, widget.itemText(place)) for place in range(widget.count()))
        elif isinstance(widget, QAbstractItemView) and not isinstance(widget, QHeaderView) and widget.model() is not None:
            yield from _cells(widget)
    for action in top.findChildren(QObject):
        if isinstance(action, QAction) and not _is_of_charts(action):
            yield "QAction", action.text()


def chart_texts(top: QWidget) -> Iterator[tuple[str, str]]:
    """Return kind and text of the axes, numbers and scales of the charts in ``top`` that are seen; others follow when they are shown."""
    for chart in top.findChildren(QWidget):
        if type(chart).__name__ != "Plot" or not chart.isVisible():
            continue
        for item in chart.scene().items():
            name = type(item).__name__
            if name == "TextItem":
                yield "chart.text", item.toPlainText()
            elif item.isVisible() and hasattr(item, "labelText"):
                yield "chart.axis", item.labelText or ""
                yield from (("chart.tick", words) for level in getattr(item, "_tickLevels", None) or () for _, words in level)


def painted_texts(top: QWidget) -> list[tuple[str, str]]:
    """Return kind and text of what Python code paints on ``top``, such as legends and drawings."""
    found: list[tuple[str, str]] = []
    paint = QPainter.drawText

    def note(painter: QPainter, *arguments: object) -> object:
        found.extend(("painted", one) for one in arguments if isinstance(one, str))
        return paint(painter, *arguments)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(QPainter, "drawText", note)
        top.grab()
    return found


def _cells(view: QAbstractItemView) -> Iterator[tuple[str, str]]:
    model, kind = view.model(), type(view).__name__
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for column in range(columns):
        yield f"{kind}.header", str(model.headerData(column, Qt.Orientation.Horizontal) or "")
    yield from _rows(model, QModelIndex(), columns, kind)


def _rows(model: QAbstractItemModel, parent: QModelIndex, columns: int, kind: str) -> Iterator[tuple[str, str]]:
    for row in range(min(model.rowCount(parent), MOST_ROWS)):
        for column in range(columns):
            index = model.index(row, column, parent)
            yield kind, str(index.data() or "")
            yield f"{kind}.tip", str(index.data(Qt.ItemDataRole.ToolTipRole) or "")
        first = model.index(row, 0, parent)
        if not isinstance(model, QAbstractListModel | QAbstractTableModel) and model.rowCount(first):
            yield from _rows(model, first, columns, kind)


def _is_of_charts(one: QObject | None) -> bool:
    """Whether something belongs to the menus of the library of charts, which the window never shows."""
    while one is not None:
        if any(base.__module__.startswith("pyqtgraph") for base in type(one).__mro__):
            return True
        one = one.parent()
    return False
