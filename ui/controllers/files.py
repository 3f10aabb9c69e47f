"""Inspection of a cloud or mesh from a file, without a project, against a nominal or by an inspection program."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError, UnitQuestion
from ui.controllers.comparison import compute_comparison
from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import Comparison, Session

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Inspection
    from measureapp.data.mesh import Mesh
    from measureapp.project.geometry.files import PlainPoints
    from ui.workers.job import Job

PROGRAMS = (".toml",)


@dataclass(frozen=True)
class FilesToMeasure:
    """A cloud or mesh, its nominal or inspection program, and the units of both, if known."""

    cloud: Path
    reference: Path  # nominal or inspection program
    unit: LengthUnit | None = None
    nominal_unit: LengthUnit | None = None


@dataclass(frozen=True, eq=False)
class FileQuestion:
    """Files for which a unit is requested."""

    files: FilesToMeasure
    question: UnitQuestion


@dataclass(frozen=True, eq=False)
class MeasuredFile:
    """Result of the inspection of a file."""

    files: FilesToMeasure
    cloud: StitchedCloud
    inspection: Inspection
    comparison: Comparison | None


class FilesController(QObject):
    """Shows an inspected file in place of the project; on failure the project stays open."""

    measured = Signal()
    unitAsked = Signal(object)  # FileQuestion

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner

    @Slot(object)
    def measure(self, files: FilesToMeasure) -> None:
        """Read the files, align, inspect and compare."""
        if self._session.refuse_during_job() or self._session.ask_about_unsaved(lambda: self.measure(files)):
            return
        self._runner.run(tr("Measuring {name}", name=files.cloud.name), lambda job: measure_file(files, job), self._show)

    @Slot(object)
    def _show(self, found: MeasuredFile | FileQuestion) -> None:
        if isinstance(found, FileQuestion):
            self.unitAsked.emit(found)
            return
        session, files = self._session, found.files
        session.open_project(files.cloud.name, files.reference.stem, None)
        session.set_stitched(found.cloud)
        session.set_inspection(found.inspection)
        session.set_comparison(found.comparison)
        session.tell(tr("{name} was inspected against {name_2}.", name=files.cloud.name, name_2=files.reference.name), "", "done")
        self.measured.emit()


def measure_file(files: FilesToMeasure, job: Job) -> MeasuredFile | FileQuestion:
    """Inspect a file, or return the question for a unit; runs on a job's thread."""
    from measureapp.inspection.dimensions import inspect
    from measureapp.inspection.settings import InspectionSettings
    from measureapp.progress import PartOf
    from measureapp.project.geometry.files import read_cloud_or_mesh

    job.report(0, 10, "Reading the files")
    cloud = _cloud(files, read_cloud_or_mesh(files.cloud, unit=files.unit or LengthUnit.MM))
    program, nominal = _read_reference(files)
    try:
        inspection = inspect(cloud, program, nominal, InspectionSettings(), PartOf(job, 0.2, 0.7))
    except UnitQuestion as question:
        if (files.unit if question.what == "points" else files.nominal_unit) is None:
            return FileQuestion(files, question)
        raise InputError(question.message, "Choose files of the same part, or other units.") from question
    comparison = None if nominal is None else compute_comparison(cloud, nominal, inspection.alignment, program, PartOf(job, 0.7, 1.0))
    return MeasuredFile(files, cloud, inspection, comparison)


def _read_reference(files: FilesToMeasure) -> tuple[InspectionProgram, Mesh | None]:
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.project.geometry.files import read_mesh
    from measureapp.project.program_file import read_program, read_program_nominal

    if files.reference.suffix.lower() not in PROGRAMS:
        return InspectionProgram(name=files.reference.stem), read_mesh(files.reference, unit=files.nominal_unit or LengthUnit.MM)
    program = read_program(files.reference)
    if files.nominal_unit is not None:
        program = program.model_copy(update={"nominal_unit": files.nominal_unit})
    return program, read_program_nominal(files.reference, program)


def _cloud(files: FilesToMeasure, read: PlainPoints | Mesh) -> StitchedCloud:
    """Return the points as a stitched cloud; without σ in the file it is 0, without views there is one named after the file."""
    import numpy as np

    from measureapp.data.cloud import StitchedCloud
    from measureapp.inspection.measured_points import MeasuredPoints
    from measureapp.project.geometry.files import PlainPoints

    points = MeasuredPoints.of(read)
    count = len(points)
    normals = np.zeros((count, 3)) if points.normals is None else points.normals
    sigma = np.zeros(count) if points.sigma_mm is None else points.sigma_mm
    view, names, grey = np.zeros(count, np.int16), (files.cloud.name,), np.full(count, np.nan)
    if isinstance(read, PlainPoints) and read.view is not None and 0 <= read.view.min() <= read.view.max() < len(read.view_names):
        view, names = read.view, read.view_names
    return StitchedCloud(points.points_mm, normals, sigma, grey, view, (), view_names=names, sampled_view=points.view, errors=points.errors)
