"""Every page says what there is, empty and filled."""

from __future__ import annotations

import pytest
from PySide6.QtGui import QImage

from ui.controllers.documents import FORMATS
from ui.look.wording import millimetres
from ui.pages.calibration_rows import added_to_length_mm
from ui.session import DriverRow
from ui.widgets.properties_panel import Properties

WITH_DATA = ("calibration", "plan", "scan", "clouds", "inspection", "report")


@pytest.fixture
def filled(application, window, rig, plan, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    session = application.session
    session.open_project("demo-gypsum", "gypsum", None)
    session.set_rig(rig, (DriverRow("virtual_rig", "rig", "1.0"), DriverRow("broken", "camera", "0.1", "The manifest has no entry.")))
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    return window


@pytest.fixture
def drawn(qtbot):
    """Waits until the picture of a page is composed and shown."""

    def wait(page):
        qtbot.waitUntil(lambda: not page.is_composing, timeout=10_000)
        return page

    return wait


def plain(text: str) -> str:
    return text.replace("\u00a0", " ").replace("\u2009", " ").strip()


def test_an_empty_page_says_it_in_a_sentence_with_one_filled_button(window):
    own = {"calibration": "Calibrate the whole rig…", "plan": "Generate a plan…", "scan": "Set up a scan"}
    for name in WITH_DATA:
        window.show_page(name)
        page = window.pages[name]
        assert page.is_empty, name
        assert page.empty.text.text().endswith("."), name
        assert plain(page.empty.button.text()) == own.get(name, "Run the demo")
        buttons = page.findChildren(type(page.empty.button))
        assert [one for one in buttons if one.isVisible() and one.property("role") == "primary"] == [page.empty.button], name


@pytest.mark.parametrize("title", ["Opening project", "Opening the sample project"])
def test_an_empty_page_claims_no_work_while_a_project_is_opened(application, window, title):
    for name in ("calibration", "plan", "scan", "clouds", "inspection", "report"):
        window.show_page(name)
        application.session.set_busy(title)
        assert window.pages[name].empty.heading.text() == "Opening the project…"
        application.session.set_busy("")
        assert window.pages[name].empty.heading.text() != "Opening the project…"


def test_an_empty_page_in_a_running_job_waits_without_a_button(application, window):
    for name in WITH_DATA:
        window.show_page(name)
        application.session.set_busy("Demo: gypsum")
        assert not window.pages[name].empty.button.isVisible()
        application.session.set_busy("")
        assert window.pages[name].empty.button.isVisible()


def test_a_filled_page_shows_its_body_and_has_properties(filled):
    for name in ("rig", *WITH_DATA):
        filled.show_page(name)
        page = filled.pages[name]
        assert not page.is_empty
        assert page.state.text().endswith((".", "…"))
        assert isinstance(page.properties, Properties)
        assert filled.properties.shown is page.properties
        assert page.properties.groups


def test_the_rig_page_lists_every_device_and_the_driver_that_failed(filled):
    page = filled.pages["rig"]
    rows = page.devices.texts()
    assert [row[0] for row in rows] == ["Camera left", "Camera right", "Camera upper", "Projector", "Robot", "Linear guide", "Rotary table"]
    assert "2592 × 1944 px" in rows[0][2]
    assert "1 driver could not be loaded" in page.state.text()
    assert filled.header.devices.text() == "1 driver failed"


def test_the_rig_is_drawn(filled):
    picture = filled.pages["rig"].drawing.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    colours = {picture.pixel(x, y) for x in range(0, picture.width(), 7) for y in range(0, picture.height(), 7)}
    assert len(colours) > 4


def test_the_calibration_page_judges_every_solution(filled):
    filled.show_page("calibration")
    page = filled.pages["calibration"]
    rows = page.table.texts()
    assert [row[0] for row in rows] == ["Camera left", "Camera right", "Camera upper", "Hand–eye", "Linear guide", "Table axis"]
    assert [row[4] for row in rows] == ["Good"] * 6
    assert plain(rows[3][3]) == "0.213 mm"
    assert plain(page.verdict.text()) == plain(millimetres(added_to_length_mm(filled.session.calibration, filled.session.rig)))
    page.table.selectRow(0)
    assert plain(dict(page.properties.groups[0].rows)["Blur of its images"]) == "0.75 px"
    page.table.selectRow(3)
    assert "Blur of its images" not in dict(page.properties.groups[0].rows)
    assert page.chart.bars[-1].name == "Together"
    assert page.chart.bars[-1].value == pytest.approx(sum(bar.value**2 for bar in page.chart.bars[:-1]) ** 0.5)


def test_a_poor_solution_is_named(filled, application, calibration):
    from dataclasses import replace

    application.session.set_calibration(replace(calibration, axis=replace(calibration.axis, residual_mm=0.31)))
    filled.show_page("calibration")
    page = filled.pages["calibration"]
    assert page.table.texts()[5][4] == "Poor"
    assert "Table axis" in page.state.text()
    assert "✗" in filled.header.calibration.text()


def test_the_plan_page_lists_the_viewpoints_of_the_project(filled, plan):
    page = filled.pages["plan"]
    filled.show_page("plan")
    rows = page.tree.rows
    assert [rows.name_at(rows.index(row, 0)) for row in range(rows.rowCount())] == [viewpoint.id for viewpoint in plan]
    assert plain(rows.data(rows.index(1, 3))) == "20.0 mm"
    page.tree.select((plan.viewpoints[2].id,))
    assert page.properties.title == plan.viewpoints[2].id


def test_the_scan_page_shows_each_viewpoint_in_its_state(filled):
    filled.show_page("scan")
    page = filled.pages["scan"]
    assert page.tiles.words() == ["Processed"] * 4 + ["Failed", "Processed"]
    assert "5 of 6 viewpoints processed, 1 failed" in page.state.text()
    assert page.tiles.tiles[4].note.startswith("point noise")


def test_the_scan_page_shows_the_newest_image_of_a_camera(filled, application):
    import numpy as np

    from measureapp.acquire.events import ImageTaken

    filled.show_page("scan")
    page = filled.pages["scan"]
    application.session.images.put("right", ImageTaken("view-02", "right", 80_000, np.full((30, 40), 90, np.uint8)))
    page._take_images()
    assert not page.pictures.images["right"].is_empty
    assert page.pictures.images["left"].is_empty
    assert plain(page.pictures.images["right"].caption) == "right · 80 ms"
    assert page.pictures_title.text() == "Images of view-02"


def test_the_clouds_page_lists_views_with_points_correction_and_verdict(filled, measurement):
    filled.show_page("clouds")
    page = filled.pages["clouds"]
    rows = page.table.texts()
    assert [row[1] for row in rows] == [view.viewpoint_id for view in measurement.views]
    assert plain(rows[0][2]) == str(len(measurement.views[0].cloud))
    assert plain(rows[0][3]) == "0.210 mm"
    assert [row[5] for row in rows] == ["Good"] * 4 + ["Poor", "Good"]
    assert page.stage.value() == "merged"


def test_hiding_a_view_takes_its_points_away(filled, measurement, monkeypatch, drawn):
    page = filled.pages["clouds"]
    filled.show_page("clouds")
    page.stage.setValue("after")
    drawn(page)
    shown = []
    monkeypatch.setattr(page.view, "set_clouds", lambda layers, _cloud: shown.append(sum(len(layer.points_mm) for layer in layers)))
    page.table.cellClicked.emit(0, 0)
    drawn(page)
    page.table.cellClicked.emit(0, 0)
    drawn(page)
    total = sum(len(view.cloud) for view in measurement.views)
    assert shown == [total - len(measurement.views[0].cloud), total]


def test_clouds_can_be_coloured_in_every_stage(filled, drawn):
    page = filled.pages["clouds"]
    filled.show_page("clouds")
    for stage in ("before", "after", "merged"):
        for colour_by in ("view", "sigma", "grey", "residual"):
            page.stage.setValue(stage)
            page.colour_by.setValue(colour_by)
            layers = drawn(page).view._clouds
            assert layers
            assert all(len(layer.colours) == len(layer.points_mm) for layer in layers)
            assert (page.view.legend is not None) == (colour_by in {"sigma", "residual"})


def test_the_inspection_page_shows_value_error_and_verdict(filled):
    filled.show_page("inspection")
    page = filled.pages["inspection"]
    rows = [[plain(text) for text in row] for row in page.side.table.texts()]
    assert rows[0] == ["a", "120.000", "± 0.100", "120.021", "+0.021", "0.018", "Pass", "Best fit"]
    assert rows[3] == ["d", "10.000", "± 0.100", "–", "–", "–", "Not measured", "Best fit"]
    shown = [chip.accessibleName() for chip in page.side.filter.buttons.values() if not chip.isHidden()]
    assert shown == ["1 fail", "1 not proven", "1 not measured", "1 pass"]
    assert [row.name for row in page.side.table.shown_rows] == ["b", "c", "d", "a"]  # the worst first


def test_selecting_a_dimension_labels_it_in_the_viewport(filled, qtbot):
    page = filled.pages["inspection"]
    filled.show_page("inspection")
    page.side.table.select(0)
    qtbot.waitUntil(lambda: [flag.key for flag in page.view._flags] == ["dimension:a"])
    (flag,) = page.view._flags
    assert (flag.title, plain(flag.value), flag.verdict) == ("a", "120.021 mm", "pass")
    assert len(page.view._lines[-1].lines) == 3
    page.side.table.select(3)
    qtbot.waitUntil(lambda: page.view._flags == ())
    assert page.properties.note == "No points lie near the feature."


def test_the_inspection_page_shows_the_surface_or_the_points(filled, drawn):
    page = filled.pages["inspection"]
    filled.show_page("inspection")
    assert drawn(page).view._surface is not None
    page.shape.setValue("points")
    drawn(page)
    assert page.view._surface is None
    assert len(page.view._clouds[0].points_mm) == 6000


def test_the_report_page_shows_pages_and_offers_what_can_be_exported(filled):
    page = filled.pages["report"]
    filled.show_page("report")
    picture = QImage(60, 80, QImage.Format.Format_RGB32)
    picture.fill(0x336699)
    page.show_pages((picture,) * 2)
    assert len(page.pages) == 2
    shown = page.pages[0]
    assert shown.height() == pytest.approx(shown.sizeHint().width() * 80 / 60, abs=1)
    assert shown.grab().toImage().pixelColor(shown.width() // 2, shown.height() // 2).name() == "#336699"
    assert [kind for kind, button in page.exports.items() if button.isVisible()] == list(FORMATS)
    assert not page.open_pdf.isVisible()


@pytest.mark.parametrize("kind", ["ply", "stl"])
def test_shapes_are_exported_as_files_that_can_be_read_again(filled, application, qtbot, tmp_path, kind, measurement):
    import trimesh

    target = tmp_path / f"part.{kind}"
    application.controllers.documents.export(kind, target)
    qtbot.waitUntil(target.exists, timeout=10_000)
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=10_000)
    read = trimesh.load(target)
    assert len(read.vertices) == (len(measurement.stitched) if kind == "ply" else len(measurement.mesh.vertices_mm))
    assert application.session.messages[-1].level == "done"


def test_an_open_patch_is_joined_without_closing_it_and_a_closed_body_is_refused(filled, application, qtbot, tmp_path, measurement):
    import numpy as np
    import trimesh

    from measureapp.register.clouds.filter_chain import Filter, FilterChain

    def exported(name):
        application.controllers.documents.export("open", tmp_path / name)
        qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=20_000)
        return application.session.messages[-1]

    assert exported("ball.stl").level == "error" and "not a single open patch" in application.session.messages[-1].text
    assert not (tmp_path / "ball.stl").exists()
    cap = measurement.stitched.points_mm[:, 2] > 100.0  # what filters left is what is exported
    application.session.set_filters(FilterChain((Filter("plane", (0, 0, 1, 100.0)),), cap.astype(np.uint8)))
    assert exported("cap.stl").level == "done"
    mesh = trimesh.load(tmp_path / "cap.stl")
    assert not mesh.is_watertight and mesh.bounds[0][2] > 99.9


