"""Operator mode with two sample programs, and a scan that ends at once with a measurement made by hand."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from measureapp.data.dimension import Verdict
from measureapp.errors import DeviceError
from measureapp.pipeline.part_program import store_part_program
from measureapp.pipeline.sample_program import write_sample_programs
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from ui.session import RunNow


@pytest.fixture(scope="session")
def sample_programs(tmp_path_factory) -> Path:
    """Return a folder with the sample programs."""
    folder = tmp_path_factory.mktemp("programs")
    write_sample_programs(folder)
    return folder


@dataclass
class Workshop:
    """Operator mode, and what its next scan will find."""

    application: Any
    window: Any
    measurement: Any
    qtbot: Any
    verdicts: tuple[str, ...] = ("pass", "pass", "pass", "pass")
    fault: DeviceError | None = None
    is_folder_lost: bool = False  # after a fault
    requests: list[Any] = field(default_factory=list)

    @property
    def screens(self) -> Any:
        """The workspace of operator mode."""
        return self.window.shell.operator

    @property
    def operator(self) -> Any:
        """The controller of operator mode."""
        return self.application.controllers.operator

    def scan(self, _title: str, make: Callable[[Any], Any], _subject: str) -> None:
        """Stand in for the scan: store a project as it does, and put its measurement into the session."""
        session = self.application.session
        session.set_run(RunNow("running"))
        request = make(Ticket())
        self.requests.append(request)
        if self.fault is not None:
            session.set_plan(request.plan)
            first = next(iter(request.plan)).id
            session.set_viewpoint(first, "stored")
            if not self.is_folder_lost:
                self.stored_project(request)
            session.tell(self.fault.message, self.fault.hint, "error")
            session.set_run(RunNow("idle"))
            return
        found = self.measured(request)
        session.set_measurement(found, {"report_pdf": request.folder / "report" / "report.pdf"})
        session.set_run(RunNow("idle"))

    def measured(self, request: Any) -> Any:
        """Store the project of a scan with these verdicts, and return its measurement."""
        dimensions = tuple(
            replace(one, verdict=Verdict(verdict))
            for one, verdict in zip(self.measurement.inspection.dimensions, self.verdicts, strict=False)
        )
        moment = (datetime.now(UTC) - timedelta(seconds=10 - len(self.requests))).isoformat()
        inspection = replace(self.measurement.inspection, dimensions=dimensions)
        found = replace(self.measurement, inspection=inspection, measured_at=moment)
        project = self.stored_project(request)
        with project.lock():
            project.save_calibration(self.measurement.calibration)
            project.save_plan(request.plan)
            store_part_program(project, request.part_program)
            project.save_measurement(found, NoProgress())
            project.report_pdf.parent.mkdir(exist_ok=True)
            project.report_pdf.write_bytes(b"%PDF-1.7 of this run")
        return found

    def stored_project(self, request: Any) -> ProjectFolder:
        """Create the project of a scan, or open it."""
        new = request.created
        return ProjectFolder.create(request.folder, ProjectSettings(name=new.name, part=new.part, rig=request.rig, board=new.board))

    def wait(self, condition: Callable[[], Any]) -> None:
        """Wait for a job; what the window said meanwhile is in the failure."""
        try:
            self.qtbot.waitUntil(lambda: bool(condition()), timeout=60_000)
        except self.qtbot.TimeoutError as late:
            said = [message.text for message in self.application.session.messages.open]
            raise AssertionError(f"{late}; the window says {said}") from late

    def identify(self, serial: str) -> None:
        """Choose the gypsum cross and state a serial number, as far as the screen for loading."""
        self.wait(lambda: self.operator.shelf is not None)
        card = next(card for card in self.operator.shelf.cards if card.name == "Gypsum cross")
        self.operator.choose(card)
        self.screens.identify.fields["serial"].setText(serial)

    def begin(self, serial: str) -> None:
        """Start the measurement of the gypsum cross with a serial number."""
        self.identify(serial)
        self.screens.identify.next.click()
        self.load_and_start()

    def load_and_start(self) -> None:
        """Confirm that the part is clamped, and start."""
        self.wait(lambda: self.operator.obstacles is not None)
        load = self.screens.load
        load.confirm.done = True
        load.confirm.held.emit()
        load.start.click()


class Ticket:
    """The job of the stand-in."""

    def check(self) -> None:
        """Nobody cancels."""


@pytest.fixture
def workshop(application, window, rig, measurement, sample_programs, qtbot, tmp_path, monkeypatch) -> Workshop:
    """Return operator mode as an operator finds it."""
    monkeypatch.setattr("ui.controllers.documents.DocumentsController.preview", lambda self: None)
    shutil.copytree(sample_programs, tmp_path / "MeasureApp" / "programs")
    monkeypatch.setattr("ui.pages.operator.big.SECOND_PRESS_MS", 0)  # no hand is as fast as a test
    made = Workshop(application, window, measurement, qtbot)
    monkeypatch.setattr(application.controllers.scanning, "run", made.scan)
    application.session.set_rig(rig)
    application.session.set_role("operator")
    made.wait(lambda: made.operator.shelf is not None)
    return made
