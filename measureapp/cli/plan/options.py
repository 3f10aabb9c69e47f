"""Options that the commands of plans share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

PlanArgument = Annotated[Path, typer.Argument(help="Scan plan (TOML or JSON).")]
RigOption = Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")]
NominalOption = Annotated[
    Path | None,
    typer.Option(help="Nominal of the part (STL, PLY, OBJ), as it stands on the table at 0°: origin in the centre of the table's top."),
]
