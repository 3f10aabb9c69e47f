"""Files of scan plans, as TOML or JSON."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, get_args

import tomli_w
from pydantic import ValidationError

from measureapp.data.model import NONE, first_problem, toml_values
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.data.plan import ScanPlan
from measureapp.errors import InputError
from measureapp.project.atomic import write_text
from measureapp.project.text_document import read_toml_or_json

SUFFIXES = (".toml", ".json")
NEWEST: int = get_args(ScanPlan.model_fields["schema_version"].annotation)[0]
NOUNS = {"viewpoints": "viewpoint", "groups": "group"}
NUMBERS = re.compile(r"\[\n((?: +[-+.0-9e]+,\n)+)\]")  # arrays of numbers, which tomli_w writes one a line
UNFIT = "string_pattern_mismatch"
SHOWN = 60  # characters of a name that is no name


def read_plan(path: Path) -> ScanPlan:
    """Read a plan from JSON or TOML.

    Raises
    ------
    InputError
        Naming the file, and the field and viewpoint that are invalid.
    """
    path = Path(path)
    document = read_toml_or_json(path, "a scan plan", "Give a scan plan as JSON or TOML.")
    version = document.get("schema_version") if isinstance(document, Mapping) else None
    if isinstance(version, int) and version > NEWEST:
        raise InputError(
            f"{path} is a plan of version {version}; this version of MeasureApp reads versions up to {NEWEST}.",
            "Open it with the version that wrote it, or a later one.",
        )
    try:
        return ScanPlan.model_validate(document)
    except ValidationError as error:
        more = f" (and {error.error_count() - 1} more)" if error.error_count() > 1 else ""
        raise InputError(f"{path}: {_problem(error, document)}{more}.", "Correct this entry of the plan.") from error


def write_plan(path: Path, plan: ScanPlan) -> None:
    """Write a plan as TOML or JSON, by the extension; groups stay groups, comments of an earlier file are lost.

    Raises
    ------
    InputError
        The extension is neither ``.toml`` nor ``.json``.
    StorageError
        It cannot be written; an earlier file stays as it was.
    """
    path = Path(path)
    check_plan_name(path)
    write_text(path, plan_text(plan) if path.suffix.lower() == ".toml" else plan.model_dump_json(indent=2, exclude_none=True) + "\n")


def check_plan_name(path: Path) -> None:
    """Raise InputError if the extension of a plan to be written is neither ``.toml`` nor ``.json``."""
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(f"{path} is not the name of a plan file.", "End its name in .toml or .json.")


def plan_text(plan: ScanPlan) -> str:
    """Return a plan as TOML: a predefined pattern set by its name, and nothing that has its default value."""
    values = {"schema_version": plan.schema_version, **toml_values(plan)}
    known = next((name for name, patterns in PATTERN_SETS.items() if patterns == plan.patterns), None)
    if known is not None:
        values["patterns"] = known
    whole = {name: _without_none(value) for name, value in values.items() if value != NONE}
    return NUMBERS.sub(lambda found: f"[{' '.join(found[1].split()).rstrip(',')}]", tomli_w.dumps(whole))


def _without_none(value: Any) -> Any:
    """Return a value without its missing ones, for they are the defaults of a plan."""
    if isinstance(value, Mapping):
        return {name: _without_none(inner) for name, inner in value.items() if inner != NONE}
    return [_without_none(inner) for inner in value] if isinstance(value, list) else value


def _problem(error: ValidationError, document: Any) -> str:
    """Return the first problem, with the viewpoint or group that it concerns in words."""
    first = error.errors()[0]
    place = list(first["loc"])
    if len(place) < 2 or place[0] not in NOUNS or not isinstance(place[1], int):
        return first_problem(error, "the plan")
    reason = {
        "extra_forbidden": "is not a known field",
        UNFIT: "a name begins with a letter or digit, and has letters, digits, '.', '_' and '-' only",
    }.get(first["type"], first["msg"].removeprefix("Value error, "))
    return ": ".join(part for part in (_where(document, place), reason) if part)


def _where(document: Any, place: Sequence[Any]) -> str:
    field = ".".join(str(part) for part in place[2:])
    return f"{NOUNS[place[0]]} {_name(document, place)}" + (f", {field}" if field else "")


def _name(document: Any, place: Sequence[Any]) -> str:
    """Return the id of an entry, and its number where that is clearer."""
    number = f"no. {place[1] + 1}"
    try:
        name = document[place[0]][place[1]]["id"]
    except (KeyError, IndexError, TypeError):
        return number
    return f"{str(name)[:SHOWN]!r} ({number})"
