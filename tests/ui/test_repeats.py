"""Repeated measurements in the window: chosen or made, compared and reported."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from measureapp.data.repeats import RepeatedMeasurement
from measureapp.errors import InputError
from measureapp.inspection.repeats import InspectedPart, evaluate_repeats
from measureapp.project.folder import ProjectFolder, ProjectSettings
from tests.ui.scan_runs import QuickRun
from ui.pages.repeats.rows import rows_of

PATIENCE_MS = 20_000
SHIFTS_MM = {"a": (0.0, 0.006, -0.006), "b": (0.0, 0.2, -0.2), "c": (0.0, 0.004, -0.002)}


@pytest.fixture
def study(inspection):
    """Three measurements: the spread of b contradicts its U of 0.02 mm, that of a and c does not."""

    def shifted(number: int):
        dimensions = [
            one if one.measured is None else replace(one, measured=one.measured + SHIFTS_MM[one.name][number])
            for one in inspection.dimensions
        ]
        return replace(inspection, dimensions=tuple(dimensions))

    made = [InspectedPart(RepeatedMeasurement(f"m{number}", f"2026-01-0{number + 1}T10:00:00", ""), shifted(number)) for number in range(3)]
    return evaluate_repeats("gypsum", made)


@pytest.fixture
def dialog(application, window):
    window.show_page("report")
    page = window.pages["report"]
    page.open_repeats()
    yield page.repeats
    page.repeats.close()


def test_a_spread_that_contradicts_the_stated_uncertainty_comes_first(study):
    rows = rows_of(study)
    assert [row[0].text for row in rows] == ["b", "d", "a", "c"]
    assert [row[-1].sign for row in rows] == ["fail", "not measured", "pass", "pass"]
    assert rows[0][2].text.replace("\u00a0", " ") == "40.131 mm" and rows[0][6].text == "3" and rows[0][8].text == "< 0.001"


def test_projects_are_chosen_compared_and_reported(application, dialog, study, monkeypatch, tmp_path, qtbot):
    asked = []
    monkeypatch.setattr("measureapp.pipeline.repeats.compare_repeats", lambda folders, **choices: asked.append((folders, choices)) or study)
    assert not dialog.compare.isEnabled()
    for name in ("one", "two"):
        dialog.add_project(tmp_path / name)
    dialog.add_project(tmp_path / "one")  # once only
    dialog.compare.click()
    qtbot.waitUntil(lambda: dialog.study is study and dialog.save.isEnabled(), timeout=PATIENCE_MS)
    assert asked == [((tmp_path / "one", tmp_path / "two"), {"one_part": False})]
    assert dialog.words.text().startswith("3 measurements by the program gypsum.")
    monkeypatch.setattr("ui.settings.dialogs.QFileDialog.getExistingDirectory", lambda *_: str(tmp_path))
    dialog.save.click()
    qtbot.waitUntil(lambda: not application.session.busy_with and (tmp_path / "repeats.pdf").exists(), timeout=PATIENCE_MS)
    assert sorted(path.suffix for path in tmp_path.glob("repeats.*")) == [".csv", ".json", ".pdf"]


def test_a_refused_comparison_says_why(application, dialog, monkeypatch, tmp_path, qtbot):
    def refuse(*_, **__):
        raise InputError("one and two are of different parts.", "Name projects of one part.")

    monkeypatch.setattr("measureapp.pipeline.repeats.compare_repeats", refuse)
    for name in ("one", "two"):
        dialog.add_project(tmp_path / name)
    dialog.compare.click()
    qtbot.waitUntil(lambda: "different parts" in dialog.words.text(), timeout=PATIENCE_MS)
    assert not dialog.save.isEnabled()


@pytest.fixture
def measured(application, rig, plan, calibration, tmp_path):
    """A calibrated project with a plan, open in the window."""
    application.session.set_rig(rig)
    project = ProjectFolder.create(tmp_path / "wheel", ProjectSettings(name="wheel", part="wheel", rig=rig))
    project.save_plan(plan)
    application.session.open_project("wheel", "wheel", project.path)
    application.session.set_plan(plan)
    application.session.set_calibration(calibration)
    return project.path


@pytest.mark.parametrize("reclamp", [False, True])
def test_a_part_is_measured_again_each_time_into_a_project_of_its_own(
    application, measured, dialog, measurement, monkeypatch, qtbot, reclamp
):
    views = {view.viewpoint_id: view for view in measurement.views}
    quick = QuickRun(views.__getitem__)
    quick.gate.set()

    def scan(request, *others):
        quick.scan_into_project(request, *others)
        ProjectFolder.create(request.folder, ProjectSettings(name=request.folder.name, part="wheel", rig=request.rig))

    monkeypatch.setattr("measureapp.pipeline.run.scan_into_project", scan)
    repeats = application.controllers.repeats
    dialog.reclamp.setChecked(reclamp)
    dialog.again.click()
    for number in (1, 2):
        if reclamp:
            qtbot.waitUntil(lambda: repeats.is_waiting, timeout=PATIENCE_MS)
            assert dialog.series.text() == f"Clamp the part again, then continue with measurement {number} of 2."
            dialog.go_on.click()
        qtbot.waitUntil(lambda number=number: len(quick.requests) == number, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: repeats.series is None and not application.controllers.jobs.queue.busy, timeout=PATIENCE_MS)
    folders = [measured.with_name(f"wheel-repeat-{number}") for number in (2, 3)]
    assert [(request.folder, request.calibrated) for request in quick.requests] == [(folder, measured) for folder in folders]
    assert dialog.folders() == (measured, *folders)


def test_a_failed_measurement_ends_the_series(application, measured, dialog, monkeypatch, qtbot):
    def fail(*_):
        raise InputError("The part has gone.", "Clamp it.")

    monkeypatch.setattr("measureapp.pipeline.run.scan_into_project", fail)
    dialog.again.click()
    qtbot.waitUntil(lambda: application.controllers.repeats.series is None, timeout=PATIENCE_MS)
    assert dialog.folders() == (measured,) and Path(measured).exists()
    assert application.session.messages[-1].text == "The part has gone."
