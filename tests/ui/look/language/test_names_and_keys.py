"""What keeps its words: names that were proposed, and the names of keys."""

from __future__ import annotations

import pytest
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialogButtonBox

from measureapp.language.languages import catalogue_of
from ui.controllers.creating import NAMES
from ui.look.language.language import Language
from ui.look.language.words import TRANSLATOR, for_name, translated


@pytest.fixture
def chinese(qapp):
    language = Language()
    language.choose("zh_CN")
    yield language
    language.choose("en")


def test_new_names_are_in_the_language_of_the_window_and_then_stay(chinese):
    name = f"{for_name('circle')} 1"
    assert name == "圆 1" and for_name("slot width") == "槽宽" and for_name("seat") == "seat"
    assert all(for_name(words) != words for words in NAMES.values())
    chinese.choose("en")
    assert translated(name) == "圆 1" and f"{for_name('circle')} 1" == "circle 1"


def test_keys_are_written_as_in_tooltips_while_dialogs_of_qt_are_translated(chinese):
    assert TRANSLATOR.catalogue is catalogue_of("zh_CN")
    written = [QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText) for keys in ("Alt+Up", "Ctrl+Return", "Space", "Del")]
    assert written == ["Alt+Up", "Ctrl+Return", "Space", "Del"]
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
    assert [one.text() for one in buttons.buttons()] == ["取消"]
