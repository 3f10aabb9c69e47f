"""Reading and writing PLY so that a damaged file is refused in words: nothing is allocated that the file does not hold."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import InputError

HEADER_LIMIT_BYTES = 65536
MOST_DIGITS = 18  # of a count; Python refuses to read thousands of them
BYTE_ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}
TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip
NAMES = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint", "f4": "float", "f8": "double"}
DAMAGED = "Export or copy the file again."


@dataclass(frozen=True, slots=True, eq=False)
class Ragged:
    """A list property: row i holds `counts[i]` of the concatenated `values`."""

    counts: IntArray
    values: FloatArray | IntArray


@dataclass(frozen=True, slots=True)
class Property:
    """One property of an element; `count_type` is set for a list."""

    name: str
    type: str
    count_type: str | None = None


@dataclass(frozen=True, slots=True)
class Element:
    """One element of the header."""

    name: str
    count: int
    properties: tuple[Property, ...]

    @property
    def has_lists(self) -> bool:
        """Whether rows differ in length."""
        return any(prop.count_type for prop in self.properties)

    @property
    def least_bytes(self) -> int:
        """The fewest bytes one binary row takes."""
        return sum(np.dtype(prop.count_type or prop.type).itemsize for prop in self.properties)

    def of_doubles(self) -> Element:
        """Return the element with every number, lengths of lists among them, as float64."""
        return replace(self, properties=tuple(Property(prop.name, "f8", prop.count_type and "f8") for prop in self.properties))


@dataclass(frozen=True, slots=True, eq=False)
class Ply:
    """The contents of a PLY file: element -> property -> array or list."""

    comments: tuple[str, ...]
    elements: Mapping[str, Mapping[str, Any]]

    def column(self, element: str, name: str) -> FloatArray | IntArray | None:
        """Return a scalar property; None where the file has none of that name."""
        found = self.elements.get(element, {}).get(name)
        return found if isinstance(found, np.ndarray) else None


def read_ply(path: Path) -> Ply:
    """Read every element of a PLY file (ascii, binary of both byte orders).

    Raises
    ------
    InputError
        Not a PLY file, cut short, or its header declares more than the file holds.
    """
    data = path.read_bytes()
    order, comments, elements, start = _header(path, data)
    body = memoryview(data)[start:]
    if order == "=":
        body, elements = _as_doubles(path, body), [element.of_doubles() for element in elements]
    read = _Body(path, body, order)
    return Ply(comments, {element.name: read.element(element) for element in elements})


def write_ply(path: Path, comments: Sequence[str], elements: Mapping[str, Mapping[str, Any]]) -> None:
    """Write scalar columns, and (N, k) arrays as lists, as binary little endian PLY."""
    header = ["ply", "format binary_little_endian 1.0", *(f"comment {comment}" for comment in comments)]
    tables = []
    for element, columns in elements.items():
        fields: list[Any] = []
        count = len(next(iter(columns.values())))
        header.append(f"element {element} {count}")
        for name, column in columns.items():
            kind = column.dtype.str[1:]
            if column.ndim == 2:
                fields += [(f"#{name}", "u1"), (name, f"<{kind}", (column.shape[1],))]
                header.append(f"property list uchar {NAMES[kind]} {name}")
            else:
                fields.append((name, f"<{kind}"))
                header.append(f"property {NAMES[kind]} {name}")
        table = np.empty(count, fields)
        for name, column in columns.items():
            table[name] = column
            if column.ndim == 2:
                table[f"#{name}"] = column.shape[1]
        tables.append(table)
    with path.open("wb") as file:
        file.write(("\n".join([*header, "end_header"]) + "\n").encode())
        for table in tables:
            table.tofile(file)


def _header(path: Path, data: bytes) -> tuple[str, tuple[str, ...], list[Element], int]:
    end = data.find(b"end_header", 0, HEADER_LIMIT_BYTES)
    if not data.startswith(b"ply") or end < 0:
        raise InputError(f"{path} is not a PLY file, or its header is damaged.", DAMAGED)
    start = data.find(b"\n", end) + 1
    if start == 0:
        raise InputError(f"{path} ends with its header.", DAMAGED)
    order, comments = "", []
    elements: list[Element] = []
    for line in data[:end].decode("latin-1").splitlines()[1:]:
        words = line.split()
        if not words or words[0] == "obj_info":
            continue
        if words[0] == "comment":
            comments.append(line.strip()[8:])
        elif words[0] == "format" and len(words) >= 2 and words[1] in BYTE_ORDERS:
            order = BYTE_ORDERS[words[1]]
        elif words[0] == "element" and len(words) == 3 and words[2].isdecimal() and len(words[2]) <= MOST_DIGITS:
            elements.append(Element(words[1], int(words[2]), ()))
        elif words[0] == "property" and elements and (prop := _property(words, elements[-1].properties)):
            last = elements[-1]
            elements[-1] = Element(last.name, last.count, (*last.properties, prop))
        else:
            raise InputError(f"{path} has a line in its header that cannot be understood: {line.strip()[:60]!r}.", DAMAGED)
    if not order:
        raise InputError(f"{path} does not say whether it is ascii or binary.", DAMAGED)
    return order, tuple(comments), elements, start


def _property(words: list[str], earlier: tuple[Property, ...]) -> Property | None:
    name = words[-1]
    while any(prop.name == name for prop in earlier):  # two of one name: the first counts
        name += "'"
    if len(words) == 3 and words[1] in TYPES:
        return Property(name, TYPES[words[1]])
    if len(words) == 5 and words[1] == "list" and TYPES.get(words[2], "f")[0] in "iu" and words[3] in TYPES:
        return Property(name, TYPES[words[3]], TYPES[words[2]])
    return None


def _as_doubles(path: Path, body: memoryview) -> memoryview:
    """Return the numbers of an ascii body, lengths of lists among them, as the bytes of float64."""
    try:
        return np.fromstring(bytes(body), sep=" ").data.cast("B")
    except (ValueError, DeprecationWarning) as error:
        raise InputError(f"{path} holds something that is not a number.", DAMAGED) from error


def _cut_short(path: Path, element: Element) -> InputError:
    return InputError(f"{path} is cut short: it declares {element.count} of element {element.name!r} and holds fewer.", DAMAGED)


def _gather(element: Element, rows: Mapping[str, list[Any]]) -> dict[str, Any]:
    """Turn the values collected row by row into arrays."""
    columns: dict[str, Any] = {}
    for prop in element.properties:
        values = rows[prop.name]
        if prop.count_type is None:
            columns[prop.name] = np.array(values)
        else:
            counts = np.array([len(value) for value in values], np.int64)
            columns[prop.name] = Ragged(counts, np.concatenate(values) if values else np.empty(0))
    return columns


class _Body:
    """Takes elements one after the other from binary data."""

    def __init__(self, path: Path, body: memoryview, order: str) -> None:
        self.path, self.body, self.order, self.at = path, body, order, 0

    def element(self, element: Element) -> dict[str, Any]:
        if element.least_bytes == 0:
            return {}
        if element.count * element.least_bytes > len(self.body) - self.at:
            raise _cut_short(self.path, element)
        if element.count == 0:
            return _gather(element, {prop.name: [] for prop in element.properties})
        return self._uniform(element) or self._row_by_row(element)

    def _uniform(self, element: Element) -> dict[str, Any] | None:
        """Read the element as one table, if all its lists are as long as in the first row."""
        fields: list[Any] = []
        at = self.at
        for prop in element.properties:
            length, at = self._length(element, prop, at)
            if prop.count_type:
                fields.append((f"#{prop.name}", self.order + prop.count_type))
            fields.append((prop.name, self.order + prop.type, (length,)) if prop.count_type else (prop.name, self.order + prop.type))
            at += length * np.dtype(prop.type).itemsize
        table_type = np.dtype(fields)
        if element.count * table_type.itemsize > len(self.body) - self.at:
            if not element.has_lists:
                raise _cut_short(self.path, element)
            return None
        table = np.frombuffer(self.body, table_type, element.count, self.at)
        columns: dict[str, Any] = {}
        for prop in element.properties:
            column = table[prop.name].astype(prop.type)
            if prop.count_type:
                counts = table[f"#{prop.name}"]
                if np.any(counts != counts[0]):
                    return None
                columns[prop.name] = Ragged(counts.astype(np.int64), column.ravel())
            else:
                columns[prop.name] = column
        self.at += element.count * table_type.itemsize
        return columns

    def _length(self, element: Element, prop: Property, at: int) -> tuple[int, int]:
        """Return how many values a property has in the row at ``at`` and where they begin."""
        if prop.count_type is None:
            return 1, at
        kind = np.dtype(self.order + prop.count_type)
        if at + kind.itemsize > len(self.body):
            raise _cut_short(self.path, element)
        length = np.frombuffer(self.body, kind, 1, at)[0]
        most = (len(self.body) - at - kind.itemsize) // np.dtype(prop.type).itemsize
        if not 0 <= length <= most or length != int(length):  # also what is no number, or none that is whole, in ascii
            raise _cut_short(self.path, element)
        return int(length), at + kind.itemsize

    def _row_by_row(self, element: Element) -> dict[str, Any]:
        rows: dict[str, list[Any]] = {prop.name: [] for prop in element.properties}
        for _ in range(element.count):
            for prop in element.properties:
                length, self.at = self._length(element, prop, self.at)
                kind = np.dtype(self.order + prop.type)
                if self.at + length * kind.itemsize > len(self.body):
                    raise _cut_short(self.path, element)
                values = np.frombuffer(self.body, kind, length, self.at)
                rows[prop.name].append(values if prop.count_type else values[0])
                self.at += length * kind.itemsize
        return _gather(element, rows)
