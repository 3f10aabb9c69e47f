"""Opening projects of which something is wrong: what is whole is shown, the rest is told with a remedy."""

from __future__ import annotations

import json

import pytest

from measureapp.errors import InputError, StorageError
from measureapp.pipeline import process_project
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings

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
    assert "Compute again" in told.hint
    assert ".." not in told.text


def test_a_project_of_a_later_version_says_so(project):
    path = project.path / "project.json"
    path.write_text(json.dumps(json.loads(path.read_text(encoding="utf-8")) | {"schema_version": 9}), encoding="utf-8")
    with pytest.raises(StorageError, match="has format 9; this version reads format 1") as refused:
        ProjectFolder.open(project.path)
    assert "version of MeasureApp" in refused.value.hint


def test_a_project_whose_images_are_gone_cannot_be_computed_again_and_says_why(project):
    with pytest.raises(InputError, match="holds no images of the part"):
        process_project(project, lambda _event: None, NoProgress())


def test_an_operator_goes_on_to_the_dimensions_and_an_engineer_to_the_clouds(application, window, measurement):
    application.session.set_measurement(measurement, {})
    scan = window.pages["scan"]
    window.show_page("scan")
    scan.next_step.click()
    assert window.page is window.pages["clouds"]
    window.header.role.setValue("operator")
    window.show_page("scan")
    assert scan.next_step.text().strip() == "See the dimensions"
    scan.next_step.click()
    assert window.page is window.pages["inspection"]
