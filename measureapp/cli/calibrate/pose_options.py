"""Options common to the calibrations of robot, guide and table, and the observations from them."""

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
    from measureapp.cli.calibrate.observed_files import ObservedFiles
    from measureapp.cli.calibrate.options import BoardSource
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
    typer.Option("--robot-alike-mm", min=0.0, help="Correlation length of the robot's pose errors, mm; 0: uncorrelated."),
]


@dataclass(frozen=True, kw_only=True, slots=True)
class RobotNoise:
    """Noise of the robot; rotations have the same ratio of repeatability and the same correlation as positions."""

    robot_sigma_mm: RobotSigmaMm = 0.2
    robot_sigma_deg: RobotSigmaDeg = 0.012
    robot_repeat_mm: RobotRepeatMm = 0.01
    robot_alike_mm: RobotAlikeMm = 300.0

    def axis_noise(self, table_arcsec: float = 10.0) -> AxisNoise:
        """Return the noise of all axes; the error motions of the table are those of a usual one, which the sightings refine."""
        from measureapp.calibrate.motions import axis_noise as usual
        from measureapp.calibrate.motions.axis_noise import CORRELATION_MM, CORRELATION_TURN, AxisNoise
        from measureapp.data.axis_motions import ARCSEC

        return AxisNoise(
            robot_mm=self.robot_sigma_mm,
            robot_rad=math.radians(self.robot_sigma_deg),
            table_rad=math.radians(table_arcsec / 3600),
            robot_repeat_mm=self.robot_repeat_mm,
            robot_repeat_rad=math.radians(self.robot_sigma_deg) * self.robot_repeat_mm / self.robot_sigma_mm,
            robot_correlation_mm=self.robot_alike_mm,
            robot_correlation_turn=CORRELATION_TURN * self.robot_alike_mm / CORRELATION_MM,
            table_radial_mm=usual.USUAL_RADIAL_MM,
            table_axial_mm=usual.USUAL_AXIAL_MM,
            table_tilt_rad=usual.USUAL_TILT_ARCSEC * ARCSEC,
        )


@dataclass(frozen=True, kw_only=True, slots=True)
class RigTables:
    """Where every axis was, per sighting of the board."""

    robot_poses: RobotPosesOption
    guide_positions: GuidePositionsOption
    angles: AnglesOption


def observe_rig(tables: RigTables, source: BoardSource, subject: str, progress: Progress) -> ObservedFiles:
    """Detect the board in all images, and read the positions of every axis from the tables.

    Raises
    ------
    InputError
        A file cannot be used, or files do not belong together.
    """
    from measureapp.cli.calibrate.observed_files import observe_files, read_robot_poses, require_same_names
    from measureapp.data.fringe import AxisReadback
    from measureapp.project.tables import read_angles, read_guide

    robot, slide = read_robot_poses(tables.robot_poses), read_guide(tables.guide_positions)
    table = list(read_angles(tables.angles).values())
    require_same_names(tables.guide_positions, tuple(robot), tuple(slide))
    if len(table) != len(robot):
        raise InputError(f"{len(table)} table angles do not belong to {len(robot)} robot poses.", "Give one of each per robot pose.")
    readbacks = {name: AxisReadback(robot[name], slide[name], angle) for name, angle in zip(robot, table, strict=True)}
    return observe_files(source, subject, progress, readbacks)
