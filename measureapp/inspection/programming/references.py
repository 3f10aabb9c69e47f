"""References between the entries of a program: renaming, and documents that can be validated again."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pydantic import ValidationError

from measureapp.data.datum_letters import is_datum_letter, letters_of
from measureapp.data.dimension_program import LIMITS
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.model import first_problem
from measureapp.errors import InputError

Document = dict[str, Any]
LISTS = {"feature": "features", "dimension": "dimensions", "alignment": "alignments"}
ONE_NAME, NAMES = ("plane", "line", "point"), ("of", "features", "datums")


def document_of(program: InspectionProgram) -> Document:
    """Return the stated values of a program, and the letters of its datums, which edits must not shift.

    Limits that follow from the text of a tolerance are not among them.
    """
    document = program.model_dump(exclude_unset=True)
    document["datum_letters"] = _by_letter(letters_of(program))
    for name in LISTS.values():
        document[name] = [dict(one) for one in document.get(name, ())]
    for dimension in document["dimensions"]:
        if dimension.get("tolerance") is not None:
            for limit in LIMITS:
                dimension.pop(limit, None)
    return document


def program_from(document: Document) -> InspectionProgram:
    """Validate a changed document; raises InputError with the reason why the change cannot be made.

    The program states the letter of each datum, so that it keeps it from now on.
    """
    stated = {name: value for name, value in document.items() if name != "datum_letters" or value}
    try:
        program = InspectionProgram.model_validate(stated)
    except ValidationError as error:
        raise InputError(
            f"The change is not possible: {first_problem(error, 'the program')}.", "Change the entry it names first."
        ) from error
    letters = _by_letter(letters_of(program))
    return program if letters == dict(program.datum_letters) else program.model_copy(update={"datum_letters": letters})


def _by_letter(letters: Mapping[str, str]) -> dict[str, str]:
    """Return the letters as a program states them; those of common datums follow from their features'."""
    single = {feature: letter for feature, letter in letters.items() if is_datum_letter(letter)}
    return {letter: feature for feature, letter in sorted(single.items(), key=lambda one: (len(one[1]), one[1]))}


def rename_references(document: Document, rename: Callable[[str], str]) -> None:
    """Replace the names of features in all entries that refer to them."""
    for entry in (*document["features"], *document["dimensions"]):
        _rename_in(entry, rename)
        entry_materials = entry.get("datum_material")
        if entry_materials is not None:
            entry["datum_material"] = [{**one, "datum": rename(one["datum"])} for one in entry_materials]
    document["datum_letters"] = {letter: rename(one) for letter, one in document["datum_letters"].items()}
    if "alignment" in document:
        document["alignment"] = _renamed_alignment(document["alignment"], rename)
    for one in document["alignments"]:
        one["alignment"] = _renamed_alignment(one["alignment"], rename)


def _rename_in(entry: Document, rename: Callable[[str], str]) -> None:
    for name in NAMES:
        if entry.get(name):
            entry[name] = [rename(one) for one in entry[name]]


def _renamed_alignment(alignment: Document, rename: Callable[[str], str]) -> Document:
    changed = dict(alignment)
    _rename_in(changed, rename)
    for name in ONE_NAME:
        if name in changed:
            changed[name] = rename(changed[name])
    if "points" in changed:
        changed["points"] = [{**one, "feature": rename(one["feature"])} for one in changed["points"]]
    return changed
