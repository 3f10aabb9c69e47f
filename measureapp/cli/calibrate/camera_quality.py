"""Uncertainty map and cross-validation of `calibrate cameras` and `calibrate projector`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measureapp.errors import CalibrationError, InputError

if TYPE_CHECKING:
    from measureapp.calibrate.cameras.array import CameraArrayProblem, CameraArraySolution
    from measureapp.calibrate.cameras.validation import CrossValidation
    from measureapp.data.uncertainty import UncertaintyMap
    from measureapp.progress import Progress

PICTURE = ".png"


@dataclass(frozen=True, slots=True, eq=False)
class Quality:
    """The uncertainty map and the cross-validation, or the reasons for their absence."""

    uncertainty: UncertaintyMap | None
    validation: CrossValidation | None
    reasons: tuple[str, ...]


def quality_of(problem: CameraArrayProblem, solution: CameraArraySolution, standoff_mm: float | None, progress: Progress) -> Quality:
    """Compute uncertainty map and cross-validation of a solution; where one cannot be computed, its reason."""
    import numpy as np

    from measureapp.calibrate.cameras.uncertainty import observed_volume, uncertainty_map

    places = np.array([pose.apply(solution.board.middle_mm) for pose in solution.boards.values()])
    reasons, uncertainty = [], None
    try:
        volume = observed_volume(solution.calibration, places, standoff_mm)
        uncertainty = uncertainty_map(solution.calibration, solution.parameters, solution.covariance, volume)
    except CalibrationError as error:
        reasons.append(f"No uncertainty map: {error.message}")
    validated = validation_of(problem, solution, progress)
    return Quality(uncertainty, validated.validation, (*reasons, *validated.reasons))


def validation_of(problem: CameraArrayProblem, solution: CameraArraySolution, progress: Progress) -> Quality:
    """Return what views held back say of a solution, or the reason for their rejectionhing; without an uncertainty map."""
    from measureapp.calibrate.cameras.validation import cross_validate

    try:
        return Quality(None, cross_validate(problem, solution, progress=progress), ())
    except CalibrationError as error:
        return Quality(None, None, (f"No cross-validation: {error.message}",))


def quality_answer(quality: Quality) -> dict[str, Any]:
    """Return its part of the JSON answer."""
    answer: dict[str, Any] = {"not_judged": list(quality.reasons)}
    if quality.validation is not None:
        validation = quality.validation
        answer["cross_validation"] = {
            "healthy": validation.healthy,
            "verdict": validation.verdict,
            "observed_px": validation.observed_px,
            "predicted_px": validation.predicted_px,
            "halves": [
                {"camera": half.camera, "difference_px": half.difference_px, "predicted_px": half.predicted_px}
                for half in validation.halves
            ],
            "views": [{"view": one.view, "observed_px": one.observed_px, "predicted_px": one.predicted_px} for one in validation.views],
        }
    if quality.uncertainty is not None:
        found = quality.uncertainty
        answer["uncertainty"] = {
            "sentence": found.sentence,
            "projection": {
                name: {"range_mm": one.range_mm, "least_px": float(one.sigma_px.min()), "worst_px": float(one.sigma_px.max())}
                for name, one in found.projection.items()
            },
        }
        if found.volume is not None:
            answer["uncertainty"]["volume"] = {
                "points": len(found.volume.points_mm),
                "shape_rms_mm": found.volume.shape_rms_mm,
                "length_mm": found.volume.length_mm,
                "length_sigma_mm": found.volume.length_sigma_mm,
                "worst_length_sigma_mm": found.volume.worst_length_sigma_mm,
                "worst_length_at_mm": found.volume.worst_length_at_mm,
            }
    return answer


def quality_lines(quality: Quality) -> list[str]:
    """Return its lines for people."""
    lines = [] if quality.validation is None else [quality.validation.verdict]
    lines += [] if quality.uncertainty is None else [quality.uncertainty.sentence]
    return lines + list(quality.reasons)


def write_map(path: Path, quality: Quality) -> dict[str, Path]:
    """Write the uncertainty map and its picture next to it; return their paths by name. Raises InputError where there is none."""
    from measureapp.project.calibration.uncertainty_maps import write_uncertainty, write_uncertainty_picture

    if quality.uncertainty is None:
        raise InputError("; ".join(quality.reasons), "Omit --uncertainty-map, or give --standoff-mm.")
    picture = path.with_suffix(PICTURE)
    if picture == path:
        raise InputError(f"--uncertainty-map {path} would be overwritten by its picture.", "Give it the suffix .npz.")
    write_uncertainty(path, quality.uncertainty)
    write_uncertainty_picture(picture, quality.uncertainty)
    return {"uncertainty_map": path, "uncertainty_picture": picture}
