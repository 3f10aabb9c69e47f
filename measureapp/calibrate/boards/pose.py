"""Resection: pose of the board from its corners in all cameras, with its information matrix."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeVar

import cv2
import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.calibrate.least_squares import NormalEquations, minimise
from measureapp.calibrate.poses import apply_changes
from measureapp.calibrate.projection import cross_matrices, project_with_derivatives
from measureapp.calibrate.sightings import Sighting, rms
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise

ASSUMED_SIGMA_PX = 0.1
LEAST_SIGMA_PX = 0.02
Name = TypeVar("Name")
Seen = tuple[CameraCalibration, FloatArray, FloatArray]  # camera, pixels (N, 2), marks on the board (N, 3)


@dataclass(frozen=True, slots=True, eq=False)
class BoardPose:
    """A pose of the board in the reference camera's frame.

    `information` is the inverse covariance (6, 6) of a small change (ω, τ) of the pose: R' = exp(ω) R, t' = t + τ.
    """

    camera_from_board: RigidTransform
    information: FloatArray
    rms_px: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "information", read_only(self.information, np.float64, (6, 6)))


def stated_pose(camera_from_board: RigidTransform, sigma_rad: float, sigma_mm: float) -> BoardPose:
    """Return a pose whose noise is stated instead of following from images."""
    return BoardPose(camera_from_board, np.diag([sigma_rad**-2.0] * 3 + [sigma_mm**-2.0] * 3))


def board_pose(
    corners_px: Mapping[str, FloatArray],
    cameras: CameraArrayCalibration,
    board: BoardDescription,
    corner_sigma_px: float = ASSUMED_SIGMA_PX,
    ids: Mapping[str, IntArray] | None = None,
) -> BoardPose:
    """Estimate camera_from_board by least squares over the corners in all cameras that detected the board (resection).

    Parameters
    ----------
    corners_px : camera -> corners (N, 2), ordered like ``board.corners_mm``
    corner_sigma_px : standard deviation of one coordinate of a corner, from the camera calibration
    ids : camera -> which corners (N,) it detected, if not all

    Raises
    ------
    CalibrationError
        No camera saw the board, or a camera is not among ``cameras``.
    """
    unknown = [name for name in corners_px if name not in cameras.cameras]
    if unknown or not corners_px:
        raise CalibrationError(
            f"Camera {unknown[0]!r} is not calibrated." if unknown else "No camera saw the board.",
            "Use the calibration of the cameras that took the images: " + ", ".join(cameras.cameras) + ".",
        )
    seen = [
        (cameras.cameras[name], np.asarray(pixels, float), board.marks_mm((ids or {}).get(name))) for name, pixels in corners_px.items()
    ]
    start = min((_first_guess(*one) for one in seen), key=lambda pose: _cost(pose, seen))
    minimum = minimise(
        start,
        lambda pose: _normal(pose, seen),
        lambda pose: _cost(pose, seen),
        lambda pose, step: np.asarray(apply_changes(pose, step)),
        iterations=30,
    )
    pose = RigidTransform(orthonormalise(minimum.state), "camera", "board")
    residuals = np.concatenate([_residuals(minimum.state, *one) for one in seen])
    return BoardPose(pose, minimum.hessian / corner_sigma_px**2, rms(residuals))


def pose_of(
    seen: Mapping[str, Sighting], cameras: CameraArrayCalibration, board: BoardDescription, corner_sigma_px: float = ASSUMED_SIGMA_PX
) -> BoardPose:
    """Find camera_from_board from the sightings of several cameras at the same time (camera -> marks); as `board_pose`."""
    corners = {camera: one.corners_px for camera, one in seen.items()}
    return board_pose(corners, cameras, board, corner_sigma_px, {camera: one.ids for camera, one in seen.items()})


def with_residual_noise(poses: Mapping[Name, BoardPose]) -> dict[Name, BoardPose]:
    """Scale the information of poses found with the assumed noise of corners to the noise that the residuals of all of them show."""
    if not poses:
        return {}
    sigma = max(float(np.sqrt(np.mean([pose.rms_px**2 for pose in poses.values()]) / 2)), LEAST_SIGMA_PX)
    return {name: replace(pose, information=pose.information * (ASSUMED_SIGMA_PX / sigma) ** 2) for name, pose in poses.items()}


def triangulate(corners_px: Mapping[str, FloatArray], cameras: CameraArrayCalibration) -> FloatArray:
    """Return the points (N, 3) in the reference camera's frame nearest to the rays of two or more cameras."""
    normal, right = np.zeros((1, 3, 3)), np.zeros((1, 3))
    for name, pixels in corners_px.items():
        camera = cameras.cameras[name]
        rays = camera.reference_from_camera.rotate(camera.pinhole.rays(np.asarray(pixels, float)))
        across = np.eye(3) - rays[:, :, None] * rays[:, None, :]
        normal = normal + across
        right = right + across @ camera.reference_from_camera.translation_mm
    return np.asarray(np.linalg.solve(normal, right[..., None])[..., 0])


def _flat(marks_mm: FloatArray) -> FloatArray:
    return np.column_stack([marks_mm[:, :2], np.zeros(len(marks_mm))])


def _first_guess(camera: CameraCalibration, pixels: FloatArray, marks_mm: FloatArray) -> FloatArray:
    flat = camera.pinhole.normalise(pixels)
    _, turns, shifts, errors = cv2.solvePnPGeneric(_flat(marks_mm), flat.reshape(-1, 1, 2), np.eye(3), np.zeros(5), flags=cv2.SOLVEPNP_IPPE)
    best = int(np.argmin(np.ravel(errors)))
    in_camera = RigidTransform.from_vector(np.ravel(turns[best]), np.ravel(shifts[best]), camera.name, "board")
    place = camera.reference_from_camera
    return np.asarray((RigidTransform(place.matrix, "camera", camera.name) @ in_camera).matrix)


def _in_camera(pose: FloatArray, camera: CameraCalibration, marks_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    turned = marks_mm @ pose[:3, :3].T
    place = camera.reference_from_camera
    return turned, (turned + pose[:3, 3] - place.translation_mm) @ place.rotation


def _residuals(pose: FloatArray, camera: CameraCalibration, pixels: FloatArray, marks_mm: FloatArray) -> FloatArray:
    return camera.pinhole.project(_in_camera(pose, camera, marks_mm)[1]) - pixels


def _cost(pose: FloatArray, seen: list[Seen]) -> float:
    return sum(float(np.sum(_residuals(pose, *one) ** 2)) for one in seen)


def _normal(pose: FloatArray, seen: list[Seen]) -> NormalEquations:
    hessian, gradient = np.zeros((6, 6)), np.zeros(6)
    for camera, pixels, marks_mm in seen:
        turned, points = _in_camera(pose, camera, marks_mm)
        projected, by_point, _ = project_with_derivatives(camera.pinhole, points)
        by_reference = by_point @ camera.reference_from_camera.rotation.T
        jacobian = np.concatenate([-by_reference @ cross_matrices(turned), by_reference], axis=2).reshape(-1, 6)
        hessian += jacobian.T @ jacobian
        gradient += jacobian.T @ (projected - pixels).ravel()
    return NormalEquations(hessian, gradient, _cost(pose, seen))
