"""Formatting of the command help: PATH, TEXT and NUMBER as value types, and complete sentences for commands."""

from __future__ import annotations

import re
from typing import Any

import typer
import typer.core

KINDS = {"path": "PATH", "file": "PATH", "directory": "PATH", "str": "TEXT", "int": "NUMBER", "float": "NUMBER"}
TYPE = re.compile(r"<([^<>]*)>(?:\.\.\.)?")  # as Typer writes the type of a value
RANGES = (
    (re.compile(r"([-\d.]+)<=x<=([-\d.]+)"), r"from \1 to \2"),
    (re.compile(r"x>=([-\d.]+)"), r"at least \1"),
    (re.compile(r"x<=([-\d.]+)"), r"at most \1"),
)


class _PlainHelp:
    """Help formatting common to commands and groups."""

    def collect_usage_pieces(self, ctx: Any) -> list[str]:
        """Return the parts of the usage line after the command name."""
        own: Any = self
        names = [_usage(one) for one in own.get_params(ctx) if one.param_type_name == "argument"]
        return [own.options_metavar, *names, *([own.subcommand_metavar] if hasattr(own, "commands") else [])]

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write arguments, options and commands."""
        own: Any = self
        records = [(one, one.get_help_record(ctx)) for one in own.get_params(ctx)]
        for title, kind in (("Arguments", "argument"), ("Options", "option")):
            rows = [_row(one, *record) for one, record in records if record is not None and one.param_type_name == kind]
            _write(formatter, title, rows)
        commands = getattr(own, "commands", {})
        _write(formatter, "Commands", [(name, _first_sentence(command.help or "")) for name, command in commands.items()])


class PlainHelpCommand(_PlainHelp, typer.core.TyperCommand):
    """A command with this help formatting."""


class PlainHelpGroup(_PlainHelp, typer.core.TyperGroup):
    """A command group with this help formatting."""


def use_plain_help(app: typer.Typer) -> typer.Typer:
    """Apply the help formatting to an application and all its commands."""
    app.info.cls = PlainHelpGroup
    for command in app.registered_commands:
        command.cls = PlainHelpCommand
    for group in app.registered_groups:
        if group.typer_instance is not None:
            use_plain_help(group.typer_instance)
    return app


def _write(formatter: Any, title: str, rows: list[tuple[str, str]]) -> None:
    if rows:
        with formatter.section(title):
            formatter.write_dl(rows)


def _row(parameter: Any, name: str, text: str) -> tuple[str, str]:
    """Return one row of the help: parameter and meaning."""
    for pattern, words in RANGES:
        text = pattern.sub(words, text)
    if parameter.param_type_name != "argument":
        return TYPE.sub(_kind, name), text
    choices = [found.split("|") for found in TYPE.findall(name) if "|" in found]
    return _word(parameter), f"{', '.join(choices[0])}: {text}" if choices else text


def _kind(found: re.Match[str]) -> str:
    """Return the value type of an option: one, several, or a choice."""
    label = found[1].removeprefix("list[").removesuffix("]").removesuffix(" range")
    return " ".join(KINDS.get(part, part) for part in label.split(","))


def _word(argument: Any) -> str:
    return str(argument.metavar or argument.name.upper().replace("_", "-"))


def _usage(argument: Any) -> str:
    word = _word(argument) + ("…" if argument.nargs != 1 else "")
    return word if argument.required else f"[{word}]"


def _first_sentence(text: str) -> str:
    """Return the first sentence of a help text; Typer would cut it to one line."""
    paragraph = " ".join(text.strip().split("\n\n", maxsplit=1)[0].split())
    return re.split(r"(?<=\.)\s", paragraph, maxsplit=1)[0]
