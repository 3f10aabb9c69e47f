"""`measureapp report`: the report documents of a measured project."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, LanguageOption, TerminalProgress, reply
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH

if TYPE_CHECKING:
    from measureapp.report.documents import DocumentKind


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def report(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        pdf: Annotated[bool, typer.Option("--pdf", help="Write report.pdf.")] = False,
        csv: Annotated[bool, typer.Option("--csv", help="Write report.csv.")] = False,
        xlsx: Annotated[bool, typer.Option("--xlsx", help="Write report.xlsx.")] = False,
        html: Annotated[bool, typer.Option("--html", help="Write report.html.")] = False,
        template: Annotated[
            Path | None, typer.Option("--template", help="Template folder with a template.toml; by default the project's, else your own.")
        ] = None,
        out: Annotated[Path | None, typer.Option("--out", help="Output folder; by default the project's.", file_okay=False)] = None,
        language: LanguageOption = ENGLISH,
        as_json: JsonOption = False,
    ) -> None:
        """Write the report of the last measurement in the chosen formats (default: PDF, CSV and JSON)."""
        from measureapp.project.folder import ProjectFolder
        from measureapp.report.documents import ALL_KINDS, write_documents
        from measureapp.report.project import compose_project
        from measureapp.report.template import read_template

        if out is not None and out.suffix.lower()[1:] in ALL_KINDS and not out.is_dir():
            raise InputError(
                f"--out is a folder, and {out} would be one with the name of a file.", "Name a folder; the files are called report."
            )
        folder = ProjectFolder.open(project)
        chosen = None if template is None else read_template(template)
        model = compose_project(folder, template=chosen, language=language, progress=TerminalProgress())
        files = write_documents(model, out or folder.report_pdf.parent, _kinds(pdf=pdf, csv=csv, xlsx=xlsx, html=html))
        document = {"files": dict(files), "verdict": None if model.verdict is None else model.verdict.value}
        reply(document, "\n".join([model.summary, *(str(path) for path in files.values())]), as_json)


def _kinds(**wanted: bool) -> tuple[DocumentKind, ...]:
    from measureapp.report.documents import ALL_KINDS

    return tuple(kind for kind in ALL_KINDS if wanted.get(kind)) or ("pdf", "csv", "json")
