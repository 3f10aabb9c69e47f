"""What the header of a report states, and by which template it is laid out; read and stored on a job's thread."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ui.look.language.words import tr

if TYPE_CHECKING:
    from measureapp.data.identification import Identification
    from measureapp.data.measurement import Measurement
    from ui.workers.job import Job


@dataclass(frozen=True)
class TemplateChoice:
    """A template of reports: the company's (of this user), the project's own, or another one to be copied into the project."""

    words: str
    source: Path | None = None  # of another one: a folder with a template.toml, or a Typst file
    of_project: bool = False


@dataclass(frozen=True)
class ReportHeader:
    """Identification of the part, company and logo of this user, and the template."""

    identification: Identification
    company: str
    logo: Path | None
    template: TemplateChoice
    templates: tuple[TemplateChoice, ...] = ()  # to choose from: the company's first


def read_header(folder: Path, job: Job) -> ReportHeader:
    """Return what the report of a project states; runs on a job's thread. Raises InputError for a template that is not valid."""
    job.report(0, 1, "Report header")
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.identification_file import read_identification
    from measureapp.report.template import default_template, own_logo, read_template

    company, own = default_template().description, ProjectFolder.open(folder).report_template
    offered = [TemplateChoice(tr("Your own: {name}, version {version}", name=company.name, version=company.version))]
    if own is not None:
        kept = read_template(own).description
        words = tr("{name}, version {version}", name=kept.name, version=kept.version) if own.is_dir() else "a layout (Typst)"
        offered.append(TemplateChoice(tr("This project's: {words}", words=words), of_project=True))
    return ReportHeader(read_identification(folder), company.company, own_logo(), offered[-1], tuple(offered))


def read_choice(path: Path) -> TemplateChoice:
    """Return a template folder or Typst file as a choice. Raises InputError for any other."""
    from measureapp.report.template import read_template

    found = read_template(path)
    words = path.name if path.is_file() else tr("{name}, version {version}", name=found.description.name, version=found.description.version)
    return TemplateChoice(tr("Another: {words}", words=words), path)


def save_header(folder: Path, header: ReportHeader, measurement: Measurement | None, job: Job) -> None:
    """Store identification, company, logo and template, and write the project's documents anew; runs on a job's thread."""
    job.report(0, 2, "Report header")
    from measureapp.pipeline.documents import write_reports
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.identification_file import save_identification
    from measureapp.project.template_folder import choose_template
    from measureapp.report.template import default_template, own_logo, save_own_template

    save_identification(folder, header.identification)  # first: a logo or template that is refused must not cost what was typed
    if (header.company, header.logo) != (default_template().description.company, own_logo()):
        save_own_template(header.company, header.logo)
    if not header.template.of_project:
        choose_template(folder, header.template.source)
    job.report(1, 2, "Documents")
    if measurement is not None:
        write_reports(ProjectFolder.open(folder), measurement, job.language)
