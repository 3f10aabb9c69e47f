"""Recompute that is stopped leaves what is stored in the window, not some of its results beside those before."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.errors import StorageError
from measureapp.pipeline.events import InspectionReady
from measureapp.progress import Cancelled
from tests.ui.test_report_header import project, settled  # noqa: F401 - a fixture


@pytest.mark.parametrize("end", [Cancelled(), StorageError("The disk is full.", "Free some space.")])
def test_results_of_a_stopped_recompute_do_not_stay_in_the_window(qtbot, application, project, monkeypatch, end):  # noqa: F811
    session, controller = application.session, application.controllers.project
    controller.open(project.path)
    settled(qtbot, application)
    before, shown = session.inspection, []

    def process(_project, on_event, _progress, *, language: str):
        on_event(InspectionReady(replace(before, dimensions=())))
        raise end

    monkeypatch.setattr("measureapp.pipeline.run.process_project", process)
    session.inspectionChanged.connect(lambda: shown.append(len(session.inspection.dimensions)))
    controller.process()
    settled(qtbot, application)
    assert shown[0] == 0  # a result was shown on the way
    assert session.inspection == session.measurement.inspection and len(session.inspection.dimensions) == len(before.dimensions)


def test_nothing_is_read_again_once_the_window_has_ended_its_jobs(qtbot, application, project, monkeypatch):  # noqa: F811
    controllers, started = application.controllers, []
    controllers.project.open(project.path)
    settled(qtbot, application)
    monkeypatch.setattr("measureapp.pipeline.run.process_project", lambda *_, **__: (_ for _ in ()).throw(Cancelled()))
    controllers.project.process()
    assert controllers.end(10_000)
    controllers.jobs.queue.started.connect(started.append)
    qtbot.wait(200)
    assert not started and not controllers.jobs.queue.busy
