"""Using a view that was left out, leaving one out, and taking that back."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import pytest

from measureapp.data.surroundings import SURROUNDINGS, SURROUNDINGS_KEPT, Surroundings
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import RegistrationError
from measureapp.pipeline import restitch as stitching_again
from measureapp.project import folder as folders
from ui.pages.clouds.view_words import EXCLUDE, USE, choice_for, view_verdict


@pytest.fixture
def kept(application, window, measurement, tmp_path, monkeypatch):
    """A measured project on disk, of which stitching again gives the same; the choices it keeps."""
    store = SimpleNamespace(choices=ViewChoices(), fails=False)
    (tmp_path / "project.json").write_text("{}")

    def restitch(_project, choices, _on_event, _progress, _language):
        if store.fails:
            raise RegistrationError("No view can be used.", "Use another one.")
        store.choices = choices
        return SimpleNamespace(measurement=measurement, files={}, filters=None)

    monkeypatch.setattr(folders.ProjectFolder, "open", lambda _path: SimpleNamespace(view_choices=lambda: store.choices, nominal=None))
    monkeypatch.setattr(stitching_again, "restitch", restitch)
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.open_project("demo", "gypsum", tmp_path)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    return store


def settled(application, qtbot):
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=10_000)


def test_a_used_view_can_be_excluded_and_the_choice_undone(application, window, kept, qtbot):
    page = window.pages["clouds"]
    page.table.selectRow(1)
    assert page.properties.decision == EXCLUDE
    assert not page.undo.isVisible()
    window.properties.decisionClicked.emit()
    settled(application, qtbot)
    assert kept.choices == ViewChoices(refused=("view-02",))
    assert page.undo.isVisible()
    page.undo.click()
    settled(application, qtbot)
    assert kept.choices == ViewChoices()
    assert not page.undo.isVisible()


def test_a_choice_that_fails_changes_nothing_and_says_why(application, window, kept, qtbot):
    page = window.pages["clouds"]
    kept.fails = True
    page.table.selectRow(1)
    page.decide()
    settled(application, qtbot)
    assert application.session.messages[-1].text == "No view can be used."
    assert kept.choices == ViewChoices()
    assert not page.undo.isVisible()


def test_what_was_excluded_around_the_part_can_be_kept_and_excluded_again(application, window, kept, measurement, qtbot):
    page, session = window.pages["clouds"], application.session
    assert not page.surroundings.isVisible()
    said = Surroundings(1000, (("table", 400),)).sentence
    session.set_measurement(replace(measurement, settings={SURROUNDINGS: said}), {})
    assert page.surroundings.isVisible() and page.surroundings.toolTip() == said
    assert page.surroundings.text().strip() == "Keep surroundings"
    page.surroundings.click()
    settled(application, qtbot)
    assert kept.choices == ViewChoices(keep_surroundings=True)
    session.set_measurement(replace(measurement, settings={SURROUNDINGS: SURROUNDINGS_KEPT}), {})
    assert page.surroundings.text().strip() == "Exclude surroundings"
    page.surroundings.click()
    settled(application, qtbot)
    assert kept.choices == ViewChoices()


def test_without_a_project_on_disk_nothing_is_offered(application, window, measurement):
    application.session.open_project("demo", "gypsum", None)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    page = window.pages["clouds"]
    page.table.selectRow(1)
    assert page.properties.decision == ""


def test_what_is_offered_and_said_follows_what_was_decided(measurement):
    view, placement = measurement.views[0], measurement.stitched.placements[0]
    poor = measurement.views[4]
    assert choice_for(placement) == (EXCLUDE, "refuse")
    assert choice_for(None) == (USE, "use")
    assert choice_for(replace(placement, used=False)) == (USE, "use")
    assert view_verdict(view, replace(placement, verdict="its surface lies 0.2 mm away: accepted by hand"))[1:] == (
        "Manual",
        "Used by manual choice. Its surface lies 0.2 mm away.",
    )
    assert view_verdict(poor, placement)[:2] == ("not proven", "Manual")
    assert view_verdict(view, replace(placement, used=False, verdict="refused by hand: excluded"))[1] == "Excluded"