def test_a_measurement_without_a_project_has_its_documents(filled, application, qtbot, tmp_path):
    application.controllers.documents.export("csv", tmp_path / "a.csv")
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=20_000)
    assert application.session.messages[-1].text.startswith("a.csv saved to")
    assert application.session.inspection.dimensions[0].name in (tmp_path / "a.csv").read_text(encoding="utf-8")


def test_a_preview_that_fails_says_so(filled, application, qtbot):
    from PySide6.QtWidgets import QLabel

    page = filled.pages["report"]
    filled.show_page("report")
    application.controllers.documents.pagesFailed.emit()
    qtbot.waitUntil(lambda: "No preview." in [label.text() for label in page._sheet.findChildren(QLabel) if label.isVisible()])


def test_a_click_on_a_tile_asks_for_the_images_of_its_viewpoint(filled, application, monkeypatch, qtbot):
    from PySide6.QtCore import Qt

    page = filled.pages["scan"]
    filled.show_page("scan")
    with qtbot.waitSignal(page.tiles.tileClicked) as told:
        qtbot.mouseClick(page.tiles.widget(), Qt.MouseButton.LeftButton, pos=page.tiles.box(2).center().toPoint())
    assert told.args == ["view-03"]


def test_stored_images_of_every_camera_are_read_from_the_project(tmp_path, monkeypatch):
    from types import SimpleNamespace

    import numpy as np

    from measureapp.project.folder import ProjectFolder
    from ui.controllers.stored_images import first_images

    images = {name: np.full((2, 3, 4, 5), level, np.uint8) for name, level in (("right", 9), ("left", 7))}
    stack = SimpleNamespace(exposures_us=(80_000, 20_000), images=images)
    project = SimpleNamespace(stored_viewpoints=lambda: ("view-01",), frames=SimpleNamespace(load=lambda _id, checked: stack))
    monkeypatch.setattr(ProjectFolder, "open", lambda _path: project)
    found = first_images(tmp_path, "view-01", None)
    assert [(event.camera, event.exposure_us, int(event.pixels[0, 0])) for event in found] == [("left", 80_000, 7), ("right", 80_000, 9)]
    assert first_images(tmp_path, "view-09", None) == ()


