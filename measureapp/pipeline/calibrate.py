"""From images of the board to a calibrated rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import UTC, datetime

import numpy as np

from measureapp.calibrate.axis_noise import AxisNoise, articulated_robot
from measureapp.calibrate.board import find_board
from measureapp.calibrate.board_pose import board_pose
from measureapp.calibrate.camera_array import CameraArrayProblem, CameraArraySolution
from measureapp.calibrate.camera_array import solve as solve_cameras
from measureapp.calibrate.camera_prior import pose_by_cameras
from measureapp.calibrate.joint import RigObservation, solve_rig
from measureapp.calibrate.joint_solution import RigSolution
from measureapp.calibrate.sightings import FoundBoard, Rejection, sighting_of
from measureapp.data.board import BoardDescription, BoardView
from measureapp.data.calibration import CameraArrayCalibration, LabelledCovariance, Provenance
from measureapp.data.rig import RigDescription
from measureapp.errors import CalibrationError
from measureapp.progress import PartOf, Progress
from measureapp.project.frame_store import checksum

DETECTION_THREADS = 2
STRAIGHTNESS_MM = 0.003  # usual of a ground rail over the travel of a calibration
SPAN_OVER_RMS = np.sqrt(8.0)  # of a sine


@dataclass(frozen=True, slots=True, eq=False)
class CalibratedRig:
    """The solutions of all calibrations of one run."""

    cameras: CameraArraySolution
    rig: RigSolution  # its `calibration` holds everything


def calibrate_from_views(views: Sequence[BoardView], board: BoardDescription, rig: RigDescription, progress: Progress) -> CalibratedRig:
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
        sightings=tuple(sighting_of(camera, view, one) for view, seen in found.items() for camera, one in seen.items()),
        rejected=missed,
    )
    solved = solve_cameras(problem, PartOf(progress, 0.5, 0.8))
    cameras = _with_serials(solved.calibration, rig)
    solved = replace(solved, calibration=cameras)
    observations = _observations(views, found, solved)
    prior = LabelledCovariance(solved.parameters, solved.covariance)
    solution = solve_rig(observations, cameras, noise=expected_noise(rig), camera_prior=prior, progress=PartOf(progress, 0.8, 1.0))
    provenance = Provenance(
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        method=solution.calibration.provenance.method,
        inputs={camera.name: camera.serial for camera in rig.cameras} | checksums_of(views),
    )
    return CalibratedRig(solved, replace(solution, calibration=replace(solution.calibration, provenance=provenance)))


def checksums_of(views: Sequence[BoardView]) -> dict[str, str]:
    """Return "view/camera" -> checksum of every image, which is how a project stores them."""
    return {f"{view.viewpoint_id}/{camera}": checksum(np.asarray(pixels)) for view in views for camera, pixels in view.images.items()}


def expected_noise(rig: RigDescription) -> AxisNoise:
    """Return what the data sheets of the rig's axes let expect; a table's accuracy is the span of its error over a turn."""
    return articulated_robot(
        rig.robot.absolute_accuracy_mm,
        float(np.deg2rad(rig.robot.absolute_accuracy_deg)),
        rig.robot.repeatability_mm,
        float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)) / SPAN_OVER_RMS,
        float(np.hypot(STRAIGHTNESS_MM, rig.guide.repeatability_mm)),
    )


def _detected(
    views: Sequence[BoardView], board: BoardDescription, progress: Progress
) -> tuple[dict[str, dict[str, FoundBoard]], tuple[Rejection, ...]]:
    """Corners by view and camera, and the images without a board."""
    found: dict[str, dict[str, FoundBoard]] = {view.viewpoint_id: {} for view in views}
    missed = []
    images = [(view.viewpoint_id, camera, pixels) for view in views for camera, pixels in view.images.items()]
    with ThreadPoolExecutor(DETECTION_THREADS) as pool:
        pending = [pool.submit(find_board, pixels, board) for _, _, pixels in images]
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
    views: Sequence[BoardView], found: Mapping[str, Mapping[str, FoundBoard]], solved: CameraArraySolution
) -> list[RigObservation]:
    """Board poses from the sightings that the camera calibration kept."""
    used = {(residual.camera, residual.view) for residual in solved.views}
    observations = []
    for view in views:
        seen = {camera: one for camera, one in found[view.viewpoint_id].items() if (camera, view.viewpoint_id) in used}
        if seen:
            corners, ids = {camera: one.corners_px for camera, one in seen.items()}, {camera: one.ids for camera, one in seen.items()}
            pose = board_pose(corners, solved.calibration, solved.board, solved.sigma_px, ids)
            by_cameras = pose_by_cameras(pose, ids, solved.calibration, solved.board, solved.parameters)
            observations.append(RigObservation(view.viewpoint_id, view.readback, pose, by_cameras))
    return observations


def _with_serials(calibration: CameraArrayCalibration, rig: RigDescription) -> CameraArrayCalibration:
    cameras = {name: replace(camera, serial=rig.camera(name).serial) for name, camera in calibration.cameras.items()}
    return replace(calibration, cameras=cameras)
