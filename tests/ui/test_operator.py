"""An operator starts, watches, reads the verdict, and opens the report: three clicks."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.data.dimension import Verdict
from ui.widgets.verdict_banner import verdict_on


@pytest.fixture
def operator(application, window, rig, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.set_rig(rig)
    window.header.role.setValue("operator")
    window.show_page("rig")
    return window


def test_from_start_to_report_an_operator_clicks_three_times(application, operator, measurement, monkeypatch):
    started, opened = [], []
    demo, documents = application.controllers.demo, application.controllers.documents
    rig, inspection, report = (operator.pages[name] for name in ("rig", "inspection", "report"))
    rig.run_demo.clicked.disconnect(demo.run)
    rig.run_demo.clicked.connect(lambda: started.append(application.session.set_busy("Demo: gypsum")))
    report.open_pdf.clicked.disconnect(documents.open_pdf)
    report.open_pdf.clicked.connect(lambda: opened.append(True))
    rig.run_demo.click()
    assert operator.page is operator.pages["scan"] and started
    application.session.set_measurement(measurement, {"report_pdf": measurement})
    assert operator.page is inspection and inspection.side.banner.isVisible()
    assert inspection.side.banner.word.text() == "FAIL" and "1 of 4 dimensions fail" in inspection.side.banner.accessibleName()
    assert inspection.side.table.current_row().name == "b"  # the one that fails
    assert ("b", "fail") in [(flag.title, flag.verdict) for flag in inspection.view._flags]
    application.session.set_busy("")
    inspection.see_report.click()
    report.open_pdf.click()
    assert operator.page is report and opened


def test_an_engineer_stays_where_he_is_and_sees_no_banner(application, window, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    window.show_page("scan")
    application.session.set_measurement(measurement, {})
    assert window.page is window.pages["scan"]
    window.show_page("inspection")
    assert not window.page.side.banner.isVisible() and not window.page.see_report.isVisible()


@pytest.mark.parametrize(
    ("verdicts", "whole"),
    [
        (("pass", "pass"), "pass"),
        (("pass", "not proven"), "not proven"),
        (("pass", "not measured"), "not proven"),
        (("not proven", "fail"), "fail"),
        ((), None),
    ],
)
def test_a_part_passes_with_all_its_dimensions_and_fails_with_one(verdicts, whole):
    assert verdict_on(verdicts) == whole


def test_a_part_that_passes_says_so(application, operator, measurement):
    good = tuple(replace(found, verdict=Verdict.PASS) for found in measurement.inspection.dimensions)
    operator.show_page("scan")
    application.session.set_measurement(replace(measurement, inspection=replace(measurement.inspection, dimensions=good)), {})
    assert operator.pages["inspection"].side.banner.accessibleName() == "PASS. All 4 dimensions pass."