def test_a_view_that_registration_excluded_says_so_with_its_reason(measurement):
    from dataclasses import replace

    from ui.pages.clouds.view_words import view_properties, view_verdict

    view, placement = measurement.views[0], measurement.stitched.placements[0]
    assert view_verdict(view, placement)[:2] == ("pass", "Good")
    left_out = replace(placement, used=False, verdict="its surface lies 0.18 mm away: excluded")
    assert view_verdict(view, left_out) == ("fail", "Excluded", "Its surface lies 0.18 mm away.")
    assert view_properties(view, left_out).note == "Its surface lies 0.18 mm away."


def test_the_name_of_a_dimension_is_words_but_a_letter_of_the_drawing_stays():
    from ui.look.wording import dimension_words

    assert dimension_words("sphere_5_diameter") == "Sphere 5 diameter"
    assert dimension_words("a") == "a"


def test_the_plan_page_says_the_predicted_performance_of_the_patterns_and_what_a_view_costs(filled, rig):
    page = filled.pages["plan"]
    filled.show_page("plan")
    groups = {group.heading: {name: plain(value) for name, value in group.rows} for group in page.properties.groups}
    predicted, cost = groups["Predicted performance"], groups["Per viewpoint"]
    assert predicted["Range"] == "1088 px" and predicted["Guard band"] == "64 px"
    assert float(predicted["σ of the column"].split()[0]) == pytest.approx(0.03, abs=0.01)
    assert predicted["Wrong fringe orders"] == "None expected"
    assert cost["Images"] == "60 × 3 cameras"
    # 12 images of 100, 80, 60, 40 and 20 ms, each followed by 69 ms of read-out
    assert cost["Acquisition time"] == "At least 7.7 s"
    assert cost["Disk space"] == "907 MB"


