"""Finds texts in a window that are cut or elided."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QComboBox, QHeaderView, QLabel, QPushButton, QStyle, QStyleOptionComboBox, QToolButton, QWidget

from ui.widgets.basic import ElidedLabel

SLACK_PX = 1


def cut_texts(top: QWidget) -> list[str]:
    """Return the visible texts below ``top`` that have too little room, with the room and the need in px."""
    found = []
    for widget in top.findChildren(QWidget):
        if widget.isVisible() and not widget.visibleRegion().isEmpty():
            found += [f"{type(widget).__name__} “{text}”: {has} of {needs} px" for text, has, needs in _shortages(widget)]
            found += _beyond_the_edge(top, widget)
    return found


def _shortages(widget: QWidget) -> Iterator[tuple[str, int, int]]:
    if isinstance(widget, ElidedLabel):
        if widget.text() != widget.words:
            yield widget.words, widget.width(), widget.fontMetrics().horizontalAdvance(widget.words)
    elif isinstance(widget, QLabel):
        yield from _label(widget)
    elif isinstance(widget, QPushButton):
        if widget.text() and widget.property("role") != "message" and widget.width() + SLACK_PX < widget.sizeHint().width():
            yield widget.text().strip(), widget.width(), widget.sizeHint().width()
    elif isinstance(widget, QToolButton):
        needs = widget.fontMetrics().horizontalAdvance(widget.text())
        if widget.text() and needs > widget.width():
            yield widget.text(), widget.width(), needs
    elif isinstance(widget, QComboBox):
        yield from _combo(widget)
    elif isinstance(widget, QHeaderView) and widget.orientation() == Qt.Orientation.Horizontal:
        yield from _header(widget)


def _label(label: QLabel) -> Iterator[tuple[str, int, int]]:
    text, inner = label.text(), label.contentsRect()
    if not text or not label.pixmap().isNull() or label.textFormat() == Qt.TextFormat.RichText or "<" in text:
        return
    if label.wordWrap():
        needs = label.heightForWidth(label.width())
        if needs > label.height() + SLACK_PX:
            yield text, label.height(), needs
        return
    needs = max(label.fontMetrics().horizontalAdvance(line) for line in text.splitlines())
    if needs > inner.width() + SLACK_PX:
        yield text, inner.width(), needs


def _combo(combo: QComboBox) -> Iterator[tuple[str, int, int]]:
    option = QStyleOptionComboBox()
    option.initFrom(combo)
    room = combo.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, combo).width()
    needs = combo.fontMetrics().horizontalAdvance(combo.currentText())
    if not combo.isEditable() and needs > room + SLACK_PX:
        yield combo.currentText(), room, needs


def _header(header: QHeaderView) -> Iterator[tuple[str, int, int]]:
    for section in range(header.count()):
        words = str(header.model().headerData(section, Qt.Orientation.Horizontal) or "")
        needs = header.fontMetrics().horizontalAdvance(words) + 12
        if words and not header.isSectionHidden(section) and header.sectionSize(section) + SLACK_PX < needs:
            yield words, header.sectionSize(section), needs


def _beyond_the_edge(top: QWidget, widget: QWidget) -> list[str]:
    """Return a button or label that reaches beyond the right or lower edge of the window."""
    if not isinstance(widget, QLabel | QPushButton | QComboBox) or _is_scrolled(widget, top):
        return []
    end = widget.mapTo(top, QPoint(widget.width(), widget.height()))
    if end.x() <= top.width() and end.y() <= top.height():
        return []
    words = getattr(widget, "text", widget.accessibleName)()
    return [f"{type(widget).__name__} “{words}” reaches to ({end.x()}, {end.y()}) of ({top.width()}, {top.height()})"]


def _is_scrolled(widget: QWidget, top: QWidget) -> bool:
    from PySide6.QtWidgets import QAbstractScrollArea

    parent = widget.parentWidget()
    while parent is not None and parent is not top:
        if isinstance(parent, QAbstractScrollArea):
            return True
        parent = parent.parentWidget()
    return False
