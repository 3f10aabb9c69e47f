"""Tables keep what is selected when their rows are read again."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from ui.look.look import Look
from ui.widgets.data_table import Cell, DataTable


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
