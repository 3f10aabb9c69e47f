"""A map on its own, and the window of the images of a view."""

from __future__ import annotations

import pytest

from tests.fringe_project import fringe_project
from tests.ui.images.maps import PATIENCE_MS
from ui.images.map_view import MapView
from ui.look.look import Look


@pytest.fixture
def look(qapp):
    return Look("light")


@pytest.fixture
def begun(qtbot):
    """Wait until the axes of a map are made, which charts do in turn, and everything is laid out."""

    def wait(view):
        qtbot.waitUntil(lambda: view.plot is not None)
        qtbot.wait(30)

    return wait


@pytest.fixture
def view(qtbot, look):
    made = MapView(look)
    qtbot.addWidget(made)
    made.resize(700, 500)
    made.show()
    return made


@pytest.fixture
def clouds(application, window, measurement, monkeypatch, tmp_path):
    """The page Clouds of a project on disk with the images of two of its views."""
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    project = fringe_project(tmp_path / "p", "view-01", "view-02")
    application.session.open_project("shiny", "gear", project.path)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    return window.pages["clouds"]


@pytest.fixture
def opened(qtbot, clouds):
    clouds.images.click()
    dialog = clouds.images_dialog
    qtbot.waitUntil(lambda: dialog.view is not None and not dialog.progress.isVisible(), timeout=PATIENCE_MS)
    return dialog


@pytest.fixture
def shown(qtbot):
    """Show widgets and keep them until the end of the test: a picture that is freed while it is painted ends the process."""
    kept = []

    def show(widget, width=640, height=480):
        qtbot.addWidget(widget)
        kept.append(widget)
        widget.resize(width, height)
        widget.show()
        return widget

    return show
