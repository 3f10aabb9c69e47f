"""The language of reports is chosen on the page Report; it is that of the window unless another one is chosen."""

from __future__ import annotations

import json

import pytest
from PySide6.QtGui import QDesktopServices

from measureapp.errors import InputError
from tests.ui.test_report_header import project, settled  # noqa: F401 - a fixture
from ui.look.language.words import spoken
from ui.session import Session
from ui.settings.settings import AS_WINDOW, Settings

PATIENCE_MS = 60_000


@pytest.fixture
def opened(qtbot, application, project):  # noqa: F811 - the fixture
    application.controllers.project.open(project.path)
    settled(qtbot, application)
    application.window.show()
    application.window.show_page("report")
    settled(qtbot, application)
    return application


def written(project) -> str:  # noqa: F811 - of the fixture
    return json.loads(project.report_json.read_text(encoding="utf-8"))["language"]


def choose(page, name: str) -> None:
    place = page.language.findData(name)
    page.language.setCurrentIndex(place)
    page.language.activated.emit(place)


def speak(application, name: str) -> None:
    application.settings.set_text("language", name)
    application.language.retranslation.finish()


def test_a_chosen_language_is_kept_and_the_documents_of_the_project_are_written_in_it(opened, qtbot, project):  # noqa: F811
    page = opened.window.pages["report"]
    assert [page.language.itemText(place) for place in range(page.language.count())] == ["As the window", "English", "简体中文"]
    assert page.language.currentData() == AS_WINDOW and opened.session.report_language == "en"
    former = page.pages
    choose(page, "zh_CN")
    settled(qtbot, opened)
    assert opened.session.report_language == "zh_CN" and opened.settings.text("report_language") == "zh_CN" and spoken() == "en"
    assert written(project) == "zh_CN" and former and page.pages and former[0] is not page.pages[0]
    choose(page, "en")
    settled(qtbot, opened)
    assert written(project) == "en"


def test_the_report_follows_the_window_unless_another_language_is_chosen(opened, qtbot):
    page, drawn = opened.window.pages["report"], []
    opened.controllers.documents.pagesReady.connect(lambda pages: drawn.append(len(pages)))
    try:
        speak(opened, "zh_CN")
        settled(qtbot, opened)
        assert opened.session.report_language == "zh_CN" and len(drawn) == 1
        choose(page, "zh_CN")
        settled(qtbot, opened)
        drawn.clear()
    finally:
        speak(opened, "en")
    settled(qtbot, opened)
    assert opened.session.report_language == "zh_CN" and not drawn


def test_open_pdf_writes_the_report_anew_in_the_present_language(opened, qtbot, project, monkeypatch):  # noqa: F811
    shown: list[str] = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: shown.append(url.toLocalFile()) or True)
    documents = opened.controllers.documents
    documents.open_pdf()
    settled(qtbot, opened)
    assert shown == [str(project.report_pdf)] and written(project) == "en"
    before = project.report_pdf.stat().st_mtime_ns
    documents.open_pdf()
    assert len(shown) == 2 and project.report_pdf.stat().st_mtime_ns == before  # it is current: opened at once
    opened.settings.set_text("report_language", "zh_CN")
    documents.open_pdf()
    settled(qtbot, opened)
    assert len(shown) == 3 and written(project) == "zh_CN"


def test_every_job_writes_in_the_language_of_its_time(application, qtbot):
    application.settings.set_text("report_language", "zh_CN")
    found: list[str] = []
    application.controllers.jobs.run("Language", lambda job: job.language, found.append)
    settled(qtbot, application)
    assert found == ["zh_CN"]


def test_a_language_that_there_is_not_is_that_of_the_window():
    settings = Settings()
    settings._store.setValue("window/report_language", "klingon")
    assert Session(settings).report_language == "en"


def test_recomputing_writes_the_report_in_the_present_language(opened, qtbot, monkeypatch):
    asked: list[str] = []

    def process(_project, _on_event, _progress, *, language: str):
        asked.append(language)
        raise InputError("Not now.", "Later.")

    monkeypatch.setattr("measureapp.pipeline.run.process_project", process)
    opened.settings.set_text("report_language", "zh_CN")
    opened.controllers.project.process()
    settled(qtbot, opened)
    assert asked == ["zh_CN"]
