"""STL and OBJ, read so that a damaged file is refused in words, and STL written."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import InputError

STL_RECORD = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
STL_HEADER_BYTES = 84
DAMAGED = "Export or copy the file again."


def read_stl(path: Path) -> tuple[FloatArray, IntArray]:
    """Return vertices (V, 3), equal corners joined, and triangles (T, 3) of a binary or ascii STL; raises InputError."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little") if len(data) >= STL_HEADER_BYTES else -1
    wanted = STL_HEADER_BYTES + count * STL_RECORD.itemsize
    if count >= 0 and len(data) == wanted:
        return join_corners(np.frombuffer(data, STL_RECORD, count, STL_HEADER_BYTES)["corners"].reshape(-1, 3))
    if data.lstrip()[:5].lower() == b"solid" and b"facet" in data[:4096]:
        return join_corners(_ascii_corners(path, data))
    if count >= 0 and len(data) > wanted and count > 0:  # some programs append their own data
        return join_corners(np.frombuffer(data, STL_RECORD, count, STL_HEADER_BYTES)["corners"].reshape(-1, 3))
    if count > 0:
        held = (len(data) - STL_HEADER_BYTES) // STL_RECORD.itemsize
        raise InputError(f"{path} is cut short: it declares {count} triangles and holds {held}.", DAMAGED)
    raise InputError(f"{path} is not an STL file.", DAMAGED)


def _ascii_corners(path: Path, data: bytes) -> FloatArray:
    if b"endsolid" not in data[-1024:].lower():
        raise InputError(f"{path} is cut short: its last line is missing.", DAMAGED)
    words = data.lower().split(b"vertex")[1:]
    try:
        corners = np.array([word.split(maxsplit=3)[:3] for word in words], dtype="S32").astype(np.float64)
    except ValueError as error:
        raise InputError(f"{path} has a vertex that is not three numbers.", DAMAGED) from error
    if corners.ndim != 2 or corners.shape[1] != 3 or len(corners) % 3:
        raise InputError(f"{path} has a triangle that does not have three corners.", DAMAGED)
    return corners


def join_corners(corners_mm: FloatArray) -> tuple[FloatArray, IntArray]:
    """Join equal corners (3T, 3) to vertices; triangles that collapse to a line by it are left out."""
    order = np.lexsort(corners_mm.T[::-1])  # as np.unique of rows would, in a tenth of its time
    rows = corners_mm[order]
    first = np.ones(len(rows), np.bool_)
    first[1:] = np.any(rows[1:] != rows[:-1], axis=1)
    index = np.empty(len(rows), np.int32)
    index[order] = np.cumsum(first) - 1
    vertices, triangles = rows[first].astype(np.float64), index.reshape(-1, 3)
    a, b, c = triangles.T
    return vertices, triangles[(a != b) & (b != c) & (c != a)]


def read_obj(path: Path) -> tuple[FloatArray, IntArray, FloatArray | None]:
    """Return vertices, triangles (polygons are fanned) and, if there is one per vertex, normals of an OBJ; raises InputError."""
    vertices: list[list[float]] = []
    normals: list[list[float]] = []
    triangles: list[tuple[int, int, int]] = []
    for number, line in enumerate(path.read_bytes().decode("latin-1").splitlines(), 1):
        words = line.split()
        try:
            if not words:
                continue
            if words[0] == "v":
                vertices.append([float(words[1]), float(words[2]), float(words[3])])
            elif words[0] == "vn":
                normals.append([float(words[1]), float(words[2]), float(words[3])])
            elif words[0] == "f":
                corners = [_obj_index(word, len(vertices)) for word in words[1:]]
                triangles += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
        except (ValueError, IndexError) as error:
            raise InputError(f"{path}, line {number}: {line.strip()[:60]!r} cannot be understood.", DAMAGED) from error
    if not vertices:
        raise InputError(f"{path} has no vertices.", "Export the part again as OBJ with a mesh in it.")
    per_vertex = np.array(normals) if len(normals) == len(vertices) else None
    return np.array(vertices), np.array(triangles, np.int64).reshape(-1, 3), per_vertex


def _obj_index(word: str, vertices: int) -> int:
    index = int(word.split("/", 1)[0])
    if abs(index) > np.iinfo(np.int32).max:
        raise ValueError(f"there is no vertex {word}")
    return index - 1 if index > 0 else vertices + index


def write_stl(path: Path, vertices_mm: FloatArray, triangles: IntArray) -> None:
    """Write a binary STL."""
    from trimesh import Trimesh
    from trimesh.exchange.stl import export_stl

    data = export_stl(Trimesh(vertices_mm, triangles, process=False))
    path.write_bytes(b"MeasureApp, millimetres".ljust(80) + data[80:])
