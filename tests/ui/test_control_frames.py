"""Feature control frames: what they state, and that they are drawn whole."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QRectF, Qt

from measureapp.data.control_frame import CHARACTERISTICS, ControlFrame, control_frame
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.dimension_program import DimensionProgram
from measureapp.data.feature import Feature
from ui.controllers.program_rows import DimensionRow
from ui.look.look import Look
from ui.look.theme import Theme
from ui.pages.inspection.dimension_model import FRAME_ROLE, Column
from ui.pages.inspection.dimension_table import DimensionTable
from ui.pages.inspection.flags import dimension_flags
from ui.viewport.overlay.control_frame import frame_size, frame_width, symbol_path
from ui.viewport.overlay.flag import Flag, flag_size
from ui.viewport.overlay.style import OverlayStyle

UP = np.array([0, 0, 1.0])
FACE = Feature("face", "plane", np.zeros(3), UP, points=100)
BORE = Feature("bore", "cylinder", np.zeros(3), UP, 5.0, points=100)
BALL = Feature("ball", "sphere", np.zeros(3), None, 5.0, points=100)


def flag_of(kind, feature, datums=(), upper=0.1, **entry):
    names = tuple(one.name for one in datums)
    stated = DimensionProgram(name="it", kind=kind, features=(feature.name,), datums=names, upper_tolerance=0.1, **entry)
    letters = dict(zip(names, "AB", strict=False))
    frame = control_frame(stated, {one.name: one.shape for one in (feature, *datums)}, letters)
    found = Dimension("it", 0.0, 0.03, 0.01, 0.0, upper, Verdict.PASS, features=(feature.name,), kind=kind, datums=names, frame=frame)
    (flag,) = dimension_flags([found], [feature, *datums], None, {})
    return flag


def plain(frame):
    return [one.replace("\u00a0", " ") for one in frame.words()]


@pytest.mark.parametrize(
    ("kind", "feature", "datums", "cells"),
    [
        ("flatness", FACE, (), ["0.100"]),
        ("position", BORE, (FACE,), ["Ø 0.100", "A"]),
        ("concentricity", BALL, (BORE,), ["SØ 0.100", "A"]),
        ("perpendicularity", BORE, (FACE,), ["Ø 0.100", "A"]),
        ("parallelism", BORE, (FACE,), ["0.100", "A"]),
        ("parallelism", FACE, (BORE,), ["0.100", "A"]),
        ("position", FACE, (BORE,), ["0.100", "A"]),
    ],
)
def test_a_zone_about_an_axis_or_centre_has_a_diameter_and_a_slab_has_none(kind, feature, datums, cells):
    flag = flag_of(kind, feature, datums)
    assert flag.frame.characteristic == kind and plain(flag.frame) == cells
    assert flag.tolerance == ""  # the frame states it


def test_modifiers_stand_behind_what_they_modify_and_a_bonus_is_not_part_of_the_stated_width():
    material = {"datum": "pin", "condition": "least", "size_limits_mm": (9.9, 10.1)}
    pin = Feature("pin", "cylinder", np.zeros(3), UP, 5.0, points=100)
    more = {"material_condition": "maximum", "size_limits_mm": (9.9, 10.1), "datum_material": (material,)}
    flag = flag_of("position", BORE, (FACE, pin), upper=0.18, **more)
    assert plain(flag.frame) == ["Ø 0.100 \u24c2", "A", "B\u24c1"]
    assert "0.180" in flag.tolerance  # with its bonus, which the frame must not claim
    assert plain(flag_of("surface_profile", FACE, (BORE,), zone_offset_mm=0.02).frame)[0] == "0.100 UZ +0.020"


def test_sizes_and_zones_without_a_tolerance_have_no_frame():
    size = Dimension("d", 10.0, 10.0, 0.01, -0.1, 0.1, Verdict.PASS, features=("bore",), kind="diameter")
    free = Dimension("f", 0.0, 0.02, 0.01, None, None, Verdict.NO_TOLERANCE, features=("face",), kind="flatness")
    assert [flag.frame for flag in dimension_flags([size, free], [FACE, BORE], None, {})] == [None, None]


@pytest.mark.parametrize("kind", sorted(CHARACTERISTICS))
def test_every_symbol_stays_in_its_cell_and_differs_from_all_others(kind):
    area = QRectF(10.0, 20.0, 12.0, 12.0)
    path = symbol_path(kind, area)
    reach = path.boundingRect()
    assert not path.isEmpty()
    assert reach.left() >= area.left() - 0.01 and reach.right() <= area.right() + 0.01
    assert reach.top() >= area.top() - 0.01 and reach.bottom() <= area.bottom() + 0.01
    assert all(path != symbol_path(other, area) for other in set(CHARACTERISTICS) - {kind, "coaxiality", "concentricity"})


def test_a_box_is_never_narrower_than_its_frame(qapp):
    style = OverlayStyle.of(Theme.load("light"))
    frame = ControlFrame("position", 0.1, "Ø", ("\u24c2", "UZ +0.020 and more than fits"), ("A", "B", "C"))
    plain_flag, framed = Flag("one", np.zeros(3), "One"), Flag("one", np.zeros(3), "One", frame=frame)
    assert flag_size(framed, style).width() > frame_size(frame, style).width()
    assert flag_size(framed, style).height() == flag_size(plain_flag, style).height() + frame_size(frame, style).height()


def test_a_table_draws_the_frame_in_place_of_limits_and_shows_alignments_only_where_they_differ(qtbot, qapp):
    look = Look("light")
    frame = ControlFrame("position", 0.1, "Ø", ("\u24c2",), ("A",))
    found = Dimension(
        "it",
        0.0,
        0.03,
        0.01,
        0.0,
        0.18,
        Verdict.PASS,
        features=("bore",),
        kind="position",
        datums=("face",),
        datum_letters=("A",),
        frame=frame,
    )
    table = DimensionTable(look, lambda _edit: False)
    qtbot.addWidget(table)
    rows = [
        DimensionRow(0, "it", None, found, "current", frame, "best fit"),
        DimensionRow(1, "b", None, found, "current", None, "best fit"),
    ]
    table.set_rows(rows)
    assert table.isColumnHidden(Column.ALIGNMENT)
    cell = table.dimensions.index(0, Column.TOLERANCE)
    assert cell.data(FRAME_ROLE) == frame
    tip = cell.data(Qt.ItemDataRole.ToolTipRole).replace("\u00a0", " ")
    assert "Ø 0.100 \u24c2" in tip and "A Face" in tip and "0.180" in tip  # what the bonus makes of it
    assert table.columnWidth(Column.TOLERANCE) > frame_width(frame, OverlayStyle.of(look.theme))
    table.set_rows([rows[0], replace(rows[1], aligned_by="pins")])
    assert not table.isColumnHidden(Column.ALIGNMENT)
    assert table.dimensions.index(1, Column.ALIGNMENT).data() == "Pins"
