"""A part program becomes a part of a project."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from measureapp.data.identification import Identification
from measureapp.data.mesh import Mesh
from measureapp.data.part_program import PartProgram
from measureapp.data.storage_rules import StorageRules
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.identification_file import read_identification, save_identification
from measureapp.project.program_file import parse_program
from measureapp.project.program_record import save_record
from measureapp.project.template_folder import save_folder, unzip_folder


@contextmanager
def nominal_of(program: PartProgram) -> Iterator[tuple[Path, Mesh] | None]:
    """Provide the nominal of a part program as a temporary file and as a mesh in millimetres; None where it has none. Raises InputError."""
    if program.nominal is None:
        yield None
        return
    ending, content = program.nominal
    with tempfile.TemporaryDirectory(prefix="measureapp-part-") as folder:
        source = Path(folder) / f"nominal{ending}"
        source.write_bytes(content)
        stated = None if program.inspection is None else parse_program(program.inspection.decode())
        yield source, read_mesh(source) if stated is None else read_mesh(source, unit=stated.nominal_unit)


def store_part_program(project: ProjectFolder, program: PartProgram) -> None:
    """Store inspection program, nominal, report template and identification of a part program in a project; the scan stores its plan.

    Raises
    ------
    InputError
        The nominal cannot be read.
    StorageError
        The project cannot be written.
    """
    with nominal_of(program) as found:
        if found is not None:
            project.save_nominal(*found)
    if program.inspection is not None:
        project.save_program(program.inspection.decode())
    if program.report_template is not None:
        project.save_report_template(program.report_template)
    if program.template_folder is not None:
        save_folder(project.path, unzip_folder(program.template_folder, program.facts.name))
    defaults = program.facts.identification.with_defaults(Identification(part_number=program.facts.part_number))
    if defaults != Identification():
        save_identification(project.path, read_identification(project.path).with_defaults(defaults))
    save_record(project.path, program)
    if program.facts.raw is not None and program.facts.raw != project.storage_rules().raw:
        project.save_storage_rules(StorageRules(raw=program.facts.raw))
