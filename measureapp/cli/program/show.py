"""`program show`: what a part program contains."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgram


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def show(program: Annotated[Path, typer.Argument(help="Part program (.mpart).")], as_json: JsonOption = False) -> None:
        """Show what a part program contains; everything in it is checked."""
        from measureapp.project.part_program_file import read_part_program

        found = read_part_program(program)
        reply(facts_document(found), "\n".join(facts_lines(found)), as_json)


def release_words(program: PartProgram) -> str:
    """Return whether and by whom a part program is released, in a sentence."""
    from measureapp.project.part_program_file import is_released

    facts = program.facts
    if facts.release is not None and is_released(program):
        return f"Revision {facts.revision}, released by {facts.release.by} on {facts.release.at[:10]}."
    return f"Not released{f'; the last release was revision {facts.revision}' if facts.revision else ''}: not offered to operators."


def facts_document(program: PartProgram) -> dict[str, Any]:
    """Return what a part program contains, as JSON."""
    from measureapp.project.part_program_file import is_released

    return {
        "name": program.facts.name,
        "part_number": program.facts.part_number,
        "drawing": program.facts.identification.drawing,
        "revision": program.facts.identification.revision,
        "remarks": program.facts.remarks,
        "code_pattern": program.facts.code_pattern,
        "required": list(program.facts.required),
        "viewpoints": len(program.plan),
        "inspection": program.inspection is not None,
        "nominal": None if program.nominal is None else f"nominal{program.nominal[0]}",
        "report_template": (program.report_template or program.template_folder) is not None,
        "picture": program.picture is not None,
        "revision_of_program": program.facts.revision,
        "released": is_released(program),
        "released_by": "" if program.facts.release is None else program.facts.release.by,
        "raw": program.facts.raw,
        "rig": None if program.rig is None else program.rig.name,
        "calibration": None if program.facts.calibration is None else program.facts.calibration.model_dump(),
    }


def facts_lines(program: PartProgram) -> list[str]:
    """Return what a part program contains, as lines for a person."""
    number = f" ({program.facts.part_number})" if program.facts.part_number else ""
    parts = {
        "inspection program": program.inspection,
        "nominal": program.nominal,
        "report template": program.report_template or program.template_folder,
        "picture": program.picture,
    }
    there = ", ".join(name for name, part in parts.items() if part is not None)
    absent = ", ".join(name for name, part in parts.items() if part is None)
    lines = [f"{program.facts.name}{number}: {len(program.plan)} viewpoints{f', {there}' if there else ''}."]
    lines.append(release_words(program))
    if program.rig is not None:
        named = program.facts.calibration
        lines.append(f"Rig: {program.rig.name}{'' if named is None else f', calibrated in {named.folder}'}.")
    lines += [f"Not included: {absent}."] if absent else []
    drawing, revision = program.facts.identification.drawing, program.facts.identification.revision
    lines += [f"Drawing {drawing}, revision {revision or 'not stated'}."] if drawing else []
    return lines + ([program.facts.remarks] if program.facts.remarks else [])
