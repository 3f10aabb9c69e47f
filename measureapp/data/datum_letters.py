"""Letters of datum features (ISO 5459): one letter names one feature of the drawing, in every frame that refers to it.

A common datum, which two features establish together, has the letters of both: A-B.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from string import ascii_uppercase
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.dimension_program import DimensionProgram
    from measureapp.data.inspection_program import InspectionProgram

AVOIDED = "IOQX"  # ISO 5459 advises against them; a drawing may have them, they are never given
GIVEN = tuple(letter for letter in ascii_uppercase if letter not in AVOIDED)


def is_datum_letter(word: str) -> bool:
    """Return whether a word can name a datum: a capital, or the same capital twice.

    >>> is_datum_letter("A"), is_datum_letter("AA"), is_datum_letter("AB"), is_datum_letter("a")
    (True, True, False, False)
    """
    return len(word) in (1, 2) and set(word) <= set(ascii_uppercase) and len(set(word)) == 1


def letters_of(program: InspectionProgram, further: Iterable[str] = ()) -> dict[str, str]:
    """Return the letter of each datum by its feature: those that the program states, then free ones in the order of first use.

    So a program of an earlier version, which states none, gets the same letters whenever it is read. ``further`` datums come after its own.

    >>> from measureapp.data.inspection_program import InspectionProgram
    >>> plane = {"shape": "plane", "point_mm": (0, 0, 0), "direction": (0, 0, 1)}
    >>> square = {"kind": "parallelism", "upper_tolerance": 0.1}
    >>> dimensions = [{**square, "name": "a", "features": ["p"], "datums": ["q"]}, {**square, "name": "b", "features": ["q"], "datums": ["r"]}]
    >>> document = {"name": "n", "features": [{**plane, "name": name} for name in "pqr"], "dimensions": dimensions}
    >>> letters_of(InspectionProgram.model_validate({**document, "datum_letters": {"A": "r"}}))
    {'r': 'A', 'q': 'B'}
    """
    letters = {feature: letter for letter, feature in program.datum_letters.items()}
    commons = features_of_commons(program)
    for used in (*_used(program), *further):
        for feature in commons.get(used, (used,)):
            if feature not in letters:
                letters[feature] = free_letter(letters.values())
    joined = {name: "-".join(letters[one] for one in of) for name, of in commons.items() if all(one in letters for one in of)}
    return letters | joined


def features_of_commons(program: InspectionProgram) -> dict[str, tuple[str, ...]]:
    """Return the features that establish each common datum of a program, by its name."""
    from measureapp.data.feature_program import ConstructedFeature, copy_names, parent_sets  # needs pydantic, which help does without

    found: dict[str, tuple[str, ...]] = {}
    for one in program.features:
        if isinstance(one, ConstructedFeature) and one.shape == "common_datum":
            for name, of in zip(copy_names(one.name, one.repeat), parent_sets(one), strict=True):
                found[name] = tuple(single for parent in of for single in found.get(parent, (parent,)))
    return found


def free_letter(taken: Iterable[str]) -> str:
    """Return the first letter that is not taken; after Z follow AA, BB and so on.

    >>> free_letter(["A", "C"]), free_letter(GIVEN)
    ('B', 'AA')
    """
    used = set(taken)
    return next(letter for times in (1, 2) for one in GIVEN if (letter := one * times) not in used)


def common_datums(entry: DimensionProgram) -> tuple[str, ...]:
    """Return the datums of a dimension in their order; none where the copies of a pattern have datums of their own."""
    return entry.datum_sets[0] if len(set(entry.datum_sets)) == 1 else ()


def relettered(dimension: Dimension, letters: Mapping[str, str]) -> Dimension:
    """Return a result with the letters that the program has now; those of a pattern, which has none, stay as they are."""
    if not dimension.datum_letters or not all(name in letters for name in dimension.datums):
        return dimension
    now = tuple(letters[name] for name in dimension.datums)
    if now == dimension.datum_letters:
        return dimension
    frame = dimension.frame
    if frame is not None:
        cells = zip(frame.datums, dimension.datum_letters, now, strict=True)
        frame = replace(frame, datums=tuple(letter + cell.removeprefix(former) for cell, former, letter in cells))
    return replace(dimension, datum_letters=now, frame=frame)


def _used(program: InspectionProgram) -> Iterator[str]:
    from measureapp.data.alignment_program import DatumAlignment  # needs pydantic, which help does without

    for alignment in (program.alignment, *(one.alignment for one in program.alignments)):
        if isinstance(alignment, DatumAlignment):
            yield from alignment.datums
    for entry in program.dimensions:
        yield from common_datums(entry)
