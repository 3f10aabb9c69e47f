"""Repeated measurements of one part, each in a project of its own."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from measureapp.data.repeats import RepeatedMeasurement, RepeatStudy
from measureapp.errors import InputError
from measureapp.inspection.repeats import InspectedPart, evaluate_repeats
from measureapp.pipeline.inspected import InspectedProject, read_inspected
from measureapp.pipeline.project_names import unique_names
from measureapp.project.folder import ProjectFolder


def compare_repeats(folders: Sequence[Path], *, one_part: bool = False) -> RepeatStudy:
    """Evaluate the stored inspections of several projects of one part.

    Parameters
    ----------
    one_part : the projects are of one part although they name it differently

    Raises
    ------
    InputError
        A folder is given twice or is no measured project, or the projects are of different parts, nominals or inspection programs.
    InspectionError
        There are fewer than two projects, or two of them are copies of one measurement.
    StorageError
        The results of a project are damaged.
    """
    names = unique_names(folders, "Name each project once; a spread needs independent scans.")
    projects = {name: read_inspected(ProjectFolder.open(path)) for name, path in zip(names, folders, strict=True)}
    _require_one_part(projects, one_part)
    parts = [InspectedPart(RepeatedMeasurement(name, one.measured_at, one.calibrated_at), one.inspection) for name, one in projects.items()]
    return evaluate_repeats(next((one.part for one in projects.values()), ""), parts)


def _require_one_part(projects: dict[str, InspectedProject], one_part: bool) -> None:
    first_name, first = next(iter(projects.items()), ("", None))
    for name, one in projects.items():
        if first is None or one is first:
            continue
        where = f"{first_name} and {name}"
        if one.part != first.part and not one_part:
            hint = "Name projects of one part; if this is one part under two names, add --one-part."
            raise InputError(f"{where} are of different parts: {first.part!r} and {one.part!r}.", hint)
        if one.nominal_sha256 != first.nominal_sha256:
            hint = "Give all projects the same nominal, and measure them again."
            raise InputError(f"{where} were compared with different nominals.", hint)
        if one.program != first.program:
            hint = "Give all projects the same program, and measure them again: measureapp process PROJECT."
            raise InputError(f"{where} have different inspection programs ({_difference(first, one)}).", hint)


def _difference(first: InspectedProject, other: InspectedProject) -> str:
    """Name the first entry in which two programs differ."""
    for kind in ("dimensions", "features"):
        expected, found = ({one.name: one for one in getattr(program, kind)} for program in (first.program, other.program))
        for name in expected | found:
            if expected.get(name) != found.get(name):
                return f"{kind.removesuffix('s')} {name!r}"
    return "name or alignment"
