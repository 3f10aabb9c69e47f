"""The header of a report is edited in the window, and documents are exported as they are now."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import openpyxl
import pytest

from measureapp.data.identification import Identification
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.identification_file import read_identification
from measureapp.report.template import default_template
from tests.ui.journey.user import answering
from ui.controllers.report_header import ReportHeader, TemplateChoice
from ui.pages.report_header import ANOTHER, HeaderDialog

PATIENCE_MS = 30_000


@pytest.fixture
def project(tmp_path, rig, calibration, measurement):
    made = ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=rig))
    made.save_calibration(calibration)
    made.save_measurement(measurement)
    return made


OWN = TemplateChoice("Your own: built-in, version 1")


def header_of(identification: Identification, company: str = "Works") -> ReportHeader:
    return ReportHeader(identification, company, None, OWN, (OWN,))


def settled(qtbot, application):
    runners = (application.controllers.jobs, application.controllers.background)
    qtbot.waitUntil(lambda: not any(one.queue.busy for one in runners), timeout=PATIENCE_MS)


@pytest.fixture
def opened(qtbot, application, project):
    application.controllers.project.open(project.path)
    settled(qtbot, application)
    assert application.session.measurement is not None
    return application


def test_the_dialog_returns_what_was_entered_and_refuses_a_temperature_that_is_none(opened, qtbot):
    given = Identification(part_name="Größe 件", serial_number="7", temperature_c=20.5, remarks="clean")
    dialog = HeaderDialog(opened.look, header_of(given))
    qtbot.addWidget(dialog)
    assert dialog.value() == given
    dialog.fields["temperature_c"].setText("21,5")
    assert dialog.value().temperature_c == 21.5
    dialog.fields["temperature_c"].setText("warm")
    dialog.accept_button.click()
    assert dialog.result() == 0 and dialog.problem.text() == "Temperature (°C): Enter a number."


def test_a_header_is_stored_with_company_and_logo_and_is_in_the_workbook(opened, qtbot, tmp_path, project):
    logo = tmp_path / "mark.png"
    logo.write_bytes(cv2.imencode(".png", np.zeros((8, 8, 3), np.uint8))[1].tobytes())
    opened.controllers.documents.set_header(replace(header_of(Identification(serial_number="SN 件"), "Müller & Söhne"), logo=logo))
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


def test_a_logo_that_is_refused_costs_nothing_of_what_was_typed(opened, qtbot, tmp_path, project):
    given = Identification(serial_number="SN 8", remarks="clean")
    dialog = HeaderDialog(opened.look, replace(header_of(given), logo=tmp_path / "none.png"))
    qtbot.addWidget(dialog)
    dialog.accept_button.click()
    assert dialog.result() == 0 and "none.png" in dialog.problem.text()
    damaged = tmp_path / "mark.png"
    damaged.write_text("no picture", encoding="utf-8")
    opened.controllers.documents.set_header(replace(header_of(given), logo=damaged))
    settled(qtbot, opened)
    assert read_identification(project.path) == given


def test_the_button_opens_the_dialog(opened, qtbot):
    page = opened.window.pages["report"]
    page.header_button.click()
    settled(qtbot, opened)
    (dialog,) = page.findChildren(HeaderDialog)
    assert dialog.isVisible()
    dialog.reject()


def write_template(folder, name="aerospace"):
    folder.mkdir()
    (folder / "template.toml").write_text(
        f'schema_version = 1\nname = "{name}"\nversion = "3"\ntitle = "Inspection of castings"\n', encoding="utf-8"
    )
    return folder


def choose_another(dialog, folder):
    place = dialog.template.findText(ANOTHER)
    dialog.template.setCurrentIndex(place)
    with answering(folder):
        dialog.template.activated.emit(place)


def ask(opened, qtbot):
    page = opened.window.pages["report"]
    page.header_button.click()
    settled(qtbot, opened)
    return page.findChildren(HeaderDialog)[-1]


def test_another_template_is_chosen_kept_in_the_project_and_given_up_again(opened, qtbot, tmp_path, project):
    dialog = ask(opened, qtbot)
    assert dialog.template.count() == 2 and dialog.company.isEnabled()
    choose_another(dialog, write_template(tmp_path / "castings"))
    assert dialog.template.currentText() == "Another: aerospace, version 3" and not dialog.company.isEnabled()
    dialog.accept_button.click()
    settled(qtbot, opened)
    assert (project.path / "inspection" / "report_template" / "template.toml").exists()
    again = ask(opened, qtbot)
    assert again.template.currentText() == "This project's: aerospace, version 3"
    again.template.setCurrentIndex(0)
    again.template.activated.emit(0)
    assert again.company.isEnabled()
    again.accept_button.click()
    settled(qtbot, opened)
    assert ProjectFolder.open(project.path).report_template is None


def test_a_folder_that_is_no_template_is_refused_in_the_dialog(opened, qtbot, tmp_path):
    dialog = ask(opened, qtbot)
    choose_another(dialog, tmp_path)
    assert "template.toml" in dialog.problem.text() and dialog.problem.isVisible()
    assert dialog.template.currentIndex() == 0
    dialog.reject()
