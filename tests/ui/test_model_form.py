"""Forms made from models give back what they were given, and state problems in words."""

from __future__ import annotations

import json
from typing import Literal

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pydantic import Field

from measureapp.data.model import Model, toml_values
from measureapp.data.rig import KeepOutBox, MotionRules, ParkPose
from measureapp.devices.plugin_loader import discover, load_driver
from measureapp.errors import PluginError
from ui.look.field_words import UNITS, field_words, place_words
from ui.widgets.field_editors import KeptEditor
from ui.widgets.model_form import ModelForm

SHIPPED = [(row.id, kind) for row in discover() for kind in row.kinds]
SAMPLES = {"drive": "toyo_xc100", "link": "bus", "controller": "shot"}  # of settings that have no default
SLOW = settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


class Inner(Model):
    low_mm: tuple[float, float, float] = (0.0, 0.0, 1.5)
    on: bool = True


class Everything(Model):
    text: str = "a"
    count: int = Field(default=3, ge=1)
    ratio: float = Field(default=0.5, gt=0, lt=10)
    mode: Literal["fast", "slow", 3] = "fast"
    limit_us: float | None = 2.0
    word: str | None = None
    numbers: tuple[int, ...] = (1, 2)
    inner: Inner = Inner()
    boxes: tuple[Inner, ...] = ()
    free: dict[str, object] = Field(default_factory=dict)


def made(qtbot, model):
    form = ModelForm(model)
    qtbot.addWidget(form)
    return form


def settings_model(plugin, kind):
    try:
        return load_driver(None, plugin, kind).settings
    except PluginError as error:
        pytest.skip(f"{plugin} cannot be loaded here: {error}")


@pytest.mark.parametrize(("plugin", "kind"), SHIPPED)
def test_the_settings_of_every_shipped_driver_survive_the_form(qtbot, plugin, kind):
    model = settings_model(plugin, kind)
    wanted = model.model_validate({name: SAMPLES[name] for name, field in model.model_fields.items() if field.is_required()})
    form = made(qtbot, model)
    form.setValue(wanted)
    assert form.problem() == ""
    assert form.value() == wanted
    assert model.model_validate(toml_values(form.value())) == wanted


@pytest.mark.parametrize(("plugin", "kind"), SHIPPED)
def test_few_settings_of_shipped_drivers_can_only_be_looked_at(qtbot, plugin, kind):
    form = made(qtbot, settings_model(plugin, kind))
    kept = {name for name, editor in form.editors.items() if isinstance(editor, KeptEditor)}
    assert kept <= {"board"}


def test_a_value_that_cannot_be_edited_is_shown_as_json(qtbot):
    form = made(qtbot, load_driver(None, "virtual_rig", "rig").settings)
    assert json.loads(form.editors["board"].text.toPlainText())["columns"] == 14


INNER = st.builds(Inner, low_mm=st.tuples(*[st.floats(-1e9, 1e9)] * 3), on=st.booleans())
WORDS = st.text(st.characters(codec="utf-8", exclude_categories=("Cc", "Cs", "Zl", "Zp")), max_size=12)
ANYTHING = st.builds(
    Everything,
    text=WORDS,
    count=st.integers(1, 2**40),
    ratio=st.floats(0, 10, exclude_min=True, exclude_max=True),
    mode=st.sampled_from(["fast", "slow", 3]),
    limit_us=st.none() | st.floats(-1e12, 1e12),
    word=st.none() | WORDS,
    numbers=st.lists(st.integers(-9, 9), max_size=4).map(tuple),
    inner=INNER,
    boxes=st.lists(INNER, max_size=2).map(tuple),
    free=st.dictionaries(WORDS, st.booleans() | st.integers(-(2**62), 2**62) | WORDS, max_size=3),
)


@given(wanted=ANYTHING)
@SLOW
def test_every_kind_of_field_gives_back_what_it_was_given(qtbot, wanted):
    form = made(qtbot, Everything)
    form.setValue(wanted)
    assert form.value() == wanted


