"""Answers of commands: one JSON document or plain lines on standard output, progress on standard error."""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from measureapp.data.length_unit import LengthUnit

JsonOption = Annotated[bool, typer.Option("--json", help="Answer with exactly one JSON document on standard output.")]

UNIT_HELP = "Unit of its lengths: mm, inch, m, cm or um; default: mm, with a question if another unit is more likely."
UnitOption = Annotated[LengthUnit, typer.Option("--unit", help=UNIT_HELP)]


def jsonable(value: Any) -> Any:
    """Convert arrays, paths, enums and NumPy numbers in ``value`` to plain JSON; non-finite numbers become null."""
    if isinstance(value, Mapping):
        return {str(key): jsonable(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return jsonable(value.tolist())
    if isinstance(value, (list, tuple)):
        return [jsonable(item) for item in value]
    if isinstance(value, Enum):
        return jsonable(value.value)
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, np.generic):
        return jsonable(value.item())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def reply(document: Mapping[str, Any], lines: str, as_json: bool) -> None:
    """Print the answer of a command, as JSON or as ``lines``."""
    print(json.dumps(jsonable(document), indent=2, allow_nan=False) if as_json else lines)


def say(message: str) -> None:
    """Print a message to standard error."""
    print(message, file=sys.stderr)


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
