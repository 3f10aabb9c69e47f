"""`calibrate check`: is the calibration of the rig still good?"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardSource
from measureapp.cli.calibrate.pose_options import RigTables, observe_rig
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import TerminalProgress
from measureapp.errors import InputError, MeasureError

if TYPE_CHECKING:
    from measureapp.calibrate.rig.quick_check import QuickCheck
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration


@dataclass(frozen=True, kw_only=True, slots=True)
class RigFiles:
    """The calibrated rig and the axis positions, for views from files."""

    calibration: Annotated[Path | None, typer.Option(help="Saved by `calibrate rig --out`.")] = None
    robot_poses: Annotated[Path | None, typer.Option("--robot-poses", help="base_from_flange: name,x_mm,y_mm,z_mm,qw,qx,qy,qz.")] = None
    guide_positions: Annotated[Path | None, typer.Option("--guide-positions", help="Slide positions: name,position_mm.")] = None
    angles: Annotated[
        Path | None, typer.Option("--angles", help="Table angles: position,angle_deg, in the order of the sorted robot pose names.")
    ] = None

    def given(self) -> list[str]:
        """Return the options that were given."""
        return [f"--{name.replace('_', '-')}" for name in asdict(self) if getattr(self, name) is not None]

    def needed(self) -> tuple[Path, RigTables]:
        """Return the calibration and the tables. Raises InputError naming what is missing."""
        if self.calibration is None or self.robot_poses is None or self.guide_positions is None or self.angles is None:
            missing = next(name for name, value in asdict(self).items() if value is None)
            raise InputError(f"--{missing.replace('_', '-')} is missing.", "Give it, or check the rig of a project with --project DIR.")
        return self.calibration, RigTables(robot_poses=self.robot_poses, guide_positions=self.guide_positions, angles=self.angles)


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def check(
        ctx: typer.Context,
        files: RigFiles,
        source: BoardSource,
        answer: Answer,
        project: Annotated[
            Path | None, typer.Option("--project", help="Project whose calibration and board are checked on its rig; needs no files.")
        ] = None,
        rig: Annotated[str | None, typer.Option("--rig", help="With --project: another description of its rig.")] = None,
        limit_mm: Annotated[float, typer.Option(min=1e-6, help="Largest deviation of the board in a view, mm.")] = 0.5,
    ) -> None:
        """Compare a few views of a board on the table with the calibrated rig; exit code 1 if the calibration has drifted.

        With --project the rig takes the views itself; otherwise they come from files.
        """
        if project is not None:
            surplus = [*files.given(), *(["--images"] if source.images else []), *(["--cameras"] if source.cameras else [])]
            if surplus:
                raise InputError(f"{surplus[0]} does not go with --project.", "Check the rig of a project, or give all files.")
            document = check_answer(_check_on_rig(project, rig, limit_mm)) | {"images_rejected": []}
        else:
            document = _check_files(files, source, limit_mm)
        answer.give(ctx, document, _lines(document))
        if not document["good"]:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _check_on_rig(folder: Path, rig: str | None, limit_mm: float) -> QuickCheck:
    from measureapp.devices.connect import connect_rig
    from measureapp.pipeline.board_check import check_with_board
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.rig_file import read_rig

    project = ProjectFolder.open(folder)
    connected = connect_rig(project.rig() if rig is None else read_rig(rig))
    try:
        return check_with_board(project, connected, TerminalProgress(), limit_mm)
    finally:
        connected.close()


def _check_files(files: RigFiles, source: BoardSource, limit_mm: float) -> dict[str, Any]:
    from measureapp.calibrate.rig.quick_check import quick_check

    calibration, tables = files.needed()
    seen = observe_rig(tables, source, "the check of the rig", TerminalProgress())
    located = seen.located()
    found = quick_check(located.observations, read_rig_answer(calibration, seen.cameras), seen.board, limit_mm=limit_mm)
    return check_answer(found) | {"images_rejected": seen.rejected(located.rejected)}


def read_rig_answer(path: Path, cameras: CameraArrayCalibration) -> RigCalibration:
    """Read the rig from the answer of `calibrate rig`. Raises InputError where the file holds none."""
    from measureapp.data.calibration import HandEye, LinearGuide, RigCalibration, RobotStation, RotationAxis
    from measureapp.geometry.transform import RigidTransform
    from measureapp.project.documents import motions_from

    def pose(matrix: Any) -> RigidTransform:
        return RigidTransform(matrix, "base", "flange")

    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        axis = document["axis"]
        return RigCalibration(
            cameras,
            HandEye(RigidTransform(document["flange_from_camera"], "flange", "camera")),
            LinearGuide(document["guide"]["direction"], float(document["guide"]["scale"])),
            RotationAxis(axis["point_mm"], axis["direction"], axis["frame"]),
            stations=tuple(RobotStation(pose(one["read"]), pose(one["true"])) for one in document.get("stations", ())),
            motions=motions_from(document.get("error_motions")),
        )
    except (OSError, ValueError, KeyError, TypeError, MeasureError, RecursionError) as error:
        from measureapp.project.text_document import reason_of

        raise InputError(
            f"{path} holds no calibrated rig: {reason_of(error)}.", "Give the file that `calibrate rig --out` wrote."
        ) from error


def check_answer(found: QuickCheck) -> dict[str, Any]:
    """Return the JSON answer of a check."""
    return {
        "good": found.good,
        "verdict": found.sentence,
        "limit_mm": found.limit_mm,
        "suspect": found.suspect,
        "explained": dict(found.explained),
        "not_tested": list(found.not_tested),
        "views": [
            {"name": view.name, "deviation_mm": view.deviation_mm, "deviation_px": view.deviation_px, "camera_px": view.camera_px}
            for view in found.views
        ],
    }


def _lines(document: dict[str, Any]) -> list[str]:
    lines = [document["verdict"]]
    lines += [f"  {view['name']:<16} {view['deviation_mm']:.3f} mm  {view['deviation_px']:.2f} px" for view in document["views"]]
    lines += [f"  freeing {link} alone would explain {share:.0%}" for link, share in document["explained"].items()]
    lines += [f"  not tested, since its axis did not move: {link}" for link in document["not_tested"]]
    return lines + [f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["images_rejected"]]
