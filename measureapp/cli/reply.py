"""Answers of commands: one JSON document or plain lines on standard output, progress on standard error."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterable, Mapping
from typing import Annotated, Any

import typer

from measureapp.data.json_values import jsonable
from measureapp.data.length_unit import LengthUnit
from measureapp.data.shown_number import shown_number
from measureapp.language.languages import LANGUAGES, known_language

JsonOption = Annotated[bool, typer.Option("--json", help="Answer with exactly one JSON document on standard output.")]

LANGUAGE_HELP = "Language of reports (PDF, HTML, XLSX); CSV and JSON, which programs read, are in English."
LanguageOption = Annotated[str, typer.Option("--language", metavar="|".join(LANGUAGES), callback=known_language, help=LANGUAGE_HELP)]

UNIT_HELP = "Unit of its lengths: mm, inch, m, cm or um; default: mm, with a question if another unit is more likely."
UnitOption = Annotated[LengthUnit, typer.Option("--unit", help=UNIT_HELP)]


def reply(document: Mapping[str, Any], lines: str, as_json: bool) -> None:
    """Print the answer of a command, as JSON or as ``lines``."""
    print(json.dumps(jsonable(document), indent=2, allow_nan=False) if as_json else lines)


def say(message: str) -> None:
    """Print a message to standard error."""
    print(message, file=sys.stderr)


def triple(values: Iterable[float], digits: int) -> str:
    """Return a point or a direction with fixed digits.

    >>> triple([0.5, -1e-9, 1], 3)
    '(0.500, 0.000, 1.000)'
    """
    return f"({', '.join(shown_number(value, digits) for value in values)})"


class TerminalProgress:
    """A progress line on standard error, only where that is a terminal."""

    def __init__(self) -> None:
        self._visible = sys.stderr.isatty()
        self._last = 0.0

    def report(self, done: float, total: float, note: str = "") -> None:
        """Redraw the line at most ten times a second."""
        now = time.monotonic()
        if not self._visible or (now - self._last < 0.1 and done < total):
            return
        self._last = now
        share = done / total if total > 0 else 1.0
        bar = "█" * round(24 * share)
        print(f"\r{bar:<24} {share:4.0%}  {note[:70]:<70}", end="\n" if done >= total else "", file=sys.stderr, flush=True)

    def check(self) -> None:
        """Do nothing: Ctrl-C raises KeyboardInterrupt by itself."""
