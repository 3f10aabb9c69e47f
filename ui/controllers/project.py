"""Opening and recomputing of projects."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Slot

from measureapp.errors import StorageError
from ui.controllers.jobs import JobRunner
from ui.controllers.run_events import RunEvents
from ui.look.language.words import tr
from ui.look.paths import sample_folder
from ui.messages import OPEN_PROJECT, RECOMPUTE
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.measurement import Measurement
    from measureapp.data.plan import ScanPlan
    from measureapp.data.rig import RigDescription
    from measureapp.data.validity import Validity
    from measureapp.pipeline.run import Outcome
    from measureapp.project.folder import ProjectFolder
    from measureapp.register.clouds.filter_chain import FilterChain
    from ui.workers.job import Job
OPENING, OPENING_SAMPLE = "Opening project", "Opening the sample project"  # titles of the jobs that only read
IN_USE = "Nothing can be scanned or recomputed here until that has ended. Then open the project again."


@dataclass(frozen=True)
class ReadProject:
    """Contents of a project folder."""

    folder: Path
    name: str
    part: str
    rig: RigDescription
    plan: ScanPlan | None
    calibration: RigCalibration | None
    stored: tuple[str, ...]
    measurement: Measurement | None
    files: dict[str, Path]
    validity: Validity | None
    filters: FilterChain | None = None  # of the stitched cloud
    damage: StorageError | None = None  # error of the results, if they cannot be read
    lost: StorageError | None = None  # error of the filters, if they cannot be read
    holder: str | None = None  # another window or command that writes into the project


class ProjectController(QObject):
    """Opens a project folder; recomputes a project from its stored images."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner = runner
        self._events = RunEvents(session, self)

    @Slot(object)
    def open(self, folder: Path) -> None:
        """Open the project in ``folder``; refused while a job runs, because its results would go to the wrong project."""
        if self._session.refuse_during_job() or self._session.ask_about_unsaved(lambda: self.open(folder)):
            return
        self._runner.run(OPENING, lambda job: read_project(folder, job), self._show)

    @Slot(object, str)
    def create(self, folder: Path, part: str) -> None:
        """Make a project of the present rig in ``folder``, and open it."""
        rig = self._session.rig
        if rig is None or self._session.refuse_during_job() or self._session.ask_about_unsaved(lambda: self.create(folder, part)):
            return

        def work(job: Job) -> ReadProject:
            from measureapp.project.folder import ProjectFolder, ProjectSettings

            job.report(0, 1, "Making the project")
            ProjectFolder.create(folder, ProjectSettings(name=folder.name, part=part, rig=rig))
            return read_project(folder, job)

        self._runner.run("New project", work, self._show)

    @Slot(object, object)
    def start(self, template: Path, folder: Path) -> None:
        """Make a project from a template (.mpart) in ``folder``, and open it."""
        rig = self._session.rig
        if self._session.refuse_during_job() or self._session.ask_about_unsaved(lambda: self.start(template, folder)):
            return

        def work(job: Job) -> ReadProject:
            from measureapp.pipeline.templates import new_project
            from measureapp.project.part_program_file import read_part_program

            job.report(0, 1, "Making the project")
            read = read_part_program(template)
            new_project(read, folder, rig=rig if read.rig is None else None)
            return read_project(folder, job)

        self._runner.run("New project", work, self._show)

    @Slot(str)
    def open_sample(self, name: str) -> None:
        """Open a sample project, which is unpacked the first time."""
        if self._session.refuse_during_job() or self._session.ask_about_unsaved(lambda: self.open_sample(name)):
            return

        def work(job: Job) -> ReadProject:
            from measureapp.pipeline.samples import unpack_sample

            job.report(0, 1, "Unpacking the sample project")
            return read_project(unpack_sample(name, sample_folder(name)).path, job)

        self._runner.run(OPENING_SAMPLE, work, self._show)

    @Slot(object)
    def save_template(self, path: Path) -> None:
        """Save the open project as a template of new ones: everything but its data."""
        source = self._session.folder
        if source is None or self._session.refuse_during_job():
            return

        def work(job: Job) -> Path:
            from measureapp.pipeline.templates import template_of_project
            from measureapp.project.folder import ProjectFolder
            from measureapp.project.part_program_file import with_former_revision, write_part_program

            job.report(0, 1, path.name)
            return write_part_program(with_former_revision(template_of_project(ProjectFolder.open(source)), path), path)

        self._runner.run("Saving the template", work, self._say_saved)

    @Slot(object)
    def _say_saved(self, path: Path) -> None:
        self._session.tell(
            tr("The template is saved to {path}.", path=path), "New projects start from it: New project from a template.", "done"
        )

    @Slot(object)
    def copy_to(self, folder: Path) -> None:
        """Copy the open project to ``folder``, and open the copy."""
        source = self._session.folder
        if source is None or self._session.refuse_during_job():
            return

        def work(job: Job) -> ReadProject:
            from measureapp.project.copying import copy_project

            copy_project(source, folder, job)
            return read_project(folder, job)

        self._runner.run("Copying the project", work, self._show)

    def recent(self) -> tuple[tuple[Path, str], ...]:
        """Return folder and name of the projects that were opened last and are still there."""
        from measureapp.project.recent_projects import recent_file, recent_projects

        return tuple((Path(project.folder), project.name) for project in recent_projects(recent_file()))

    @Slot()
    def process(self) -> None:
        """Recompute the open project from its stored images."""
        folder = self._session.folder
        if folder is None:
            self._session.tell("No project is open.", "Open a project or run the demo first.", "warning", remedy=OPEN_PROJECT)
            return
        if self._session.refuse_during_job():
            return
        self._runner.run("Recomputing", self._work(folder), self._show_recomputed, on_event=self._events.apply, on_stopped=self._read_again)

    def _work(self, folder: Path) -> Any:
        events = self._events

        def work(job: Job) -> Outcome:
            from measureapp.pipeline.run import process_project
            from measureapp.project.folder import ProjectFolder

            return process_project(ProjectFolder.open(folder), events.sink(job), job, language=job.language)

        return work

    @Slot(object)
    def _show(self, read: ReadProject) -> None:
        session = self._session
        session.open_project(read.name, read.part, read.folder)
        session.set_rig(read.rig)
        session.set_plan(read.plan)
        session.set_calibration(read.calibration)
        session.set_stored(read.stored)
        if read.measurement is not None:
            session.set_measurement(read.measurement, read.files, read.filters)
        session.set_validity(read.validity)
        session.tell(tr("{name} is open.", name=read.name), "", "done")
        if read.damage is not None:
            session.tell(read.damage.message, "Press Recompute on the page Scan; no new scan is needed.", "warning", remedy=RECOMPUTE)
        if read.lost is not None:
            session.tell(read.lost.message, read.lost.hint, "warning")
        if read.holder is not None:
            session.tell(tr("{name} is open read-only: it is in use by {holder}.", name=read.name, holder=read.holder), IN_USE, "warning")

    @Slot()
    def _read_again(self) -> None:
        """Show what is stored: a run that was stopped has shown some of its results, and may have stored some."""
        folder = self._session.folder
        if folder is not None:
            self._runner.run("Reading the project", lambda job: read_project(folder, job), self._show_stored, quiet=True)

    @Slot(object)
    def _show_stored(self, read: ReadProject) -> None:
        session = self._session
        if session.folder != read.folder:
            return
        session.set_stored(read.stored)
        session.set_calibration(read.calibration)
        if read.measurement is not None:
            session.set_measurement(read.measurement, read.files, read.filters)

    @Slot(object)
    def _show_recomputed(self, outcome: Outcome) -> None:
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        self._session.tell("The project was recomputed from the stored images.", "", "done")


