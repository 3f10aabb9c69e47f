"""What is typed into the table of dimensions, as edits of the inspection program."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from measureapp.errors import InputError
from ui.controllers.program_rows import DimensionRow
from ui.look.language.words import tr
from ui.look.wording import dimension_words, sentence
from ui.pages.inspection.dimension_model import CellEdit, Column

if TYPE_CHECKING:
    from measureapp.data.inspection_program import InspectionProgram
    from ui.controllers.programming import ProgrammingController

    Change = Callable[[InspectionProgram], InspectionProgram]

NEVER_NEGATIVE = ("diameter", "radius", "cone_angle", "slot_width", "slot_length", "thickness")
NEGATIVE = "A size cannot be negative."
NOT_A_NUMBER = "Enter a number, such as 24.5."


def problem_of(row: DimensionRow, column: Column, text: str) -> str:
    """Return why a text cannot be used in a cell; empty: it can."""
    try:
        change_of(row, column, text)
    except ValueError as error:
        return str(error)
    return ""


def change_of(row: DimensionRow, column: Column, text: str) -> Change:
    """Return the edit that a text in a cell means. Raises ValueError with the reason if it cannot be used."""
    from measureapp.inspection.programming import edits
    from measureapp.inspection.session.graph import Node

    if column is Column.NAME:
        if not text.strip():
            raise ValueError("A dimension needs a name.")
        return lambda program: edits.rename(program, Node("dimension", row.name), text)
    if column is Column.NOMINAL:
        value = _number(text)
        if value < 0 and row.kind in NEVER_NEGATIVE:
            raise ValueError(NEGATIVE)
        return lambda program: edits.set_nominal(program, row.name, value)
    from measureapp.data.tolerance_text import parse_tolerance

    parse_tolerance(text, kind=row.kind, nominal=row.nominal, is_zone=row.is_zone)
    return lambda program: edits.set_tolerance(program, row.name, text)


def apply_edit(programming: ProgrammingController, rows: Sequence[DimensionRow], edit: CellEdit) -> bool:
    """Edit the program by what was typed into a cell, for all its rows in one step; return whether it was done."""
    chosen = [row for row in rows if row.id in edit.ids and not (edit.column is Column.NOMINAL and row.is_zone)]
    if not chosen:
        return False

    def change(program: InspectionProgram) -> InspectionProgram:
        try:
            changes = [change_of(row, edit.column, edit.text) for row in chosen]
        except ValueError as error:
            raise InputError("The entry was not taken over.", sentence(str(error))) from error
        return one_after_the_other(changes)(program)

    what = {Column.NAME: "Name", Column.NOMINAL: "Nominal", Column.TOLERANCE: "Tolerance"}[edit.column]
    words = (
        tr("{what} of {name} changed.", what=what, name=dimension_words(chosen[0].name))
        if len(chosen) == 1
        else tr("{what} of {count} dimensions changed.", what=what, count=len(chosen))
    )
    return programming.edit(change, words)


def one_after_the_other(changes: Sequence[Change]) -> Change:
    """Return one edit that makes several."""

    def change(program: InspectionProgram) -> InspectionProgram:
        for one in changes:
            program = one(program)
        return program

    return change


def _number(text: str) -> float:
    words = text.strip().replace("\u2212", "-").removesuffix("mm").removesuffix("°").strip()
    if not re.fullmatch(r"[+-]?\d+(?:[.,]\d+)?", words):
        raise ValueError(NOT_A_NUMBER)
    return float(words.replace(",", "."))
