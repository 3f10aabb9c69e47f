"""A mesh of one's own for the demo: looked at before it is taken, its unit asked for where it is not plainly millimetres."""

from __future__ import annotations

import pytest
import trimesh

from measureapp.data.length_unit import LengthUnit
from ui.look.demo_settings import DemoSettings
from ui.look.paths import demo_folder
from ui.widgets.unit_dialog import UnitDialog

PATIENCE_MS = 30_000


@pytest.fixture
def take(application, window, rig, tmp_path, qtbot):
    """Choose a box with this longest side, or a file with this content."""

    def taken(what):
        path = tmp_path / "box.stl"
        if isinstance(what, bytes):
            path.write_bytes(what)
        else:
            trimesh.creation.box([what, what / 2, what / 3]).export(path)
        application.session.set_rig(rig)
        window.pages["rig"].form.meshChosen.emit(path)
        qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=PATIENCE_MS)
        return path

    return taken


def test_a_mesh_of_the_rigs_size_is_taken_without_a_question(application, window, take):
    path = take(120.0)
    assert application.controllers.demo.settings.part == str(path)
    assert application.controllers.demo.settings.unit is LengthUnit.MM and window.pages["rig"].unit_dialog is None


@pytest.mark.parametrize(("side", "likely"), [(4.0, LengthUnit.INCH), (0.12, LengthUnit.M)])
def test_a_mesh_of_another_unit_is_asked_about_and_a_question_closed_changes_nothing(application, window, take, side, likely):
    path, rig = take(side), window.pages["rig"]
    assert rig.unit_dialog.value() is likely
    said = rig.unit_dialog.units[likely].text().replace("\u00a0", " ")
    assert f"{side * likely.in_mm:.1f} mm" in said
    rig.unit_dialog.reject()
    assert application.controllers.demo.settings == DemoSettings()
    take(side)
    rig.unit_dialog.accept_button.click()
    chosen = application.controllers.demo.settings
    assert (chosen.part, chosen.unit) == (str(path), likely)
    assert likely.words in rig.form._part.currentText() and str(likely) in demo_folder(chosen).name


@pytest.mark.parametrize("content", [b"", b"solid box\nfacet", b"\0" * 84])
def test_a_mesh_that_cannot_be_read_keeps_the_part_and_says_why(application, window, take, content):
    path = take(content)
    told = application.session.messages[-1]
    assert told.level == "error" and str(path) in told.text and told.hint
    assert application.controllers.demo.settings == DemoSettings() and window.pages["rig"].form.value() == DemoSettings()


def test_the_marked_unit_is_the_one_reported(qtbot, application):
    dialog = UnitDialog(application.look, "points", "The points span 7.1, the nominal 180 mm", LengthUnit.INCH)
    qtbot.addWidget(dialog)
    dialog.units[LengthUnit.CM].click()
    with qtbot.waitSignal(dialog.chosen) as told:
        dialog.accept_button.click()
    assert told.args == [LengthUnit.CM]