def test_boxes_and_park_pose_survive_the_form(qtbot):
    wanted = MotionRules(
        keep_out=(KeepOutBox(name="wall", low_mm=(0, 0, 0), high_mm=(1, 2, 3)),),
        park=ParkPose(position_mm=(1, 2, 3), quaternion_wxyz=(1, 0, 0, 0), guide_mm=-4.5),
    )
    form = made(qtbot, MotionRules)
    form.setValue(wanted)
    assert form.value() == wanted


@pytest.mark.parametrize(
    ("field", "entered", "words"),
    [
        ("ratio", "half", "Ratio: Enter a number."),
        ("ratio", "0", "Ratio: Must be greater than 0."),
        ("count", "2.5", "Count: Enter a whole number."),
        ("count", "", "Count: Enter a whole number."),
        ("ratio", "nan", "Ratio: Enter a finite number."),
    ],
)
def test_a_problem_is_stated_under_its_field_and_goes_away(qtbot, field, entered, words):
    form = made(qtbot, Everything)
    form.show()
    line = form.editors[field].line
    line.selectAll()
    line.clear()
    line.insert(entered)
    line.textEdited.emit(entered)
    assert form.problem() == words
    note = form._notes[field]
    assert note.isVisible()
    assert note.text() == words.partition(": ")[2]
    line.setText("1")
    with qtbot.waitSignal(form.valueChanged):
        line.textEdited.emit("1")
    assert form.problem() == ""
    assert not note.isVisible()


def test_a_problem_inside_a_folded_group_unfolds_it(qtbot):
    form = made(qtbot, MotionRules)
    form.show()
    form.editors["park"].box.setChecked(True)
    line = form.editors["park"].inner.rows.editors["position_mm"].lines[1]
    assert line.isVisible()
    assert form.problem() == "Park pose, position (x, y, z): Enter a number."


def test_a_box_without_a_volume_is_refused_in_words(qtbot):
    form = made(qtbot, MotionRules)
    form.editors["keep_out"].button.click()
    (box,) = form.editors["keep_out"].items
    box.set_raw({"name": "wall", "low_mm": (0, 0, 0), "high_mm": (1, 1, 0)})
    box.edited.emit()
    assert form.problem() == "Keep-out boxes: Lower corner must be below upper corner in x, y and z."


def test_settings_without_a_model_are_lines_of_toml(qtbot):
    form = made(qtbot, Everything)
    form.editors["free"].text.setPlainText("port = COM3")
    assert "as TOML" in form.problem()
    form.editors["free"].text.setPlainText('port = "COM3"')
    assert form.value().free == {"port": "COM3"}


def test_names_are_words_with_units():
    assert field_words("speed_mm_per_s") == ("Speed", "mm/s")
    assert field_words("speed_mm_s") == ("Speed", "mm/s") and field_words("acceleration_mm_s2") == ("Acceleration", "mm/s²")
    assert field_words("exposures_us") == ("Exposures", "µs")
    assert field_words("certificate_sha256") == ("Certificate SHA-256", "")
    assert place_words(("keep_out", 1, "low_mm", 0)) == "Keep-out boxes 2, lower corner"
    assert list(UNITS) == sorted(UNITS, key=lambda ending: -ending.count("_")), "longer endings first"


class Stated(Model):
    length_mm: float = Field(gt=0)
    uncertainty_mm: float = Field(gt=0)
    number: str = ""


def test_a_field_still_to_be_filled_in_is_no_error_before_it_was_touched(qtbot):
    form = made(qtbot, Stated)
    form.set_raw({"length_mm": 250.0})
    form.show()
    note, line = form._notes["uncertainty_mm"], form.editors["uncertainty_mm"].line
    assert form.problem() and not note.isVisible()
    form.editors["number"].line.textEdited.emit("4711")
    assert not note.isVisible()
    line.setText("0")
    line.textEdited.emit("0")
    assert note.isVisible() and note.text() == "Must be greater than 0."
    line.setText("")
    line.textEdited.emit("")
    assert note.isVisible()
