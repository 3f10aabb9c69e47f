"""Check of a project's calibration with a few views of the board on its rig."""

from __future__ import annotations

from collections.abc import Sequence

from measureapp.acquire.engine import Engine
from measureapp.acquire.motion import checked
from measureapp.acquire.tasks.board import BoardTask
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.rig.quick_check import LEAST_VIEWS, QuickCheck, quick_check
from measureapp.data.board import BoardDescription, BoardView
from measureapp.data.calibration import RigCalibration
from measureapp.data.validity import CheckRecord, DriftStatus
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError
from measureapp.pipeline.validity import check_before_scan
from measureapp.planning.calibration_views import check_viewpoints
from measureapp.planning.collision.build import PartSolid
from measureapp.progress import Progress
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder


def check_with_board(project: ProjectFolder, rig: Rig, progress: Progress, limit_mm: float = 0.5) -> QuickCheck:
    """Take and store a few views of the board, compare them with the project's calibration, and add the verdict to its history.

    Raises
    ------
    CalibrationError
        There is no calibration, it is of other cameras, or the board is detected in too few views.
    DeviceError
        From the rig.
    """
    with project.lock():
        return _check(project, rig, progress, limit_mm)


def _check(project: ProjectFolder, rig: Rig, progress: Progress, limit_mm: float) -> QuickCheck:
    calibration = project.require_calibration()
    check_before_scan(rig, calibration)
    viewpoints = check_viewpoints(rig.description)
    views: list[BoardView] = []
    Engine(checked(rig, PartSolid.board_on_stand())).run(
        "check of the calibration", viewpoints, BoardTask(views.append), lambda _: None, progress
    )
    at = max(view.conditions.taken_at for view in views if view.conditions is not None)
    for view in views:
        project.save_check_view(at.replace(":", "").replace("+0000", ""), view)
    found = compare_board(views, calibration, project.settings.board, limit_mm)
    progress.report(1, 1, "checked")
    worst = max(view.deviation_mm for view in found.views)
    warm = rig.conditions(at).temperature_c
    status: DriftStatus = "good" if found.good else "drifted"
    named = calibration_id(calibration)
    project.record_check(CheckRecord(at, "board check", named, status, found.sentence, error_mm=worst, temperature_c=warm))
    return found


def compare_board(views: Sequence[BoardView], calibration: RigCalibration, board: BoardDescription, limit_mm: float = 0.5) -> QuickCheck:
    """Compare views of the board with a calibration. Raises CalibrationError where too few show the board, with the reason of each."""
    observations, missed = [], []
    for view in views:
        found = {}
        for camera, pixels in view.images.items():
            try:
                found[camera] = find_board(pixels, board)
            except CalibrationError as error:
                missed.append(f"{view.viewpoint_id} ({camera}): {error.message}")
        if found:
            pose = pose_of(found, calibration.cameras, board)
            observations.append(Observation(view.viewpoint_id, view.readback, pose))
    if len(observations) < LEAST_VIEWS:
        raise CalibrationError(
            f"The board is detected in {len(observations)} of {len(views)} views: " + " ".join(missed),
            "Put the board of the calibration on the table, facing the head, and light it.",
        )
    return quick_check(observations, calibration, board, limit_mm=limit_mm)
