"""Derivatives of board poses with respect to camera parameters (implicit function theorem)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.poses import apply_changes
from measureapp.calibrate.projection import apply_intrinsic_changes, cross_matrices, intrinsic_names, project_with_derivatives
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.transform import RigidTransform, orthonormalise

POSE_NAMES = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")
BOW_LABELS = ("board.bow_xx_mm", "board.bow_xy_mm", "board.bow_yy_mm")


def pose_camera_jacobian(
    pose: BoardPose,
    seen_by: Mapping[str, IntArray | None],
    cameras: CameraArrayCalibration,
    board: BoardDescription,
    parameters: Sequence[str],
) -> FloatArray:
    """Return the derivatives (6, C) of a board pose found by least squares with respect to the parameters of the cameras.

    Where the sum of squared pixel errors is least, its gradient by the pose stays zero while a parameter c changes:
    dp/dc = -(∂r/∂p ᵀ ∂r/∂p)⁻¹ ∂r/∂p ᵀ ∂r/∂c. Together with the pose's information at fixed cameras this propagates the whole bundle
    adjustment, without its corners.

    Parameters
    ----------
    seen_by : cameras that detected the board -> which of its marks, or None for all
    parameters : labels of the columns; one that no camera here has (another camera's) gives zeros
    """
    column = {label: index for index, label in enumerate(parameters)}
    normal, mixed = np.zeros((6, 6)), np.zeros((6, len(parameters)))
    for name, ids in seen_by.items():
        by_pose, by_own, labels = derivatives(pose, cameras.cameras[name], board, ids)
        normal += by_pose.T @ by_pose
        known = [index for index, label in enumerate(labels) if label in column]
        mixed[:, [column[labels[index]] for index in known]] += by_pose.T @ by_own[:, known]
    return np.asarray(-np.linalg.solve(normal, mixed))


def derivatives(
    pose: BoardPose, camera: CameraCalibration, board: BoardDescription, ids: IntArray | None = None
) -> tuple[FloatArray, FloatArray, tuple[str, ...]]:
    """Return the derivatives of the corners in pixels by the board's pose (2 N, 6), and by camera and bow (2 N, K), labelled."""
    place = camera.reference_from_camera
    turned = board.marks_mm(ids) @ pose.camera_from_board.rotation.T
    from_centre = turned + pose.camera_from_board.translation_mm - place.translation_mm
    _, by_point, by_lens = project_with_derivatives(camera.pinhole, from_centre @ place.rotation)
    by_reference = by_point @ place.rotation.T
    by_pose = np.concatenate([-by_reference @ cross_matrices(turned), by_reference], axis=2)
    by_place = np.concatenate([by_reference @ cross_matrices(from_centre), -by_reference], axis=2)
    terms = board.bow_terms if ids is None else board.bow_terms[ids]
    by_bow = (by_reference @ pose.camera_from_board.rotation[:, 2])[:, :, None] * terms[:, None, :]
    own = np.concatenate([by_lens, by_place, by_bow], axis=2)
    names = (*intrinsic_names(len(camera.pinhole.distortion)), *POSE_NAMES)
    labels = (*(f"{camera.name}.{name}" for name in names), *BOW_LABELS)
    return by_pose.reshape(-1, 6), own.reshape(-1, own.shape[2]), labels


def perturb_cameras(cameras: CameraArrayCalibration, parameters: Sequence[str], change: FloatArray) -> CameraArrayCalibration:
    """Return the cameras after a change (C,) of their labelled parameters; the board's bow is not theirs."""
    steps = dict(zip(parameters, change, strict=True))
    result = {}
    for name, camera in cameras.cameras.items():
        lens = np.array([steps.get(f"{name}.{label}", 0.0) for label in intrinsic_names(len(camera.pinhole.distortion))])
        place = np.array([steps.get(f"{name}.{label}", 0.0) for label in POSE_NAMES])
        matrix = orthonormalise(apply_changes(camera.reference_from_camera.matrix, place))
        result[name] = replace(
            camera, pinhole=apply_intrinsic_changes(camera.pinhole, lens), reference_from_camera=RigidTransform(matrix, "camera", name)
        )
    return replace(cameras, cameras=result)
