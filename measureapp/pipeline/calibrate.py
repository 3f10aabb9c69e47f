"""From images of the board to a calibrated rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from statistics import median

import numpy as np

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.cameras.array import CameraArrayProblem, CameraArraySolution
from measureapp.calibrate.cameras.array import solve as solve_cameras
from measureapp.calibrate.cameras.prior import pose_by_cameras
from measureapp.calibrate.motions.axis_noise import AxisNoise, articulated_robot
from measureapp.calibrate.rig.joint import RigObservation, approaches_to, solve_rig
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.sightings import FoundBoard, Rejection, sighting_of
from measureapp.data.board import BoardDescription, BoardView
from measureapp.data.calibration import LabelledCovariance, Provenance
from measureapp.data.conditions import LensSetting
from measureapp.data.fringe import AxisReadback
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
    solved = with_devices(solve_cameras(problem, PartOf(progress, 0.5, 0.8)), *_devices(rig, views))
    readbacks = {view.viewpoint_id: view.readback for view in views}
    calibrated = rig_with_cameras(solved, found, readbacks, expected_noise(rig), PartOf(progress, 0.8, 1.0))
    calibration = calibrated.rig.calibration
    provenance = _provenance(calibration.provenance.method, rig, views)
    cameras = replace(calibration.cameras, provenance=replace(provenance, method=calibration.cameras.provenance.method))
    return replace(calibrated, rig=replace(calibrated.rig, calibration=replace(calibration, cameras=cameras, provenance=provenance)))


def rig_with_cameras(
    solved: CameraArraySolution,
    found: Mapping[str, Mapping[str, FoundBoard]],
    readbacks: Mapping[str, AxisReadback],
    noise: AxisNoise,
    progress: Progress,
    approaches: Mapping[str, int] | None = None,
) -> CalibratedRig:
    """Solve hand-eye, guide and axis with cameras that were calibrated from the same sightings.

    Parameters
    ----------
    found : view -> camera -> marks
    readbacks : view -> where the axes stood, in the order the views were taken
    approaches : view -> which approach of the robot; default: as ``readbacks`` follow one another

    Raises
    ------
    CalibrationError
        The sightings do not determine the rig.
    """
    prior = LabelledCovariance(solved.parameters, solved.covariance)
    if approaches is None:
        approaches = dict(zip(readbacks, approaches_to([one.base_from_flange for one in readbacks.values()]), strict=True))
    observations = _observations(readbacks, found, solved, approaches)
    return CalibratedRig(solved, solve_rig(observations, solved.calibration, noise=noise, camera_prior=prior, progress=progress))


def _provenance(method: str, rig: RigDescription, views: Sequence[BoardView]) -> Provenance:
    """Where the calibration comes from. It is as old as its last image: solving it again does not make it younger."""
    recorded = [view.conditions for view in views if view.conditions is not None]
    warm = [conditions.temperature_c for conditions in recorded if conditions.temperature_c is not None]
    return Provenance(
        created=max((conditions.taken_at for conditions in recorded), default=datetime.now(UTC).isoformat(timespec="seconds")),
        method=method,
        inputs=checksums_of(views),
        temperature_c=median(warm) if warm else None,
        valid_days=rig.calibration_rules.valid_days,
    )


def checksums_of(views: Sequence[BoardView]) -> dict[str, str]:
    """Return "view/camera" -> checksum of every image, which is how a project stores them."""
    return {f"{view.viewpoint_id}/{camera}": checksum(np.asarray(pixels)) for view in views for camera, pixels in view.images.items()}


def expected_noise(rig: RigDescription) -> AxisNoise:
    """Return what the data sheets of the rig's axes let expect.

    A table's accuracy is the span of its error over a turn; a guide's repeatability (±) is two standard deviations.
    """
    along_mm = rig.guide.repeatability_mm / 2
    robot = articulated_robot(
        rig.robot.absolute_accuracy_mm, float(np.deg2rad(rig.robot.absolute_accuracy_deg)), rig.robot.repeatability_mm
    )
    return replace(
        robot,
        table_rad=float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)) / SPAN_OVER_RMS,
        guide_mm=float(np.hypot(STRAIGHTNESS_MM, along_mm)),
        guide_along_mm=along_mm,
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
    readbacks: Mapping[str, AxisReadback],
    found: Mapping[str, Mapping[str, FoundBoard]],
    solved: CameraArraySolution,
    approaches: Mapping[str, int],
) -> list[RigObservation]:
    """Board poses from the sightings that the camera calibration kept."""
    used = {(residual.camera, residual.view) for residual in solved.views}
    observations = []
    for view, readback in readbacks.items():
        seen = {camera: one for camera, one in found[view].items() if (camera, view) in used}
        if seen:
            corners, ids = {camera: one.corners_px for camera, one in seen.items()}, {camera: one.ids for camera, one in seen.items()}
            pose = board_pose(corners, solved.calibration, solved.board, solved.sigma_px, ids)
            by_cameras = pose_by_cameras(pose, ids, solved.calibration, solved.board, solved.parameters)
            observations.append(RigObservation(view, readback, pose, by_cameras, approaches[view]))
    return observations


def _devices(rig: RigDescription, views: Sequence[BoardView]) -> tuple[Mapping[str, str], Mapping[str, LensSetting]]:
    """Return the serial number of every camera, as it said itself or else as the rig is described, and how its lens was set."""
    last = next((view.conditions for view in reversed(views) if view.conditions is not None), None)
    serials = {camera.name: camera.serial for camera in rig.cameras}
    return (serials, {}) if last is None else ({**serials, **last.serials}, last.lenses)


def with_devices(
    solution: CameraArraySolution, serials: Mapping[str, str], lenses: Mapping[str, LensSetting] | None = None
) -> CameraArraySolution:
    """Return the solution with the serial numbers of its cameras and how their lenses were set."""
    calibration = solution.calibration
    cameras = {
        name: replace(camera, serial=serials.get(name, ""), lens=(lenses or {}).get(name, LensSetting()))
        for name, camera in calibration.cameras.items()
    }
    return replace(solution, calibration=replace(calibration, cameras=cameras))
