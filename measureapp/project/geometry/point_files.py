"""Points in PCD and plain text, read so that a damaged file is refused in words."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError

PCD_TYPES = {("F", 4): "f4", ("F", 8): "f8"} | {(kind.upper(), size): f"{kind}{size}" for kind in "iu" for size in (1, 2, 4, 8)}
PCD_HEADER_BYTES = 16384
DAMAGED = "Export or copy the file again."
COMMENTS = ("#", "//")
AXES = ("x", "y", "z")
NAMED = re.compile(r"([^\W_]+)(?:_([\wµ]+))?(?:\s*[\[(]\s*([^\])]*?)\s*[\])])?")  # name_unit or name [unit]
UNITS = {str(unit): unit for unit in LengthUnit} | {
    "in": LengthUnit.INCH,
    "inches": LengthUnit.INCH,
    "µm": LengthUnit.UM,
    "μm": LengthUnit.UM,
}
SEPARATORS = re.compile(r"[;\s]+")
NUMBER = re.compile(r"[+-]?(\d+\.?|\d*[.,]\d+)([eE][+-]?\d+)?")


@dataclass(frozen=True, slots=True, eq=False)
class TextPoints:
    """Points of a text file, in its unit of lengths."""

    points: FloatArray  # (N, 3)
    normals: FloatArray | None  # (N, 3)
    unit: LengthUnit | None  # as the names of the columns state it


def read_text_points(path: Path) -> TextPoints:
    """Read a text file, one point a line, white space, commas or semicolons between the numbers.

    Commas within numbers that something else separates are decimal points, as spreadsheets write in many countries. A line of names at
    the top, also one that begins with ``#`` or ``//``, says which columns are x, y and z (nx, ny and nz of normals), and their unit, as in
    ``x_mm`` or ``X [inch]``. Without such names the first three columns are the point, and of six the others its normal.

    Raises
    ------
    InputError
        No points, a line with other than the first line's number of values, something that is not a number, or an unknown unit.
    """
    text = path.read_bytes().decode("latin-1")
    lines = text.replace(",", "." if _has_decimal_commas(text) else " ").replace(";", " ").splitlines()
    kept = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith(COMMENTS)]
    if kept and not _is_numbers(kept[0][1]):
        kept = kept[1:]
    if not kept:
        raise InputError(f"{path} holds no points.", "Give a file with one point (x y z) a line.")
    width = len(kept[0][1].split())
    if width < 3:
        raise InputError(f"{path}, line {kept[0][0]}: {width} values where a point needs 3.", "Give x, y and z on every line.")
    try:
        table = np.loadtxt([line for _, line in kept], comments=None, ndmin=2)
    except ValueError:
        raise _misfit(path, kept, width) from None
    above = [line.lstrip(" #/\t") for line in text.splitlines()[: kept[0][0] - 1] if line.strip()]
    names = _column_names(above[-1]) if above else []
    return _by_name(path, table, names) if len(names) == width else TextPoints(table[:, :3], table[:, 3:6] if width == 6 else None, None)


def _column_names(line: str) -> list[tuple[str, str]]:
    r"""Return names and units of columns.

    >>> _column_names("id, x_mm, Y [inch]"), _column_names("X (mm)\tz")
    ([('id', ''), ('x', 'mm'), ('y', 'inch')], [('x', 'mm'), ('z', '')])
    """
    found = NAMED.findall(line.encode("latin-1").decode("utf-8", "replace").lower())
    return [
        (name, within or behind) if name in AXES else (name + (f"_{behind}" if behind else ""), within) for name, behind, within in found
    ]


def _by_name(path: Path, table: FloatArray, names: list[tuple[str, str]]) -> TextPoints:
    words = [name for name, _ in names]
    if not all(words.count(axis) == 1 for axis in AXES):
        return TextPoints(table[:, :3], table[:, 3:6] if len(words) == 6 else None, None)
    units = {unit for name, unit in names if name in AXES}
    unknown = sorted(units - UNITS.keys() - {""})
    if unknown or len(units) > 1:
        stated = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in names if name in AXES)
        raise InputError(
            f"{path} states units that are not one unit of length: {stated}.", "Name the columns x, y, z with mm, inch, m, cm or um."
        )
    normals = [f"n{axis}" for axis in AXES]
    return TextPoints(
        table[:, [words.index(axis) for axis in AXES]],
        table[:, [words.index(one) for one in normals]] if all(one in words for one in normals) else None,
        UNITS.get(units.pop()),
    )


def _has_decimal_commas(text: str) -> bool:
    """Return whether the first line of numbers with a comma has it within a number, and another separator between numbers."""
    for line in text.splitlines() if "," in text else ():
        words = [word for word in SEPARATORS.split(line.strip()) if word]
        if "," in line and all(NUMBER.fullmatch(part) for word in words for part in word.split(",") if part):
            return len(words) > 1 and all(NUMBER.fullmatch(word) for word in words)
    return False


def _misfit(path: Path, lines: list[tuple[int, str]], width: int) -> InputError:
    """Return what to say of the first line that is not a point of ``width`` numbers."""
    number, line = next((number, line) for number, line in lines if len(line.split()) != width or not _is_numbers(line))
    if len(line.split()) != width:
        return InputError(f"{path}, line {number}: {len(line.split())} values where line {lines[0][0]} has {width}.", DAMAGED)
    return InputError(f"{path}, line {number}: {line.strip()[:60]!r} is not a point.", DAMAGED)


def _is_numbers(line: str) -> bool:
    try:
        np.loadtxt([line], comments=None)
    except ValueError:
        return False
    return True


def read_pcd(path: Path) -> dict[str, FloatArray]:
    """Return the fields of a PCD file (ascii or binary) by name; raises InputError."""
    data = path.read_bytes()
    fields, start = _pcd_header(path, data)
    try:
        names = fields["FIELDS"]
        counts = [int(value) for value in fields.get("COUNT", ["1"] * len(names))]
        codes = [PCD_TYPES[kind, int(size)] for kind, size in zip(fields["TYPE"], fields["SIZE"], strict=True)]
        points = int(fields["POINTS"][0]) if "POINTS" in fields else int(fields["WIDTH"][0]) * int(fields["HEIGHT"][0])
        row = np.dtype([(f"{i}", f"<{code}", (count,)) for i, (code, count) in enumerate(zip(codes, counts, strict=True))])
        layout = fields["DATA"][0].lower()
    except (KeyError, IndexError, ValueError) as error:
        raise InputError(f"{path} has a header that cannot be understood ({error}).", DAMAGED) from error
    if layout == "binary":
        if points < 0 or points * row.itemsize > len(data) - start:
            raise InputError(f"{path} is cut short: it declares {points} points and holds fewer.", DAMAGED)
        table = np.frombuffer(data, row, points, start)
        return {name: table[f"{i}"][:, 0].astype(np.float64) for i, name in enumerate(names) if counts[i]}
    if layout == "ascii":
        return _pcd_ascii(path, data[start:], names, counts, points)
    raise InputError(f"{path} is stored as {layout!r}.", "Save it as ascii or (uncompressed) binary PCD, or as PLY.")


def _pcd_header(path: Path, data: bytes) -> tuple[dict[str, list[str]], int]:
    end = data.find(b"DATA ", 0, PCD_HEADER_BYTES)
    start = data.find(b"\n", end) + 1
    if end < 0 or start == 0:
        raise InputError(f"{path} is not a PCD file, or its header is damaged.", DAMAGED)
    lines = (line.split() for line in data[:start].decode("latin-1").splitlines())
    return {words[0]: words[1:] for words in lines if words and not words[0].startswith("#")}, start


def _pcd_ascii(path: Path, body: bytes, names: list[str], counts: list[int], points: int) -> dict[str, FloatArray]:
    try:
        numbers = np.array(body.split(), "S32").astype(np.float64)
    except ValueError as error:
        raise InputError(f"{path} holds something that is not a number.", DAMAGED) from error
    width = sum(counts)
    if points < 0 or width == 0 or points * width > len(numbers):
        raise InputError(f"{path} is cut short: it declares {points} points and holds fewer.", DAMAGED)
    table = numbers[: points * width].reshape(points, width)
    starts = np.cumsum([0, *counts[:-1]])
    return {name: table[:, start] for name, start in zip(names, starts, strict=True)}
