"""Measuring again on the stitched cloud there is, after the inspection program or the drawing was changed."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from measureapp.data.length_unit import LengthUnit
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.surface.units import check_size
from measureapp.pipeline.assemble import inspection_settings
from measureapp.pipeline.chosen_views import chosen
from measureapp.pipeline.run import Outcome, finished
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import program_from


@dataclass(frozen=True, slots=True)
class Drawing:
    """A nominal in a file, and the unit of its lengths."""

    path: Path
    unit: LengthUnit = LengthUnit.MM


def measure_again(
    project: ProjectFolder, measurement: Measurement, progress: Progress, *, program: str | None = None, drawing: Drawing | None = None
) -> Outcome:
    """Measure with another program or drawing, and keep program, drawing and results.

    Where this fails, or is cancelled, everything stays as it was.

    Parameters
    ----------
    measurement : the last one of the project
    program : text (TOML); None: as the project has it
    drawing : None: as the project has it

    Raises
    ------
    InputError
        Program or drawing cannot be used.
    UnitQuestion
        The drawing looks like another unit.
    InspectionError
        The drawing is of another part.
    """
    progress.report(0, 1, "reading the drawing")
    watch, nominal = Stopwatch(), _nominal(project, drawing)
    text = project.program_text(has_nominal=nominal is not None) if program is None else program
    described = program_from(text)
    settings = inspection_settings(measurement.calibration, project.rig(), chosen(measurement.views, project.view_choices()))
    if drawing is not None and nominal is not None:
        check_size(measurement.stitched.points_mm, nominal.vertices_mm)
    with project.lock():
        with watch.stage("inspection"):
            found = inspect(measurement.stitched, described, nominal, settings, PartOf(progress, 0.2, 0.8))
        progress.report(0.8, 1.0, "storing")
        if drawing is not None and nominal is not None:
            project.save_nominal(drawing.path, nominal)
        project.save_program(text)
        measured = replace(measurement, inspection=found)
        project.update_inspection(measured)
        return finished(project, measured, watch)


def _nominal(project: ProjectFolder, drawing: Drawing | None) -> Mesh | None:
    if drawing is not None:
        return read_mesh(drawing.path, unit=drawing.unit)
    return None if project.nominal is None else read_mesh(project.nominal)