def test_the_wrong_orders_of_the_papers_patterns_are_predicted(rig):
    from measureapp.data.pattern_sets import PATTERN_SETS
    from ui.pages.pattern_prediction import odds, predict

    rows = dict(predict(PATTERN_SETS["paper"], 1024, 768)[0].rows)
    assert rows["Wrong fringe orders"].startswith("1 of ")
    both = predict(PATTERN_SETS["paper-both"], 1024, 768)
    assert [group.heading.rpartition(", ")[2] for group in both] == ["vertical fringes", "horizontal fringes"]
    assert "Cannot be used" in dict(predict(PATTERN_SETS["paper"], 4096, 768)[0].rows)
    assert [plain(odds(value)) for value in (4.9e-4, 0.25, 1e-9, 0.0)] == [
        "1 of 2\u202f000 pixels".replace("\u202f", " "),
        "1 of 4 pixels",
        "< 1 of 1 000 000 pixels".replace("\u2009", " "),
        "None expected",
    ]


def test_decoded_percentages_and_losses_are_shown_where_they_are_stored(filled, application, measurement):
    from dataclasses import replace

    from ui.pages.clouds.view_words import view_properties

    figures = {"decoded_ratio": 0.152, "order_conflicts": 3, "phase_sigma_median": 0.0071}
    decode = {"left": figures, "right": {**figures, "decoded_ratio": 0.131}}
    view = replace(measurement.views[0], decode=decode, rejected={"island": 2, "contradicted": 700, "flying": 0})
    groups = {group.heading: dict(group.rows) for group in view_properties(view, None).groups}
    assert plain(groups["Pixels decoded"]["Camera left"]) == "15.2 %"
    assert groups["Pixels decoded"]["Order conflicts"] == "6"
    assert list(groups["Rejected points"]) == ["Contradicted", "Isolated patch"]
    application.session.add_view(view)
    filled.show_page("scan")
    tiles = {tile.name: plain(tile.figure) for tile in filled.pages["scan"].tiles.tiles}
    assert tiles[view.viewpoint_id] == "13–15 % decoded"
    assert tiles[measurement.views[1].viewpoint_id] == ""
