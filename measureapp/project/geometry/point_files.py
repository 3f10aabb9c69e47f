"""Points in PCD and plain text, read so that a damaged file is refused in words."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import InputError

PCD_TYPES = {("F", 4): "f4", ("F", 8): "f8"} | {(kind.upper(), size): f"{kind}{size}" for kind in "iu" for size in (1, 2, 4, 8)}
PCD_HEADER_BYTES = 16384
DAMAGED = "Export or copy the file again."
SEPARATORS = re.compile(r"[;\s]+")
NUMBER = re.compile(r"[+-]?(\d+\.?|\d*[.,]\d+)([eE][+-]?\d+)?")


def read_table(path: Path, least_columns: int = 3) -> FloatArray:
    """Return the numbers of a text file, one point a line, white space, commas or semicolons between them.

    Commas within numbers that something else separates are decimal points, as spreadsheets write in many countries.

    Lines without numbers at the top (column names) and lines that begin with ``#`` or ``//`` are passed over.

    Raises
    ------
    InputError
        No points, a line with other than the first line's number of values, or something that is not a number.
    """
    text = path.read_bytes().decode("latin-1")
    lines = text.replace(",", "." if _has_decimal_commas(text) else " ").replace(";", " ").splitlines()
    kept = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith(("#", "//"))]
    if kept and not _is_numbers(kept[0][1]):
        kept = kept[1:]
    if not kept:
        raise InputError(f"{path} holds no points.", "Give a file with one point (x y z) a line.")
    width = len(kept[0][1].split())
    if width < least_columns:
        raise InputError(
            f"{path}, line {kept[0][0]}: {width} values where a point needs {least_columns}.", "Give x, y and z on every line."
        )
    try:
        return np.loadtxt([line for _, line in kept], comments=None, ndmin=2)
    except ValueError:
        raise _misfit(path, kept, width) from None


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
