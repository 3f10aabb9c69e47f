"""Common parts of the calibrations of lenses: cameras, the projector, and a rig that calibrates its cameras too."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.calibrate.cameras.array import CameraArrayProblem, CameraArraySolution
from measureapp.calibrate.cameras.array import solve as solve_array
from measureapp.calibrate.cameras.projector_sightings import device_title
from measureapp.calibrate.cameras.uncertainty import POSE_NAMES
from measureapp.calibrate.cameras.validation import CrossValidation, cross_validate
from measureapp.calibrate.draft.comparison import Comparison, changes_between, millimetres, sigma_ratio
from measureapp.calibrate.draft.draft import Draft, Effect, Solved
from measureapp.calibrate.draft.estimate import camera_estimates
from measureapp.calibrate.kinds.on_part import (
    fitting_length_mm,
    length_uncertainty,
    shape_difference_mm,
    sideways_difference_mm,
    sideways_sigma_mm,
    volume_of,
)
from measureapp.calibrate.poses import change_between
from measureapp.calibrate.projection import intrinsic_names
from measureapp.calibrate.sightings import Rejection, rms
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.conditions import LensSetting
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.progress import Progress

ENOUGH_VIEWS = 24  # of a calibration that only has to tell parts of a board apart


def lens_problem(draft: Draft, names: Sequence[str]) -> CameraArrayProblem:
    """Return the problem of the lenses of these names, of which the projector may be one."""
    setup = draft.setup
    sizes = {name: size for name, size in draft.sizes_px.items() if name in names}
    sightings = tuple(marks.of(camera, one.id) for one in draft.observations for camera, marks in one.seen.items() if camera in names)
    return CameraArrayProblem(setup.board, setup.reference, sizes, sightings, distortion_count=setup.distortion_count)


def camera_problem(draft: Draft, rejected: Sequence[Rejection] = ()) -> CameraArrayProblem:
    """Return the problem of the cameras. Raises CalibrationError where one has no images yet.

    Parameters
    ----------
    rejected : images in which the board was not found, for the list of what was rejected
    """
    missing = [name for name in draft.setup.camera_names if name not in draft.sizes_px]
    if missing:
        raise CalibrationError(f"Camera {missing[0]!r} has no images yet.", "Give one image per camera with every observation.")
    return replace(lens_problem(draft, draft.setup.camera_names), rejected=tuple(rejected))


def solve_cameras(draft: Draft, progress: Progress, *, roughly: bool = False) -> Solved:
    """Calibrate the cameras of a draft; ``roughly``: from some views, with the board's marks where it has them. Raises CalibrationError."""
    if roughly:
        draft = _some_views(draft)
    start = None if draft.solved is None else draft.solved.camera_solution
    solution = solve_array(replace(camera_problem(draft), free_marks=not roughly), progress, start)
    return solved_cameras(draft, with_devices(solution, draft.setup.serials))


def _some_views(draft: Draft) -> Draft:
    """Return a draft of few observations, evenly spread over those in which most cameras see the board; the same one if it has no more."""
    most = max((len(one.seen) for one in draft.observations), default=0)
    best = [one for one in draft.observations if len(one.seen) == most]
    if len(best) <= ENOUGH_VIEWS:
        return draft
    chosen = np.linspace(0, len(best) - 1, ENOUGH_VIEWS).round().astype(int)
    return replace(draft, observations=tuple(best[index] for index in chosen))


def solved_cameras(draft: Draft, solution: CameraArraySolution) -> Solved:
    """Return a solution of cameras with the fit of every observation."""
    residuals: dict[str, dict[str, float]] = {}
    for view in solution.views:
        residuals.setdefault(view.view, {})[view.camera] = view.rms_px
    reasons: dict[str, list[str]] = {}
    for rejection in solution.rejected:
        reasons.setdefault(rejection.view, []).append(f"{device_title(rejection.camera)}: {rejection.reason}.")
    for corner in solution.rejected_corners:
        reasons.setdefault(corner.view, []).append(f"{device_title(corner.camera)}: corner {corner.corner} rejected, it {corner.reason}.")
    return Solved(
        solution=solution,
        of=tuple(one.id for one in draft.observations),
        used=tuple(one.id for one in draft.observations if one.id in residuals),
        board=solution.board,
        cameras=solution.calibration,
        places=dict(solution.boards),
        camera_solution=solution,
        residuals_px=residuals,
        reasons={name: " ".join(lines) for name, lines in reasons.items()},
    )


def with_devices(
    solution: CameraArraySolution, serials: Mapping[str, str], lenses: Mapping[str, LensSetting] | None = None
) -> CameraArraySolution:
    """Return the solution with the serial numbers of its cameras and the settings of their lenses."""
    calibration = solution.calibration
    cameras = {
        name: replace(camera, serial=serials.get(name, ""), lens=(lenses or {}).get(name, LensSetting()))
        for name, camera in calibration.cameras.items()
    }
    return replace(solution, calibration=replace(calibration, cameras=cameras))


