"""Sections in the 3-D view: of blades, of line profiles, and where one cuts oneself."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.inspection.blades.curves import BladeCurves
from measureapp.inspection.section_curves import SectionCurves
from measureapp.inspection.surface.section import Section
from ui.look.look import Look
from ui.pages.inspection.dimension_rows import feature_words
from ui.pages.inspection.feature_lines import OUTLINE, feature_lines
from ui.pages.inspection.flags import dimension_flags
from ui.pages.inspection.section_bar import CutPlane, SectionBar
from ui.pages.inspection.section_lines import GAINS, Whiskers, measured_lines

GREEN = (27, 153, 139)


def line(*places: tuple[float, float]) -> np.ndarray:
    return np.array([[x, y, 5.0] for x, y in places])


CURVES = BladeCurves(
    (line((0, 1), (9, 1)), line((0, -1), (9, -1))), {"leading": line((0, 1), (-1, 0), (0, -1))},
    line((-1, 0), (10, 0)), None, line((4, 1), (4, -1)),
)  # fmt: skip
BLADE = Feature("low.1", "point", np.array([4.0, 0, 5]), points=500, rms_mm=0.01)
PROFILE = Section(
    "ridge", (line((0, 0), (100, 0)),), line(*((x, 0.02) for x in range(100))), np.full(100, 0.02), np.tile([0.0, 1.0, 0.0], (100, 1))
)
SECTIONS = SectionCurves({"low.1": CURVES}, {"low.1": (line((0, 2), (9, 2)),)}, {"ridge": PROFILE})


def dimension(name: str, kind: str, features: tuple[str, ...]) -> Dimension:
    return Dimension(name, 2.0, 2.01, 0.02, -0.1, 0.1, Verdict.PASS, features=features, kind=kind)


def test_what_a_dimension_measures_on_a_blade_is_drawn_on_it():
    assert measured_lines("max_thickness", CURVES)[0] is CURVES.thickest
    assert measured_lines("camber", CURVES)[0] is CURVES.mean_line
    assert measured_lines("leading_radius", CURVES)[0] is CURVES.edges["leading"]
    assert measured_lines("trailing_radius", CURVES) == []  # it was not measured
    assert measured_lines("chord", CURVES) == []
    assert np.array_equal(measured_lines("pitch", CURVES)[0], CURVES.mean_line[[0, -1]])


def test_a_selected_blade_shows_its_measured_outline_over_that_of_the_nominal():
    layers = feature_lines([BLADE], [BLADE], dimension("thickness", "max_thickness", ("low.1",)), SECTIONS, GREEN)
    by_width = {layer.width: layer for layer in layers}
    assert by_width[1.5].colour == OUTLINE and by_width[1.5].lines == SECTIONS.nominal_blades["low.1"]
    assert by_width[2.5].colour == GREEN and len(by_width[2.5].lines) == 3
    assert by_width[5.0].lines == (CURVES.thickest,)
    quiet = feature_lines([BLADE], [], None, SECTIONS, GREEN)
    assert [len(layer.lines) for layer in quiet] == [3]
    assert feature_words(BLADE).replace("\u00a0", " ") == "Low.1: blade section, 500 points"


def test_a_line_profile_shows_its_deviations_magnified_by_the_factor_its_label_names():
    plane = Feature("top", "plane", np.zeros(3), np.array([0, 0, 1.0]), points=100)
    ridge = dimension("ridge", "line_profile", ("top",))
    layers = feature_lines([plane], [plane], ridge, SECTIONS, GREEN)
    whiskers = [layer for layer in layers if layer.width == 2.0]
    gain = Whiskers.of(PROFILE).gain
    assert gain in GAINS and gain > 1
    assert len(whiskers) == 1  # all lie outside
    lengths = [np.linalg.norm(one[1] - one[0]) for one in whiskers[0].lines]
    assert np.allclose(lengths, gain * 0.02)
    assert np.allclose([one[0][1] for one in whiskers[0].lines], 0.0)
    (flag,) = dimension_flags([ridge], [plane], SECTIONS, {})
    assert flag.verdict == "pass" and flag.more == (f"Whiskers × {gain}",)


def test_a_gross_deviation_does_not_stick_out_of_the_picture():
    off = PROFILE.deviations_mm.copy()
    off[50] = 30.0
    gross = Section("ridge", PROFILE.nominal, PROFILE.measured_mm + [0, 1, 0] * (off - 0.02)[:, None], off, PROFILE.nominal_normals)
    lengths = [np.linalg.norm(one[1] - one[0]) for layer in Whiskers.of(gross).layers() for one in layer.lines]
    assert max(lengths) < 0.15 * 100


def test_whiskers_of_nothing_are_none():
    empty = Section("nothing", (), np.empty((0, 3)), np.empty(0), np.empty((0, 3)))
    assert Whiskers.of(empty).layers() == [] and Whiskers.of(empty).gain == 1


def test_the_section_bar_gives_back_the_plane_it_was_given(qtbot):
    class Surface:
        low_mm, high_mm = np.array([-10.0, -20.0, 0.0]), np.array([10.0, 20.0, 80.0])

    bar = SectionBar(Look("light"))
    qtbot.addWidget(bar)
    qtbot.addWidget(bar.button)
    assert bar.value() is None
    bar.show_extent(Surface())
    for plane in (CutPlane("z", 60.0), CutPlane("x", -5.0), CutPlane("y", 20.0)):
        bar.setValue(plane)
        found = bar.value()
        assert found.axis == plane.axis and found.place_mm == pytest.approx(plane.place_mm, abs=0.11)
    bar.show_extent(None)
    assert bar.value() is None and not bar.button.isEnabled()


def test_a_section_is_moved_to_a_typed_position_and_by_arrow_keys(qtbot):
    bar = SectionBar(Look("light"))
    qtbot.addWidget(bar)
    bar._low, bar._high = np.array([-50.0, -50, 0]), np.array([50.0, 50, 80])
    bar._follow_slider()
    bar.button.setChecked(True)
    assert bar.value() == CutPlane("z", 40.0)
    bar.place.selectAll()
    qtbot.keyClicks(bar.place, "12,34")
    with qtbot.waitSignal(bar.changed):
        qtbot.keyClick(bar.place, Qt.Key.Key_Return)
    assert bar.value() == CutPlane("z", 12.34) and bar.slider.value() == round(400 * 12.34 / 80)
    qtbot.keyClick(bar.place, Qt.Key.Key_Up)
    assert bar.value() == CutPlane("z", 13.34)
    bar.slider.setValue(100)
    assert bar.value() == CutPlane("z", 20.0)
    bar.axis.setValue("x")
    assert bar.value() == CutPlane("x", -25.0)
