"""A run that is cancelled while its report is drawn leaves no report of the results before."""

from __future__ import annotations

from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.pipeline.run import finish
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import Cancelled
from measureapp.project.folder import ProjectFolder
from measureapp.project.results import PICTURES


class CancelledAt:
    """Progress that is cancelled when it was asked so many times."""

    def __init__(self, asked: int) -> None:
        self.left = asked

    def report(self, _done: float, _total: float, _note: str = "") -> None:
        self.check()

    def check(self) -> None:
        self.left -= 1
        if self.left < 0:
            raise Cancelled


@pytest.mark.parametrize("asked", [0, 3])
def test_a_report_that_is_cancelled_leaves_none(demo: Demo, tmp_path: Path, asked: int) -> None:
    project = ProjectFolder.open(linked_copy(demo.folder, tmp_path / "p"))
    (project.results / PICTURES).unlink()
    reports, measurement = (project.report_pdf, project.report_csv, project.report_json), project.measurement()
    assert measurement is not None and all(report.exists() for report in reports)
    with pytest.raises(Cancelled):
        finish(project, measurement, Stopwatch(), progress=CancelledAt(asked))
    assert not any(report.exists() for report in reports)
    assert all(
        report.exists() for report in (demo.project.report_pdf, demo.project.report_csv)
    )  # links are removed, not what they point to
