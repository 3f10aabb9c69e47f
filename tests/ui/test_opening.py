"""Opening projects of which something is wrong: what is whole is shown, the rest is told with a remedy."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from measureapp.errors import InputError, StorageError
from measureapp.pipeline.run import process_project
from measureapp.progress import NoProgress
from measureapp.project import filter_file, upkeep
from measureapp.project.filter_file import FILTERED, FILTERS, save_filters
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry.files import read_stitched, write_cloud
from measureapp.project.results import STITCHED
from measureapp.register.clouds.filter_chain import Filter, FilterChain

PATIENCE_MS = 30_000


@pytest.fixture
def project(tmp_path, rig, calibration):
    made = ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=rig))
    made.save_calibration(calibration)
    return made


def opened(qtbot, application, folder):
    application.controllers.project.open(folder)
    qtbot.waitUntil(lambda: application.controllers.jobs.queue.running is None, timeout=PATIENCE_MS)
    return application.session.messages[-1]


def test_damaged_results_do_not_keep_a_project_shut(qtbot, application, window, project):
    project.results.mkdir()
    (project.results / "measurement.json").write_text("{", encoding="utf-8")
    told = opened(qtbot, application, project.path)
    assert application.session.project_name == "part"
    assert application.session.calibration is not None
    assert application.session.measurement is None
    assert told.level == "warning"
    assert str(project.results) in told.text
    assert "Recompute" in told.hint
    assert ".." not in told.text


def test_a_project_of_a_later_version_says_so(project):
    path = project.path / "project.json"
    path.write_text(json.dumps(json.loads(path.read_text(encoding="utf-8")) | {"schema_version": 9}), encoding="utf-8")
    upkeep.accept_changes(project.path, ["project.json"])  # as that version would have entered it in the journal
    with pytest.raises(
        StorageError, match=r"written by a newer version of MeasureApp \(format 9; this version reads format 1\)"
    ) as refused:
        ProjectFolder.open(project.path)
    assert "version of MeasureApp" in refused.value.hint


def test_a_project_whose_images_are_gone_cannot_be_computed_again_and_says_why(project):
    with pytest.raises(InputError, match="contains no images of the part"):
        process_project(project, lambda _event: None, NoProgress())


def test_after_a_scan_the_next_step_are_the_clouds(application, window, measurement):
    application.session.set_measurement(measurement, {})
    window.show_page("scan")
    window.pages["scan"].next_step.click()
    assert window.page is window.pages["clouds"]


def measured(project, measurement):
    stored = replace(measurement, inspection=None)
    project.save_measurement(stored)
    return stored


def test_filters_come_back_with_the_project_and_can_be_undone_one_by_one(qtbot, application, window, project, measurement):
    stitched = measured(project, measurement).stitched
    chain = FilterChain.build((Filter("plane", (0, 0, 1, 30.0)), Filter("plane", (0, 0, 1, 60.0))), stitched.points_mm)
    save_filters(project.results, chain, stitched)
    assert opened(qtbot, application, project.path).level == "done"
    session, filtering = application.session, application.controllers.filtering
    window.show_page("clouds")
    assert window.pages["clouds"].stage.value() == "filtered" and session.filters.filters == chain.filters
    for least_mm in (60.0, 30.0):
        left = stitched.points_mm[stitched.points_mm[:, 2] >= least_mm]
        assert session.filtered.points_mm == pytest.approx(left, abs=1e-4)
        assert len(read_stitched(project.results / FILTERED)) == len(left)
        filtering.undo()
        qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not session.busy_with, timeout=PATIENCE_MS)
    assert session.filtered is None and not (project.results / FILTERED).exists()


@pytest.mark.parametrize("harm", ["damaged", "of another cloud"])
def test_filters_that_do_not_fit_are_reported_and_the_cloud_is_shown_whole(qtbot, application, window, project, measurement, harm):
    stitched = measured(project, measurement).stitched
    save_filters(project.results, FilterChain.build((Filter("plane", (0, 0, 1, 60.0)),), stitched.points_mm), stitched)
    if harm == "damaged":
        (project.results / FILTERS).write_bytes(b"PK\x03\x04 no archive")
    else:
        moved = replace(stitched, points_mm=stitched.points_mm + 1.0)
        write_cloud(project.results / STITCHED, moved)
    told = opened(qtbot, application, project.path)
    assert told.level == "warning" and "shown unfiltered" in told.text and "page Clouds" in told.hint
    assert application.session.filtered is None and len(application.session.stitched) == len(stitched)


def test_filters_are_applied_again_to_a_cloud_that_is_computed_again(project, measurement):
    before = measured(project, measurement).stitched
    save_filters(project.results, FilterChain.build((Filter("plane", (0, 0, 1, 60.0)),), before.points_mm), before)
    after = replace(before, points_mm=before.points_mm + np.array([0, 0, 20.0]))
    project.save_measurement(replace(measurement, inspection=None, stitched=after))
    assert np.array_equal(project.filters(after).kept_mask, after.points_mm[:, 2] >= 60.0)
    far = replace(before, points_mm=before.points_mm - np.array([0, 0, 500.0]))
    project.save_measurement(replace(measurement, inspection=None, stitched=far))  # nothing is left of it
    assert project.filters(far) is None and not (project.results / FILTERED).exists()


def test_a_project_that_cannot_be_written_is_filtered_for_looking_and_says_so(
    qtbot, application, window, project, measurement, monkeypatch
):
    measured(project, measurement)
    opened(qtbot, application, project.path)

    def refuse(*_arguments):
        raise StorageError("results cannot be written: Permission denied.", "Check the permissions, or choose another folder.")

    monkeypatch.setattr(filter_file, "save_filters", refuse)
    application.controllers.filtering.apply(Filter("plane", (0, 0, 1, 60.0)))
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=PATIENCE_MS)
    told = application.session.messages[-1]
    assert told.level == "warning" and "Not saved" in told.text and "permissions" in told.hint
    assert application.session.filtered.points_mm[:, 2].min() >= 60.0


def test_the_projects_opened_last_are_offered_and_one_that_is_gone_is_not(qtbot, application, window, project, tmp_path):
    other = ProjectFolder.create(tmp_path / "other", ProjectSettings(name="A & B", part="gypsum", rig=project.rig()))
    for folder in (project.path, other.path):
        opened(qtbot, application, folder)
    assert application.controllers.project.recent() == ((other.path, "A & B"), (project.path, "part"))
    menu = window.header.open.menu()
    menu.aboutToShow.emit()
    recent = next(action.menu() for action in menu.actions() if action.text() == "Open recent")
    assert [action.text() for action in recent.actions()] == ["A && B", "part"]
    recent.actions()[-1].trigger()
    qtbot.waitUntil(lambda: application.session.folder == project.path, timeout=PATIENCE_MS)
    (other.path / "project.json").unlink()
    assert application.controllers.project.recent() == ((project.path, "part"),)


def test_a_project_that_another_program_writes_into_is_opened_read_only_with_its_holder(application, rig, tmp_path, qtbot):
    from measureapp.project.folder import ProjectFolder, ProjectSettings

    project = ProjectFolder.create(tmp_path / "wheel", ProjectSettings(name="wheel", part="wheel", rig=rig))
    with project.lock():
        application.controllers.project.open(project.path)
        qtbot.waitUntil(lambda: any("read-only" in message.text for message in application.session.messages), timeout=20_000)
    told = next(message for message in application.session.messages if "read-only" in message.text)
    assert told.text.startswith("wheel is open read-only: it is in use by this program, user ")
