"""`calibrate check`: is the calibration of the rig still good?"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardSource
from measureapp.cli.calibrate.pose_options import RigTables, rig_sightings
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import TerminalProgress
from measureapp.errors import InputError, MeasureError

if TYPE_CHECKING:
    from measureapp.calibrate.quick_check import QuickCheck
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def check(
        ctx: typer.Context,
        tables: RigTables,
        source: BoardSource,
        answer: Answer,
        calibration: Annotated[Path, typer.Option(help="What `calibrate rig --out` wrote.")],
        limit_mm: Annotated[float, typer.Option(min=1e-6, help="Largest deviation of the board in a view, mm.")] = 0.5,
    ) -> None:
        """Compare a few views of a board on the table with the calibrated rig; exit code 1 where it no longer holds."""
        from measureapp.calibrate.quick_check import quick_check

        observations, seen = rig_sightings(tables, source, "the check of the rig", TerminalProgress())
        found = quick_check(observations, read_rig_answer(calibration, seen.cameras), seen.board, limit_mm=limit_mm)
        document = check_answer(found) | {"images_rejected": seen.rejected}
        answer.give(ctx, document, _lines(document))
        if not found.good:
            raise typer.Exit(OUT_OF_TOLERANCE)


def read_rig_answer(path: Path, cameras: CameraArrayCalibration) -> RigCalibration:
    """Read the rig from the answer of `calibrate rig`. Raises InputError where the file holds none."""
    from measureapp.data.calibration import HandEye, LinearGuide, RigCalibration, RobotStation, RotationAxis
    from measureapp.geometry.transform import RigidTransform

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
        )
    except (OSError, ValueError, KeyError, TypeError, MeasureError) as error:
        raise InputError(f"{path} holds no calibrated rig: {error}.", "Give the file that `calibrate rig --out` wrote.") from error


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
    return lines + [f"  left out: {one['image']} ({one['camera']}): {one['reason']}" for one in document["images_rejected"]]
