"""What the calibrations that move robot, guide and table share: their options, and the sightings these lead to."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.calibrate.options import RobotPosesOption
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.calibrate.motions.axis_noise import AxisNoise
    from measureapp.calibrate.rig.joint import RigObservation
    from measureapp.cli.calibrate.options import BoardSource
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
RobotRepeatMm = Annotated[
    float,
    typer.Option(
        "--robot-repeat-mm",
        min=0.0,
        help="Scatter of the robot at every approach of a pose, mm; equal poses that follow one another by name are one approach.",
    ),
]
RobotAlikeMm = Annotated[
    float,
    typer.Option("--robot-alike-mm", min=0.0, help="Distance over which the robot's errors are alike, mm; 0: each pose has its own."),
]


@dataclass(frozen=True, kw_only=True, slots=True)
class RobotNoise:
    """How the robot errs; rotations repeat and resemble each other as positions do."""

    robot_sigma_mm: RobotSigmaMm = 0.2
    robot_sigma_deg: RobotSigmaDeg = 0.012
    robot_repeat_mm: RobotRepeatMm = 0.01
    robot_alike_mm: RobotAlikeMm = 300.0

    def axis_noise(self, table_arcsec: float = 10.0) -> AxisNoise:
        """Return the noise of all axes."""
        from measureapp.calibrate.motions.axis_noise import ALIKE_MM, ALIKE_TURN, AxisNoise

        return AxisNoise(
            robot_mm=self.robot_sigma_mm,
            robot_rad=math.radians(self.robot_sigma_deg),
            table_rad=math.radians(table_arcsec / 3600),
            robot_repeat_mm=self.robot_repeat_mm,
            robot_repeat_rad=math.radians(self.robot_sigma_deg) * self.robot_repeat_mm / self.robot_sigma_mm,
            robot_alike_mm=self.robot_alike_mm,
            robot_alike_turn=ALIKE_TURN * self.robot_alike_mm / ALIKE_MM,
        )


@dataclass(frozen=True, kw_only=True, slots=True)
class RigTables:
    """Where every axis was, per sighting of the board."""

    robot_poses: RobotPosesOption
    guide_positions: GuidePositionsOption
    angles: AnglesOption


def rig_sightings(tables: RigTables, source: BoardSource, purpose: str, progress: Progress) -> tuple[list[RigObservation], PosesFromImages]:
    """Return the sightings of the board with the read-back of every axis.

    Raises
    ------
    InputError
        A file cannot be used, or files do not belong together.
    """
    from measureapp.calibrate.rig.joint import RigObservation
    from measureapp.cli.calibrate.sightings import poses_from_images, read_robot_poses, same_names
    from measureapp.data.fringe import AxisReadback
    from measureapp.project.tables import read_angles, read_guide

    robot, slide = read_robot_poses(tables.robot_poses), read_guide(tables.guide_positions)
    table = list(read_angles(tables.angles).values())
    names = tuple(robot)
    same_names(tables.guide_positions, names, tuple(slide))
    seen = poses_from_images(source, purpose, progress)
    for what, count in (("images per camera", seen.positions), ("table angles", len(table))):
        if count != len(names):
            raise InputError(f"{count} {what} do not belong to {len(names)} robot poses.", "Give one of each per robot pose.")
    observations = [
        RigObservation(
            names[position],
            AxisReadback(robot[names[position]], slide[names[position]], table[position]),
            pose,
            seen.by_cameras.get(position),
        )
        for position, pose in seen.poses.items()
    ]
    return observations, seen
