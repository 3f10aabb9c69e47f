"""The header of a report is edited in the window, and documents are exported as they are now."""

from __future__ import annotations

import cv2
import numpy as np
import openpyxl
import pytest

from measureapp.data.identification import Identification
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.identification_file import read_identification
from measureapp.report.template import default_template
from ui.pages.report_header import HeaderDialog

PATIENCE_MS = 30_000


@pytest.fixture
def project(tmp_path, rig, calibration, measurement):
    made = ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=rig))
    made.save_calibration(calibration)
    made.save_measurement(measurement)
    return made


def settled(qtbot, application):
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=PATIENCE_MS)


@pytest.fixture
def opened(qtbot, application, project):
    application.controllers.project.open(project.path)
    settled(qtbot, application)
    assert application.session.measurement is not None
    return application


def test_the_dialog_returns_what_was_entered_and_refuses_a_temperature_that_is_none(opened, qtbot):
    given = Identification(part_name="Größe 件", serial_number="7", temperature_c=20.5, remarks="clean")
    dialog = HeaderDialog(opened.look, given, "Works", None)
    qtbot.addWidget(dialog)
    assert dialog.value() == given
    dialog.fields["temperature_c"].setText("21,5")
    assert dialog.value().temperature_c == 21.5
    dialog.fields["temperature_c"].setText("warm")
    dialog.accept_button.click()
    assert dialog.result() == 0 and "temperature_c" in dialog.problem.text()


def test_a_header_is_stored_with_company_and_logo_and_is_in_the_workbook(opened, qtbot, tmp_path, project):
    logo = tmp_path / "mark.png"
    logo.write_bytes(cv2.imencode(".png", np.zeros((8, 8, 3), np.uint8))[1].tobytes())
    opened.controllers.documents.set_header(Identification(serial_number="SN 件"), "Müller & Söhne", logo)
    settled(qtbot, opened)
    assert read_identification(project.path).serial_number == "SN 件"
    assert default_template().description.company == "Müller & Söhne" and default_template().logo is not None
    opened.session.set_measurement(opened.session.measurement, {"report_pdf": project.report_pdf})
    settled(qtbot, opened)
    opened.controllers.documents.export("xlsx", tmp_path / "t.xlsx")
    settled(qtbot, opened)
    book = openpyxl.load_workbook(tmp_path / "t.xlsx")
    assert ("Serial number", "SN 件") in [tuple(cell.value for cell in row) for row in book["Report"].iter_rows()]
    book.close()


def test_the_button_opens_the_dialog(opened, qtbot):
    page = opened.window.pages["report"]
    page.header_button.click()
    settled(qtbot, opened)
    (dialog,) = page.findChildren(HeaderDialog)
    assert dialog.isVisible()
    dialog.reject()
