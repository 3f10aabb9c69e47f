"""Calibration of all cameras of the head: Zhang's method for each, poses from pairs, then one bundle adjustment."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.find import require_unambiguous
from measureapp.calibrate.boards.quality import blur_px
from measureapp.calibrate.cameras.bundle import IN_PLANE, Bundle, BundleState, IndexedSighting, adjust
from measureapp.calibrate.cameras.camera import FIXED_COEFFICIENTS, LEAST_VIEWS, calibrate_camera, estimate_poses
from measureapp.calibrate.cameras.cleaning import Cleaned, CornerRejection, Names, drop_empty_views, reject_corners
from measureapp.calibrate.cameras.known import (
    LARGEST_DISTORTION,
    complete_covariance,
    estimate_board_poses,
    pad_distortion,
    require_agreement,
    require_known,
)
from measureapp.calibrate.cameras.marks import MarkScatter, find_scatter
from measureapp.calibrate.cameras.pairs import LoopCheck, find_contradictions, loops, placed_from_reference
from measureapp.calibrate.cameras.projector_sightings import device_title
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.poses import invert_poses
from measureapp.calibrate.projection import intrinsic_names
from measureapp.calibrate.sightings import Rejection, Sighting, ViewResidual, explain_by_refused, relative_sigmas, rms
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, LabelledCovariance, Provenance
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.progress import NoProgress, PartOf, Progress

ROUNDS = 6  # of adjustment and outlier rejection
WEAK_FOCAL_SHARE = 0.05
LEAST_SIGHTS_FOR_BOW = 12
METHOD = "Zhang, then bundle adjustment of all cameras"
METHOD_WITH_MARKS = f"{METHOD} and of the board's marks"
BOW_NAMES = ("board.bow_xx_mm", "board.bow_xy_mm", "board.bow_yy_mm")
POSE_NAMES = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")


@dataclass(frozen=True, slots=True, eq=False)
class CameraArrayProblem:
    """Board, images and sightings from which cameras are calibrated."""

    board: BoardDescription
    reference: str
    sizes_px: Mapping[str, tuple[int, int]]  # camera -> (width, height)
    sightings: tuple[Sighting, ...]
    rejected: tuple[Rejection, ...] = ()
    distortion_count: int = 5  # 4, 5 or 8 coefficients
    free_bow: bool = True  # estimate the board's departure from flat, where there are enough sightings
    free_marks: bool = True  # estimate where its marks are, where images show that they are displaced
    known: CameraArrayCalibration | None = None  # cameras that are kept as they are; those to find come after them in `sizes_px`


@dataclass(frozen=True, slots=True, eq=False)
class CameraArraySolution:
    """Calibrated cameras, the residual of every view, and the rejections."""

    calibration: CameraArrayCalibration
    joint_rms_px: float
    sigma_px: float  # standard deviation of one coordinate of a corner, over all cameras
    sigmas_px: Mapping[str, float]  # the same per camera
    board: BoardDescription  # with its bow and the displacements of its marks, where those were estimated
    views: tuple[ViewResidual, ...]
    rejected: tuple[Rejection, ...]
    rejected_corners: tuple[CornerRejection, ...]
    boards: Mapping[str, RigidTransform]  # view -> camera_from_board in the reference camera's frame
    loops: tuple[LoopCheck, ...]
    parameters: tuple[str, ...]  # names of the rows of `covariance`: "left.fx", "right.x_mm", …
    covariance: FloatArray = field(repr=False, default_factory=lambda: np.empty((0, 0)))
    scatter: MarkScatter | None = None  # of the marks about where the board has them, where they were estimated


def solve(problem: CameraArrayProblem, progress: Progress | None = None, before: CameraArraySolution | None = None) -> CameraArraySolution:
    """Calibrate 1…n cameras from views of one board.

    Per camera Zhang's method; pairs by R = R_l R_rᵀ, t = t_l - R t_r; then one bundle adjustment over all lenses,
    camera poses and board poses with a robust loss. Sightings that fit badly are left out, each with its reason. Where the residuals
    show that marks are not where the board has them, the adjustment is made again with their displacements as unknowns.

    Parameters
    ----------
    before : a solution from fewer or other views of the same cameras, whose lenses are then the start in place of Zhang's

    Raises
    ------
    CalibrationError
        Too few views, views that do not determine the lens, images that do not belong together, or cameras that
        share no view.
    """
    progress = progress or NoProgress()
    _check(problem)
    sightings, rejected, start, checks = _start_values(problem, before, PartOf(progress, 0.0, 0.4))
    cameras, views = _indices(problem, sightings)
    sights = [
        IndexedSighting(cameras[one.camera], views[one.view], one.corners_px, np.ones(len(one.corners_px), bool), one.ids, spread)
        for one, spread in zip(sightings, relative_sigmas(sightings), strict=True)
    ]
    known = 0 if problem.known is None else sum(name in problem.known.cameras for name in cameras)
    names: Names = (tuple(cameras), tuple(views))
    free_bow = problem.free_bow and len(sights) >= LEAST_SIGHTS_FOR_BOW
    if free_bow and before is not None:
        start = replace(start, bow_mm=np.array(before.board.bow_mm))
    adjusting = partial(adjust, problem.board, free_bow=free_bow, known_cameras=known)
    adjusted = _without_outliers(adjusting, _Chosen(sights, names, rejected, []), start, known, PartOf(progress, 0.4, 0.8))
    scatter = find_scatter(adjusted.bundle, adjusted.minimum, known) if problem.free_marks else None
    if scatter is not None:
        adjusting = partial(adjusting, mark_weights=scatter.weights(problem.board))
        adjusted = _without_outliers(adjusting, adjusted.chosen, adjusted.minimum.state, known, PartOf(progress, 0.8, 1.0))
    progress.report(1, 1)
    edges = {name: [one.edge_px for one in sightings if one.camera == name] for name in cameras}
    return replace(_solution(adjusted, checks, problem.known, edges), scatter=scatter)


@dataclass(frozen=True, slots=True, eq=False)
class _Chosen:
    """The sightings that count, and what was rejected."""

    sights: list[IndexedSighting]
    names: Names
    rejected: list[Rejection]
    corners: list[CornerRejection]


@dataclass(frozen=True, slots=True, eq=False)
class _Adjusted:
    """An adjustment without outliers."""

    bundle: Bundle
    minimum: Minimum[BundleState]
    chosen: _Chosen


def _without_outliers(
    adjusting: Callable[..., tuple[Minimum[BundleState], Bundle]], chosen: _Chosen, start: BundleState, known: int, progress: Progress
) -> _Adjusted:
    """Adjust and reject outliers in turn.

    Parameters
    ----------
    adjusting : `adjust`, short of sightings, start and progress
    known : how many of the cameras were given
    """
    for number in range(ROUNDS + 1):
        part = PartOf(progress, number / (ROUNDS + 1), (number + 1) / (ROUNDS + 1), "bundle: ")
        minimum, bundle = adjusting(chosen.sights, start, progress=part)
        if number == ROUNDS:  # outliers of the last round are rejected as well, so the solution must not contain them
            break
        found = reject_corners(bundle, minimum.state, chosen.names)
        if not found.anything:
            break
        start, sights, names = drop_empty_views(minimum.state, found.kept, chosen.names, known)
        chosen = _Chosen(sights, names, chosen.rejected + found.rejected, _still_used(chosen.corners, found))
    return _Adjusted(bundle, minimum, chosen)


def _still_used(corners: list[CornerRejection], found: Cleaned) -> list[CornerRejection]:
    """Add the corners found; those of a sighting rejected as a whole are not listed."""
    out = {(one.camera, one.view) for one in found.rejected}
    return [one for one in (*corners, *found.corners) if (one.camera, one.view) not in out]


def _check(problem: CameraArrayProblem) -> None:
    if problem.distortion_count not in FIXED_COEFFICIENTS:
        raise CalibrationError(f"{problem.distortion_count} distortion coefficients are not offered.", "Choose 4, 5 or 8.")
    if problem.reference not in problem.sizes_px:
        raise CalibrationError(f"The reference camera {problem.reference!r} has no images.", "Name one of the cameras given.")
    if problem.known is not None:
        require_known(problem.known, problem.sizes_px)
        require_agreement(problem.known, problem.sightings, problem.board)
    if len(problem.sizes_px) > 1:
        require_unambiguous(problem.board, "a calibration of several cameras")


def _start_values(
    problem: CameraArrayProblem, before: CameraArraySolution | None, progress: Progress
) -> tuple[list[Sighting], list[Rejection], BundleState, tuple[LoopCheck, ...]]:
    """Calibrate every camera alone, or take its lens from ``before``, and chain them: the start values of the bundle."""
    order = (problem.reference, *(name for name in problem.sizes_px if name != problem.reference))
    rejected = list(problem.rejected)
    known = {} if problem.known is None else problem.known.cameras
    count = max([problem.distortion_count, *(len(camera.pinhole.distortion) for camera in known.values())])
    count = min(count, LARGEST_DISTORTION)
    lenses: list[PinholeCamera] = []
    poses: dict[str, dict[str, RigidTransform]] = {}
    for done, camera in enumerate(order):
        progress.report(done, len(order), f"camera {camera}")
        own = [sighting for sighting in problem.sightings if sighting.camera == camera]
        if camera in known:
            lenses.append(pad_distortion(known[camera].pinhole, count))
            poses[camera] = estimate_board_poses(own, known[camera], problem.board)
            continue
        if len(own) < LEAST_VIEWS:
            few = CalibrationError(
                f"{device_title(camera)} has {len(own)} {'view' if len(own) == 1 else 'views'} of the board; at least {LEAST_VIEWS} are needed.",
                "Add views with the board tilted in different directions.",
            )
            raise explain_by_refused(few, [(f"view {one.view}", one.reason) for one in problem.rejected if one.camera == camera])
        if before is None:
            alone = calibrate_camera(own, problem.board, problem.sizes_px[camera], count)
        else:
            alone = estimate_poses(own, problem.board, before.calibration.cameras[camera].pinhole)
        rejected += alone.rejected
        lenses.append(alone.pinhole)
        poses[camera] = dict(alone.camera_from_board)
    for rejection in find_contradictions(poses):
        poses[rejection.camera].pop(rejection.view, None)
        rejected.append(rejection)
    placed = placed_from_reference(
        poses, problem.reference, {name: known[name].reference_from_camera.matrix for name in order if name in known}
    )
    sightings = [sighting for sighting in problem.sightings if sighting.view in poses[sighting.camera]]
    boards: dict[str, FloatArray] = {}
    for sighting in sorted(sightings, key=lambda sighting: order.index(sighting.camera)):
        boards.setdefault(sighting.view, placed[sighting.camera] @ poses[sighting.camera][sighting.view].matrix)
    state = BundleState(
        tuple(lenses),
        np.array([placed[camera] for camera in order]),
        np.array([boards[view] for view in dict.fromkeys(sighting.view for sighting in sightings)]),
        np.array(problem.board.bow_mm),
        np.zeros((problem.board.count, IN_PLANE)),
    )
    return sightings, rejected, state, loops(poses)


def _indices(problem: CameraArrayProblem, sightings: list[Sighting]) -> tuple[dict[str, int], dict[str, int]]:
    order = (problem.reference, *(name for name in problem.sizes_px if name != problem.reference))
    views = dict.fromkeys(sighting.view for sighting in sightings)
    return {name: index for index, name in enumerate(order)}, {view: index for index, view in enumerate(views)}


def _solution(
    adjusted: _Adjusted, checks: tuple[LoopCheck, ...], known: CameraArrayCalibration | None, edges_px: Mapping[str, Sequence[float]]
) -> CameraArraySolution:
    bundle, minimum = adjusted.bundle, adjusted.minimum
    state, (cameras, views) = minimum.state, adjusted.chosen.names
    variance = bundle.variance(state)
    labels = _labels(bundle, cameras)
    covariance = minimum.covariance(variance)
    if known is None:
        covariance = covariance[: len(labels), : len(labels)]
    else:
        given = sum(name in known.cameras for name in cameras)
        covariance = complete_covariance(covariance, bundle, minimum, variance, known.covariance, labels, bundle.layout.lens_at(given))
    sigmas = np.sqrt(variance) * np.array(bundle.sigmas_px)
    counts = [sum(int(sight.used.sum()) for sight in bundle.sights if sight.camera == camera) for camera in range(len(cameras))]
    deviations = dict(zip(labels, np.sqrt(np.diag(covariance)), strict=True))
    residuals = [bundle.residuals(state, sight)[sight.used] for sight in bundle.sights]
    calibrations = {}
    for index, name in enumerate(cameras):
        if known is not None and name in known.cameras:
            calibrations[name] = known.cameras[name]
            continue
        own = np.concatenate([values for values, sight in zip(residuals, bundle.sights, strict=True) if sight.camera == index])
        mine = {key.removeprefix(f"{name}."): float(value) for key, value in deviations.items() if key.startswith(f"{name}.")}
        _check_lens(name, state, index, mine)
        place = RigidTransform(orthonormalise(state.reference_from_camera[index]), "camera", name)
        calibrations[name] = CameraCalibration(name, state.pinholes[index], place, mine, rms(own), blur_px=blur_px(edges_px[name]))
    own_rows = [index for index, label in enumerate(labels) if label not in BOW_NAMES]
    left_uncertain = LabelledCovariance(tuple(labels[index] for index in own_rows), covariance[np.ix_(own_rows, own_rows)])
    if known is None:
        by = METHOD_WITH_MARKS if bundle.layout.marks else METHOD
        pairs, method = _pair_rms(bundle, residuals, cameras), Provenance(method=by)
        marks = rms(state.marks_mm) if bundle.layout.marks else 0.0
        array = CameraArrayCalibration(cameras[0], calibrations, pairs, method, None, left_uncertain, bundle.board.lengths, marks)
    else:
        array = replace(known, cameras=calibrations, covariance=None if known.covariance is None else left_uncertain)
    return CameraArraySolution(
        calibration=array,
        joint_rms_px=rms(np.concatenate(residuals)),
        sigma_px=float(np.sqrt(np.average(sigmas**2, weights=counts))),
        sigmas_px={name: float(sigma) for name, sigma in zip(cameras, sigmas, strict=True)},
        board=_board_as_seen(bundle, state),
        views=tuple(
            ViewResidual(cameras[sight.camera], views[sight.view], rms(values), len(values))
            for sight, values in zip(bundle.sights, residuals, strict=True)
        ),
        rejected=tuple(adjusted.chosen.rejected),
        rejected_corners=tuple(adjusted.chosen.corners),
        boards={
            view: RigidTransform(orthonormalise(pose), "camera", "board")
            for view, pose in zip(views, state.reference_from_board, strict=True)
        },
        loops=checks,
        parameters=labels,
        covariance=covariance,
    )


def _board_as_seen(bundle: Bundle, state: BundleState) -> BoardDescription:
    """Return the board with its bow, and with the displacements of its marks where they were estimated."""
    update: dict[str, object] = {"bow_mm": tuple(float(value) for value in state.bow_mm)}
    if bundle.layout.marks:
        update["displaced_mm"] = tuple((float(x), float(y)) for x, y in state.marks_mm)
    return bundle.board.model_copy(update=update)


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
    chain = invert_poses(place) @ calibration.cameras[right].reference_from_camera.matrix
    return RigidTransform(orthonormalise(chain), left, right)
