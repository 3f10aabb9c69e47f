"""The pose of the board in every observation, once the cameras are known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.agreement import reject_contradicting
from measureapp.calibrate.boards.observation import Observation, camera_jacobians_of
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.prior import pose_camera_jacobian
from measureapp.calibrate.draft.draft import Draft
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, LabelledCovariance


@dataclass(frozen=True, slots=True, eq=False)
class Located:
    """Observations with the pose of the board, and those whose cameras contradict each other."""

    observations: tuple[Observation, ...]
    rejected: dict[str, str]  # observation -> reason
    prior: LabelledCovariance | None  # covariance of the cameras, to which the derivatives in the observations belong

    @property
    def camera_jacobian(self) -> FloatArray | None:
        """Derivatives (N, 6, C) of the poses with respect to the parameters of `prior`."""
        return camera_jacobians_of(self.observations)


def locate_board(draft: Draft) -> Located:
    """Locate the board in the observations of a draft whose cameras are known. Raises CalibrationError as `locate`."""
    cameras = draft.setup.cameras
    assert cameras is not None  # guaranteed by `Setup`
    return locate(draft.observations, cameras, draft.setup.board)


def locate(observations: Sequence[Observation], cameras: CameraArrayCalibration, board: BoardDescription) -> Located:
    """Find the board's pose in every observation with calibrated cameras, and its derivatives where their covariance is known.

    The corner noise behind the information of the poses is that of the residuals of all of them together.

    Raises
    ------
    CalibrationError
        In most observations the images contradict the cameras.
    """
    seen = {one.id: {name: marks for name, marks in one.seen.items() if name in cameras.cameras} for one in observations}
    places = reject_contradicting({name: pose_of(marks, cameras, board) for name, marks in seen.items()})
    kept = tuple(replace(one, board=places.poses[one.id]) for one in observations if one.id in places.poses)
    return Located(_add_camera_jacobians(kept, cameras, board, cameras.covariance), dict(places.rejected), cameras.covariance)


def locate_in_solution(observations: Sequence[Observation], solved: CameraArraySolution) -> Located:
    """As `locate`, with cameras that were calibrated from the same observations: only the sightings that their solution kept, at its noise."""
    used = {(residual.camera, residual.view) for residual in solved.views}
    prior, kept = LabelledCovariance(solved.parameters, solved.covariance), []
    for one in observations:
        seen = {camera: marks for camera, marks in one.seen.items() if (camera, one.id) in used}
        if seen:
            kept.append(replace(one, seen=seen, board=pose_of(seen, solved.calibration, solved.board, solved.sigma_px)))
    return Located(_add_camera_jacobians(kept, solved.calibration, solved.board, prior), {}, prior)


def _add_camera_jacobians(
    observations: Sequence[Observation], cameras: CameraArrayCalibration, board: BoardDescription, prior: LabelledCovariance | None
) -> tuple[Observation, ...]:
    if prior is None:
        return tuple(observations)
    return tuple(
        replace(
            one,
            camera_jacobian=pose_camera_jacobian(
                one.pose, {name: marks.ids for name, marks in one.seen.items() if name in cameras.cameras}, cameras, board, prior.parameters
            ),
        )
        for one in observations
    )
