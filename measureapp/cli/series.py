"""`series …`: results of many parts measured by one program."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.reply import JsonOption, LanguageOption, reply
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH

ProgramArgument = Annotated[str, typer.Argument(help="Name of the program, as `series list` shows it.")]
RootOption = Annotated[Path | None, typer.Option("--results", help="Folder of all series; by default MeasureApp/results in your home.")]

NONE_YET = "There is none yet: measure parts by this program, or add projects with `measureapp series add`."


def register(app: typer.Typer) -> None:
    """Add the command group."""
    group = typer.Typer(help="Series of parts: what was measured by one program, trend and capability.", no_args_is_help=True)
    for add in (_add_list, _add_show, _add_add, _add_report, _add_rebuild):
        add(group)
    app.add_typer(group, name="series")


def _add_list(group: typer.Typer) -> None:
    @group.command(name="list")
    def list_series(results: RootOption = None, as_json: JsonOption = False) -> None:
        """List the programs that have a series."""
        from measureapp.project.series.store import list_programs

        programs = list_programs(results)
        reply({"programs": list(programs)}, "\n".join(programs) or "No series yet.", as_json)


def _add_show(group: typer.Typer) -> None:
    @group.command()
    def show(
        program: ProgramArgument,
        serial: Annotated[str | None, typer.Option("--serial", help="Only this serial number.")] = None,
        since: Annotated[str | None, typer.Option("--since", help="Only runs since this date or time (ISO 8601).")] = None,
        results: RootOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Show the runs of a program, with trend and capability of every dimension."""
        from measureapp.project.series.store import SeriesStore, list_programs
        from measureapp.report.series.documents import series_document

        known = list_programs(results)
        if program not in known:
            raise InputError(f"There is no series of {program}.", f"Name one of: {', '.join(known)}." if known else NONE_YET)
        runs = SeriesStore(program, results).runs(serial_number=serial, since=since)
        lines = [
            f"{run.measured_at}  {run.identification.serial_number or '-':20}  {run.verdict or 'no verdict'}"
            + (f"  ({run.repeat_reason})" if run.repeat_reason else "")
            for run in runs
        ]
        reply(series_document(program, runs), "\n".join(lines) or f"The series of {program} has no such runs.", as_json)


def _add_add(group: typer.Typer) -> None:
    @group.command()
    def add(
        project: Annotated[Path, typer.Argument(help="Measured project folder.")],
        reason: Annotated[str, typer.Option("--reason", help="Why a part that was measured before is measured again.")] = "",
        results: RootOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Add the measurement of a project to the series of its program; one that is there already stays as it is (exit code 0)."""
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.series.filing import file_run

        run, is_new = file_run(ProjectFolder.open(project), repeat_reason=reason, root=results)
        said = f"{'Added to' if is_new else 'Already in'} the series of {run.program}: {run.verdict or 'no verdict'}."
        reply(run.model_dump(mode="json") | {"added": is_new}, said, as_json)


def _add_report(group: typer.Typer) -> None:
    @group.command()
    def report(
        program: ProgramArgument,
        out: Annotated[Path, typer.Option("--out", help="Folder for series.pdf, .csv and .json.", file_okay=False)],
        since: Annotated[str | None, typer.Option("--since", help="Only runs since this date or time (ISO 8601).")] = None,
        language: LanguageOption = ENGLISH,
        results: RootOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Write run charts and capability of a program's series as PDF, and its values as CSV and JSON."""
        from measureapp.project.series.store import SeriesStore
        from measureapp.report.series.documents import write_series

        files = write_series(program, SeriesStore(program, results).runs(since=since), out, language)
        reply({"files": files}, "\n".join(map(str, files.values())), as_json)


def _add_rebuild(group: typer.Typer) -> None:
    @group.command()
    def rebuild(
        program: ProgramArgument,
        projects: Annotated[list[Path], typer.Argument(help="Project folders, or folders that contain some.")],
        results: RootOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Rebuild a damaged series from what is left of it and from project folders."""
        from measureapp.project.series.filing import find_runs
        from measureapp.project.series.store import SeriesStore, list_programs

        found = find_runs(projects)
        if not found and program not in list_programs(results):
            raise InputError(
                f"{projects[0]} contains no measured part, and there is no series of {program}.", "Name other project folders."
            )
        made = SeriesStore(program, results).rebuild(found)
        document = {
            "runs": made.runs,
            "from_damaged": made.from_damaged,
            "from_projects": made.from_projects,
            "kept_as": None if made.kept_as is None else str(made.kept_as),
        }
        said = f"{made.runs} runs: {made.from_damaged} from the former file, {made.from_projects} more from projects."
        reply(document, said, as_json)
