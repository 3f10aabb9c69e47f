"""Tables keep what is selected when their rows are read again."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from ui.look.look import Look
from ui.widgets.data_table import Cell, DataTable
from ui.widgets.empty_rows import EmptyRows


@pytest.mark.parametrize("keys", [Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier])
def test_the_selected_row_is_kept_whatever_key_is_held_down(qtbot, keys):
    table = DataTable(Look("light"), ("Name",))
    qtbot.addWidget(table)
    table.setSelectionMode(DataTable.SelectionMode.ExtendedSelection)
    table.set_rows([[Cell(name)] for name in ("bore", "boss")])
    table.show()
    table.selectRow(1)
    QTest.mouseClick(table.horizontalHeader(), Qt.MouseButton.LeftButton, keys)  # the key stays down
    table.set_rows([[Cell(name)] for name in ("bore", "boss", "tip")])
    assert [index.row() for index in table.selectionModel().selectedRows()] == [1]


def test_a_table_without_rows_says_how_it_is_filled(qtbot):
    table = DataTable(Look("light"), ["Name"])
    empty = EmptyRows(table, "Nothing yet. Press Add.")
    qtbot.addWidget(table)
    table.show()
    assert empty.isVisible() and empty.text() == "Nothing yet. Press Add."
    table.set_rows([[Cell("a")]])
    assert not empty.isVisible()
    table.set_rows([])
    assert empty.isVisible()
    table.resize(400, 300)
    assert empty.width() <= table.viewport().width()
