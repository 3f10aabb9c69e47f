"""Calibration of one camera by Zhang's method."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.sightings import Rejection, Sighting, rms
from measureapp.data.board import BoardDescription
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform

LEAST_VIEWS = 3
BAD_VIEW_FACTOR = 3.0  # a view whose rms exceeds the median this many times was refined wrongly or shows something else
BAD_VIEW_FLOOR_PX = 0.1
_ALONE = threading.Lock()
FIXED_COEFFICIENTS = {4: cv2.CALIB_FIX_K3, 5: 0, 8: cv2.CALIB_RATIONAL_MODEL}


@dataclass(frozen=True, slots=True, eq=False)
class MonoSolution:
    """One camera's lens and the board poses it saw."""

    pinhole: PinholeCamera
    camera_from_board: dict[str, RigidTransform]  # by view
    rejected: tuple[Rejection, ...]


def calibrate_camera(
    sightings: Sequence[Sighting], board: BoardDescription, size_px: tuple[int, int], distortion_count: int = 5
) -> MonoSolution:
    """Calibrate one camera by Zhang's method [1]_, rejecting views with three times the median residual.

    Raises
    ------
    CalibrationError
        Fewer than three usable views, or views that do not determine the lens.

    References
    ----------
    .. [1] Z. Zhang, IEEE Trans. Pattern Analysis and Machine Intelligence 22(11), 1330-1334, 2000.
    """
    used = list(sightings)
    rejected: list[Rejection] = []
    while True:
        if len(used) < LEAST_VIEWS:
            raise _too_few(sightings, used, rejected)
        pinhole, poses, errors = _zhang(used, board, size_px, distortion_count)
        limit = max(BAD_VIEW_FACTOR * float(np.median(errors)), BAD_VIEW_FLOOR_PX)
        worst = int(np.argmax(errors))
        if errors[worst] <= limit:
            break
        rejected.append(Rejection(used[worst].camera, used[worst].view, bad_view_reason(errors[worst], float(np.median(errors)))))
        del used[worst]
    return MonoSolution(pinhole, {sighting.view: pose for sighting, pose in zip(used, poses, strict=True)}, tuple(rejected))


def estimate_poses(sightings: Sequence[Sighting], board: BoardDescription, pinhole: PinholeCamera) -> MonoSolution:
    """Estimate the board poses of one camera by resection with a roughly known lens; no view is rejected, since the lens may cause the residuals."""
    poses = {}
    for sighting in sightings:
        marks, flat = board.marks_mm(sighting.ids), pinhole.normalise(sighting.corners_px)
        plane = np.column_stack([marks[:, :2], np.zeros(len(marks))])
        _, turn, shift = cv2.solvePnP(plane, flat.reshape(-1, 1, 2), np.eye(3), np.zeros(5), flags=cv2.SOLVEPNP_IPPE)
        poses[sighting.view] = RigidTransform.from_vector(np.ravel(turn), np.ravel(shift), sighting.camera, "board")
    return MonoSolution(pinhole, poses, ())


def bad_view_reason(error_px: float, median_px: float) -> str:
    """Return the reason why a view was rejected."""
    return (
        f"its rms of {error_px:.2f} px is more than {BAD_VIEW_FACTOR:.0f} times the median of {median_px:.2f} px: "
        "its corners were found in a wrong place, or the image is blurred"
    )


def _zhang(
    sightings: Sequence[Sighting], board: BoardDescription, size_px: tuple[int, int], distortion_count: int
) -> tuple[PinholeCamera, list[RigidTransform], FloatArray]:
    corners = [board.marks_mm(sighting.ids).astype(np.float32) for sighting in sightings]
    pixels = [sighting.corners_px.astype(np.float32).reshape(-1, 1, 2) for sighting in sightings]
    flags = FIXED_COEFFICIENTS[distortion_count]
    camera = sightings[0].camera
    try:
        with _single_threaded():
            _, matrix, distortion, turns, shifts = cv2.calibrateCamera(corners, pixels, size_px, None, None, flags=flags)
    except cv2.error as error:
        raise CalibrationError(
            f"The views of camera {camera!r} do not determine its lens.", "Tilt the board in several directions and fill the image."
        ) from error
    if not (np.all(np.isfinite(matrix)) and np.all(np.isfinite(distortion))):
        raise CalibrationError(f"The views of camera {camera!r} do not determine its lens.", "Tilt the board in several directions.")
    pinhole = PinholeCamera(*size_px, np.asarray(matrix, np.float64), np.ravel(distortion)[:distortion_count].astype(np.float64))
    poses = [
        RigidTransform.from_vector(np.ravel(turn), np.ravel(shift), camera, "board") for turn, shift in zip(turns, shifts, strict=True)
    ]
    errors = [
        rms(pinhole.project(pose.apply(board.marks_mm(sighting.ids))) - sighting.corners_px)
        for pose, sighting in zip(poses, sightings, strict=True)
    ]
    return pinhole, poses, np.array(errors)


@contextmanager
def _single_threaded() -> Iterator[None]:
    """Keep OpenCV to one thread: several add the views up in the order in which they finish, and the last digits change from run to run."""
    with _ALONE:
        threads = cv2.getNumThreads()
        cv2.setNumThreads(1)
        try:
            yield
        finally:
            cv2.setNumThreads(threads)


def _too_few(sightings: Sequence[Sighting], used: Sequence[Sighting], rejected: Sequence[Rejection]) -> CalibrationError:
    camera = sightings[0].camera if sightings else "a camera"
    left_out = f" {len(rejected)} were rejected because they fit badly." if rejected else ""
    return CalibrationError(
        f"Camera {camera!r} has {len(used)} usable views of the board; at least {LEAST_VIEWS} are needed.{left_out}",
        "Add sharp views with the board tilted in different directions.",
    )
