"""Entry point of the command line; the only place where errors become exit codes."""

from __future__ import annotations

import importlib
import io
import json
import pkgutil
import sys
from collections.abc import Sequence

import typer
import typer.exceptions

from measureapp import __version__
from measureapp.cli.help_words import use_plain_help
from measureapp.cli.reply import say
from measureapp.errors import DeviceError, MeasureError
from measureapp.progress import Cancelled

DONE, OUT_OF_TOLERANCE, BAD_INPUT, DEVICE_FAILED, CANCELLED = 0, 1, 2, 3, 130
NOT_COMMANDS = ("help_words", "main", "outcome", "part_options", "reply", "scan_log", "stop_signals")


def build() -> typer.Typer:
    """Return the command line with every command group registered."""
    app = typer.Typer(
        name="measureapp",
        help="Measure large curved parts with fringe projection. Lengths in mm, angles in degrees, exposures in µs.",
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
    )

    @app.callback(invoke_without_command=True)
    def version(show: bool = typer.Option(False, "--version", help="Print the version and stop.")) -> None:
        if show:
            print(__version__)
            raise typer.Exit(DONE)

    for module in pkgutil.iter_modules(importlib.import_module("measureapp.cli").__path__):
        if module.name not in NOT_COMMANDS:
            importlib.import_module(f"measureapp.cli.{module.name}").register(app)
    return use_plain_help(app)


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; invalid input never causes a traceback."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    as_json = "--json" in arguments
    _replace_unencodable()
    try:
        outcome = build()(args=arguments, obj=tuple(arguments), prog_name="measureapp", standalone_mode=False)
        if outcome == CANCELLED:  # how Typer ends a command on Ctrl-C
            raise KeyboardInterrupt
        return outcome if isinstance(outcome, int) else DONE
    except typer.Exit as stop:
        return stop.exit_code
    except (Cancelled, KeyboardInterrupt, typer.exceptions.Abort):
        return _fail("Cancelled", "Cancelled.", "Nothing more was written.", as_json, CANCELLED)
    except typer.exceptions.TyperException as error:
        return _fail_usage(error, as_json)
    except DeviceError as error:
        return _fail(type(error).__name__, error.message, error.hint, as_json, DEVICE_FAILED)
    except MeasureError as error:
        return _fail(type(error).__name__, error.message, error.hint, as_json, BAD_INPUT)
    except OSError as error:
        message = f"{error.filename or 'The disk'}: {error.strerror or 'a file cannot be read or written'}."
        return _fail("StorageError", message, "Check the path, the free space and the permissions.", as_json, BAD_INPUT)


def _replace_unencodable() -> None:
    """Print a question mark for characters (✓, σ, µ) missing in the encoding of a terminal or file."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _fail_usage(error: typer.exceptions.TyperException, as_json: bool) -> int:
    """Report a usage error with the help of the command that it concerns; without a command print the help."""
    message = error.format_message()
    if message.startswith("Usage:"):
        if not as_json:
            say(message)
            return BAD_INPUT
        message = "A command is missing."
    sentence = message if message.endswith((".", "?")) else f"{message}."
    return _fail("UsageError", sentence, f"See `{_command_of(error)} --help`.", as_json, BAD_INPUT)


def _command_of(error: typer.exceptions.TyperException) -> str:
    """Return the command line up to the command or group in which an error was found."""
    context = getattr(error, "ctx", None)
    return "measureapp" if context is None else str(context.command_path)


def _fail(kind: str, message: str, hint: str, as_json: bool, code: int) -> int:
    if as_json:
        try:
            print(json.dumps({"error": {"type": kind, "message": message, "hint": hint}}), flush=True)
        except OSError:  # the answer has no place to go, such as a full disk
            say(f"measureapp: {message} {hint}".rstrip())
    else:
        say(f"measureapp: {message} {hint}".rstrip())
    return code
