"""Nothing is cut in the smallest window, also with longer words and at other scalings of the screen."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QLineEdit, QPushButton, QWidget

from tests.fringe_project import fringe_project
from tests.ui.cut_texts import cut_texts
from ui.session import DriverRow

ROOT = Path(__file__).resolve().parents[2]
LONGER = 140  # per cent of the width of the letters, as for a language with longer words
ALLOWED = (
    "demo-gypsum",  # names that users give
    "view-0",
    "Part: ",
)
WIZARDS = ("cameras", "rig", "projector", "axis")


@pytest.fixture
def longer(qapp):
    """Letters that are wider, as if all words were longer."""
    before = QApplication.font()
    wide = QFont(before)
    wide.setStretch(LONGER)
    QApplication.setFont(wide)
    yield
    QApplication.setFont(before)


@pytest.fixture
def filled(application, window, rig, plan, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    session = application.session
    session.open_project("demo-gypsum", "gypsum", None)
    session.set_rig(rig, (DriverRow("virtual_rig", "rig", "1.0"), DriverRow("broken", "camera", "0.1", "The manifest has no entry.")))
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    window.resize(window.minimumSize())
    return window


def not_allowed(found: list[str]) -> list[str]:
    return [text for text in found if not any(allowed in text for allowed in ALLOWED)]


def walk_pages(window, qtbot) -> list[str]:
    found = []
    for name in window.pages:
        window.show_page(name)
        for folded in (True, False):
            window.properties.fold(folded)
            qtbot.wait(30)
            found += [f"{name}: {text}" for text in not_allowed(cut_texts(window))]
    return sorted(set(found))


def walk_dialogs(window, qtbot) -> list[str]:
    found = []
    for dialog in (window.messages, window.settings_dialog, window.palette_, window.shortcuts):
        dialog.begin()
        qtbot.wait(10)
        found += [f"{dialog.windowTitle()}: {text}" for text in not_allowed(cut_texts(dialog))]
        dialog.close()
    return sorted(set(found))


def squashed(top: QWidget) -> list[QWidget]:
    """Return the fields and buttons in sight that are lower than their contents."""
    found = [*top.findChildren(QPushButton), *top.findChildren(QAbstractSpinBox), *top.findChildren(QLineEdit)]
    own = [one for one in found if one.isVisible() and not isinstance(one.parent(), QAbstractSpinBox)]
    return [one for one in own if one.height() < one.minimumSizeHint().height()]


def test_no_text_is_cut_in_the_smallest_window(filled, qtbot):
    assert "\n".join(walk_pages(filled, qtbot)) == ""


def test_no_text_is_cut_with_words_that_are_longer_by_two_fifths(longer, filled, qtbot):
    assert "\n".join(walk_pages(filled, qtbot)) == ""


def test_no_text_of_a_dialog_is_cut_with_longer_words(longer, filled, qtbot):
    filled.session.tell("The rig is not connected.", "Press Connect on the page Rig, then try again.", "warning")
    assert "\n".join(walk_dialogs(filled, qtbot)) == ""


def test_no_text_of_the_images_of_a_view_is_cut_with_longer_words(longer, application, filled, qtbot, tmp_path):
    application.session.open_project("demo-gypsum", "gypsum", fringe_project(tmp_path / "p", "view-01").path)
    clouds = filled.pages["clouds"]
    filled.show_page("clouds")
    dialog = clouds.images_dialog
    dialog.open_view("view-01", "left", (5, 5))
    qtbot.waitUntil(lambda: dialog.view is not None and not dialog.progress.isVisible(), timeout=60_000)
    dialog.resize(dialog.minimumSize())
    dialog.line.setChecked(True)
    found = []
    for kind in ("fringes", "state"):
        dialog.kind.setValue(kind)
        qtbot.wait(50)
        found += [f"{kind}: {text}" for text in not_allowed(cut_texts(dialog))]
    dialog.close()
    assert found == []


def test_no_text_of_a_wizard_is_cut_with_longer_words(longer, filled, qtbot):
    page, found = filled.pages["calibration"], []
    for kind in WIZARDS:
        page.open_wizard(kind)
        wizard = page.wizards[kind]
        wizard.resize(1280, 648)
        for source in ("rig", "images"):
            wizard.setup.source.setValue(source)
            qtbot.wait(30)
            found += [f"{kind}, {source}: {text}" for text in not_allowed(cut_texts(wizard))]
            found += [f"{kind}, {source}: {type(one).__name__} of {one.height()} px" for one in squashed(wizard)]
        wizard.close()
    assert found == []


@pytest.mark.slow
@pytest.mark.parametrize("factor", ["1.25", "1.5", "2"])
def test_no_text_is_cut_at_other_scalings_of_the_screen(factor):
    """The factor is read once, when a program starts."""
    choice = ["-p", "no:cacheprovider", "-k", "smallest_window or longer_words"]
    command = [sys.executable, "-m", "pytest", "-q", *choice, __file__]
    done = subprocess.run(
        command, cwd=ROOT, env={**os.environ, "QT_SCALE_FACTOR": factor}, capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == 0, done.stdout[-4000:]
