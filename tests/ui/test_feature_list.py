"""The list of features: proposals, constructed features, names, and what is refused in words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu

from measureapp.inspection.dimensions import inspect
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.program_file import parse_program
from ui.widgets.data_table import is_in_sight

PATIENCE_MS = 60_000
BALL = '[[features]]\nname = "ball"\nshape = "sphere"\npoint_mm = [0, 0, 60]\nradius_mm = 60\n\n'
PLATE = '[[features]]\nname = "{name}"\nshape = "plane"\npoint_mm = [140, 0, 10]\ndirection = [0, 0, 1]\ncut = {{ edge_mm = 0 }}\n\n'
SIZE = '[[dimensions]]\nname = "size"\nkind = "diameter"\nfeatures = ["ball"]\nnominal = 120\n'
PROGRAM = 'name = "ball"\nalignment = "none"\n\n' + BALL + PLATE.format(name="plate") + SIZE
LONG = 30  # more rows than a list shows at once


def made(tmp_path, rig, measurement, program) -> ProjectFolder:
    """A measured ball of 120 mm and a plate beside it at 10 mm; the points have no noise."""
    folder = ProjectFolder.create(tmp_path / "ball", ProjectSettings(name="ball", part="ball", rig=rig))
    folder.save_calibration(measurement.calibration)
    folder.save_program(program)
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(100.0, 180.0, 2), np.arange(-40.0, 40.0, 2)))
    count, ball = len(x), measurement.stitched
    more = {
        "points_mm": np.column_stack([x, y, np.full(count, 10.0)]),
        "normals": np.tile([0.0, 0.0, 1.0], (count, 1)),
        "sigma_mm": np.full(count, 0.01),
        "grey": np.full(count, 0.5),
        "view": np.zeros(count, int),
    }
    stitched = replace(ball, **{name: np.concatenate([getattr(ball, name), values]) for name, values in more.items()})
    folder.save_measurement(replace(measurement, stitched=stitched, inspection=inspect(stitched, parse_program(program))))
    return folder


@pytest.fixture
def program() -> str:
    return PROGRAM


@pytest.fixture
def page(application, window, tmp_path, rig, measurement, program, qtbot, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.controllers.project.open(made(tmp_path, rig, measurement, program).path)
    window.show_page("inspection")
    settled(application, qtbot)
    shown = window.pages["inspection"]
    shown.side.list.setValue("features")
    return shown


def settled(application, qtbot):
    controllers = application.controllers
    runners = (controllers.jobs, controllers.background, controllers.inspecting)
    qtbot.waitUntil(lambda: not any(one.queue.busy for one in runners) and not application.session.busy_with, timeout=PATIENCE_MS)
    return application.session.messages[-1]


def cells(page, name):
    return next(row for row in page.side.features.texts() if row[0] == name)


def names(application):
    return [one.name for one in application.session.inspection.features]


def test_enter_never_adds_what_was_proposed_for_an_earlier_selection(application, page, monkeypatch):
    page.side.features.select_names(["ball", "plate"])
    bar = page.side.create
    assert bar.choice.count() == 1

    def fail(_names):
        raise RuntimeError("no proposal")

    monkeypatch.setattr(application.controllers.creating, "proposals", fail)
    with pytest.raises(RuntimeError):
        bar.show_proposals()
    bar.accept()
    assert [one.name for one in application.controllers.programming.state.program.dimensions] == ["size"]


def test_new_entries_are_named_in_the_language_of_the_window_and_keep_their_names(application, page, qtbot):
    application.settings.set_text("language", "zh_CN")
    page.side.features.select_names(["plate"])
    page.side.create.menu.actions()[0].trigger()
    settled(application, qtbot)
    page.side.features.select_names(["ball"])
    page.side.create.accept()
    settled(application, qtbot)
    application.settings.set_text("language", "en")
    application.language.retranslation.finish()
    program = application.controllers.programming.state.program
    assert (program.features[-1].name, program.dimensions[-1].name) == ("偏置平面 1", "ball 直径")
    assert "偏置平面 1" in [row[0] for row in page.side.features.texts()]


def test_a_constructed_feature_is_made_at_its_distance_and_listed_with_what_it_is_made_from(application, page, qtbot):
    page.side.features.select_names(["plate"])
    bar = page.side.create
    assert not bar.distance.isHidden() and bar.distance.value() == 10.0
    bar.distance.selectAll()
    qtbot.keyClicks(bar.distance, "-2,5")
    bar.menu.actions()[0].trigger()
    settled(application, qtbot)
    entry = application.controllers.programming.state.program.features[-1]
    assert (entry.name, entry.distance_mm) == ("offset plane 1", -2.5)
    assert cells(page, "Offset plane 1")[2:] == ["plane, constructed", "–", "–", "–"]
    assert page.side.features.constructed["offset plane 1"].of == ("plate",)
    (group,) = page.properties.groups
    assert [(name, words.replace("\u00a0", " ")) for name, words in group.rows] == [
        ("Constructed from", "Plate"),
        ("Distance", "\u22122.500 mm"),
    ]
    assert bar.choice.count() == 0 and "alone" in bar.words.text()  # it has no form of its own


def test_the_distance_of_an_offset_plane_is_changed_from_its_menu(application, page, qtbot):
    table, programming = page.side.features, application.controllers.programming
    assert "Distance…" not in offered(table)  # nothing is selected
    table.select_names(["plate"])
    assert "Distance…" not in offered(table)
    page.side.create.menu.actions()[0].trigger()
    settled(application, qtbot)
    assert application.session.messages[-1].text == "Offset plane 1 added to the inspection program."
    assert table.names() == ("offset plane 1",) and "Distance…" in offered(table)
    page.side.feature_actions.change_distance()
    dialog = page.side.feature_actions.dialog
    assert dialog.field.value() == 10.0
    dialog.field.lineEdit().setText("-4,25 mm")
    dialog.use.click()
    settled(application, qtbot)
    assert programming.state.program.features[-1].distance_mm == -4.25
    moved = next(one for one in application.session.inspection.features if one.name == "offset plane 1")
    plate = next(one for one in application.session.inspection.features if one.name == "plate")
    assert (moved.point_mm - plate.point_mm) @ plate.direction == pytest.approx(-4.25)
    page.undo_last()
    settled(application, qtbot)
    assert programming.state.program.features[-1].distance_mm == 10.0


def offered(table) -> list[str]:
    menu = QMenu(table)
    table.menuAsked.emit(menu)
    return [one.text() for one in menu.actions()]


def test_a_feature_is_renamed_and_deleted_from_its_list(application, page, qtbot):
    table = page.side.features
    table.select_names(["plate"])
    qtbot.keyClick(table, Qt.Key.Key_F2)
    dialog = page.side.feature_actions.dialog
    dialog.line.setText("Ball")
    assert not dialog.use.isEnabled() and "already" in dialog.problem.text()
    dialog.line.setText("base_plate")
    dialog.use.click()
    settled(application, qtbot)
    assert names(application) == ["ball", "base_plate"] and table.names() == ("base_plate",)
    page.side.feature_actions.remove()  # no window is active here after a dialog, so that keys go nowhere
    settled(application, qtbot)
    assert names(application) == ["ball"] and table.names() == ()
    page.undo_last()
    settled(application, qtbot)
    assert names(application) == ["ball", "base_plate"]
    table.select_names(["base_plate"])
    menu = page.side.datums.menu("base_plate")
    assert [one.text() for one in menu.actions() if one.isEnabled() and not one.isSeparator()][1:] == ["Rename…", "Delete"]


def test_a_feature_that_others_need_is_kept_and_these_are_named(application, page, qtbot):
    page.side.features.select_names(["ball"])
    qtbot.keyClick(page.side.features, Qt.Key.Key_Delete)
    told = settled(application, qtbot)
    assert told.level == "error" and told.text == "ball is used by size." and names(application) == ["ball", "plate"]


def test_a_distance_of_a_feature_to_itself_cannot_be_added(page):
    bar = page.program.bar
    bar.nominal.setValue(10.0)
    bar.first.setCurrentText("ball")
    bar.second.setCurrentText("ball")
    assert not bar.add.isEnabled() and "different" in bar.problem.text() and "different" in bar.add.toolTip()
    bar.second.setCurrentText("plate")
    assert bar.add.isEnabled() and not bar.problem.text()


MANY = [PLATE.format(name=f"plate {k}") for k in range(LONG)], [SIZE.replace("size", f"size {k}") for k in range(LONG)]


@pytest.mark.parametrize("program", ["\n".join(['name = "many"\nalignment = "none"\n', BALL, *MANY[0], *MANY[1]])])
def test_what_is_new_is_scrolled_into_sight(application, page, qtbot):
    features, dimensions = page.side.features, page.side.table
    features.select_names(["plate 0"])
    page.side.create.menu.actions()[0].trigger()
    settled(application, qtbot)
    assert features.names() == ("offset plane 1",) and features.verticalScrollBar().maximum() > 0
    last = features.model().index(features.model().rowCount() - 1, 0)
    qtbot.waitUntil(lambda: is_in_sight(features, last))
    features.select_names(["ball", "offset plane 1"])
    page.side.create.accept()
    settled(application, qtbot)
    assert dimensions.current_row().name == "ball – offset plane 1" and dimensions.verticalScrollBar().maximum() > 0
    qtbot.waitUntil(lambda: is_in_sight(dimensions, dimensions.currentIndex()))
