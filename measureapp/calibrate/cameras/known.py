"""Calibrated cameras that stay fixed while another one, such as a projector, is added."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.agreement import reject_contradicting
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.cameras.bundle import Bundle, BundleState
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, LabelledCovariance
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform

LARGEST_DISTORTION = 8


def pad_distortion(pinhole: PinholeCamera, count: int) -> PinholeCamera:
    """Return the same lens with ``count`` coefficients, the further ones zero. Raises CalibrationError where it has more."""
    own = len(pinhole.distortion)
    if own > count:
        raise CalibrationError(
            f"The given cameras have {own} distortion coefficients, at most {LARGEST_DISTORTION} are offered.",
            "Calibrate the cameras with 4, 5 or 8 coefficients.",
        )
    return PinholeCamera(pinhole.width_px, pinhole.height_px, pinhole.matrix, np.append(pinhole.distortion, np.zeros(count - own)))


def estimate_board_poses(sightings: Sequence[Sighting], camera: CameraCalibration, board: BoardDescription) -> dict[str, RigidTransform]:
    """Estimate view -> camera_from_board by resection, in the frame named after the camera."""
    alone = CameraArrayCalibration(camera.name, {camera.name: camera})
    to_camera = RigidTransform(camera.reference_from_camera.matrix, "camera", camera.name).inverse()
    poses = {}
    for one in sightings:
        poses[one.view] = to_camera @ pose_of({camera.name: one}, alone, board).camera_from_board
    return poses


def complete_covariance(
    covariance: FloatArray,
    bundle: Bundle,
    minimum: Minimum[BundleState],
    variance: float,
    known: LabelledCovariance | None,
    labels: Sequence[str],
    held: int,
) -> FloatArray:
    """Return the covariance of all common parameters where the first ``held`` of them were given, not estimated (Schur complement).

    The estimate changes with a given parameter c by dp/dc = -H_pp⁻¹ H_pc, the condition that the gradient stays zero; to the
    covariance at fixed c this adds (dp/dc) C (dp/dc)ᵀ. Where C is not known it counts as zero.

    Parameters
    ----------
    covariance : (P, P) of the parameters of ``minimum``, in which those given are not connected with the others
    labels : of the parameters that all views share, the given ones first
    """
    shared = len(labels)
    own = np.zeros((held, held)) if known is None else known.rows_of(labels[:held])
    by_given = -covariance[held:, held:] / variance @ bundle.linearise(minimum.state).hessian[held:, :held]
    result = np.zeros((shared, shared))
    by_given = by_given[: shared - held]
    result[:held, :held] = own
    result[held:, :held] = by_given @ own
    result[:held, held:] = result[held:, :held].T
    result[held:, held:] = covariance[held:shared, held:shared] + by_given @ own @ by_given.T
    return result


def require_agreement(known: CameraArrayCalibration, sightings: Sequence[Sighting], board: BoardDescription) -> None:
    """Refuse images in most of which the given cameras contradict each other. Raises CalibrationError."""
    views: dict[str, dict[str, Sighting]] = {}
    for one in sightings:
        if one.camera in known.cameras:
            views.setdefault(one.view, {})[one.camera] = one
    reject_contradicting({view: pose_of(seen, known, board) for view, seen in views.items()})


def require_known(known: CameraArrayCalibration, sizes_px: Mapping[str, tuple[int, int]]) -> None:
    """Refuse images that do not fit the given cameras. Raises CalibrationError."""
    for name, camera in known.cameras.items():
        given = (camera.pinhole.width_px, camera.pinhole.height_px)
        if sizes_px.get(name, given) != given:
            width, height = sizes_px[name]
            raise CalibrationError(
                f"The images of camera {name!r} are {width} × {height} px, it was calibrated for {given[0]} × {given[1]} px.",
                "Use the calibration of the cameras that took the images.",
            )
