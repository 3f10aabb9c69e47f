"""Text of an inspection program after edits: entries that did not change keep their lines, comments and layout."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from measureapp.data.dimension_program import LIMITS
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.model import Model
from measureapp.project.program_file import parse_program
from measureapp.project.program_text import format_entry, format_value

BLOCK = re.compile(r"^(?=\[\[(?:features|dimensions|alignments)\]\]|\[(?:alignment|deviation_scale|datum_letters)[\].])", re.MULTILINE)
KIND = re.compile(r"^\[+(features|dimensions|alignments|alignment|deviation_scale|datum_letters)[\].]", re.MULTILINE)
KINDS = ("alignments", "features", "dimensions")
TABLES = ("alignment", "deviation_scale", "datum_letters")  # of the program itself, inline or with a header of their own
TOP = ("name", "nominal", "nominal_unit", *TABLES)
COMMENT = re.compile(r"(?:^[ \t]*#[^\n]*\n)+\Z", re.MULTILINE)  # comment lines right above a header
Values = dict[str, Any]


@dataclass(frozen=True, slots=True)
class _Block:
    kind: str  # one of `KINDS` or `TABLES`, or "" for the head
    text: str


def rewrite_program(text: str, program: InspectionProgram) -> str:
    """Return the text of a program changed so that it describes ``program``.

    Unchanged entries keep their text, changed ones their comments where a value stands on its own line; entries follow the order of
    ``program``. If that is not possible, the whole program is written anew.

    Raises
    ------
    InputError
        The former text is not a program.
    """
    former = parse_program(text)
    blocks = list(_split(text))
    changed = _assemble(blocks, former, program)
    return changed if parse_program(changed) == program else format_program(program)


def format_program(program: InspectionProgram) -> str:
    """Return a program as TOML."""
    values = program.model_dump(exclude_unset=True)
    head = [f"{name} = {format_value(value)}" for name, value in values.items() if name not in KINDS and value is not None]
    entries = [_format(kind, one) for kind in KINDS for one in getattr(program, kind)]
    return "\n".join(["\n".join(head) + "\n", *entries])


def _split(text: str) -> Iterator[_Block]:
    """Split a text at the headers of entries; comments right above a header belong to it."""
    carried = ""
    parts = BLOCK.split(text)
    for number, part in enumerate(parts):
        whole, carried = carried + part, ""
        if number + 1 < len(parts) and (match := COMMENT.search(whole)) and match.start() > 0:
            whole, carried = whole[: match.start()], match.group()
        kind = KIND.search(whole)
        yield _Block(kind[1] if kind and number else "", whole)


def _assemble(blocks: Sequence[_Block], former: InspectionProgram, program: InspectionProgram) -> str:
    queues = {kind: _texts(kind, blocks, former, program) for kind in KINDS}
    lasts = {kind: max((number for number, one in enumerate(blocks) if one.kind == kind), default=len(blocks) - 1) for kind in KINDS}
    headed = {one.kind for one in blocks if one.kind in TABLES}
    pieces: list[str] = []
    for number, block in enumerate(blocks):
        if block.kind in queues:
            pieces += queues[block.kind][:1]
            del queues[block.kind][:1]
        else:
            pieces.append(_top_values(block, former, program, headed))
        for kind in KINDS:
            if lasts[kind] == number:
                pieces += queues[kind]
                queues[kind] = []
    return _joined(pieces)


def _joined(pieces: Sequence[str]) -> str:
    """Join pieces with one empty line between an entry and the next."""
    text = ""
    for piece in pieces:
        if text and not text.endswith("\n\n"):
            text = text.rstrip("\n") + "\n\n"
        text += piece
    return text.rstrip("\n") + "\n"


def _texts(kind: str, blocks: Sequence[_Block], former: InspectionProgram, program: InspectionProgram) -> list[str]:
    """Return the text of each new entry of one kind."""
    old, new = getattr(former, kind), getattr(program, kind)
    texts = [one.text for one in blocks if one.kind == kind]
    if len(texts) != len(old):  # written as one inline list: all entries are formatted
        texts, old = [], ()
    origin = _match(old, new)
    return [_format(kind, one) if number is None else _edit(kind, texts[number], old[number], one) for one, number in origin]


def _match(old: Sequence[Any], new: Sequence[Any]) -> list[tuple[Any, int | None]]:
    """Return each new entry with the index of the old one it comes from: equal, of the same name, or, as the only ones left, renamed."""
    free = dict(enumerate(old))
    found: dict[int, int] = {}
    for whole in (True, False):
        for number, one in enumerate(new):
            matches = (at for at, other in free.items() if (one == other if whole else one.name == other.name))
            if number not in found and (match := next(matches, None)) is not None:
                found[number] = match
                del free[match]
    left = [number for number in range(len(new)) if number not in found]
    if len(left) == len(free):
        found |= dict(zip(left, free, strict=True))
    return [(one, found.get(number)) for number, one in enumerate(new)]


def _edit(kind: str, text: str, old: Model, new: Model) -> str:
    """Change the values of an entry line by line; where that is not possible, format it under its comments."""
    if old == new:
        return text
    before, after = _values(old), _values(new)
    changed = text
    for name in dict.fromkeys((*before, *after)):
        if before.get(name) != after.get(name):
            changed = _set_line(changed, name, after.get(name))
    try:
        read = tomllib.loads(changed)[kind]
    except (tomllib.TOMLDecodeError, KeyError):
        read = []
    if len(read) == 1 and _is_same(type(new), read[0], new):
        return changed
    comments = "".join(line + "\n" for line in text.splitlines() if line.lstrip().startswith("#"))
    return comments + _format(kind, new)


def _is_same(model: type[Model], values: Values, new: Model) -> bool:
    try:
        return model.model_validate(values) == new
    except ValueError:
        return False


def _set_line(text: str, name: str, value: Any) -> str:
    """Set, add or (None) remove the value of a key that stands on a line of its own; a comment behind it stays."""
    line = re.compile(rf"^{re.escape(name)}[ \t]*=[^\n]*\n?", re.MULTILINE)
    match = line.search(text)
    if value is None:
        return text if match is None else text[: match.start()] + text[match.end() :]
    written = f"{name} = {format_value(value)}"
    if match is None:
        body = text.rstrip("\n")
        return f"{body}\n{written}{text[len(body) :] or chr(10)}"
    comment = re.search(r"\s+#[^\"'\n]*$", match.group().rstrip("\n"))
    end = "\n" if match.group().endswith("\n") else ""
    return text[: match.start()] + written + (comment.group() if comment else "") + end + text[match.end() :]


def _top_values(block: _Block, former: InspectionProgram, program: InspectionProgram, headed: Collection[str]) -> str:
    """Return the head, or a table of the program itself, with changed values; ``headed``: the tables with a header of their own."""
    before, after = _values(former), _values(program)
    text = block.text
    if block.kind in TABLES:
        same = before.get(block.kind) == after.get(block.kind)
        return text if same else _format_table(block.kind, after.get(block.kind, {}), text)
    for name in TOP:
        if before.get(name) != after.get(name) and name not in headed:
            text = _set_line(text, name, after.get(name))
    return text


def _format_table(name: str, values: Values, text: str) -> str:
    comments = "".join(line + "\n" for line in text.splitlines() if line.lstrip().startswith("#"))
    return comments + "\n".join(
        [f"[{name}]", *(f"{key} = {format_value(value)}" for key, value in values.items() if value is not None), ""]
    )


def _values(entry: Model) -> Values:
    """Return the stated values of an entry, without limits that follow from the text of a tolerance."""
    values = {name: value for name, value in entry.model_dump(exclude_unset=True).items() if value is not None}
    if "tolerance" in values:
        for limit in LIMITS:
            values.pop(limit, None)
    return values


def _format(kind: str, entry: Model) -> str:
    return format_entry(kind, _values(entry)) + "\n"
