"""Rows of trees with the height of table rows."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QStyleOptionViewItem

from ui.widgets.data_table import ROW_HEIGHT, Index, SignDelegate

INDENT = 20


class RowDelegate(SignDelegate):
    """Gives rows and children the height of table rows."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """Return the width of the text and the height of a row."""
        return QSize(super().sizeHint(option, index).width(), ROW_HEIGHT)
