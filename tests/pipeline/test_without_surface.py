"""A surface that cannot be made, as for want of memory, costs nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy
from without_pictures import without_pictures

from measureapp.cli.outcome import report_event
from measureapp.pipeline.events import Event, SurfaceFailed
from measureapp.pipeline.restitch import restitch
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.register.surface import closed


def test_points_and_dimensions_do_without_a_surface_and_it_is_told_why(
    demo: Demo, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    project = ProjectFolder.open(linked_copy(demo.folder, tmp_path / "project"))
    before, events = project.measurement(), list[Event]()
    monkeypatch.setattr(closed, "available_bytes", lambda: 1000)
    with without_pictures():
        made = restitch(project, project.view_choices(), events.append, NoProgress()).measurement
    assert made.mesh is None
    assert before is not None and before.inspection is not None and made.inspection is not None
    assert [one.measured for one in made.inspection.dimensions] == pytest.approx([one.measured for one in before.inspection.dimensions])
    stored = project.measurement()
    assert stored is not None and stored.mesh is None
    (told,) = (event for event in events if isinstance(event, SurfaceFailed))
    report_event(told)
    assert "No surface: The surface needs about" in capsys.readouterr().err
