"""Options that the commands of plans share."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.data.length_unit import LengthUnit

if TYPE_CHECKING:
    from measureapp.data.mesh import Mesh
    from measureapp.data.part_pose import PartPose

PlanArgument = Annotated[Path, typer.Argument(help="Scan plan (TOML or JSON).")]
RigOption = Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")]
NominalOption = Annotated[
    Path | None,
    typer.Option(help="Nominal of the part (STL, PLY, OBJ); its pose is that of the plan, else upright in the middle of the table."),
]


UpsideDownOption = Annotated[bool, typer.Option("--upside-down", help="The part stands on its head: turned by 180° about x.")]
TurnOption = Annotated[
    tuple[float, float, float] | None,
    typer.Option("--turn-deg", help="The part is turned by these angles about x, then y, then z, before it is put on the table."),
]
PoseFileOption = Annotated[
    Path | None,
    typer.Option("--pose", help="4×4 matrix part_from_nominal (text or JSON). Default: upright in the middle of the table."),
]


def pose_of_options(pose: Path | None, turn_deg: tuple[float, float, float] | None, upside_down: bool) -> PartPose | None:
    """Return how the part stands; None where no option says so. Raises InputError where two do."""
    from measureapp.data.part_pose import PartPose
    from measureapp.errors import InputError
    from measureapp.project.calibration.matrix_file import read_transform

    if (pose is not None) + (turn_deg is not None) + upside_down > 1:
        raise InputError("Only one of --pose, --turn-deg and --upside-down can be given.", "State once how the part stands.")
    if pose is not None:
        return PartPose.of(read_transform(pose, "part", "nominal"))
    if upside_down:
        return PartPose.upside_down()
    return None if turn_deg is None else PartPose(rotation_deg=turn_deg)


def read_part(path: Path, unit: LengthUnit, pose: PartPose | None) -> Mesh:
    """Read a nominal and place it on the table, as a plan states. Raises InputError."""
    from measureapp.pipeline.plan_coverage import place_on_table
    from measureapp.project.geometry.files import read_mesh

    return place_on_table(read_mesh(path, unit=unit), pose)
