"""Editors give back what they were given."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtWidgets import QFileDialog

from measureapp.data.board import CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.data.length_unit import LengthUnit
from measureapp.data.pattern_sets import DEFAULT_NAME, PATTERN_SETS
from ui.look.demo_settings import DemoSettings
from ui.look.paths import demo_folder
from ui.look.pattern_words import PATTERN_WORDS, RECOMMENDED
from ui.widgets.board_form import BoardForm
from ui.widgets.demo_form import OWN_MESH, PARTS, DemoForm
from ui.widgets.segments import Segments

ANY_SETTINGS = st.builds(
    DemoSettings,
    st.sampled_from(sorted(PARTS)),
    st.sampled_from(["full", "half", "quarter"]),
    st.integers(3, 60),
    st.integers(1, 9999),
    st.sampled_from(sorted(PATTERN_SETS)),
)
MESHES = st.builds(DemoSettings, st.just("somewhere/bracket.stl"), unit=st.sampled_from(LengthUnit))


@given(wanted=st.one_of(ANY_SETTINGS, MESHES))
@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_the_demo_form_gives_back_what_it_was_given(qtbot, wanted):
    form = DemoForm()
    qtbot.addWidget(form)
    form.setValue(wanted)
    assert form.value() == wanted


def test_a_change_by_the_user_is_signalled(qtbot):
    form = DemoForm()
    qtbot.addWidget(form)
    with qtbot.waitSignal(form.valueChanged) as told:
        form._viewpoints.setValue(12)
    assert told.args[0].viewpoints == 12


def test_every_pattern_set_is_offered_with_a_name_of_its_own_and_what_it_consists_of():
    assert set(PATTERN_WORDS) == set(PATTERN_SETS)
    assert len({words.title for words in PATTERN_WORDS.values()}) == len(PATTERN_WORDS)
    assert next(iter(PATTERN_WORDS)) == RECOMMENDED == DEFAULT_NAME
    for name, patterns in PATTERN_SETS.items():
        consists = patterns.name.partition(": ")[2] or patterns.name
        advice = "Recommended. " if name == DEFAULT_NAME else ""
        assert PATTERN_WORDS[name].line == f"{advice}{patterns.count} images: {consists}."


def test_the_patterns_of_the_demo_can_be_chosen(qtbot):
    form = DemoForm()
    qtbot.addWidget(form)
    assert form.value().patterns == DEFAULT_NAME
    assert form._pattern_line.text().startswith("Recommended. 12 images: 4 steps")
    with qtbot.waitSignal(form.valueChanged) as told:
        form._patterns.setCurrentIndex(form._patterns.findData("paper"))
    assert told.args[0].patterns == "paper"
    assert form._patterns.currentText() == "Paper: 32 and 33 px"
    assert form._pattern_line.text() == "8 images: 4 steps at 32 and 33 px."


def test_demos_with_other_patterns_lie_in_other_folders():
    assert demo_folder(DemoSettings()) != demo_folder(DemoSettings(patterns="paper"))


def test_choosing_the_impeller_suggests_the_viewpoints_it_needs(qtbot):
    form = DemoForm()
    qtbot.addWidget(form)
    form._part.setCurrentIndex(form._part.findData("impeller"))
    form._part.activated.emit(form._part.currentIndex())
    assert form.value().viewpoints == 26


def test_segments_give_back_what_they_were_given_and_signal_a_click(qtbot):
    segments = Segments({"a": "A", "b": "B"})
    qtbot.addWidget(segments)
    segments.setValue("b")
    assert segments.value() == "b"
    with qtbot.waitSignal(segments.valueChanged) as told:
        segments._buttons["a"].click()
    assert told.args == ["a"]


def test_a_mesh_of_the_users_own_becomes_an_entry_of_the_list(qtbot, monkeypatch, tmp_path):
    form = DemoForm()
    qtbot.addWidget(form)
    path = str(tmp_path / "bracket.stl")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (path, ""))
    place = form._part.findText(OWN_MESH)
    with qtbot.waitSignal(form.meshChosen) as told:
        form._part.setCurrentIndex(place)
        form._part.activated.emit(place)
    assert form.value().part == DemoSettings().part  # until the mesh was looked at
    with qtbot.waitSignal(form.valueChanged):
        form.show_mesh(told.args[0], LengthUnit.MM)
    assert form.value().part == path
    assert form._part.currentText() == "bracket.stl"
    assert form._part.itemText(form._part.count() - 1) == OWN_MESH
    assert demo_folder(form.value()).name.startswith("demo-bracket-quarter-8")


def test_a_file_choice_that_is_given_up_keeps_the_part(qtbot, monkeypatch):
    form = DemoForm()
    qtbot.addWidget(form)
    form.setValue(DemoSettings("gear", "full", 8, 3))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    place = form._part.findText(OWN_MESH)
    form._part.setCurrentIndex(place)
    form._part.activated.emit(place)
    assert form.value() == DemoSettings("gear", "full", 8, 3)


SIZES = st.integers(1000, 90_000).map(lambda thousandths: thousandths / 1000)
BOARDS = st.one_of(
    st.builds(CheckerboardDescription, columns=st.integers(3, 40), rows=st.integers(3, 40), square_mm=SIZES),
    st.builds(
        lambda square_mm, **fields: CharucoDescription(kind="charuco", square_mm=square_mm, marker_mm=round(square_mm / 2, 3), **fields),
        columns=st.integers(3, 12),
        rows=st.integers(3, 12),
        square_mm=SIZES,
    ),
    st.builds(
        lambda spacing_mm, **fields: CirclesDescription(
            kind="circles", spacing_mm=spacing_mm, diameter_mm=round(spacing_mm / 2, 3), **fields
        ),
        columns=st.integers(2, 12),
        rows=st.integers(3, 40),
        spacing_mm=SIZES,
    ),
)


@given(wanted=BOARDS)
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_the_board_form_gives_back_what_it_was_given(qtbot, wanted):
    form = BoardForm()
    qtbot.addWidget(form)
    form.setValue(wanted)
    assert form.problem() == ""
    assert form.value() == wanted
