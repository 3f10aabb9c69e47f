"""Has a camera turned since the calibration? Any scan tells which, by how far the phases of all cameras contradict each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.camera_shift import ShiftEvidence, together
from measureapp.data.validity import Drift, Standing

# The calibration left rms_px for one corner; a shift common to a whole image is the mean of thousands of them and, while nothing moved,
# smaller by the square root of their number. One as large as the residual of a single corner is therefore no noise.
WATCH_FACTOR, DRIFTED_FACTOR = 1.0, 3.0  # of the residual that the calibration left
LEAST_EXPECTED_PX = 0.02  # what defocus and response of the projector do to phases differs a little from camera to camera
UNKNOWN_PX = 0.1  # where the calibration does not say what it left
TELLING = 0.05  # of the variance of the noise, per residual: the errors of a good calibration explain less,
APART = 0.02  # and speak by less for one camera against another
WEAKEST_RAD = float(np.deg2rad(1.0))  # prior of a turn; only bounds what the images do not determine


@dataclass(frozen=True, slots=True, eq=False)
class _Turn:
    """One camera alone has turned: how well that explains the scan."""

    camera: str
    misfit: float
    shift_px: float
    error_mm: float
    turn_deg: float


def camera_drift(evidence: Sequence[ShiftEvidence], cameras: CameraArrayCalibration) -> Drift:
    """Say whether one camera of the head turned since the calibration, and which.

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
        return Drift("unknown", "The images of this scan cannot tell whether the cameras moved; check them with a few views of the board.")
    whole = together(evidence)
    turns = [_turned_alone(whole, number) for number in range(len(whole.cameras))]
    ranked = sorted(turns, key=lambda turn: turn.misfit)
    best = ranked[0]
    left = cameras.cameras[best.camera].rms_px or UNKNOWN_PX
    expected = max(left, LEAST_EXPECTED_PX)
    standing = _standing(best, expected, whole)
    noise = max(1.0, best.misfit / max(whole.freedom, 1))
    likely = tuple(turn.camera for turn in ranked if turn.misfit - best.misfit <= APART * noise * whole.freedom)
    named = () if standing == "good" else likely
    sentence = _sentence(standing, named, best, expected)
    return Drift(standing, sentence, named, best.shift_px, expected, best.error_mm, best.turn_deg)


def _turned_alone(whole: ShiftEvidence, number: int) -> _Turn:
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


def _standing(best: _Turn, expected_px: float, whole: ShiftEvidence) -> Standing:
    explained = (whole.misfit - best.misfit) / max(whole.freedom, 1)
    if best.shift_px <= WATCH_FACTOR * expected_px or explained <= TELLING:
        return "good"
    return "drifted" if best.shift_px > DRIFTED_FACTOR * expected_px else "watch"


def _sentence(standing: Standing, named: Sequence[str], best: _Turn, expected_px: float) -> str:
    size = f"{best.shift_px:.3f} px"
    if standing == "good":
        return f"The cameras stand as they were calibrated: none is off by more than {size}, and the calibration left {expected_px:.3f} px."
    who = f"Camera {named[0]} has" if len(named) == 1 else f"One of the cameras {' and '.join(named)} has"
    advice = {
        "watch": "check the calibration with a few views of the board before the next measurement that matters.",
        "drifted": "it was knocked or refocused, or its mounting gave way: calibrate the cameras again.",
    }[standing]
    return (
        f"{who} turned by {best.turn_deg:.3f}° since the calibration: its image is off by {size} (the calibration left {expected_px:.3f} px), "
        f"which moves measured points by {best.error_mm:.3f} mm; {advice}"
    )
