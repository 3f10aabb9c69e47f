"""`calibrate rig`: hand-eye, guide and axis in one joint solution."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.options import BoardOption, CamerasOption, ImagesOption, OutOption, RobotPosesOption, SquareOption
from measureapp.cli.reply import JsonOption, TerminalProgress, jsonable, reply
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.calibrate.joint import RigSolution
    from measureapp.calibrate.rig import RigStages


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def rig(
        robot_poses: RobotPosesOption,
        guide_positions: Annotated[Path, typer.Option(help="Slide positions: name,position_mm.")],
        angles: Annotated[Path, typer.Option(help="Table angles: position,angle_deg, in the order of the sorted robot pose names.")],
        images: ImagesOption = None,
        cameras: CamerasOption = None,
        board: BoardOption = None,
        square_mm: SquareOption = None,
        robot_sigma_mm: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of robot positions, mm.")] = 0.3,
        robot_sigma_deg: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of robot rotations, degrees.")] = 0.02,
        table_sigma_arcsec: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of table angles, seconds of arc.")] = 10.0,
        out: OutOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Find hand-eye transform, guide and rotation axis together from images of one board fixed on the table."""
        from measureapp.calibrate.chain import AxisNoise
        from measureapp.calibrate.joint import RigObservation, solve_rig
        from measureapp.cli.calibrate.sightings import poses_from_images, read_robot_poses, same_names
        from measureapp.data.fringe import AxisReadback
        from measureapp.project.atomic import write_json
        from measureapp.project.tables import read_angles, read_guide

        robot, slide, table = read_robot_poses(robot_poses), read_guide(guide_positions), list(read_angles(angles).values())
        names = tuple(robot)
        same_names(guide_positions, names, tuple(slide))
        seen = poses_from_images(images, cameras, board, square_mm, "the calibration of the rig", TerminalProgress())
        for what, count in (("images per camera", seen.positions), ("table angles", len(table))):
            if count != len(names):
                raise InputError(f"{count} {what} do not belong to {len(names)} robot poses.", "Give one of each per robot pose.")
        observations = [
            RigObservation(names[position], AxisReadback(robot[names[position]], slide[names[position]], table[position]), pose)
            for position, pose in seen.poses.items()
        ]
        noise = AxisNoise(robot_sigma_mm, math.radians(robot_sigma_deg), math.radians(table_sigma_arcsec / 3600))
        solution = solve_rig(observations, seen.cameras, noise=noise, progress=TerminalProgress())
        document = rig_answer(solution) | {"images_rejected": seen.rejected}
        if out is not None:
            write_json(out, {"schema_version": 1, **jsonable(document)})
        reply(document, "\n".join(_lines(document)), as_json)


def rig_answer(solution: RigSolution) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    return _parts(solution.calibration) | {
        "stages": _parts(solution.stages),
        "guide_from_board": solution.guide_from_board.matrix,
        "standard_deviations": dict(solution.standard_deviations),
        "parameters": list(solution.parameters),
        "covariance": solution.covariance,
        "sigma_ratio": solution.sigma_ratio,
        "not_observable": list(solution.not_observable),
        "sightings": [
            {
                "name": one.name,
                "distance_mm": one.distance_mm,
                "angle_deg": one.angle_deg,
                "robot_error_mm": one.robot_error_mm,
                "robot_error_deg": one.robot_error_deg,
            }
            for one in solution.residuals
        ],
        "rejected": dict(solution.rejected),
    }


def _parts(solved: Any | RigStages) -> dict[str, Any]:
    return {
        "flange_from_camera": solved.hand_eye.flange_from_camera.matrix,
        "guide": {"direction": solved.guide.direction, "scale": solved.guide.scale},
        "axis": {"frame": solved.axis.frame, "direction": solved.axis.direction, "point_mm": solved.axis.point_mm},
    }


def _lines(document: dict[str, Any]) -> list[str]:
    lines = [f"Rig from {len(document['sightings'])} sightings; residuals {document['sigma_ratio']:.2f} times what was expected."]
    lines += [f"  {name:<28} ± {value:.3g}" for name, value in document["standard_deviations"].items()]
    lines += [f"  cannot be seen: {what}" for what in document["not_observable"]]
    lines += [f"  left out: {name}: {reason}" for name, reason in document["rejected"].items()]
    return lines + [f"  left out: {one['image']} ({one['camera']}): {one['reason']}" for one in document["images_rejected"]]
