"""Camera drift check: rotation of a camera since the calibration, from the phase contradictions between all cameras of a scan."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.camera_shift import ShiftEvidence, sum_evidence
from measureapp.data.validity import Drift, DriftStatus

# The calibration left rms_px for one corner; a shift common to a whole image is the mean of thousands of them and, while nothing moved,
# smaller by the square root of their number. One as large as the residual of a single corner is therefore no noise.
WATCH_FACTOR, DRIFTED_FACTOR = 1.0, 3.0  # of the residual that the calibration left
LEAST_EXPECTED_PX = 0.02  # what defocus and response of the projector do to phases differs a little from camera to camera
UNKNOWN_PX = 0.1  # where the calibration states no residual
SIGNIFICANT = 0.05  # of the variance of the noise, per residual: the errors of a good calibration explain less,
APART = 0.02  # and speak by less for one camera against another
MOTIONS = ("pitch", "yaw", "roll")  # about x, y, z of the camera: the image goes up or down, sideways, or turns
TURNS = {
    "pitch": "a pitch of {camera} below {limit}°",
    "yaw": "a yaw of {camera} below {limit}°",
    "roll": "a roll of {camera} below {limit}°",
}
WEAKEST_RAD = float(np.deg2rad(1.0))  # prior of a turn; only bounds what the images do not determine


@dataclass(frozen=True, slots=True, eq=False)
class _Turn:
    """Hypothesis that one camera alone has rotated, and its misfit."""

    camera: str
    misfit: float
    shift_px: float
    error_mm: float
    turn_deg: float


def camera_drift(evidence: Sequence[ShiftEvidence], cameras: CameraArrayCalibration) -> Drift:
    """Test whether one camera of the head has rotated since the calibration.

    Each camera in turn is supposed to have moved alone; the one whose small rotation explains the contradictions best is named, others
    beside it where they explain them as well. A shift of a camera by d looks like a turn by d over the distance of the part. All cameras
    together may have turned unseen: that is the hand-eye transform's matter, and a few views of the board tell.

    Parameters
    ----------
    evidence : of the views of one scan; none where two cameras see fringes of one direction only

    Returns
    -------
    drift : ``unknown`` without evidence
    """
    if not evidence:
        return Drift("unknown", "The images of this scan cannot show whether the cameras moved; check them with a few views of the board.")
    whole = sum_evidence(evidence)
    turns = [_fit_rotation_of_one(whole, number) for number in range(len(whole.cameras))]
    ranked = sorted(turns, key=lambda turn: turn.misfit)
    best = ranked[0]
    expected = _expected_px(cameras, best.camera)
    status = _classify(best, expected, whole)
    noise = max(1.0, best.misfit / max(whole.freedom, 1))
    likely = tuple(turn.camera for turn in ranked if turn.misfit - best.misfit <= APART * noise * whole.freedom)
    named = () if status == "good" else likely
    unseen = undetected_rotations(whole, cameras)
    return Drift(
        status,
        _sentence(status, named, best, expected),
        named,
        best.shift_px,
        expected,
        best.error_mm,
        best.turn_deg,
        {camera: {name: float(np.rad2deg(turn)) for name, turn in turns.items()} for camera, turns in unseen.items()},
        _describe_undetected(unseen, both_directions=whole.freedom > (len(whole.cameras) - 2) * whole.samples),
    )


def undetected_rotations(whole: ShiftEvidence, cameras: CameraArrayCalibration) -> dict[str, dict[str, float]]:
    """Return camera -> motion -> rotation (rad) at which `camera_drift` raises an alarm.

    An alarm needs a shift across the fringes that is larger than what the calibration left, and contradictions that the turn explains; a turn
    that moves the image along the fringes makes neither. Both grow in proportion to the turn, the first by the mean square shift of
    the image, the second by the Fisher information; with twice the standard deviation that leaves on top, 19 of 20 such turns are seen.
    """
    found: dict[str, dict[str, float]] = {}
    for number, name in enumerate(whole.cameras):
        own = slice(3 * number, 3 * number + 3)
        expected = _expected_px(cameras, name) * WATCH_FACTOR
        information = np.maximum(np.diag(whole.information)[own], 1 / WEAKEST_RAD**2)
        by_image = expected / np.sqrt(np.maximum(np.diag(whole.image_px2[number]), 1e-12))
        by_contradiction = np.sqrt(SIGNIFICANT * max(whole.freedom, 1) / information)
        least = np.minimum(np.maximum(by_image, by_contradiction) + 2 / np.sqrt(information), np.pi)
        found[name] = dict(zip(MOTIONS, least.tolist(), strict=True))
    return found


def _expected_px(cameras: CameraArrayCalibration, name: str) -> float:
    return max(cameras.cameras[name].rms_px or UNKNOWN_PX, LEAST_EXPECTED_PX)


def _describe_undetected(unseen: dict[str, dict[str, float]], *, both_directions: bool) -> str:
    worst = {camera: max(turns, key=lambda motion: turns[motion]) for camera, turns in unseen.items()}
    limits = [TURNS[motion].format(camera=camera, limit=f"{np.rad2deg(unseen[camera][motion]):.2g}") for camera, motion in worst.items()]
    listed = ", ".join(limits[:-1]) + " or " + limits[-1]
    if both_directions:
        return f"This scan would not show {listed}; a few views of the board would."
    return f"This scan would not show {listed}; fringes of both directions, or a few views of the board, would."


def _fit_rotation_of_one(whole: ShiftEvidence, number: int) -> _Turn:
    own = slice(3 * number, 3 * number + 3)
    information = whole.information[own, own] + np.eye(3) / WEAKEST_RAD**2
    turn = np.linalg.solve(information, whole.gradient[own])
    return _Turn(
        whole.cameras[number],
        float(whole.misfit - whole.gradient[own] @ turn),
        _size(turn, whole.image_px2[number]),
        _size(turn, whole.depth_mm2[number]),
        float(np.rad2deg(np.sqrt(turn @ turn))),
    )


def _size(turn: FloatArray, square: FloatArray) -> float:
    return float(np.sqrt(max(float(turn @ square @ turn), 0.0)))


def _classify(best: _Turn, expected_px: float, whole: ShiftEvidence) -> DriftStatus:
    explained = (whole.misfit - best.misfit) / max(whole.freedom, 1)
    if best.shift_px <= WATCH_FACTOR * expected_px or explained <= SIGNIFICANT:
        return "good"
    return "drifted" if best.shift_px > DRIFTED_FACTOR * expected_px else "watch"


def _sentence(status: DriftStatus, named: Sequence[str], best: _Turn, expected_px: float) -> str:
    size = f"{best.shift_px:.3f} px"
    if status == "good":
        return f"Camera drift check: passed; none is off by more than {size}, and the calibration left {expected_px:.3f} px."
    who = f"Camera {named[0]}" if len(named) == 1 else f"One of the cameras {' and '.join(named)}"
    advice = {
        "watch": "check the calibration with a few views of the board before the next measurement that matters.",
        "drifted": "it was knocked or refocused, or its mounting gave way: calibrate the cameras again.",
    }[status]
    return (
        f"{who} has turned by {best.turn_deg:.3f}° since the calibration: its image is off by {size} (the calibration left {expected_px:.3f} px), "
        f"which moves measured points by {best.error_mm:.3f} mm; {advice}"
    )
