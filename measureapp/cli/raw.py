"""`raw` and `discard`: what becomes of raw images, and viewpoints that are to be taken again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.data.raw_policy import RawPolicy


def register(app: typer.Typer) -> None:
    """Add the commands."""
    _register_raw(app)
    _register_discard(app)


def _register_raw(app: typer.Typer) -> None:
    @app.command()
    def raw(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        compress: Annotated[
            bool, typer.Option("--compress", help="Compress raw images without loss; every command reads them all the same.")
        ] = False,
        expand: Annotated[bool, typer.Option("--expand", help="Turn compressed images into raw ones again, byte for byte.")] = False,
        remove: Annotated[
            bool, typer.Option("--remove", help="Remove all images of the part for good; results stay. Needs --yes.")
        ] = False,
        policy: Annotated[
            RawPolicy | None, typer.Option("--policy", help="From now on, raw images are kept, compressed or dropped after a scan.")
        ] = None,
        apply: Annotated[
            bool, typer.Option("--apply", help="Do what the project states about raw images, where it is not done yet.")
        ] = False,
        yes: Annotated[
            bool, typer.Option("--yes", help="Confirm that the images may be removed: nothing can be computed from them again.")
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """List the raw images of a project with their size; compress, expand or remove them."""
        from measureapp.data.storage_rules import StorageRules
        from measureapp.errors import InputError
        from measureapp.pipeline.raw_keeping import apply_raw_policy
        from measureapp.project import raw_images
        from measureapp.project.folder import ProjectFolder

        if compress + expand + remove + apply > 1:
            raise InputError("Only one of --compress, --expand, --remove and --apply is possible.", "Run the command once for each.")
        if remove and not yes:
            raise InputError("--remove deletes images that cannot be computed again.", "Add --yes if that is what you want.")
        opened = ProjectFolder.open(project)
        if policy is not None:
            with opened.lock():
                opened.save_storage_rules(StorageRules(raw=policy))
        if apply:
            apply_raw_policy(opened, TerminalProgress())
        act = raw_images.compress if compress else raw_images.expand if expand else raw_images.remove_images if remove else None
        if act is not None or opened.journal.contents() is None:
            with opened.lock():
                if act is not None:
                    raw_images.for_all(opened.journal, act, TerminalProgress())
        found = raw_images.list_raw(opened.journal)
        lines = [f"{one.viewpoint_id}: {one.state}, {one.bytes / 1e6:.1f} MB" for one in found]
        total = sum(one.bytes for one in found)
        document = {
            "bytes": total,
            "policy": opened.storage_rules().raw,
            "viewpoints": [{"name": one.viewpoint_id, "state": one.state, "bytes": one.bytes} for one in found],
        }
        reply(document, "\n".join([*lines, f"{len(found)} viewpoints, {total / 1e6:.1f} MB of images."]), as_json)


def _register_discard(app: typer.Typer) -> None:
    @app.command()
    def discard(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        viewpoints: Annotated[list[str], typer.Argument(help="Viewpoints whose images are removed.")],
        as_json: JsonOption = False,
    ) -> None:
        """Remove the stored images of viewpoints, so that `scan --resume` takes them again."""
        from measureapp.errors import InputError
        from measureapp.project.folder import ProjectFolder

        opened = ProjectFolder.open(project)
        with opened.lock():
            stored = opened.stored_viewpoints()
            if unknown := [name for name in viewpoints if name not in stored]:
                raise InputError(f"{project} has no viewpoint {unknown[0]!r}.", f"Stored are: {', '.join(stored) or 'none'}.")
            for name in dict.fromkeys(viewpoints):
                opened.frames.discard(name)
        left = opened.stored_viewpoints()
        reply({"discarded": list(dict.fromkeys(viewpoints)), "stored": left}, f"{len(left)} viewpoints are stored.", as_json)
