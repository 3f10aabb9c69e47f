"""Options that the commands of plans share."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.data.length_unit import LengthUnit

if TYPE_CHECKING:
    from measureapp.data.mesh import Mesh

PlanArgument = Annotated[Path, typer.Argument(help="Scan plan (TOML or JSON).")]
RigOption = Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")]
NominalOption = Annotated[
    Path | None,
    typer.Option(help="Nominal of the part (STL, PLY, OBJ); it is set upright in the middle of the table."),
]


def read_part(path: Path, unit: LengthUnit) -> Mesh:
    """Read a nominal and place it on the table. Raises InputError."""
    from measureapp.pipeline.plan_coverage import place_on_table
    from measureapp.project.geometry.files import read_mesh

    return place_on_table(read_mesh(path, unit=unit))
