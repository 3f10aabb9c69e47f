"""The names of all commands, as the command line itself knows them."""

from __future__ import annotations

from collections.abc import Iterator

import typer

from measureapp.cli.main import build


def commands(group: object = None, before: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Every command of the command line, with the groups it lies in."""
    for name, command in (group or typer.main.get_command(build())).commands.items():  # type: ignore[attr-defined]
        if hasattr(command, "commands"):
            yield from commands(command, (*before, name))
        else:
            yield *before, name


ALL_COMMANDS = tuple(commands())
