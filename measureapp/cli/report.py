"""`measureapp report`: the report documents of a measured project."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.report.documents import DocumentKind


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def report(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        pdf: Annotated[bool, typer.Option("--pdf", help="Write report.pdf.")] = False,
        csv: Annotated[bool, typer.Option("--csv", help="Write report.csv.")] = False,
        html: Annotated[bool, typer.Option("--html", help="Write report.html.")] = False,
        out: Annotated[Path | None, typer.Option("--out", help="Output folder; by default the project's.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Write the report of the last measurement in the chosen formats (default: PDF, CSV and JSON)."""
        from measureapp.errors import StorageError
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.geometry.files import read_mesh
        from measureapp.report.compose import compose
        from measureapp.report.documents import write_documents

        folder = ProjectFolder.open(project)
        measurement = folder.measurement()
        if measurement is None:
            raise StorageError(f"{project} contains no measurement.", "Scan first, or recompute it: measureapp process PROJECT.")
        nominal = None if folder.nominal is None else read_mesh(folder.nominal)
        model = compose(measurement, nominal, progress=TerminalProgress())
        files = write_documents(model, out or folder.report_pdf.parent, _kinds(pdf, csv, html), folder.report_template)
        document = {"files": dict(files), "verdict": None if model.verdict is None else model.verdict.value}
        reply(document, "\n".join([model.summary, *(str(path) for path in files.values())]), as_json)


def _kinds(pdf: bool, csv: bool, html: bool) -> tuple[DocumentKind, ...]:
    chosen: list[DocumentKind] = []
    for kind, wanted in (("pdf", pdf), ("csv", csv), ("html", html)):
        if wanted:
            chosen.append(kind)  # type: ignore[arg-type]
    return tuple(chosen) or ("pdf", "csv", "json")
