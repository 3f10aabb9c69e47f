"""Residuals of board observations against a solution of axes: predicted and observed board poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.draft.draft import Draft, Solved
from measureapp.calibrate.draft.locate import Located
from measureapp.calibrate.sightings import explain_by_refused, rms
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise


def name_poses(ids: Sequence[str], poses: FloatArray) -> dict[str, RigidTransform]:
    """Return observation -> camera_from_board for poses (N, 4, 4) that a solution predicts."""
    return {name: RigidTransform(orthonormalise(pose), "camera", "board") for name, pose in zip(ids, poses, strict=True)}


def solved_axes(
    draft: Draft, located: Located, solution: object, predicted: Mapping[str, RigidTransform], moved: Mapping[str, str]
) -> Solved:
    """Return a solution of axes, with cameras known before, and the fit of every observation.

    Parameters
    ----------
    predicted : observation that was used -> camera_from_board where the solution puts it
    moved : observation that was rejected as an outlier -> reason
    """
    cameras = draft.setup.cameras
    assert cameras is not None  # guaranteed by `Setup`
    places = {one.id: one.pose.camera_from_board for one in located.observations}
    return Solved(
        solution=solution,
        of=tuple(one.id for one in draft.observations),
        used=tuple(predicted),
        board=draft.setup.board,
        cameras=cameras,
        places=places,
        residuals_px=residuals_px(draft.observations, predicted, cameras, draft.setup.board),
        residuals_mm=residuals_mm(predicted, places, draft.setup.board),
        reasons={**located.rejected, **moved},
    )


def residuals_px(
    observations: Sequence[Observation], predicted: Mapping[str, RigidTransform], cameras: CameraArrayCalibration, board: BoardDescription
) -> dict[str, dict[str, float]]:
    """Return observation -> camera -> rms distance between its marks and where they would be with the board as predicted."""
    return {one.id: _misfit_px(predicted[one.id], one, cameras, board) for one in observations if one.id in predicted}


def residuals_mm(predicted: Mapping[str, RigidTransform], seen: Mapping[str, RigidTransform], board: BoardDescription) -> dict[str, float]:
    """Return observation -> rms distance of the board's marks between predicted and observed pose."""
    marks = board.corners_mm
    return {name: rms(place.apply(marks) - seen[name].apply(marks)) for name, place in predicted.items()}


def explain_by_rejected(error: CalibrationError, located: Located) -> CalibrationError:
    """Return the error of a solution that failed, naming the observations whose cameras contradict each other: often its cause."""
    return explain_by_refused(error, [(f"observation {name}", reason) for name, reason in located.rejected.items()])


def _misfit_px(
    place: RigidTransform, observation: Observation, cameras: CameraArrayCalibration, board: BoardDescription
) -> dict[str, float]:
    result = {}
    for name, found in observation.seen.items():
        camera = cameras.cameras[name]
        points = camera.reference_from_camera.inverse().apply(place.apply(board.marks_mm(found.ids)))
        result[name] = rms(camera.pinhole.project(points) - found.corners_px)
    return result
