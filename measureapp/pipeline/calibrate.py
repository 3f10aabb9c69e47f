"""From images of the board to a calibrated rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import UTC, datetime

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.board import detect
from measureapp.calibrate.board_pose import board_pose
from measureapp.calibrate.camera_array import CameraArrayProblem, CameraArraySolution
from measureapp.calibrate.camera_array import solve as solve_cameras
from measureapp.calibrate.chain import AxisNoise
from measureapp.calibrate.joint import RigObservation, RigSolution, solve_rig
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.board import BoardView, CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, Provenance
from measureapp.data.rig import RigDescription
from measureapp.errors import CalibrationError
from measureapp.progress import PartOf, Progress

DETECTION_THREADS = 2


@dataclass(frozen=True, slots=True, eq=False)
class CalibratedRig:
    """The solutions of all calibrations of one run."""

    cameras: CameraArraySolution
    rig: RigSolution  # its `calibration` holds everything


def calibrate_from_views(
    views: Sequence[BoardView], board: CheckerboardDescription, rig: RigDescription, progress: Progress
) -> CalibratedRig:
    """Find the board in all images, calibrate the cameras from them, then hand-eye, guide and axis.

    Raises
    ------
    CalibrationError
        The views do not determine the rig; the message says what is missing.
    """
    if not views:
        raise CalibrationError("There are no images of the board.", "Take them first, or give a calibration.")
    found, missed = _detected(views, board, PartOf(progress, 0.0, 0.5))
    problem = CameraArrayProblem(
        board=board,
        reference=rig.reference,
        sizes_px={camera.name: (camera.width_px, camera.height_px) for camera in rig.cameras},
        sightings=tuple(Sighting(camera, view, corners) for view, seen in found.items() for camera, corners in seen.items()),
        rejected=missed,
    )
    solved = solve_cameras(problem, PartOf(progress, 0.5, 0.8))
    cameras = _with_serials(solved.calibration, rig)
    solved = replace(solved, calibration=cameras)
    observations = _observations(views, found, solved)
    noise = AxisNoise(
        robot_mm=rig.robot.absolute_accuracy_mm,
        robot_rad=float(np.deg2rad(rig.robot.absolute_accuracy_deg)),
        table_rad=float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)),
    )
    solution = solve_rig(observations, cameras, noise=noise, progress=PartOf(progress, 0.8, 1.0))
    provenance = Provenance(
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        method=solution.calibration.provenance.method,
        inputs={camera.name: camera.serial for camera in rig.cameras} | {"board views": str(len(views))},
    )
    return CalibratedRig(solved, replace(solution, calibration=replace(solution.calibration, provenance=provenance)))


def _detected(
    views: Sequence[BoardView], board: CheckerboardDescription, progress: Progress
) -> tuple[dict[str, dict[str, FloatArray]], tuple[Rejection, ...]]:
    """Corners by view and camera, and the images without a board."""
    found: dict[str, dict[str, FloatArray]] = {view.viewpoint_id: {} for view in views}
    missed = []
    images = [(view.viewpoint_id, camera, pixels) for view in views for camera, pixels in view.images.items()]
    with ThreadPoolExecutor(DETECTION_THREADS) as pool:
        pending = [pool.submit(detect, pixels, board) for _, _, pixels in images]
        try:
            for number, ((view, camera, _), future) in enumerate(zip(images, pending, strict=True)):
                progress.report(number, len(images), f"looking for the board in {view}")
                try:
                    found[view][camera] = future.result()
                except CalibrationError as error:
                    missed.append(Rejection(camera, view, error.message))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return found, tuple(missed)


def _observations(
    views: Sequence[BoardView], found: Mapping[str, Mapping[str, FloatArray]], solved: CameraArraySolution
) -> list[RigObservation]:
    """Board poses from the sightings that the camera calibration kept."""
    used = {(residual.camera, residual.view) for residual in solved.views}
    observations = []
    for view in views:
        corners = {camera: seen for camera, seen in found[view.viewpoint_id].items() if (camera, view.viewpoint_id) in used}
        if corners:
            pose = board_pose(corners, solved.calibration, solved.board, solved.sigma_px)
            observations.append(RigObservation(view.viewpoint_id, view.readback, pose))
    return observations


def _with_serials(calibration: CameraArrayCalibration, rig: RigDescription) -> CameraArrayCalibration:
    cameras = {name: replace(camera, serial=rig.camera(name).serial) for name, camera in calibration.cameras.items()}
    return replace(calibration, cameras=cameras)
