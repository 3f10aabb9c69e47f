"""`verify`: every byte of a project against its checksum."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.project.checks import Verified

MOST_UNKNOWN = 5  # files listed on the terminal


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def verify(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        accept: Annotated[
            list[str] | None,
            typer.Option(help="Accept a file that was changed on purpose, by its path in the project; may be given several times."),
        ] = None,
        renew_journal: Annotated[
            bool,
            typer.Option("--renew-journal", help="Keep the damaged journal under another name, and make a new one from what is there."),
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Compare every stored byte of a project with its checksum: images, read-backs, calibrations, results, reports, journal."""
        from measureapp.project import upkeep

        if renew_journal:
            upkeep.renew_journal(project)
        if accept:
            upkeep.accept_changes(project, accept)
        found = upkeep.verify(project, TerminalProgress())
        reply(_document(found), "\n".join(_lines(found)), as_json)
        if not found.whole:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _document(found: Verified) -> dict[str, Any]:
    damaged: dict[str, list[str]] = {}
    for one in found.damage:
        damaged.setdefault(one.viewpoint or one.file, []).append(one.problem)
    return {
        "checked": found.viewpoints,
        "files": found.files,
        "bytes": found.bytes,
        "damaged": damaged,
        "damage": [{"file": one.file, "viewpoint": one.viewpoint or None, "problem": one.problem} for one in found.damage],
        "unknown": found.unknown,
        "stale": found.stale,
        "removed": found.removed,
        "journal": found.journal,
    }


def _lines(found: Verified) -> list[str]:
    lines = [f"Viewpoint {one.viewpoint}: {one.problem}" if one.viewpoint else one.problem for one in found.damage]
    unknown = [f"Not stored by MeasureApp, hence not checked: {name}" for name in found.unknown[:MOST_UNKNOWN]]
    if len(found.unknown) > MOST_UNKNOWN:
        unknown.append(f"… and {len(found.unknown) - MOST_UNKNOWN} more files.")
    checked = (
        f"{found.files} files checked, among them those of {len(found.viewpoints)} views: "
        if found.journal
        else f"{len(found.viewpoints)} views checked: "
    )
    files = "1 file is" if len(found.damage) == 1 else f"{len(found.damage)} files are"
    summary = checked + (f"{files} damaged." if found.damage else "no damage.")
    old = (
        [] if found.journal else ["The project was written by an earlier version: only its images have checksums until it is next changed."]
    )
    count = len(found.removed)
    removed = (
        [f"The raw images of {count} viewpoint{'s' * (count > 1)} were removed on purpose: {', '.join(found.removed)}."] if count else []
    )
    return [*lines, *unknown, *found.stale, *removed, summary, *old]
