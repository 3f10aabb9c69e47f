"""`sample …`: projects that come with the program."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply


def register(app: typer.Typer) -> None:
    """Add the command group."""
    group = typer.Typer(help="Sample projects that come with the program: measured parts, without a scan.", no_args_is_help=True)
    for add in (_add_list, _add_open, _add_pack):
        add(group)
    app.add_typer(group, name="sample")


def _add_list(group: typer.Typer) -> None:
    @group.command(name="list")
    def list_samples(as_json: JsonOption = False) -> None:
        """List the sample projects."""
        from measureapp.pipeline.samples import sample_names

        names = sample_names()
        reply({"samples": list(names)}, "\n".join(names), as_json)


def _add_open(group: typer.Typer) -> None:
    @group.command(name="open")
    def open_sample(
        name: Annotated[str, typer.Argument(help="Name of the sample, as `sample list` shows it.")],
        out: Annotated[
            Path | None, typer.Option("--out", help="Folder of the project; default: sample-NAME here.", file_okay=False)
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Unpack a sample project, which can then be opened, measured and reported like any other."""
        from measureapp.pipeline.samples import unpack_sample

        project = unpack_sample(name, out or Path(f"sample-{name}"))
        reply({"project": str(project.path), "name": project.name}, f"{project.name}: {project.path}", as_json)


def _add_pack(group: typer.Typer) -> None:
    @group.command()
    def pack(
        project: Annotated[Path, typer.Argument(help="Measured project folder.")],
        archive: Annotated[Path, typer.Argument(help="Sample to write, such as resources/samples/NAME.zip.")],
        title: Annotated[str, typer.Option("--title", help="Name of the project in the sample.")],
        every: Annotated[int, typer.Option("--every", min=1, help="Keep every so many rows and columns of each cloud.")] = 2,
        as_json: JsonOption = False,
    ) -> None:
        """Write a sample from a measured project: no images, thinned clouds, stitched and measured anew."""
        from measureapp.pipeline.samples import pack_sample

        written = pack_sample(project, archive, title=title, every=every, progress=TerminalProgress())
        size = written.stat().st_size
        reply({"sample": str(written), "bytes": size}, f"{written}: {size / 1e6:.1f} MB", as_json)