def effect_of_cameras(draft: Draft, solution: CameraArraySolution) -> Effect:
    """Return what cameras contribute to a length in the volume where the board was shown, or a single one across its line of sight."""
    setup = draft.setup
    volume = volume_of(solution, setup.standoff_mm)
    if len(solution.calibration.cameras) == 1:
        value = COVERAGE_FACTOR * sideways_sigma_mm(solution, volume.standoff_mm)
        place = f"a point {volume.standoff_mm:.0f} mm in front of the camera"
        return Effect(value, f"Moves {place} by up to {millimetres(value)} (k = 2) across its line of sight")
    found = length_uncertainty(solution, volume, fitting_length_mm(volume, setup.length_mm))
    value, worst = COVERAGE_FACTOR * found.length_sigma_mm, COVERAGE_FACTOR * found.worst_length_sigma_mm
    return Effect(
        value, f"Adds {millimetres(value)} (k = 2), at worst {millimetres(worst)}, to a length of {found.length_mm:g} mm in this volume"
    )


def compare_cameras(previous: CameraArrayCalibration, draft: Draft, solution: CameraArraySolution) -> Comparison:
    """Compare calibrated cameras with earlier ones. Raises CalibrationError where they are not the same cameras.

    Earlier cameras may come without their covariance; its effect on the part is that of the new one, scaled by the ratio of their
    standard deviations (equal where none are stated).
    """
    new, setup = solution.calibration, draft.setup
    if set(new.cameras) != set(previous.cameras) or new.reference != previous.reference:
        raise CalibrationError(
            f"The previous calibration is one of {', '.join(previous.cameras)} with {previous.reference} as reference, "
            f"the new one of {', '.join(new.cameras)} with {new.reference}.",
            "Compare calibrations of the same cameras.",
        )
    changes = tuple(changes_between(camera_estimates(previous), camera_estimates(new)))
    volume = volume_of(solution, setup.standoff_mm)
    both = float(np.hypot(1.0, sigma_ratio(previous, new)))
    normalised = _normalised_change(previous, solution) / both
    if len(new.cameras) == 1:
        lens = new.cameras[new.reference].pinhole
        moved = sideways_difference_mm(lens, previous.cameras[new.reference].pinhole, volume.standoff_mm)
        expanded = both * COVERAGE_FACTOR * sideways_sigma_mm(solution, volume.standoff_mm)
        what = f"points {volume.standoff_mm:.0f} mm in front of the camera (rms, across the line of sight)"
        return Comparison(changes, moved, expanded, what, normalised)
    found = length_uncertainty(solution, volume, fitting_length_mm(volume, setup.length_mm))
    moved = shape_difference_mm(new, previous, volume)
    return Comparison(
        changes, moved, both * COVERAGE_FACTOR * found.shape_rms_mm, "points of the volume relative to each other (rms)", normalised
    )


def cross_validate_cameras(draft: Draft, solved: Solved, progress: Progress | None) -> CrossValidation | None:
    """Test the stated uncertainty of the cameras of a solution with held-back views; None where they were known before."""
    if solved.camera_solution is None:
        return None
    entered = replace(draft, observations=tuple(one for one in draft.observations if one.id in solved.of))
    return cross_validate(camera_problem(entered), solved.camera_solution, progress=progress)


def mark_warnings(solution: CameraArraySolution | None) -> tuple[str, ...]:
    """Say that the marks of the board are displaced by more than is stated of it; their displacements were estimated all the same."""
    if solution is None or solution.scatter is None or solution.board.displaced_mm is None:
        return ()
    board, lengths = solution.board, solution.board.lengths
    stated = 0.0 if lengths is None else COVERAGE_FACTOR * lengths.relative_sigma * float(np.ptp(board.flat_corners_mm, axis=0).max())
    if solution.scatter.rms_mm <= stated:
        return ()
    displaced = np.array(board.displaced_mm)
    away = np.linalg.norm(displaced, axis=1)
    worst = int(np.argmax(away))
    beyond = "" if lengths is None else f", beyond what is stated of it ({lengths.words})"
    return (
        f"The marks of the board are displaced by {millimetres(rms(displaced))} (rms){beyond}, the one in row "
        f"{worst // board.columns + 1}, column {worst % board.columns + 1} by {millimetres(float(away[worst]))}: their places were "
        "estimated with the cameras. Have the board certified, or use a better one.",
    )


def _normalised_change(previous: CameraArrayCalibration, solution: CameraArraySolution) -> float:
    """Return the rms difference of all values by the new calibration's covariance: the root of Mahalanobis' distance over their number."""
    changes: dict[str, float] = {}
    for name, camera in solution.calibration.cameras.items():
        other = previous.cameras[name]
        lens = [np.array(_lens_values(one)) for one in (other, camera)]
        count = min(len(values) for values in lens)
        labels = [f"{name}.{label}" for label in intrinsic_names(len(camera.pinhole.distortion))][:count]
        changes |= dict(zip(labels, (lens[1][:count] - lens[0][:count]).tolist(), strict=True))
        place = change_between(other.reference_from_camera.matrix[None], camera.reference_from_camera.matrix[None])[0]
        changes |= dict(zip((f"{name}.{label}" for label in POSE_NAMES), place.tolist(), strict=True))
    known = [index for index, label in enumerate(solution.parameters) if label in changes]
    step = np.array([changes[solution.parameters[index]] for index in known])
    covariance = solution.covariance[np.ix_(known, known)]
    scale = np.sqrt(np.diag(covariance))
    whitened = step / scale
    return float(np.sqrt(whitened @ np.linalg.solve(covariance / np.outer(scale, scale), whitened) / len(step)))


def _lens_values(camera: CameraCalibration) -> list[float]:
    matrix = camera.pinhole.matrix
    return [float(value) for value in (matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *camera.pinhole.distortion)]
