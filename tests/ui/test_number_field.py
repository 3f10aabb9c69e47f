"""A comma typed into a number field is a decimal point, and all fields for such numbers are of that kind."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtTest import QTest

from ui.widgets.number_field import NumberField

UI = Path(__file__).resolve().parents[2] / "ui"


@pytest.mark.parametrize(("typed", "value"), [("0,05", 0.05), ("40,5", 40.5), ("0.05", 0.05), ("1,000", 1.0), ("-0,2", -0.2)])
def test_a_comma_is_the_decimal_point(qtbot, typed: str, value: float) -> None:
    field = NumberField()
    qtbot.addWidget(field)
    field.setLocale(QLocale("en"))
    field.setRange(-1000.0, 1000.0)
    field.setDecimals(3)
    field.setSuffix(" mm")
    field.selectAll()
    QTest.keyClicks(field, typed)
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert field.value() == value


def test_no_field_of_the_window_drops_a_comma() -> None:
    bare = [path.name for path in UI.rglob("*.py") if "QDoubleSpinBox()" in path.read_text(encoding="utf-8")]
    assert bare == []
