"""The inspection program and the drawing are changed in the window, and the part is measured again at once."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from measureapp.data.control_frame import CHARACTERISTICS
from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.length_unit import LengthUnit
from measureapp.inspection.dimensions import inspect
from measureapp.pipeline.measure_again import measure_again
from measureapp.progress import CallbackProgress, Cancelled
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import parse_program
from measureapp.report.project import compose_project
from ui.pages.inspection.grow_bar import ADD

PATIENCE_MS = 60_000
PROGRAM = """# by hand
name = "ball"
alignment = "none"

[[features]]
name = "ball"  # the only one
shape = "sphere"
point_mm = [0, 0, 60]
radius_mm = 60

[[dimensions]]
name = "size"
kind = "diameter"
features = ["ball"]
nominal = 120
"""


@pytest.fixture
def project(tmp_path, rig, measurement) -> ProjectFolder:
    """A measured ball of 120 mm with its middle at a height of 60 mm, and a plate beside it at 10 mm; the points have no noise."""
    made = ProjectFolder.create(tmp_path / "ball", ProjectSettings(name="ball", part="ball", rig=rig))
    made.save_calibration(measurement.calibration)
    made.save_program(PROGRAM)
    stitched = with_plate(measurement.stitched)
    made.save_measurement(replace(measurement, stitched=stitched, inspection=inspect(stitched, parse_program(PROGRAM))))
    return made


def with_plate(ball):
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(100.0, 180.0), np.arange(-40.0, 40.0)))
    count = len(x)
    more = {
        "points_mm": np.column_stack([x, y, np.full(count, 10.0)]),
        "normals": np.tile([0.0, 0.0, 1.0], (count, 1)),
        "sigma_mm": np.full(count, 0.01),
        "grey": np.full(count, 0.5),
        "view": np.zeros(count, int),
    }
    return replace(ball, **{name: np.concatenate([getattr(ball, name), values]) for name, values in more.items()})


@pytest.fixture
def opened(application, window, project, qtbot, monkeypatch):
    """The page Inspect with the project open."""
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.controllers.project.open(project.path)
    settled(application, qtbot)
    window.show_page("inspection")
    return window.pages["inspection"]


def settled(application, qtbot):
    controllers = application.controllers
    runners = (controllers.jobs, controllers.background, controllers.inspecting)
    qtbot.waitUntil(lambda: not any(one.queue.busy for one in runners) and not application.session.busy_with, timeout=PATIENCE_MS)
    return application.session.messages[-1]


def test_a_project_folder_that_is_gone_is_told_and_its_edits_can_be_saved_when_it_is_back(opened, application, project, qtbot, tmp_path):
    programming, away = application.controllers.programming, tmp_path / "away"
    programming.replace(PROGRAM.replace("nominal = 120", "nominal = 119"))
    settled(application, qtbot)
    project.path.rename(away)
    programming.save()
    said = settled(application, qtbot)
    assert said.text == f"The project folder {project.path} is gone." and said.hint.startswith("Connect its disk again")
    assert programming.is_modified
    away.rename(project.path)
    programming.save()
    assert settled(application, qtbot).text == "Program and results saved."
    assert "nominal = 119" in project.program.read_text(encoding="utf-8")


def ball_mesh(path, *, scale=1.0, radius=60.0):
    ball = trimesh.creation.icosphere(subdivisions=4, radius=radius)
    ball.apply_translation([0, 0, 60.0])
    plate = trimesh.creation.box([79, 79, 2], trimesh.transformations.translation_matrix([139.5, -0.5, 9.0]))
    mesh = trimesh.util.concatenate([ball, plate] if radius == 60.0 else [ball])
    mesh.apply_scale(scale)
    mesh.export(path)
    return path


def test_a_grown_feature_joins_the_program_with_a_dimension_and_both_are_undone(application, opened, project, qtbot):
    session = application.session
    opened.grow.button.setChecked(True)
    application.controllers.growing.grow(np.array([140.0, 0, 10.0]), "plane")
    settled(application, qtbot)
    assert opened.properties.decision == ADD
    opened.decide()
    assert "Plane 1 added" in settled(application, qtbot).text
    assert [feature.name for feature in session.inspection.features] == ["ball", "plane 1"] and opened.grow.last is None
    bar = opened.program.bar
    bar.button.setChecked(True)
    bar.first.setCurrentText("plane 1")
    bar.second.setCurrentText("ball")
    assert not bar.add.isEnabled() and "nominal" in bar.add.toolTip()
    bar.nominal.setValue(50.0)
    bar.tolerance.setValue(0.25)
    bar.add.click()
    settled(application, qtbot)
    added = session.inspection.dimensions[-1]
    assert (added.name, added.nominal, added.upper_tolerance, added.features) == ("distance 1", 50.0, 0.25, ("plane 1", "ball"))
    assert added.measured == pytest.approx(50.0, abs=1e-3)  # the points are exact to single precision
    assert opened.side.table.current_row().name == "distance 1"
    assert project.program_text(has_nominal=False) == PROGRAM and application.controllers.programming.is_modified
    application.controllers.programming.save()
    settled(application, qtbot)
    assert not application.controllers.programming.is_modified
    text = project.program_text(has_nominal=False)
    assert text.startswith("# by hand") and "# the only one" in text and 'name = "distance 1"' in text
    assert [one.name for one in project.measurement().inspection.dimensions] == ["size", "distance 1"]
    for left in (["size"], ["size"]):
        opened.undo.click()
        settled(application, qtbot)
        assert [one.name for one in session.inspection.dimensions] == left
    programming = application.controllers.programming
    assert programming.text() == PROGRAM and not programming.can_undo and programming.is_modified  # than what is saved


def test_a_colour_scale_is_stored_with_the_program_used_in_the_report_and_undone(application, opened, project, qtbot, tmp_path):
    programming, session = application.controllers.programming, application.session
    ball_mesh(tmp_path / "ball.stl")
    application.controllers.nominal.use(tmp_path / "ball.stl")
    settled(application, qtbot)
    qtbot.waitUntil(lambda: session.comparison is not None, timeout=PATIENCE_MS)
    card, display = opened.side.deviation, opened.display
    assert not card.store.isEnabled() and display.legend.tolerance == (-0.1, 0.1)
    display.take_legend(replace(display.legend, low=-0.4, high=0.3, steps=10, ramp="rainbow").with_tolerance(-0.02, 0.05))
    assert card.store.isEnabled()
    card.store.click()
    settled(application, qtbot)
    assert not card.store.isEnabled() and (display.legend.low, display.legend.steps) == (-0.4, 10)
    programming.save()
    settled(application, qtbot)
    stored = parse_program(project.program_text(has_nominal=True)).deviation_scale
    assert stored == DeviationScale(tolerance_mm=(-0.02, 0.05), range_mm=(-0.4, 0.3), steps=10, ramp="rainbow")
    reported = compose_project(ProjectFolder.open(project.path)).deviation
    assert (reported.scale.low, reported.scale.high, reported.scale.ramp) == (-0.4, 0.3, "rainbow")
    assert (reported.statistics.inside, reported.statistics.below) == pytest.approx(display.shares()[:2], abs=1e-9)
    programming.undo()
    settled(application, qtbot)
    assert display.legend.tolerance == (-0.1, 0.1) and display.legend.ramp == "blue-white-red"


def test_a_dimension_is_removed_and_a_feature_that_it_needs_is_not(application, opened, project, qtbot):
    opened.side.list.setValue("features")
    opened.side.features.select_names(["ball"])
    assert opened.properties.title == "Ball" and opened.properties.decision == "Remove feature Ball"
    opened.decide()
    told = settled(application, qtbot)
    assert told.level == "error" and told.text == "ball is used by size."
    opened.side.list.setValue("dimensions")
    opened.side.table.select(0)
    assert opened.properties.decision == "Remove dimension Size"
    opened.decide()
    settled(application, qtbot)
    assert application.session.inspection.dimensions == () and "# the only one" in application.controllers.programming.text()


def test_of_a_feature_and_a_dimension_of_one_name_the_selected_one_is_removed(application, opened, qtbot):
    from measureapp.inspection.programming import edits
    from measureapp.inspection.session.graph import Node

    programming = application.controllers.programming
    programming.edit(lambda program: edits.rename(program, Node("dimension", "size"), "ball"), "Renamed.")
    settled(application, qtbot)
    opened.side.list.setValue("features")
    opened.side.features.select_names(["ball"])
    opened.decide()
    assert settled(application, qtbot).text == "ball is used by ball."
    assert [one.name for one in programming.state.program.dimensions] == ["ball"]
    opened.side.list.setValue("dimensions")
    opened.side.table.select(0)
    opened.decide()
    settled(application, qtbot)
    assert not programming.state.program.dimensions and "ball" in [one.name for one in programming.state.program.features]


def test_a_click_on_a_feature_of_the_list_chooses_it_for_the_dimension(application, opened):
    bar = opened.program.bar
    bar.show_features(["ball", "top", "side"], [])
    for name in ("side", "top"):
        bar.take(name)
    assert bar.value().features == ("side", "top") and bar.value().name == "distance 1"
    bar.kind.setCurrentText("Diameter")
    assert bar.value().features == ("side",) and bar.second.isHidden()
    offered = [bar.kind.itemData(place) for place in range(bar.kind.count())]
    assert not set(offered) & set(CHARACTERISTICS)  # tolerance zones are the editor's


def test_a_program_that_is_none_stays_in_its_window_with_the_reason(application, opened, project, qtbot):
    dialog = opened.program.dialog
    opened.program.text.click()
    assert dialog.text.toPlainText() == PROGRAM
    dialog.text.setPlainText(PROGRAM.replace('"sphere"', '"spere"'))
    dialog.measure.click()
    assert dialog.isVisible() and "features.0" in dialog.problem.text() and "Correct" in dialog.problem.text()
    dialog.text.setPlainText(PROGRAM.replace("nominal = 120", "nominal = 119"))
    dialog.measure.click()
    settled(application, qtbot)
    assert not dialog.isVisible() and application.session.inspection.dimensions[0].nominal == 119
    opened.undo.click()
    settled(application, qtbot)
    assert project.program_text(has_nominal=False) == PROGRAM


def test_the_unit_of_a_nominal_in_inches_is_asked_for_and_never_assumed(application, opened, project, qtbot, tmp_path):
    path = ball_mesh(tmp_path / "ball.stl", scale=1 / 25.4)
    take, dialog_of = application.controllers.nominal.use, opened.program.nominal
    take(path)
    settled(application, qtbot)
    assert dialog_of.dialog.value() is LengthUnit.INCH and project.nominal is None
    dialog_of.dialog.reject()
    settled(application, qtbot)
    assert project.nominal is None and application.session.comparison is None
    take(path)
    settled(application, qtbot)
    dialog_of.dialog.accept_button.click()
    assert settled(application, qtbot).level == "done"
    assert np.ptp(read_mesh(project.nominal).vertices_mm, axis=0) == pytest.approx([239.0, 120.0, 120.0], abs=0.05)
    qtbot.waitUntil(lambda: application.session.comparison is not None, timeout=PATIENCE_MS)
    assert abs(application.session.comparison.deviation.mean_mm) < 0.2  # the sag of the drawing's triangles


def test_a_nominal_that_replaces_another_can_be_undone(application, opened, project, qtbot, tmp_path):
    take = application.controllers.nominal.use
    take(ball_mesh(tmp_path / "first.stl"))
    settled(application, qtbot)
    assert not application.controllers.programming.can_undo  # there was none before
    first = read_mesh(project.nominal).vertices_mm
    take(ball_mesh(tmp_path / "second.stl", scale=1.004))
    assert "second.stl" in settled(application, qtbot).text
    assert np.ptp(read_mesh(project.nominal).vertices_mm, axis=0) == pytest.approx(1.004 * np.ptp(first, axis=0), rel=1e-5)
    opened.undo.click()
    settled(application, qtbot)
    assert read_mesh(project.nominal).vertices_mm == pytest.approx(first) and not application.controllers.programming.can_undo


@pytest.mark.parametrize("content", ["another part", "nothing", "one point", "cut off"])
def test_a_nominal_that_cannot_be_used_is_reported_and_changes_nothing(application, opened, project, qtbot, tmp_path, content):
    path = tmp_path / ("point.ply" if content == "one point" else "drawing.stl")
    if content == "another part":
        ball_mesh(path, radius=14.0)
    elif content == "cut off":
        path.write_bytes(ball_mesh(tmp_path / "whole.stl").read_bytes()[:5000])
    else:
        header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n"
        path.write_text("" if content == "nothing" else header, encoding="ascii")
    before = application.session.inspection
    application.controllers.nominal.use(path)
    told = settled(application, qtbot)
    assert told.level == "error" and told.text.endswith(".") and told.hint
    assert project.nominal is None and application.session.inspection is before and opened.program.nominal.isEnabled()


def test_measuring_again_that_is_cancelled_leaves_everything_as_it_was(project):
    before, text = project.measurement(), project.program_text(has_nominal=False)

    def cancel(done, total, _note):
        if done / total > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        measure_again(project, before, CallbackProgress(cancel), program=text.replace("120", "121"))
    assert project.program_text(has_nominal=False) == text
    assert project.measurement().inspection.dimensions[0].nominal == 120


def test_operators_are_not_offered_to_change_the_program(application, opened, window):
    opened.program.bar.button.setChecked(True)
    window.header.role.setValue("operator")
    tools = opened.program
    assert not any(one.isVisible() for one in (tools.text, tools.nominal, tools.bar.button, tools.bar, opened.grow.button))
    window.header.role.setValue("engineer")
    assert tools.text.isVisible() and tools.bar.button.isVisible()


def test_a_default_best_fit_is_said_to_be_nobodys_choice_and_leads_to_the_choice(application, opened, qtbot):
    programming, notice = application.controllers.programming, opened.side.unaligned
    assert not notice.isVisibleTo(opened) or "alignment" not in programming.state.program.model_fields_set
    lines = [line for line in programming.text().splitlines() if not line.startswith("alignment")]
    programming.replace("\n".join(lines))
    settled(application, qtbot)
    assert notice.isVisibleTo(opened)
    notice.choose.click()
    assert opened.side.list.value() == "alignment"
    programming.replace("\n".join([lines[0], 'alignment = "none"', *lines[1:]]))
    settled(application, qtbot)
    assert not notice.isVisibleTo(opened)
