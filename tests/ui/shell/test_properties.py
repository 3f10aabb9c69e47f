"""The panel on the right never describes what is gone."""

from __future__ import annotations

import pytest
from PySide6.QtWidgets import QLabel

from ui.look.look import Look
from ui.pages.page import IDLE_MS, NOTHING_SELECTED
from ui.session import DriverRow
from ui.widgets.properties_panel import Group, Properties, PropertiesPanel

PAGES = ("calibration", "scan", "clouds", "inspection")  # the Plan page keeps its draft


@pytest.fixture
def filled(application, window, rig, plan, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    session = application.session
    session.open_project("demo-gypsum", "gypsum", None)
    session.set_rig(rig, (DriverRow("virtual_rig", "rig", "1.0"),))
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    return window


def test_properties_end_with_the_project(application, filled, plan, measurement):
    for name in PAGES:
        application.session.open_project("demo-gypsum", "gypsum", None)
        application.session.set_plan(plan)
        application.session.set_measurement(measurement, {})
        filled.show_page(name)
        assert filled.page.properties is not NOTHING_SELECTED, name
        assert filled.properties.shown is filled.page.properties, name
        application.session.open_project("another", "gear", None)
        assert filled.page.properties is NOTHING_SELECTED or name == "scan"  # it describes the scan, which has no viewpoints now
        assert filled.properties.shown is filled.page.properties, name
        assert "view-0" not in str(filled.properties.shown) and "left" not in str(filled.properties.shown), name


def test_a_page_out_of_sight_shows_once_what_it_missed_in_idle_moments_and_lets_a_closed_project_go_at_once(
    application, filled, measurement, qtbot
):
    filled.show_page("clouds")
    page, session = filled.pages["inspection"], application.session
    qtbot.waitUntil(lambda: not page._owed)
    shown = []
    page.follow(session.inspectionChanged, lambda: shown.append(session.inspection))
    for _ in range(3):
        session.set_inspection(measurement.inspection)
    assert not shown
    filled.show_page("inspection")
    assert shown == [measurement.inspection] and page.side.table.texts()
    session.set_inspection(measurement.inspection)
    assert len(shown) == 2
    filled.show_page("clouds")
    session.open_project("another", "gear", None)
    assert shown[2:] == [None] and page.is_empty and not page.side.table.texts()
    session.set_busy("Scan")
    session.set_inspection(measurement.inspection)
    qtbot.wait(2 * IDLE_MS)
    assert len(shown) == 3
    session.set_busy("")
    qtbot.waitUntil(lambda: len(shown) == 4 and bool(page.side.table.texts()))  # still out of sight


def test_properties_of_a_viewpoint_end_when_it_is_deleted_and_come_back_with_undo(application, filled, qtbot):
    filled.show_page("plan")
    page = filled.page
    page.tree.select(("view-02",))
    assert "view-02" in str(filled.properties.shown)
    page.tools.remove.click()
    assert "view-02" not in str(filled.properties.shown)
    page.undo_last()
    page.tree.select(("view-02",))
    assert "view-02" in str(filled.properties.shown)


def test_rows_stay_where_only_values_differ(qtbot):
    panel = PropertiesPanel(Look("light"))
    qtbot.addWidget(panel)

    def shown(value: str, *names: str) -> list[QLabel]:
        panel.show_properties(Properties("view-01", (Group("Axes", tuple((name, value) for name in names)),), f"Note {value}"))
        return [one for one in panel.findChildren(QLabel) if one.text() in (value, f"Note {value}")]

    first, second, third = shown("1", "Guide", "Table"), shown("2", "Guide", "Table"), shown("3", "Guide")
    assert len(first) == 3 and second == first and len(third) == 2 and not set(third) & set(first)
    assert [one.text() for one in third] == ["Note 3", "3"]
