"""Cells of the table of dimensions: the sign of the status, verdicts, and editors that check what is typed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QPersistentModelIndex, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QLineEdit, QStyle, QStyleOptionViewItem, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.pages.inspection.cell_edits import problem_of
from ui.pages.inspection.dimension_model import FRAME_ROLE, ROW_ROLE, STATUS_ROLE, Column
from ui.viewport.overlay.control_frame import CELL_PX, frame_width, paint_frame
from ui.viewport.overlay.style import OverlayStyle
from ui.widgets.data_table import Index, SignDelegate

if TYPE_CHECKING:
    from ui.pages.inspection.dimension_table import DimensionTable

SIGN, FRAME_MARGIN = 12.0, 6.0  # px


class DimensionDelegate(SignDelegate):
    """Draws the status as a sign of its own shape, and edits text with a check."""

    def __init__(self, look: Look, table: DimensionTable) -> None:
        super().__init__(look, table)
        self._table = table

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw a cell; the current one of the focused table is framed."""
        super().paint(painter, option, index)
        frame = index.data(FRAME_ROLE)
        if frame is not None:
            style = OverlayStyle.of(self._look.theme)
            room = QRectF(option.rect)
            width = frame_width(frame, style)
            left = max(room.left() + FRAME_MARGIN, room.right() - FRAME_MARGIN - width)
            painter.save()
            painter.setClipRect(room)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            top = float(int(room.center().y() - CELL_PX / 2)) + 0.5
            paint_frame(painter, frame, QPointF(float(int(left)) + 0.5, top), style, self._look.theme.colour("text"))
            painter.restore()
        status = index.data(STATUS_ROLE)
        if status:
            draw_status(painter, QRectF(option.rect), status, self._look)
        if option.state & QStyle.StateFlag.State_HasFocus and index.flags() & Qt.ItemFlag.ItemIsEditable:
            painter.setPen(QPen(self._look.theme.colour("accent"), 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(option.rect.adjusted(1, 1, -2, -2))

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> None:
        """Leave the text out where a frame is drawn; of a long name both ends are shown, since names often differ in the last letters."""
        super().initStyleOption(option, index)
        if index.column() == Column.NAME:
            option.textElideMode = Qt.TextElideMode.ElideMiddle
        if index.data(FRAME_ROLE) is not None:
            option.text = ""

    def createEditor(self, parent: QWidget, _option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QWidget:
        """Return a field that turns red while its text cannot be used."""
        editor = QLineEdit(parent)
        editor.setProperty("cell", True)
        editor.setStyleSheet("QLineEdit { min-height: 0; padding: 0 3px; }")
        row, column = index.data(ROW_ROLE), Column(index.column())
        editor.setAccessibleName(f"{row.name}: {self._table.model().headerData(column, Qt.Orientation.Horizontal)}")

        def check(text: str) -> None:
            problem = problem_of(row, column, text)
            editor.setProperty("invalid", bool(problem))
            editor.setToolTip(translated(problem))
            editor.style().unpolish(editor)
            editor.style().polish(editor)

        editor.textEdited.connect(check)
        return editor

    def setEditorData(self, editor: QWidget, index: QModelIndex | QPersistentModelIndex) -> None:
        """Show the value as it can be typed, all of it selected."""
        assert isinstance(editor, QLineEdit)
        if not editor.isModified():
            editor.setText(translated(index.data(Qt.ItemDataRole.EditRole)))
            editor.selectAll()

    def setModelData(self, editor: QWidget, _model: QAbstractItemModel, index: QModelIndex | QPersistentModelIndex) -> None:
        """Edit the cell; a text that was not touched changes nothing."""
        assert isinstance(editor, QLineEdit)
        if editor.text() != index.data(Qt.ItemDataRole.EditRole):
            self._table.commit(index, editor.text())


def draw_status(painter: QPainter, box: QRectF, status: str, look: Look) -> None:
    """Draw ● current, ◐ calculating, ◌ stale, ⚠ could not be measured, ⊘ excluded."""
    theme = look.theme
    place = QRectF(box.center().x() - SIGN / 2, box.center().y() - SIGN / 2, SIGN, SIGN)
    if status == "failed":
        size = QRectF(place).adjusted(-3, -3, 3, 3).toRect()
        look.icon("warning", "verdict_not_proven").paint(painter, size)
        return
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    inner = place.adjusted(1, 1, -1, -1)
    if status == "current":
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("faint"))
        painter.drawEllipse(inner.adjusted(2, 2, -2, -2))
    elif status == "calculating":
        painter.setPen(QPen(theme.colour("accent"), 1.5))
        painter.drawEllipse(inner)
        painter.setBrush(theme.colour("accent"))
        painter.drawPie(inner, 90 * 16, 180 * 16)
    elif status == "stale":
        pen = QPen(theme.colour("verdict_not_proven"), 1.8)
        pen.setDashPattern([1.2, 1.6])
        painter.setPen(pen)
        painter.drawEllipse(inner)
    else:
        painter.setPen(QPen(theme.colour("soft"), 1.5))
        painter.drawEllipse(inner)
        painter.drawLine(QPointF(inner.left() + 1.5, inner.bottom() - 1.5), QPointF(inner.right() - 1.5, inner.top() + 1.5))
    painter.restore()
