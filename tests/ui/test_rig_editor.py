"""A rig is edited in a form made from the drivers' own settings."""

from __future__ import annotations

import pytest
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit

from measureapp.devices.plugin_loader import discover, load_driver
from measureapp.errors import PluginError
from measureapp.project.rig_file import read_rig
from ui.pages.rig.rig_editor import RigEditor
from ui.widgets.model_form import ModelForm

DRIVERS = [(row.id, kind) for row in discover() for kind in row.kinds]


@pytest.mark.parametrize(("plugin", "kind"), DRIVERS)
def test_every_driver_has_a_form_whose_empty_fields_leave_the_defaults(qtbot, plugin, kind):
    try:
        settings = load_driver(None, plugin, kind).settings
    except PluginError as error:
        pytest.skip(str(error))
    form = ModelForm(settings)
    qtbot.addWidget(form)
    assert set(form.editors) == set(settings.model_fields)
    required = [name for name, field in settings.model_fields.items() if field.is_required()]
    assert form.document().keys() <= set(required)
    assert bool(form.problem()) == bool(required)


def test_what_is_shown_is_what_is_read_back(qtbot):
    settings = load_driver(None, "axis_modbus", "linear-guide").settings
    form = ModelForm(settings)
    qtbot.addWidget(form)
    document = {"drive": "toyo_xc100", "link": "bus", "unit_id": 3, "sense": -1, "speed": 12.5}
    form.setValue(document)
    assert form.document() == document
    assert form.value() == settings.model_validate(document)


def test_lists_tables_and_choices_survive(qtbot):
    settings = load_driver(None, "virtual_rig", "rig").settings
    form = ModelForm(settings)
    qtbot.addWidget(form)
    document = {"part": "gear", "world": {"knocked_deg": {"left": [0.1, 0, 0]}}}
    form.setValue(document)
    assert form.document() == document


def test_a_value_that_does_not_fit_is_told_under_the_form(qtbot):
    form = ModelForm(load_driver(None, "axis_modbus", "linear-guide").settings)
    qtbot.addWidget(form)
    form.setValue({"drive": "toyo_xc100", "link": "bus"})
    form.editors["speed"].setText("fast")
    assert "speed" in form.problem()
    assert form.trouble.text() == form.problem()


def test_a_decimal_comma_is_understood(qtbot):
    form = ModelForm(load_driver(None, "axis_modbus", "linear-guide").settings)
    qtbot.addWidget(form)
    form.setValue({"drive": "toyo_xc100", "link": "bus"})
    form.editors["speed"].setText("12,5")
    assert form.document()["speed"] == 12.5


@pytest.fixture
def editor(application, qtbot):
    made = RigEditor(application.look, read_rig("paper"), discover(), application.window)
    qtbot.addWidget(made)
    return made


def test_a_rig_that_was_not_changed_is_saved_as_it_was(editor, tmp_path):
    assert not editor.problem()
    editor.write(tmp_path / "mine.toml")
    assert read_rig(tmp_path / "mine.toml") == read_rig("paper")


def test_a_rig_is_composed_of_drivers_and_saved(editor, tmp_path):
    editor.way.setCurrentIndex(editor.way.findData("devices"))
    assert not editor.save.isEnabled(), "devices without their settings"
    for name in ("left", "right", "upper", "projector"):
        editor.devices[name].show_choice("virtual_rig", {})
    editor.devices["robot"].show_choice("robot_generic_tcp", {"host": "10.0.0.2"} if "host" in editor.devices["robot"].form.editors else {})
    for name, drive in (("guide", "toyo_xc100"), ("table", "oriental_az")):
        editor.devices[name].show_choice("axis_modbus", {"drive": drive, "link": "line1"})
    editor.links.setPlainText('[cell]\npart = "flat"\n\n[line1]\nport = "COM3"\n')
    editor.basics.editors["name"].setText("Cell 4")
    assert editor.problem() == ""
    editor.write(tmp_path / "mine.toml")
    rig = read_rig(tmp_path / "mine.toml")
    assert rig.name == "Cell 4"
    assert rig.drivers["table"] == "axis_modbus"
    assert rig.links["line1"] == {"port": "COM3"}


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda editor: editor.basics.editors["reference"].setText("top"), "the reference camera 'top'"),
        (lambda editor: editor.links.setPlainText("[line1"), "Links:"),
        (lambda editor: editor.motion.editors["settle_s"].setText("-1"), "settle_s"),
        (lambda editor: editor.basics.editors["exposures_us"].setText("long"), "exposures_us"),
    ],
)
def test_what_does_not_fit_is_told_in_a_sentence_and_cannot_be_saved(editor, spoil, words):
    spoil(editor)
    assert words in editor.problem()
    assert words in editor.trouble.text()
    assert not editor.save.isEnabled()


def test_editors_fit_their_kind_of_value(qtbot):
    form = ModelForm(load_driver(None, "axis_modbus", "linear-guide").settings)
    qtbot.addWidget(form)
    assert isinstance(form.editors["sense"], QComboBox)
    assert isinstance(form.editors["speed"], QLineEdit)
    virtual = ModelForm(load_driver(None, "camera_genicam", "camera").settings)
    qtbot.addWidget(virtual)
    assert isinstance(virtual.editors["exposure_chunk"], QCheckBox)
