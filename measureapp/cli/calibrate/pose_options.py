"""What the calibrations that move robot, guide and table share: their options, and the sightings these lead to."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.calibrate.axis_noise import AxisNoise
    from measureapp.calibrate.joint import RigObservation
    from measureapp.cli.calibrate.options import BoardChoice
    from measureapp.cli.calibrate.sightings import PosesFromImages
    from measureapp.progress import Progress

GuidePositionsOption = Annotated[Path, typer.Option("--guide-positions", help="Slide positions: name,position_mm.")]
AnglesOption = Annotated[
    Path, typer.Option("--angles", help="Table angles: position,angle_deg, in the order of the sorted robot pose names.")
]
RobotSigmaMm = Annotated[
    float, typer.Option("--robot-sigma-mm", min=1e-6, help="Standard deviation of robot positions, per coordinate, mm.")
]
RobotSigmaDeg = Annotated[float, typer.Option("--robot-sigma-deg", min=1e-6, help="The same of robot rotations, degrees.")]
RobotRepeatMm = Annotated[float, typer.Option("--robot-repeat-mm", min=0.0, help="Scatter of the robot at every approach of a pose, mm.")]
RobotAlikeMm = Annotated[
    float,
    typer.Option("--robot-alike-mm", min=0.0, help="Distance over which the robot's errors are alike, mm; 0: each pose has its own."),
]


def axis_noise(sigma_mm: float, sigma_deg: float, repeat_mm: float, alike_mm: float, table_arcsec: float = 10.0) -> AxisNoise:
    """Return the noise of the axes as the options state it; rotations repeat and resemble each other as positions do."""
    from measureapp.calibrate.axis_noise import ALIKE_MM, ALIKE_TURN, AxisNoise

    return AxisNoise(
        robot_mm=sigma_mm,
        robot_rad=math.radians(sigma_deg),
        table_rad=math.radians(table_arcsec / 3600),
        robot_repeat_mm=repeat_mm,
        robot_repeat_rad=math.radians(sigma_deg) * repeat_mm / sigma_mm,
        robot_alike_mm=alike_mm,
        robot_alike_turn=ALIKE_TURN * alike_mm / ALIKE_MM,
    )


def rig_sightings(
    tables: tuple[Path, Path, Path],
    images: Sequence[str] | None,
    cameras: Path | None,
    board: BoardChoice,
    purpose: str,
    progress: Progress,
) -> tuple[list[RigObservation], PosesFromImages]:
    """Return the sightings of the board with the read-back of every axis.

    Parameters
    ----------
    tables : files of robot poses, slide positions and table angles

    Raises
    ------
    InputError
        A file cannot be used, or files do not belong together.
    """
    from measureapp.calibrate.joint import RigObservation
    from measureapp.cli.calibrate.sightings import poses_from_images, read_robot_poses, same_names
    from measureapp.data.fringe import AxisReadback
    from measureapp.project.tables import read_angles, read_guide

    robot_poses, guide_positions, angles = tables
    robot, slide, table = read_robot_poses(robot_poses), read_guide(guide_positions), list(read_angles(angles).values())
    names = tuple(robot)
    same_names(guide_positions, names, tuple(slide))
    seen = poses_from_images(images, cameras, board, purpose, progress)
    for what, count in (("images per camera", seen.positions), ("table angles", len(table))):
        if count != len(names):
            raise InputError(f"{count} {what} do not belong to {len(names)} robot poses.", "Give one of each per robot pose.")
    observations = [
        RigObservation(names[position], AxisReadback(robot[names[position]], slide[names[position]], table[position]), pose)
        for position, pose in seen.poses.items()
    ]
    return observations, seen
