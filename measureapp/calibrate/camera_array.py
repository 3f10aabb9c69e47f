"""All cameras of the head: each alone by Zhang's method, then in pairs, then all in one bundle adjustment."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.board import require_unambiguous
from measureapp.calibrate.bundle import Bundle, BundleState, Sight, adjust, robust_bundle, robust_sigma
from measureapp.calibrate.camera import (
    BAD_VIEW_FACTOR,
    BAD_VIEW_FLOOR_PX,
    FIXED_COEFFICIENTS,
    LEAST_VIEWS,
    bad_view_reason,
    calibrate_camera,
)
from measureapp.calibrate.camera_pairs import LoopCheck, contradictions, loops, placed_from_reference
from measureapp.calibrate.poses import inverted
from measureapp.calibrate.projection import intrinsic_names
from measureapp.calibrate.sightings import Rejection, Sighting, ViewResidual, rms
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, Provenance
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalised
from measureapp.progress import NoProgress, PartOf, Progress

ROUNDS = 3  # adjust, leave out what does not fit, adjust again
BAD_CORNER_FACTOR = 6.0
WEAK_FOCAL_SHARE = 0.05
LEAST_SIGHTS_FOR_BOW = 12
BOW_NAMES = ("board.bow_xx_mm", "board.bow_xy_mm", "board.bow_yy_mm")
POSE_NAMES = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")


@dataclass(frozen=True, slots=True, eq=False)
class CameraArrayProblem:
    """Everything the solution depends on."""

    board: CheckerboardDescription
    reference: str
    sizes_px: Mapping[str, tuple[int, int]]  # camera -> (width, height)
    sightings: tuple[Sighting, ...]
    rejected: tuple[Rejection, ...] = ()
    distortion_count: int = 5  # 4, 5 or 8 coefficients
    free_bow: bool = True  # estimate the board's departure from flat, where there are enough sightings


@dataclass(frozen=True, slots=True, eq=False)
class CameraArraySolution:
    """Calibrated cameras, how well every view fits, and what was left out."""

    calibration: CameraArrayCalibration
    joint_rms_px: float
    sigma_px: float  # standard deviation of one coordinate of a corner
    board: CheckerboardDescription  # with its bow, where that was estimated
    views: tuple[ViewResidual, ...]
    rejected: tuple[Rejection, ...]
    boards: Mapping[str, RigidTransform]  # view -> camera_from_board in the reference camera's frame
    loops: tuple[LoopCheck, ...]
    parameters: tuple[str, ...]  # names of the rows of `covariance`: "left.fx", "right.x_mm", …
    covariance: FloatArray = field(repr=False, default_factory=lambda: np.empty((0, 0)))


def solve(problem: CameraArrayProblem, progress: Progress | None = None) -> CameraArraySolution:
    """Calibrate 1…n cameras from views of one board.

    Per camera Zhang's method; pairs by R = R_l R_rᵀ, t = t_l - R t_r; then one bundle adjustment over all lenses,
    camera poses and board poses with a robust loss. Sightings that fit badly are left out, each with its reason.

    Raises
    ------
    CalibrationError
        Too few views, views that do not determine the lens, images that do not belong together, or cameras that
        share no view.
    """
    progress = progress or NoProgress()
    _check(problem)
    sightings, rejected, start, checks = _started(problem, PartOf(progress, 0.0, 0.4))
    cameras, views = _indices(problem, sightings)
    sights = [
        Sight(cameras[sighting.camera], views[sighting.view], sighting.corners_px, np.ones(len(sighting.corners_px), bool))
        for sighting in sightings
    ]
    names = (tuple(cameras), tuple(views))
    free_bow = problem.free_bow and len(sights) >= LEAST_SIGHTS_FOR_BOW
    for number in range(ROUNDS):
        part = PartOf(progress, 0.4 + 0.2 * number, 0.6 + 0.2 * number, "bundle: ")
        minimum = adjust(problem.board, sights, start, free_bow=free_bow, progress=part)
        bundle = robust_bundle(problem.board, sights, minimum.state, free_bow=free_bow)
        kept, out = _cleaned(bundle, minimum.state, names)
        if not out:
            break
        rejected += out
        start, sights, names = _compacted(minimum.state, kept, names)
    progress.report(1, 1)
    variance = bundle.variance(minimum.state)
    covariance = minimum.covariance(variance)[: bundle.layout.boards_at, : bundle.layout.boards_at]
    return _solution(bundle, minimum.state, names, rejected, checks, covariance, variance)


def _check(problem: CameraArrayProblem) -> None:
    if problem.distortion_count not in FIXED_COEFFICIENTS:
        raise CalibrationError(f"{problem.distortion_count} distortion coefficients are not offered.", "Choose 4, 5 or 8.")
    if problem.reference not in problem.sizes_px:
        raise CalibrationError(f"The reference camera {problem.reference!r} has no images.", "Name one of the cameras given.")
    if len(problem.sizes_px) > 1:
        require_unambiguous(problem.board, "a calibration of several cameras")


def _started(problem: CameraArrayProblem, progress: Progress) -> tuple[list[Sighting], list[Rejection], BundleState, tuple[LoopCheck, ...]]:
    """Calibrate every camera alone and chain them: the start values of the bundle."""
    order = (problem.reference, *(name for name in problem.sizes_px if name != problem.reference))
    rejected = list(problem.rejected)
    solutions = {}
    for done, camera in enumerate(order):
        progress.report(done, len(order), f"camera {camera}")
        own = [sighting for sighting in problem.sightings if sighting.camera == camera]
        if len(own) < LEAST_VIEWS:
            raise CalibrationError(
                f"Camera {camera!r} has {len(own)} views of the board; at least {LEAST_VIEWS} are needed.",
                "Add views with the board tilted in different directions.",
            )
        solutions[camera] = calibrate_camera(own, problem.board, problem.sizes_px[camera], problem.distortion_count)
        rejected += solutions[camera].rejected
    poses = {camera: dict(solutions[camera].camera_from_board) for camera in order}
    for rejection in contradictions(poses):
        poses[rejection.camera].pop(rejection.view, None)
        rejected.append(rejection)
    placed = placed_from_reference(poses, problem.reference)
    sightings = [sighting for sighting in problem.sightings if sighting.view in poses[sighting.camera]]
    boards: dict[str, FloatArray] = {}
    for sighting in sorted(sightings, key=lambda sighting: order.index(sighting.camera)):
        boards.setdefault(sighting.view, placed[sighting.camera] @ poses[sighting.camera][sighting.view].matrix)
    state = BundleState(
        tuple(solutions[camera].pinhole for camera in order),
        np.array([placed[camera] for camera in order]),
        np.array([boards[view] for view in dict.fromkeys(sighting.view for sighting in sightings)]),
        np.array(problem.board.bow_mm),
    )
    return sightings, rejected, state, loops(poses)


def _indices(problem: CameraArrayProblem, sightings: list[Sighting]) -> tuple[dict[str, int], dict[str, int]]:
    order = (problem.reference, *(name for name in problem.sizes_px if name != problem.reference))
    views = dict.fromkeys(sighting.view for sighting in sightings)
    return {name: index for index, name in enumerate(order)}, {view: index for index, view in enumerate(views)}


def _cleaned(bundle: Bundle, state: BundleState, names: tuple[tuple[str, ...], tuple[str, ...]]) -> tuple[list[Sight], list[Rejection]]:
    """Leave out whole sightings that fit badly, and single corners far off."""
    errors = np.array([rms(bundle.residuals(state, sight), sight.used) for sight in bundle.sights])
    limit_px = BAD_CORNER_FACTOR * np.sqrt(2) * robust_sigma(bundle, state)
    kept, out = [], []
    for sight, error in zip(bundle.sights, errors, strict=True):
        median = float(np.median([other for other, of in zip(errors, bundle.sights, strict=True) if of.camera == sight.camera]))
        camera, view = names[0][sight.camera], names[1][sight.view]
        if error > max(BAD_VIEW_FACTOR * median, BAD_VIEW_FLOOR_PX):
            out.append(Rejection(camera, view, bad_view_reason(error, median)))
            continue
        far = sight.used & (np.linalg.norm(bundle.residuals(state, sight), axis=1) > max(limit_px, BAD_VIEW_FLOOR_PX))
        if far.any():
            places = ", ".join(str(number) for number in np.flatnonzero(far))
            out.append(Rejection(camera, view, f"corner {places} lies more than {limit_px:.2f} px from where it should"))
        kept.append(replace(sight, used=sight.used & ~far))
    return kept, out


def _compacted(
    state: BundleState, sights: list[Sight], names: tuple[tuple[str, ...], tuple[str, ...]]
) -> tuple[BundleState, list[Sight], tuple[tuple[str, ...], tuple[str, ...]]]:
    """Drop board positions no camera sees any more. Raises CalibrationError where too few are left."""
    for camera, name in enumerate(names[0]):
        left = sum(sight.camera == camera for sight in sights)
        if left < LEAST_VIEWS:
            raise CalibrationError(
                f"Camera {name!r} has {left} views left that fit the others; at least {LEAST_VIEWS} are needed.",
                "Check that the images show the same rigid board, sharp and in the same order for all cameras.",
            )
    views = sorted({sight.view for sight in sights})
    new = {view: index for index, view in enumerate(views)}
    kept = [replace(sight, view=new[sight.view]) for sight in sights]
    compact = replace(state, reference_from_board=state.reference_from_board[views])
    return compact, kept, (names[0], tuple(names[1][view] for view in views))


def _solution(
    bundle: Bundle,
    state: BundleState,
    names: tuple[tuple[str, ...], tuple[str, ...]],
    rejected: list[Rejection],
    checks: tuple[LoopCheck, ...],
    covariance: FloatArray,
    variance: float,
) -> CameraArraySolution:
    cameras, views = names
    labels = _labels(bundle, cameras)
    deviations = dict(zip(labels, np.sqrt(np.diag(covariance)), strict=True))
    residuals = [bundle.residuals(state, sight)[sight.used] for sight in bundle.sights]
    calibrations = {}
    for index, name in enumerate(cameras):
        own = np.concatenate([values for values, sight in zip(residuals, bundle.sights, strict=True) if sight.camera == index])
        mine = {key.removeprefix(f"{name}."): float(value) for key, value in deviations.items() if key.startswith(f"{name}.")}
        _check_lens(name, state, index, mine)
        place = RigidTransform(orthonormalised(state.reference_from_camera[index]), "camera", name)
        calibrations[name] = CameraCalibration(name, state.pinholes[index], place, mine, rms(own))
    array = CameraArrayCalibration(
        cameras[0], calibrations, _pair_rms(bundle, residuals, cameras), Provenance(method="Zhang, then bundle adjustment of all cameras")
    )
    return CameraArraySolution(
        calibration=array,
        joint_rms_px=rms(np.concatenate(residuals)),
        sigma_px=float(np.sqrt(variance)),
        board=bundle.board.model_copy(update={"bow_mm": tuple(float(value) for value in state.bow_mm)}),
        views=tuple(
            ViewResidual(cameras[sight.camera], views[sight.view], rms(values), len(values))
            for sight, values in zip(bundle.sights, residuals, strict=True)
        ),
        rejected=tuple(rejected),
        boards={
            view: RigidTransform(orthonormalised(pose), "camera", "board")
            for view, pose in zip(views, state.reference_from_board, strict=True)
        },
        loops=checks,
        parameters=labels,
        covariance=covariance,
    )


def _labels(bundle: Bundle, cameras: tuple[str, ...]) -> tuple[str, ...]:
    lens = intrinsic_names(bundle.layout.lens - 4)
    names: list[str] = []
    for index, camera in enumerate(cameras):
        names += [f"{camera}.{name}" for name in (lens if index == 0 else (*lens, *POSE_NAMES))]
    return (*names, *(BOW_NAMES if bundle.layout.bow else ()))


def _check_lens(name: str, state: BundleState, index: int, deviations: Mapping[str, float]) -> None:
    focal = float(state.pinholes[index].matrix[0, 0])
    if focal <= 0 or deviations["fx"] > WEAK_FOCAL_SHARE * focal:
        raise CalibrationError(
            f"The views of camera {name!r} do not determine its focal length ({focal:.0f} ± {deviations['fx']:.0f} px).",
            "Tilt the board by 20° to 45° in several directions.",
        )


def _pair_rms(bundle: Bundle, residuals: list[FloatArray], cameras: tuple[str, ...]) -> dict[str, float]:
    pairs = {}
    for left, right in combinations(range(len(cameras)), 2):
        seen = {camera: {sight.view for sight in bundle.sights if sight.camera == camera} for camera in (left, right)}
        both = seen[left] & seen[right]
        chosen = [
            values for values, sight in zip(residuals, bundle.sights, strict=True) if sight.camera in (left, right) and sight.view in both
        ]
        if chosen:
            pairs[f"{cameras[left]}-{cameras[right]}"] = rms(np.concatenate(chosen))
    return pairs


def left_from_right(calibration: CameraArrayCalibration, left: str, right: str) -> RigidTransform:
    """Return the pose of camera ``right`` in the frame of camera ``left``."""
    place = calibration.cameras[left].reference_from_camera.matrix
    chain = inverted(place) @ calibration.cameras[right].reference_from_camera.matrix
    return RigidTransform(orthonormalised(chain), left, right)
