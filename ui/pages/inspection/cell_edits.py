"""What is typed into the table of dimensions, as edits of the inspection program."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ui.controllers.program_rows import DimensionRow
from ui.pages.inspection.dimension_model import CellEdit, Column

if TYPE_CHECKING:
    from measureapp.project.program_text import Value
    from ui.controllers.programming import ProgrammingController

NOT_A_NUMBER = "Enter a number, such as 24.5."


def problem_of(row: DimensionRow, column: Column, text: str) -> str:
    """Return why a text cannot be used in a cell; empty: it can."""
    try:
        values_of(row, column, text)
    except ValueError as error:
        return str(error)
    return ""


def values_of(row: DimensionRow, column: Column, text: str) -> dict[str, Value | None]:
    """Return the keys of the program that a text sets. Raises ValueError with the reason if it cannot be used."""
    if column is Column.NAME:
        if not text.strip():
            raise ValueError("A dimension needs a name.")
        return {"name": text.strip()}
    if column is Column.NOMINAL:
        return {"nominal": _number(text)}
    from measureapp.data.tolerance_text import parse_tolerance

    found = parse_tolerance(text, kind=row.kind, nominal=row.nominal, is_zone=row.is_zone)
    if found is None:
        raise ValueError("Enter a tolerance, such as ±0.1, +0.1/-0.05, H7 or 2768-m.")
    limits: dict[str, Value | None] = {"upper_tolerance": round(found.upper, 6)}
    return limits if row.is_zone else {"lower_tolerance": round(found.lower, 6), **limits}


def apply_edit(programming: ProgrammingController, rows: Sequence[DimensionRow], edit: CellEdit) -> bool:
    """Edit the program by what was typed into a cell, for all its rows in one step; return whether it was done."""
    from measureapp.project.program_edit import change_entry

    chosen = [row for row in rows if row.id in edit.ids and not (edit.column is Column.NOMINAL and row.is_zone)]
    try:
        changes = [(row.name, values_of(row, edit.column, edit.text)) for row in chosen]
    except ValueError as error:
        programming.refuse(f"{edit.text!r} was not taken over.", str(error))
        return False

    def change(text: str) -> str:
        for name, values in changes:
            text = change_entry(text, name, values)
        return text

    what = {Column.NAME: "Name", Column.NOMINAL: "Nominal", Column.TOLERANCE: "Tolerance"}[edit.column]
    words = f"{what} of {chosen[0].name} changed." if len(chosen) == 1 else f"{what} of {len(chosen)} dimensions changed."
    return programming.edit(change, words)


def free_name(name: str, taken: Sequence[str]) -> str:
    """Return a name for a copy that is not taken.

    >>> free_name("bore", ["bore", "bore 2"]), free_name("bore 2", ["bore 2"])
    ('bore 3', 'bore 3')
    """
    stem, number = re.fullmatch(r"(.*?)(?: (\d+))?", name).groups()  # type: ignore[union-attr]
    count = int(number or 1) + 1
    while f"{stem} {count}" in taken:
        count += 1
    return f"{stem} {count}"


def _number(text: str) -> float:
    words = text.strip().replace("\u2212", "-").removesuffix("mm").removesuffix("°").strip()
    if not re.fullmatch(r"[+-]?\d+(?:[.,]\d+)?", words):
        raise ValueError(NOT_A_NUMBER)
    return float(words.replace(",", "."))
