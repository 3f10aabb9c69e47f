"""Sample parts by name, other parts by file; run as a program, writes the nominal STL files of the sample parts."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError
from measureapp.simulate.part import Part
from measureapp.simulate.part_blocks import flat, gypsum
from measureapp.simulate.part_file import part_from_file
from measureapp.simulate.part_gear import gear
from measureapp.simulate.part_impeller import impeller
from measureapp.simulate.part_sphere_plate import sphere_plate

SAMPLES: dict[str, Callable[[], Part]] = {
    "impeller": impeller,
    "gypsum": gypsum,
    "gear": gear,
    "sphere_plate": sphere_plate,
    "flat": flat,
}
STL_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def make_part(name_or_path: str, unit: LengthUnit = LengthUnit.MM) -> Part:
    """Make a sample part by name, or read a part from an STL, PLY or OBJ file with lengths in ``unit``.

    Raises
    ------
    InputError
        Neither a sample part nor a readable mesh file.
    """
    if name_or_path in SAMPLES:
        return SAMPLES[name_or_path]()
    path = Path(name_or_path)
    if not path.suffix:
        raise InputError(f"There is no sample part {name_or_path!r}.", f"Name one of {', '.join(SAMPLES)}, or a mesh file (STL, PLY, OBJ).")
    return part_from_file(path, unit)


def stl_bytes(part: Part) -> bytes:
    """Return the part's mesh as a binary STL file, the same for every call."""
    corners = part.mesh.vertices_mm[part.mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    records = np.zeros(len(corners), STL_RECORD)
    records["normal"] = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    records["corners"] = corners
    header = f"measureapp nominal of {part.name}, mm".encode("ascii").ljust(80)
    return header + np.uint32(len(records)).tobytes() + records.tobytes()


def write_nominals(folder: Path) -> None:
    """Write `NAME/nominal.stl` of every sample part below ``folder``."""
    for name, make in SAMPLES.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        (folder / name / "nominal.stl").write_bytes(stl_bytes(make()))


if __name__ == "__main__":
    write_nominals(Path(sys.argv[1] if len(sys.argv) > 1 else "resources/parts"))
