"""The inspection stored in a project, read without its clouds."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass

from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Inspection
from measureapp.errors import InputError, StorageError
from measureapp.project.documents import inspection_from
from measureapp.project.folder import ProjectFolder
from measureapp.project.program_file import read_program
from measureapp.project.results import DOCUMENT


@dataclass(frozen=True, slots=True, eq=False)
class InspectedProject:
    """Last inspection of a project, and what it was made from."""

    part: str
    measured_at: str  # ISO 8601
    calibrated_at: str  # ISO 8601; empty without a calibration
    inspection: Inspection
    program: InspectionProgram
    nominal_sha256: str  # empty without a nominal


def read_inspected(project: ProjectFolder) -> InspectedProject:
    """Read the last inspection of a project.

    Raises
    ------
    InputError
        The project was not measured yet, or without an inspection program.
    StorageError
        The results are damaged, or not what was stored.
    """
    path = project.results / DOCUMENT
    if not path.exists():
        raise InputError(f"{project.path} has no results.", f"Measure it first: measureapp process {project.path}.")
    project.journal.check(path)
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        stored, measured_at = document["inspection"], str(document["measured_at"])
        inspection = None if stored is None else inspection_from(stored)
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", f"Recompute it: measureapp process {project.path}.") from error
    if inspection is None or project.program is None:
        raise InputError(
            f"{project.path} was measured without an inspection program.", "Give it one on the Inspect page, and measure again."
        )
    calibration = project.calibration()
    return InspectedProject(
        part=project.settings.part,
        measured_at=measured_at,
        calibrated_at="" if calibration is None else calibration.provenance.created,
        inspection=inspection,
        program=read_program(project.program),
        nominal_sha256="" if project.nominal is None else hashlib.sha256(project.nominal.read_bytes()).hexdigest(),
    )
