"""Circle, slot, line, edge and hole pattern by clicking on the Inspect page, with a CAD model and without one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from inspection.drilled_plate import HOLE_MM, HOLES_AT, SLOT_LENGTH_MM, SLOT_WIDTH_MM, drilled_plate, points_on
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from measureapp.inspection.dimensions import inspect
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.program_file import parse_program
from ui.controllers.comparison import compute_comparison
from ui.pages.inspection.dimension_side import TABLE_WIDTH
from ui.pages.viewport_page import PictureSplitter
from ui.session import Comparison
from ui.viewport.pick import Pick
from ui.widgets.data_table import is_in_sight

PATIENCE_MS = 60_000
NOISE_MM = 0.01
FACETS_MM = 0.022  # of a diameter: the points are on facets, inside the circle through their vertices
TOP = '[[features]]\nname = "top {number}"\nshape = "surface_point"\npoint_mm = [{number}, 20, 10]\ndirection = [0, 0, 1]\n\n'
COMPARED: list[Comparison] = []
LONG = 16  # more features than the list shows at once


@pytest.fixture
def has_nominal() -> bool:
    return True


@pytest.fixture
def page(application, window, tmp_path, rig, measurement, has_nominal, qtbot, monkeypatch):
    """The page with a plate of holes, and more features than its list shows."""
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    text = 'name = "plate"\nalignment = "none"\n\n' + "".join(TOP.format(number=number) for number in range(LONG))
    folder = ProjectFolder.create(tmp_path / "plate", ProjectSettings(name="plate", part="plate", rig=rig))
    folder.save_calibration(measurement.calibration)
    folder.save_program(text)
    points = points_on(drilled_plate(), noise_mm=NOISE_MM)
    count = len(points)
    arrays = {"points_mm": points.points_mm, "normals": points.normals, "sigma_mm": np.full(count, NOISE_MM)}
    stitched = replace(measurement.stitched, **arrays, grey=np.full(count, 0.5), view=np.zeros(count, int))
    folder.save_measurement(replace(measurement, stitched=stitched, mesh=None, inspection=inspect(stitched, parse_program(text))))
    application.controllers.project.open(folder.path)
    window.show_page("inspection")
    settled(application, qtbot)
    if has_nominal:
        application.session.set_comparison(compared(application.session))
        settled(application, qtbot)
    shown = window.pages["inspection"]
    shown.side.list.setValue("features")
    return shown


def compared(session) -> Comparison:
    """The deviations from the nominal plate, computed once: all tests have the same points."""
    if not COMPARED:
        alignment = session.inspection.alignment
        COMPARED.append(compute_comparison(session.stitched, drilled_plate(), alignment, None, NoProgress()))
    return replace(COMPARED[0], stitched=session.stitched)


def settled(application, qtbot):
    runners = application.controllers.runners
    qtbot.waitUntil(lambda: not any(one.queue.busy for one in runners) and not application.session.busy_with, timeout=PATIENCE_MS)
    return application.session.messages[-1]


def begin(page, kind):
    menu = page.side.create.new.menu()
    menu.actions()[["circle", "slot", "line", "edge", "pattern"].index(kind)].trigger()
    assert page.side.contour.isVisible() and page.side.create.isHidden()


def click(application, page, qtbot, place):
    page.view.picked.emit(Pick(np.zeros(3), np.array([0, 0, -1.0]), None if place is None else np.array(place, float)))
    settled(application, qtbot)


def features(application):
    return {one.name: one for one in application.session.inspection.features}


def entry(application):
    return application.controllers.programming.state.program.features[-1]


def test_a_circle_is_created_by_a_click_beside_its_hole_measured_listed_and_undone(application, page, qtbot):
    bar = page.side.contour
    begin(page, "circle")
    assert "Click the wall" in bar.words.text() and bar.fields.isHidden() and bar.create.isHidden()
    lines = len(page.view._lines)
    click(application, page, qtbot, [30.0, 17.0, 10.0])
    assert bar.create.isEnabled() and bar.fields.sizes["radius_mm"].value() == pytest.approx(2 * HOLE_MM, abs=1e-3)
    assert bar.fields.vectors["point_mm"].value()[:2] == pytest.approx(HOLES_AT[1], abs=1e-3)
    assert "diameter" in bar.found.text() and len(page.view._lines) > lines  # it is drawn before it exists
    assert "circle 1" not in features(application)
    bar.create.click()
    settled(application, qtbot)
    found = features(application)["circle 1"]
    assert 2 * found.radius_mm == pytest.approx(2 * HOLE_MM, abs=FACETS_MM)
    assert found.point_mm[:2] == pytest.approx(HOLES_AT[1], abs=5 * NOISE_MM * np.sqrt(2 / found.points))
    table = page.side.features
    assert table.names() == ("circle 1",) and bar.isHidden() and page.side.create.isVisible()
    assert is_in_sight(table, table.model().index(table.model().rowCount() - 1, 0), table.viewport().height())
    assert page.side.create.choice.currentText().replace("\u00a0", " ") == "Diameter 12.000 mm"
    page.undo.click()
    settled(application, qtbot)
    assert "circle 1" not in features(application)


def test_values_are_corrected_before_the_feature_is_created(application, page, qtbot):
    bar = page.side.contour
    begin(page, "circle")
    click(application, page, qtbot, [36.0, 10.0, 5.0])
    field = bar.fields.sizes["height_mm"]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "3,5")
    bar.create.click()  # without leaving the field
    settled(application, qtbot)
    assert entry(application).height_mm == 3.5 and entry(application).radius_mm == pytest.approx(HOLE_MM, abs=1e-5)


def test_values_with_which_nothing_is_measured_are_refused_in_words(application, page, qtbot):
    bar = page.side.contour
    begin(page, "circle")
    click(application, page, qtbot, [36.0, 10.0, 5.0])
    bar.fields.vectors["point_mm"].lines[2].setText("80")
    bar.fields.vectors["point_mm"].lines[2].editingFinished.emit()
    settled(application, qtbot)
    assert not bar.create.isEnabled() and "points were measured there" in bar.problem.text() and "change the values" in bar.problem.text()
    bar.fields.vectors["point_mm"].lines[2].setText("5")
    bar.fields.vectors["point_mm"].lines[2].editingFinished.emit()
    settled(application, qtbot)
    assert bar.create.isEnabled()


@pytest.mark.parametrize(
    ("kind", "clicks", "shape"),
    [
        ("slot", [[20.0, 26.0, 5.0]], "slot"),
        ("line", [[2.0, 19.0, 10.0], [58.0, 19.0, 10.0]], "line"),
        ("edge", [[20.0, 1.0, 10.0]], "line"),
    ],
)
def test_slot_line_and_edge_are_created_by_clicks(application, page, qtbot, kind, clicks, shape):
    begin(page, kind)
    for place in clicks:
        assert page.side.contour.create.isHidden()
        click(application, page, qtbot, place)
    page.side.contour.create.click()
    settled(application, qtbot)
    found = features(application)[f"{kind} 1"]
    assert found.shape == shape and page.side.features.names() == (f"{kind} 1",)
    if kind == "slot":
        assert (found.length_mm, 2 * found.radius_mm) == pytest.approx((SLOT_LENGTH_MM, SLOT_WIDTH_MM), abs=FACETS_MM)
        shown = dict(page.properties.groups[0].rows)
        assert {"Width", "Length"} <= shown.keys() and "Radius" not in shown
        assert page.side.features.texts()[-1][3] == f"{2 * found.radius_mm:.3f} × {found.length_mm:.3f}"


def test_one_click_creates_the_pattern_of_all_equal_holes(application, page, qtbot):
    begin(page, "pattern")
    click(application, page, qtbot, [10.0, 16.0, 5.0])
    assert page.side.contour.found.text().endswith("3 of 3.") and page.side.contour.fields.sizes["count"].value() == 3
    page.side.contour.create.click()
    settled(application, qtbot)
    names = tuple(f"hole pattern 1.{number}" for number in (1, 2, 3))
    assert page.side.features.names() == names
    for name, place in zip(names, HOLES_AT, strict=True):
        assert features(application)[name].point_mm[:2] == pytest.approx(place, abs=5e-3)


def test_selected_circles_become_a_pattern(application, page, qtbot):
    for x, y in HOLES_AT[:2]:
        begin(page, "circle")
        click(application, page, qtbot, [x, y + HOLE_MM, 5.0])
        page.side.contour.create.click()
        settled(application, qtbot)
    page.side.features.select_names(["circle 1", "circle 2"])
    begin(page, "pattern")
    settled(application, qtbot)
    bar = page.side.contour
    bar.fields.sizes["count"].setValue(3)  # the third follows at the same distance
    settled(application, qtbot)
    assert bar.found.text().endswith("3 of 3.")
    bar.create.click()
    settled(application, qtbot)
    assert features(application)["hole pattern 1.3"].point_mm[:2] == pytest.approx(HOLES_AT[2], abs=5e-3)


def test_a_wrong_click_is_refused_with_a_remedy_and_asked_for_again(application, page, qtbot):
    bar = page.side.contour
    begin(page, "circle")
    click(application, page, qtbot, [20.0, 26.0, 5.0])
    assert (
        "not a cylinder" in bar.problem.text()
        and "slot" in bar.problem.text()
        and "Click the wall" in bar.words.text()
        and bar.create.isHidden()
    )
    assert not [one for one in application.session.messages if one.level == "error"]  # it is said where the clicks are guided
    click(application, page, qtbot, None)
    assert "nothing at the clicked place" in bar.problem.text()
    click(application, page, qtbot, [36.0, 10.0, 5.0])
    assert bar.create.isEnabled()
    click(application, page, qtbot, [10.0, 16.0, 5.0])  # another hole in its place
    assert bar.fields.vectors["point_mm"].value()[:2] == pytest.approx(HOLES_AT[0], abs=1e-3)


def test_esc_cancels_and_undo_takes_the_last_click(application, page, qtbot):
    bar, contouring = page.side.contour, application.controllers.contouring
    before = application.controllers.programming.state
    begin(page, "line")
    click(application, page, qtbot, [2.0, 19.0, 10.0])
    assert "ends" in bar.words.text() and page.undo.isVisible()
    page.undo_last()
    assert "begins" in bar.words.text() and not contouring.can_undo
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert not contouring.is_on and bar.isHidden() and page.side.create.isVisible()
    begin(page, "edge")
    page.side.list.setValue("dimensions")
    assert not contouring.is_on
    page.side.list.setValue("features")
    begin(page, "edge")
    page.distance.button.setChecked(True)
    assert not contouring.is_on and page.distance.is_on
    page.side.list.setValue("features")
    begin(page, "edge")
    assert not page.distance.is_on and application.controllers.programming.state is before


class TestWithoutAModel:
    @pytest.fixture
    def has_nominal(self) -> bool:
        return False

    def test_three_clicks_give_a_circle(self, application, page, qtbot):
        begin(page, "circle")
        for turn, z in ((0.2, 4.0), (2.2, 6.0), (4.4, 5.0)):
            assert page.side.contour.create.isHidden()
            click(application, page, qtbot, [*(HOLES_AT[0] + HOLE_MM * np.array([np.cos(turn), np.sin(turn)])), z])
        page.side.contour.create.click()
        settled(application, qtbot)
        found = features(application)["circle 1"]
        assert 2 * found.radius_mm == pytest.approx(2 * HOLE_MM, abs=FACETS_MM)
        assert found.point_mm[:2] == pytest.approx(HOLES_AT[0], abs=5e-3)

    def test_a_pattern_says_how_it_is_made(self, application, page, qtbot):
        begin(page, "pattern")
        assert "Without a CAD model" in page.side.contour.problem.text()
        click(application, page, qtbot, [10.0, 16.0, 5.0])
        assert page.side.contour.create.isHidden()

    def test_faces_cannot_be_picked_and_the_reason_is_said(self, application, page, qtbot):
        page.side.create.pick.setChecked(True)
        click(application, page, qtbot, [30.0, 20.0, 10.0])
        assert "no CAD model" in application.session.messages[-1].text


def test_the_picture_is_never_narrower_than_the_table_and_the_side_keeps_its_width(application, window, page, qtbot):
    splitter = page.findChild(PictureSplitter)
    for width in (1280, 1920, 1280):
        window.resize(width, 720)
        qtbot.waitUntil(lambda width=width: window.width() == width)
        qtbot.wait(50)
        picture, side = splitter.sizes()
        assert picture >= side >= 400 and side <= TABLE_WIDTH
    splitter.setSizes([5000, 430])
    splitter.splitterMoved.emit(0, 1)
    window.resize(1600, 720)
    qtbot.waitUntil(lambda: window.width() == 1600)
    qtbot.wait(50)
    assert splitter.sizes()[1] == pytest.approx(430, abs=30)


def test_apply_stays_in_sight_where_the_tolerance_editor_has_more_fields_than_room(application, window, page, qtbot):
    window.resize(1280, 720)
    page.side.features.select_names(["top 5"])
    page.side.create.tolerance.click()
    editor = page.side.tolerance
    editor.kind.setCurrentIndex(editor.kind.findData("position"))
    qtbot.wait(50)
    below = editor.apply.mapTo(page.side, editor.apply.rect().bottomLeft()).y()
    assert editor.apply.isVisible() and below < page.side.height()
