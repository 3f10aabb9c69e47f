"""Repeated inspection of the stitched cloud after a change of the inspection program or the nominal."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from measureapp.data.length_unit import LengthUnit
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.surface.units import check_size
from measureapp.language.languages import ENGLISH
from measureapp.pipeline.assemble import project_settings
from measureapp.pipeline.chosen_views import select_views
from measureapp.pipeline.run import Outcome, finish
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import parse_program


@dataclass(frozen=True, slots=True)
class NominalFile:
    """File of a nominal, and the unit of its lengths."""

    path: Path
    unit: LengthUnit = LengthUnit.MM


def measure_again(
    project: ProjectFolder,
    measurement: Measurement,
    progress: Progress,
    *,
    program: str | None = None,
    nominal_file: NominalFile | None = None,
    language: str = ENGLISH,
) -> Outcome:
    """Inspect with another program or nominal, and store program, nominal and results.

    On failure or cancellation nothing is changed.

    Parameters
    ----------
    measurement : the last one of the project
    program : text (TOML); None: that of the project
    nominal_file : None: the nominal of the project
    language : of the report

    Raises
    ------
    InputError
        Program or nominal cannot be used.
    UnitQuestion
        The nominal is probably in another unit.
    InspectionError
        The nominal is of another part.
    """
    progress.report(0, 1, "reading the nominal")
    watch, nominal = Stopwatch(), _nominal(project, nominal_file)
    text = project.program_text(has_nominal=nominal is not None) if program is None else program
    described = parse_program(text)
    settings = project_settings(project, measurement.calibration, select_views(measurement.views, project.view_choices()))
    if nominal_file is not None and nominal is not None:
        check_size(measurement.stitched.points_mm, nominal.vertices_mm)
    with project.lock():
        with watch.stage("inspection"):
            found = inspect(measurement.stitched, described, nominal, settings, PartOf(progress, 0.2, 0.8))
        progress.report(0.8, 1.0, "storing")
        if nominal_file is not None and nominal is not None:
            project.save_nominal(nominal_file.path, nominal)
        project.save_program(text)
        measured = replace(measurement, inspection=found)
        project.update_inspection(measured)
        return finish(project, measured, watch, language)  # to its end: what is stored now is what the window will show


def store_program(project: ProjectFolder, measurement: Measurement, program: str, language: str = ENGLISH) -> Outcome:
    """Store a program with its inspection in ``measurement``, which was evaluated before, and write the reports.

    Raises
    ------
    StorageError
        The project cannot be written.
    """
    watch = Stopwatch()
    with project.lock():
        project.save_program(program)
        project.update_inspection(measurement)
        return finish(project, measurement, watch, language)


def _nominal(project: ProjectFolder, nominal_file: NominalFile | None) -> Mesh | None:
    if nominal_file is not None:
        return read_mesh(nominal_file.path, unit=nominal_file.unit)
    return None if project.nominal is None else read_mesh(project.nominal)
