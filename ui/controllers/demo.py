"""The demo: complete measurement on the virtual rig."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.data.length_unit import LengthUnit, likely_unit
from ui.controllers.jobs import JobRunner
from ui.controllers.run_events import RunEvents
from ui.look.demo_settings import DemoSettings
from ui.look.paths import demo_folder, next_demo_folder
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.pipeline.events import Event
    from measureapp.pipeline.run import Outcome
    from ui.workers.job import Job


@dataclass(frozen=True)
class MeshQuestion:
    """A mesh file, the longest side of its bounding box in file units, and the likely unit."""

    path: Path
    span: float
    likely: LengthUnit


class DemoController(QObject):
    """Runs the demo and shows its progress."""

    meshReady = Signal(object, object)  # Path, LengthUnit
    unitAsked = Signal(object)  # MeshQuestion

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner = runner
        self._events = RunEvents(session, self)
        self.folder: Path | None = None
        self.settings = DemoSettings()

    @Slot(object)
    def choose(self, settings: DemoSettings) -> None:
        """Set the settings of the next run."""
        self.settings = settings

    @Slot(object)
    def inspect_mesh(self, path: Path) -> None:
        """Check whether a mesh can be used as a part, and whether its unit has to be requested."""
        self._runner.run("Reading the mesh", lambda job: read_mesh_size(path, job), self._offer_mesh)

    @Slot(object)
    def _offer_mesh(self, found: MeshQuestion) -> None:
        if found.likely is LengthUnit.MM:
            self.meshReady.emit(found.path, found.likely)
        else:
            self.unitAsked.emit(found)

    @Slot()
    def run(self) -> None:
        """Calibrate the virtual rig, scan, stitch, measure and report."""
        if self._runner.queue.running is not None and not self._runner.queue.running.quiet:
            self._session.tell(f"{self._session.busy_with} is still running.", "Wait until it has finished, or cancel it.", "warning")
            return
        settings = self.settings
        folder = next_demo_folder(self.folder or demo_folder(settings))
        self._session.open_project(folder.name, settings.part, folder)
        self._runner.run(
            f"Demo: {Path(settings.part).stem}",
            self._work(settings, folder),
            self._finish,
            on_event=self._apply,
            moves=True,
        )

    def _work(self, settings: DemoSettings, folder: Path) -> Any:
        events = self._events

        def work(job: Job) -> Outcome:
            job.report(0, 1, "Preparing the virtual rig")
            from measureapp.demo import DemoRequest, run_demo

            request = DemoRequest(
                folder, settings.part, settings.resolution, settings.viewpoints, settings.seed, settings.patterns, settings.unit
            )
            return run_demo(request, events.sink(job), job)

        return work

    @Slot(object)
    def _apply(self, event: Event) -> None:
        self._read_plan()
        self._events.apply(event)

    def _read_plan(self) -> None:
        """Show the plan as soon as the run has written it."""
        folder = self._session.folder
        if self._session.plan is None and folder is not None and (folder / "plan.json").is_file():
            from measureapp.project.folder import ProjectFolder

            project = ProjectFolder.open(folder)
            self._session.set_rig(project.rig())
            self._session.set_plan(project.plan())

    @Slot(object)
    def _finish(self, outcome: Outcome) -> None:
        self._read_plan()
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        inspection = outcome.measurement.inspection
        passing = sum(1 for dimension in inspection.dimensions if dimension.verdict == "pass") if inspection else 0
        summary = f" {passing} of {len(inspection.dimensions)} dimensions pass." if inspection else ""
        self._session.tell(f"The demo is complete.{summary}", "", "done")


def read_mesh_size(path: Path, job: Job) -> MeshQuestion:
    """Read the size of a mesh; runs on a job's thread. Raises InputError when it cannot be used."""
    from measureapp.simulate.part_file import mesh_span

    job.report(0, 1, path.name)
    span = mesh_span(path)
    return MeshQuestion(path, span, likely_unit(span))