def read_project(folder: Path, job: Job) -> ReadProject:
    """Read a project folder, which is then one of the last ones opened; runs on a job's thread."""
    job.report(0, 3, "Reading the project")
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.folder_lock import holder_of
    from measureapp.project.recent_projects import recent_file, remember_project
    from measureapp.project.results import MESH, STITCHED

    project = ProjectFolder.open(folder)
    remember_project(recent_file(), folder, project.name)
    calibration = project.calibration()
    job.report(1, 3, "Reading clouds")
    measurement, damage = None, None
    try:
        measurement = project.measurement()
    except StorageError as error:  # results can be recomputed, so the project is opened without them
        damage = error
    job.report(2, 3, "Reading clouds")
    filters, lost = None, None
    try:
        filters = None if measurement is None else project.filters(measurement.stitched)
    except StorageError as error:
        lost = error
    files = {
        "project": folder,
        "report_pdf": project.report_pdf,
        "report_csv": project.report_csv,
        "report_json": project.report_json,
        "stitched_cloud": project.results / STITCHED,
        "mesh": project.results / MESH,
    }
    return ReadProject(
        folder,
        project.name,
        project.settings.part,
        project.rig(),
        project.plan(),
        calibration,
        project.stored_viewpoints(),
        measurement,
        {name: path for name, path in files.items() if path.exists()},
        None if calibration is None else _validity(project, calibration, measurement),
        filters,
        damage,
        lost,
        holder_of(folder),
    )


def _validity(project: ProjectFolder, calibration: RigCalibration, measurement: Measurement | None) -> Validity:
    """Return what is known of the validity of a calibration; imports the kernels, for which a folder that is no project needs not wait."""
    from measureapp.pipeline.validity import known_validity

    return known_validity(project, calibration, None if measurement is None else measurement.validity)
