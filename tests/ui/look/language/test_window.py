"""The window in another language: every text in sight is translated, and is what it was after changing back."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QComboBox, QDoubleSpinBox, QLabel, QWidget

from measureapp.calibrate.kinds.table import KINDS
from measureapp.language.catalogue import Catalogue, Entry, placeholders, read_catalogue
from tests.ui.cut_texts import cut_texts
from tests.ui.look.language.displayed import displayed_texts
from ui.look.language.retranslating import GIVEN
from ui.look.language.sources import catalogue_file
from ui.pages.calibration_rows import added_to_length_mm


def test_every_page_speaks_the_language_that_is_chosen(filled, speaking, english_left, qtbot):
    speaking("zh_CN")
    left: list[str] = []
    for name, page in filled.pages.items():
        filled.show_page(name)
        qtbot.wait(100)
        left += [f"{name}: {text}" for text in english_left(displayed_texts(page))]
    assert not left


def test_pages_are_what_they_were_after_changing_back(application, filled, speaking, qtbot):
    for name in filled.pages:
        filled.show_page(name)
        qtbot.wait(50)
    runners = application.controllers.runners
    qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in runners), timeout=60_000)
    qtbot.wait(200)
    before = {name: set(displayed_texts(page)) for name, page in filled.pages.items()}
    speaking("zh_CN")
    speaking("en")
    qtbot.wait(100)
    for name, page in filled.pages.items():
        assert set(displayed_texts(page)) - {("", "")} == before[name], name


def test_texts_that_share_a_translation_keep_their_own_words(application, window, qtbot, monkeypatch):
    catalogue = Catalogue("zh_CN", {text: Entry(text, "测量") for text in ("Measure", "Measurement")})
    monkeypatch.setattr("ui.look.language.language.catalogue_of", lambda name: None if name == "en" else catalogue)
    box = QWidget(window)
    labels = [QLabel("Measure", box), QLabel("Measurement", box)]
    for _ in range(2):
        application.settings.set_text("language", "zh_CN")
        application.language.retranslation.finish()
        assert [one.text() for one in labels] == ["测量", "测量"]
        application.settings.set_text("language", "en")
        application.language.retranslation.finish()
        assert [one.text() for one in labels] == ["Measure", "Measurement"]


def test_names_that_people_gave_are_not_translated(application, window, speaking):
    names, kinds = QComboBox(window), QComboBox(window)
    names.setProperty(GIVEN, True)
    for box in (names, kinds):
        box.addItem("Plane")
    speaking("zh_CN")
    assert (names.currentText(), kinds.currentText()) == ("Plane", "⟦Plane⟧")


def test_nothing_is_cut_in_chinese_in_the_smallest_window(application, filled, qtbot):
    filled.resize(1280, 720)
    application.settings.set_text("language", "zh_CN")
    application.language.retranslation.finish()
    for name in filled.pages:
        filled.show_page(name)
        qtbot.waitUntil(lambda: not [text for text in cut_texts(filled) if "view-0" not in text], timeout=10_000)


def test_wizards_speak_the_language_that_is_chosen(calibration_page, speaking, english_left):
    speaking("zh_CN")
    for name in KINDS:
        calibration_page.open_wizard(name)
        wizard = calibration_page.wizards[name]
        left = english_left(displayed_texts(wizard))
        wizard.close()
        assert not left, name


def test_the_catalogue_has_every_text_and_its_placeholders(all_texts):
    """`python -m ui.look.language` brings it up to date."""
    known = read_catalogue(catalogue_file("zh_CN")).entries
    assert not all_texts.keys() - known.keys() and not known.keys() - all_texts.keys()
    for source, entry in known.items():
        if entry.translation and "{" in source:
            try:
                names = placeholders(source)
            except ValueError:
                continue
            assert placeholders(entry.translation) == names


def test_the_choice_is_in_the_settings_and_is_remembered(application, window, speaking):
    dialog = window.settings_dialog
    dialog.begin()
    dialog.language.setValue("zh_CN")
    dialog.language.valueChanged.emit("zh_CN")
    application.language.retranslation.finish()
    assert application.settings.text("language") == "zh_CN" and application.language.name == "zh_CN"
    assert dialog.windowTitle() == "⟦Settings⟧"
    dialog.close()


def test_what_a_calibration_adds_to_a_length_does_not_depend_on_the_language(filled, speaking):
    page = filled.pages["calibration"]
    filled.show_page("calibration")
    before = page.verdict.text()
    speaking("zh_CN")
    page.look.changed.emit()
    assert added_to_length_mm(filled.session.calibration, filled.session.rig) == pytest.approx(float(before.split()[0]), abs=5e-4)


@pytest.mark.parametrize("name", ["en", "zh_CN"])
def test_fields_write_numbers_as_texts_do(application, qtbot, name):
    application.language.choose(name)
    field = QDoubleSpinBox()
    qtbot.addWidget(field)
    field.setValue(1.25)
    assert field.text() == "1.25" and QLocale().name().startswith(name.split("_")[0])


def test_commands_are_found_by_the_words_of_the_language_and_by_the_english_ones(application, window):
    application.language.choose("zh_CN")
    assert window.actions_.find("设置")[0].id == window.actions_.find("settings")[0].id == "settings"


def test_a_window_made_in_a_language_speaks_it(application, window, qtbot, speaking, english_left):
    speaking("zh_CN")
    window.header.role.setValue("operator")
    qtbot.wait(50)
    assert not english_left(displayed_texts(window.shell.operator.bar))
    window.shell.operator.bar.engineer.click()


def test_a_language_that_is_not_there_is_english(application):
    application.language.choose("tlh")
    assert application.language.name == "en"
