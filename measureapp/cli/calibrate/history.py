"""`calibrate history`: results of scans and checks for a project's calibrations."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.data.validity import CheckRecord


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def history(project: Annotated[Path, typer.Argument(help="Project folder.")], as_json: JsonOption = False) -> None:
        """List the result of every scan and every board check for the project's calibrations, oldest first."""
        from measureapp.project.documents import calibration_id, check_document
        from measureapp.project.folder import ProjectFolder

        folder = ProjectFolder.open(project)
        calibration = folder.calibration()
        lines = folder.calibration_history()
        document = {
            "calibration": None if calibration is None else calibration_id(calibration),
            "created": None if calibration is None else calibration.provenance.created,
            "checks": [check_document(line) for line in lines],
        }
        words = [history_line(line) for line in lines] or ["There is no result of a scan or board check yet."]
        reply(document, "\n".join(words), as_json)


def history_line(line: CheckRecord) -> str:
    """Return one line of the trend."""
    shift = "" if line.shift_px is None else f"{line.shift_px:.3f} px"
    error = "" if line.error_mm is None else f"{line.error_mm:.3f} mm"
    return (
        f"{line.at[:19]}  {line.kind:<11}  {line.calibration}  {line.status:<8}  {shift:>9}  {error:>9}  {', '.join(line.cameras)}".rstrip()
    )
