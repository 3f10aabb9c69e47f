"""Have the cameras moved against each other since they were calibrated? Any scan can tell, by how far its matches lie off their epipolar lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.errors import CalibrationError

WATCH_FACTOR, DRIFTED_FACTOR = 2.0, 4.0  # of what the calibration left
LEAST_EXPECTED_PX = 0.05  # a calibration cannot promise less for the matches of a scan
LEAST_MATCHES = 100


@dataclass(frozen=True, slots=True)
class Finding:
    """What a check found, in a sentence with its numbers."""

    verdict: str  # "good", "watch" or "drifted"
    sentence: str
    residual_px: float
    expected_px: float
    error_mm: float  # what the residual amounts to on the part, across the line of sight


def epipolar_drift(
    calibration_residual_px: float, scan_residuals_px: FloatArray, cameras: CameraArrayCalibration, distance_mm: float
) -> Finding:
    """Compare the epipolar residuals of a scan with what the calibration left.

    Matching along rows of equal phase cannot see a shift along the row; what is across shows that the head was knocked, warmed up,
    or refocused. The median of the absolute residuals is taken, since wrong matches are not a drift.

    Parameters
    ----------
    calibration_residual_px : rms reprojection residual of the calibration
    scan_residuals_px : (N,) signed distances of matched points from their epipolar lines, or of points from their rays, px
    distance_mm : from the cameras to the part

    Raises
    ------
    CalibrationError
        Too few matches to say anything, or residuals that are not finite.
    """
    residuals = np.asarray(scan_residuals_px, float).ravel()
    if len(residuals) < LEAST_MATCHES or not np.all(np.isfinite(residuals)):
        raise CalibrationError(
            f"{int(np.isfinite(residuals).sum())} finite epipolar residuals do not tell whether the cameras moved.",
            f"Give those of at least {LEAST_MATCHES} matched points of one scan.",
        )
    offset = float(np.median(residuals))
    spread = 1.4826 * float(np.median(np.abs(residuals - offset)))
    size = float(np.hypot(offset, spread))
    expected = max(calibration_residual_px, LEAST_EXPECTED_PX)
    focal = float(np.mean([camera.pinhole.matrix[0, 0] for camera in cameras.cameras.values()]))
    error = size * distance_mm / focal
    verdict = "drifted" if size > DRIFTED_FACTOR * expected else "watch" if size > WATCH_FACTOR * expected else "good"
    advice = {
        "good": "the cameras stand as they were calibrated.",
        "watch": "check the calibration with a few board views before the next measurement that matters.",
        "drifted": "the cameras moved, were refocused or are at another temperature: calibrate them again.",
    }[verdict]
    sentence = (
        f"Matches lie {size:.3f} px ({error:.3f} mm at {distance_mm:.0f} mm) off their epipolar lines, of which {abs(offset):.3f} px is the "
        f"same everywhere; the calibration left {calibration_residual_px:.3f} px: {advice}"
    )
    return Finding(verdict, sentence, size, expected, error)
