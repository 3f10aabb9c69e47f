"""Parts from mesh files: STL, PLY or OBJ."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.length_unit import LengthUnit
from measureapp.data.mesh import Mesh
from measureapp.errors import InputError
from measureapp.simulate.part import MATT_WHITE, Part

KINDS = (".stl", ".ply", ".obj")
STL_HEADER_BYTES, STL_TRIANGLE_BYTES = 84, 50
PLY_HEADER_BYTES = 65536
SMALLEST_MM, LARGEST_MM = 1.0, 2000.0


def part_from_file(path: Path, unit: LengthUnit = LengthUnit.MM) -> Part:
    """Read a mesh with lengths in ``unit`` as a matt white part on the table, centred on the axis.

    Raises
    ------
    InputError
        The file is missing, of another type, damaged, truncated or empty, or its size is implausible.
    """
    vertices, triangles, closed = _read(path)
    vertices = vertices * unit.in_mm
    size = np.ptp(vertices, axis=0)
    if not SMALLEST_MM <= size.max() <= LARGEST_MM:
        raise InputError(
            f"{path}: the part would be {size.max():.3g} mm long.", f"Give its unit, or scale it to {SMALLEST_MM:g}…{LARGEST_MM:g} mm."
        )
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    standing = vertices - [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]
    mesh = Mesh(standing, triangles, "nominal")
    return Part(path.stem, mesh, (MATT_WHITE,), np.zeros(len(triangles), np.uint8), watertight=closed)


def mesh_span(path: Path) -> float:
    """Return the longest side of the bounding box of a mesh file, in its own unit; raises InputError as `part_from_file`."""
    return float(np.ptp(_read(path)[0], axis=0).max())


def _read(path: Path) -> tuple[FloatArray, IntArray, bool]:
    import trimesh

    again = "Export it again, or copy it again if the copy is incomplete."
    if path.suffix.lower() not in KINDS:
        raise InputError(f"{path} is not a supported mesh file.", "Give an STL, PLY or OBJ file, or the name of a sample part.")
    if not path.is_file():
        raise InputError(f"{path} does not exist.", "Give the path of an STL, PLY or OBJ file.")
    _refuse_truncated(path, again)
    try:
        loaded = trimesh.load(path, force="mesh")
    except Exception as error:  # a damaged file can fail anywhere in the reader
        raise InputError(f"{path} cannot be read as a mesh: {error}.", again) from error
    if not isinstance(loaded, trimesh.Trimesh) or len(loaded.faces) == 0:
        raise InputError(f"{path} contains no triangles.", again)
    loaded.merge_vertices()
    loaded.update_faces(loaded.nondegenerate_faces())
    vertices, triangles = np.asarray(loaded.vertices, float), np.asarray(loaded.faces)
    if len(triangles) == 0 or not np.isfinite(vertices).all():
        raise InputError(f"{path} contains no usable triangles.", again)
    closed = bool(loaded.is_watertight)
    if closed and loaded.volume < 0:
        triangles = triangles[:, [0, 2, 1]]
    used, index = np.unique(triangles, return_inverse=True)
    return vertices[used], index.reshape(-1, 3), closed


def _refuse_truncated(path: Path, again: str) -> None:
    """Compare the size stated in the header with the length of the file."""
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(PLY_HEADER_BYTES)
    if size == 0:
        raise InputError(f"{path} is empty.", again)
    kind = path.suffix.lower()
    if kind == ".stl" and not _is_text_stl(head):
        count = int.from_bytes(head[80:84], "little") if len(head) >= STL_HEADER_BYTES else 1
        needed = STL_HEADER_BYTES + count * STL_TRIANGLE_BYTES
        if size < needed:
            raise InputError(f"{path} is truncated: it has {size} of {needed} bytes.", again)
    elif kind == ".stl" and b"endsolid" not in path.read_bytes()[-1024:]:
        raise InputError(f"{path} is truncated: the closing line `endsolid` is missing.", again)
    elif kind == ".ply":
        _refuse_truncated_ply(path, head, size, again)


def _is_text_stl(head: bytes) -> bool:
    return head.lstrip().startswith(b"solid") and b"facet" in head[:4096]


def _refuse_truncated_ply(path: Path, head: bytes, size: int, again: str) -> None:
    end = head.find(b"end_header")
    if not head.startswith(b"ply") or end < 0:
        raise InputError(f"{path} has no complete PLY header.", again)
    header = head[:end].decode("ascii", "replace")
    counts = {name: int(count) for name, count in re.findall(r"element\s+(\w+)\s+(\d+)", header)}
    smallest = 12 * counts.get("vertex", 0) + 9 * counts.get("face", 0)  # three floats; a count byte and three short indices
    if "format ascii" in header:
        rows = path.read_bytes().count(b"\n", end) - 1
        if rows + 1 < sum(counts.values()):
            raise InputError(f"{path} is truncated: it has {rows} of {sum(counts.values())} rows.", again)
    elif size - end < smallest:
        raise InputError(f"{path} is truncated: it has {size} bytes, its header needs at least {end + smallest}.", again)
