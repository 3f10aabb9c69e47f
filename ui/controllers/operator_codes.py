"""Bar codes: what a scanner typed, and what it means for the part programs. An unknown code is never guessed."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgramFacts

AIM_PREFIX = re.compile(r"^\][A-Za-z][0-9A-Za-z]")  # symbology identifier of ISO/IEC 15424, "]d2": GS1 DataMatrix
GROUP_SEPARATOR = "\x1d"


@dataclass(frozen=True)
class CodeFields:
    """What a code states; empty where it states nothing."""

    part: str = ""
    serial: str = ""
    order: str = ""


@dataclass(frozen=True)
class CodeMeaning:
    """How a code was understood: by one program, by none, by several, or as the code of another part."""

    kind: Literal["known", "unknown", "ambiguous", "wrong part"]
    fields: CodeFields = CodeFields()
    program: int = -1  # its place among the programs
    names: tuple[str, ...] = ()  # of the programs that could be meant


def clean_code(text: str) -> str:
    r"""Return a scanned text without the scanner's prefix and line ends; group separators stay.

    >>> clean_code("]d2GC-180\x1dA7\r\n") == "GC-180\x1dA7"
    True
    """
    return AIM_PREFIX.sub("", text.strip("\r\n\t ").lstrip(GROUP_SEPARATOR)).strip(GROUP_SEPARATOR)


def read_code(text: str, facts: PartProgramFacts) -> CodeFields | None:
    """Return the fields of a code by the pattern of one program; None where the whole code does not match.

    A pattern may name separators as they are sent (GS, 0x1D) or as "|", which stands for one in codes without "|" of their own.
    A program without a pattern knows its own part number only.
    """
    code = clean_code(text)
    if not facts.code_pattern:
        return CodeFields(part=code) if code and code == facts.part_number else None
    forms = (code, code.replace(GROUP_SEPARATOR, "|"))
    found = next((match for form in forms if (match := re.fullmatch(facts.code_pattern, form))), None)
    if found is None:
        return None
    named = {name: value for name, value in found.groupdict().items() if value is not None}
    return CodeFields(**named)


def find_program(text: str, programs: Sequence[PartProgramFacts | None]) -> CodeMeaning:
    """Return which program a code belongs to; None stands for a file that cannot be read."""
    found = [(place, fields) for place, facts in enumerate(programs) if facts is not None and (fields := _own(text, facts)) is not None]
    if len(found) == 1:
        return CodeMeaning("known", found[0][1], found[0][0])
    names = tuple(facts.name for place, _ in found if (facts := programs[place]) is not None)
    return CodeMeaning("ambiguous" if found else "unknown", names=names)


def check_code(text: str, chosen: PartProgramFacts, programs: Sequence[PartProgramFacts | None]) -> CodeMeaning:
    """Return what a code means while a program is chosen: its own part, the part of another one, or nothing known.

    Where the chosen program has no pattern, a code that belongs to no program is the serial number, which the operator sees and confirms.
    """
    fields = read_code(text, chosen)
    if fields is not None and fields.part in ("", chosen.part_number):
        return CodeMeaning("known", fields)
    others = find_program(text, [None if facts is chosen else facts for facts in programs])
    if fields is not None or others.kind in ("known", "ambiguous"):
        return CodeMeaning("wrong part", fields if fields is not None else others.fields)
    if not chosen.code_pattern and clean_code(text):
        return CodeMeaning("known", CodeFields(serial=clean_code(text).replace(GROUP_SEPARATOR, " ")))
    return CodeMeaning("unknown")


def _own(text: str, facts: PartProgramFacts) -> CodeFields | None:
    fields = read_code(text, facts)
    return fields if fields is not None and fields.part in ("", facts.part_number) else None
