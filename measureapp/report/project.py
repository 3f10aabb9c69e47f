"""The report of a project: what the measurement does not hold is read from its folder."""

from __future__ import annotations

from dataclasses import replace

from measureapp.data.control_frame import with_frames
from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.measurement import Measurement
from measureapp.errors import StorageError
from measureapp.language.languages import ENGLISH
from measureapp.progress import NoProgress, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.identification_file import read_identification
from measureapp.project.program_file import read_program
from measureapp.project.program_record import program_words
from measureapp.report.compose import compose
from measureapp.report.kept import KeptIn
from measureapp.report.model import Details, ReportModel
from measureapp.report.template import Template, default_template, read_template


def compose_project(
    project: ProjectFolder,
    measurement: Measurement | None = None,
    *,
    template: Template | None = None,
    created_at: str = "",
    language: str = ENGLISH,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> ReportModel:
    """Compose the report of a project.

    Parameters
    ----------
    measurement : that of the project, if it is loaded already
    template : None: the project's own, else this user's, else the built-in one
    created_at : ISO 8601; empty: now
    language : of the documents that people read, see `measureapp.language.languages`

    Raises
    ------
    StorageError
        There is no measurement, or a file of the project is damaged.
    InputError
        The template is not valid.
    """
    measurement = measurement or project.measurement(clouds=False)
    if measurement is None:
        raise StorageError(f"{project.path} contains no measurement.", "Scan first, or recompute it: measureapp process PROJECT.")
    if measurement.inspection is not None and project.program is not None:
        inspection = measurement.inspection
        dimensions = with_frames(inspection.dimensions, read_program(project.program), inspection.features)
        measurement = replace(measurement, inspection=replace(inspection, dimensions=dimensions))
    nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
    details = project_details(project, template, created_at, language)
    return compose(measurement, nominal, details=details, parts=KeptIn(project), progress=progress)


def project_details(project: ProjectFolder, template: Template | None = None, created_at: str = "", language: str = ENGLISH) -> Details:
    """Return what a report states besides the measurement. Raises StorageError, InputError as `compose_project`."""
    own = project.report_template
    return Details(
        read_identification(project.path),
        template or (default_template() if own is None else read_template(own)),
        project.plan(),
        {viewpoint: project.frames.exposures_us(viewpoint) for viewpoint in project.stored_viewpoints()},
        created_at,
        program_words(project.path),
        DeviationScale() if project.program is None else read_program(project.program).deviation_scale,
        language,
    )
