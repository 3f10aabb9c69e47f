"""Sample parts by name, other parts by file; run as a program, writes the nominal STL files of the sample parts."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

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


def make_part(name_or_path: str, unit: LengthUnit = LengthUnit.MM) -> Part:
    """Make a sample part by name, or read a part from an STL, PLY or OBJ file with lengths in ``unit``.

    Raises
    ------
    InputError
        Neither a sample part nor a readable mesh file.
    """
    if name_or_path in SAMPLES:
        return _sample(name_or_path)
    path = Path(name_or_path)
    if not path.suffix:
        raise InputError(f"There is no sample part {name_or_path!r}.", f"Name one of {', '.join(SAMPLES)}, or a mesh file (STL, PLY, OBJ).")
    return part_from_file(path, unit)


@cache
def _sample(name: str) -> Part:
    """Return a sample part, made once: triangles between thousands of chords take a second."""
    return SAMPLES[name]()


def stl_bytes(part: Part) -> bytes:
    """Return the part's mesh as a binary STL file, the same for every call."""
    from trimesh import Trimesh
    from trimesh.exchange.stl import export_stl

    data = export_stl(Trimesh(part.mesh.vertices_mm, part.mesh.triangles, process=False))
    return f"measureapp nominal of {part.name}, mm".encode("ascii").ljust(80) + data[80:]


def write_nominals(folder: Path) -> None:
    """Write `NAME/nominal.stl` of every sample part below ``folder``."""
    for name, make in SAMPLES.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        (folder / name / "nominal.stl").write_bytes(stl_bytes(make()))


if __name__ == "__main__":
    write_nominals(Path(sys.argv[1] if len(sys.argv) > 1 else "resources/parts"))
