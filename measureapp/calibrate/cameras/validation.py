"""Leave-one-out cross-validation of the stated uncertainty with held-back views, and comparison of two halves.

Two checks, after mrcal's cross-validation [1]_. *Held-back views*: every view is once left out; the cameras calibrated without it must
predict its corners as well as their noise and their own uncertainty allow. *Halves*: the cameras calibrated from every second view
and from the others must give the same projection within the uncertainty of both. Where the difference is larger than predicted, something
that noise does not explain is at work: a lens that does not follow the model, a board that is bent or moved, blurred corners.

References
----------
.. [1] D. Kogan, mrcal: "A tour of mrcal: cross-validation", documentation of mrcal 2, 2020-2024.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import ConvexHull, Delaunay

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.array import BOW_NAMES, CameraArrayProblem, CameraArraySolution, solve
from measureapp.calibrate.cameras.bundle import POSE, Bundle, BundleState, IndexedSighting, Layout, spread_of
from measureapp.calibrate.cameras.camera import LEAST_VIEWS
from measureapp.calibrate.cameras.known import pad_distortion
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.uncertainty import projection_covariance, projection_difference
from measureapp.calibrate.sightings import Sighting, relative_sigmas
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.errors import CalibrationError
from measureapp.progress import NoProgress, PartOf, Progress

FOLDS = 5
HELD_BACK_LIMIT = 1.25  # observed over predicted rms of held-back views; noise alone moves it by some per cent
HALVES_LIMIT = 2.0  # difference of two halves over its prediction; the difference has few degrees of freedom
POSE_STEPS = 4  # Gauss-Newton steps for the pose of a held-back board; the start is the solution with it
GRID = 24  # points along each side of the image
LEAST_COVERED = 12  # of its points
LEAST_VIEWS_FOR_HALVES = 2 * LEAST_VIEWS + 2


@dataclass(frozen=True, slots=True)
class HeldBackView:
    """How well cameras calibrated without a view predict its corners; rms of the distances over all cameras."""

    view: str
    observed_px: float
    predicted_px: float


@dataclass(frozen=True, slots=True)
class HalvesCheck:
    """How far two calibrations of one camera from different views project apart, rms over the part of its image in which both had corners."""

    camera: str
    difference_px: float
    predicted_px: float


@dataclass(frozen=True, slots=True, eq=False)
class CrossValidation:
    """The result of both checks."""

    folds: int
    views: tuple[HeldBackView, ...]
    halves: tuple[HalvesCheck, ...]  # empty where there are too few views

    @property
    def observed_px(self) -> float:
        """Rms of all held-back views."""
        return float(np.sqrt(np.mean([view.observed_px**2 for view in self.views])))

    @property
    def predicted_px(self) -> float:
        """The predicted rms."""
        return float(np.sqrt(np.mean([view.predicted_px**2 for view in self.views])))

    @property
    def healthy(self) -> bool:
        """Whether noise and the predicted uncertainty explain all residuals."""
        return self.observed_px <= HELD_BACK_LIMIT * self.predicted_px and all(
            half.difference_px <= HALVES_LIMIT * half.predicted_px for half in self.halves
        )

    @property
    def verdict(self) -> str:
        """One sentence for people."""
        held = f"views held back fit with {self.observed_px:.3f} px rms where {self.predicted_px:.3f} px was predicted"
        worst = max(self.halves, key=lambda half: half.difference_px / half.predicted_px, default=None)
        apart = (
            f"solutions from two halves of the views differ by {worst.difference_px:.3f} px for {_name_device(worst.camera)}, "
            f"with {worst.predicted_px:.3f} px predicted"
            if worst
            else "there are too few views to compare two halves"
        )
        if self.healthy:
            return f"The stated uncertainty can be trusted: {held}; {apart}."
        return (
            f"The stated uncertainty is too small, there are errors other than noise: {held}; {apart}. "
            "Try 8 distortion coefficients, check the board for flatness and the images for blur."
        )


def cross_validate(
    problem: CameraArrayProblem, solution: CameraArraySolution, *, folds: int = FOLDS, progress: Progress | None = None
) -> CrossValidation:
    """Check a solution with views held back.

    Views and corners that the solution left out stay out; cameras that were given stay as they are. The prediction for a held-back view is
    E|r|² = (2N − 6)σ² + tr(P C Σ Cᵀ P): noise, less what the free pose of the board takes up, and the covariance Σ of the cameras
    carried to the corners by the derivatives C and freed of what the board's pose explains (P).

    Raises
    ------
    CalibrationError
        Too few views to leave some out.
    """
    progress = progress or NoProgress()
    kept = _as_solved(problem, solution)
    views = list(dict.fromkeys(one.view for one in kept.sightings))
    if len(views) <= LEAST_VIEWS:
        raise CalibrationError(f"{len(views)} views are too few to hold some back.", "Take ten views or more.")
    folds = min(folds, len(views))
    held: list[HeldBackView] = []
    for fold in range(folds):
        part = PartOf(progress, fold / (folds + 2), (fold + 1) / (folds + 2), f"without part {fold + 1}: ")
        out = set(views[fold::folds])
        trained = solve(_only(kept, [view for view in views if view not in out]), part, solution)
        held += [_check_held_back(view, kept, trained, solution) for view in views if view in out]
    halves: tuple[HalvesCheck, ...] = ()
    if len(views) >= LEAST_VIEWS_FOR_HALVES:
        parts = (_only(kept, views[::2]), _only(kept, views[1::2]))
        first = solve(parts[0], PartOf(progress, folds / (folds + 2), (folds + 1) / (folds + 2), "first half: "), solution)
        second = solve(parts[1], PartOf(progress, (folds + 1) / (folds + 2), 1.0, "second half: "), solution)
        given = () if problem.known is None else problem.known.names
        covered = {name: _common_pixels(name, problem.sizes_px[name], parts) for name in solution.calibration.cameras if name not in given}
        apart = _covariance_of_difference(first, second, given)
        halves = tuple(
            _halves(name, first, second, apart, pixels, _range_mm(solution, name))
            for name, pixels in covered.items()
            if len(pixels) >= LEAST_COVERED
        )
    return CrossValidation(folds, tuple(sorted(held, key=lambda one: one.view)), halves)


def _as_solved(problem: CameraArrayProblem, solution: CameraArraySolution) -> CameraArrayProblem:
    """The problem without the rejections of its solution."""
    used = {(one.camera, one.view) for one in solution.views}
    wrong: dict[tuple[str, str], set[int]] = {}
    for corner in solution.rejected_corners:
        wrong.setdefault((corner.camera, corner.view), set()).add(corner.corner)
    kept = tuple(_without(one, wrong.get((one.camera, one.view), set())) for one in problem.sightings if (one.camera, one.view) in used)
    free_bow = any(name in BOW_NAMES for name in solution.parameters)
    return replace(problem, board=solution.board, sightings=kept, rejected=(), free_bow=free_bow, free_marks=False)


def _without(sighting: Sighting, corners: set[int]) -> Sighting:
    keep = ~np.isin(sighting.ids, list(corners))
    sigma = None if sighting.sigma_px is None else sighting.sigma_px[keep]
    return replace(sighting, corners_px=sighting.corners_px[keep], ids=sighting.ids[keep], sigma_px=sigma)


def _only(problem: CameraArrayProblem, views: list[str]) -> CameraArrayProblem:
    chosen = set(views)
    return replace(problem, sightings=tuple(one for one in problem.sightings if one.view in chosen))


def _check_held_back(view: str, problem: CameraArrayProblem, trained: CameraArraySolution, whole: CameraArraySolution) -> HeldBackView:
    names = list(trained.calibration.cameras)
    sights = tuple(
        IndexedSighting(names.index(one.camera), 0, one.corners_px, np.ones(len(one.corners_px), bool), one.ids, spread)
        for one, spread in zip(problem.sightings, relative_sigmas(problem.sightings), strict=True)
        if one.view == view
    )
    free_bow = any(name in BOW_NAMES for name in trained.parameters)
    bundle, state = _one_view(trained.calibration, trained.board, whole.boards[view].matrix, sights, free_bow)
    sigmas = np.concatenate([np.repeat(trained.sigmas_px[names[sight.camera]] * spread_of(sight), 2) for sight in sights])
    residuals, by_board, by_rest = _linearise(bundle, state)
    for _ in range(POSE_STEPS):
        step = -np.linalg.lstsq(by_board / sigmas[:, None], residuals / sigmas, rcond=None)[0]
        state = bundle.apply_step(state, np.concatenate([np.zeros(bundle.layout.boards_at), step]))
        residuals, by_board, by_rest = _linearise(bundle, state)
    count = len(residuals) / 2
    return HeldBackView(view, float(np.sqrt(residuals @ residuals / count)), _predict_rms(by_board, by_rest, sigmas, trained.covariance))


def _one_view(
    calibration: CameraArrayCalibration, board: BoardDescription, pose: FloatArray, sights: tuple[IndexedSighting, ...], free_bow: bool
) -> tuple[Bundle, BundleState]:
    cameras = list(calibration.cameras.values())
    count = max(len(camera.pinhole.distortion) for camera in cameras)
    state = BundleState(
        tuple(pad_distortion(camera.pinhole, count) for camera in cameras),
        np.array([camera.reference_from_camera.matrix for camera in cameras]),
        np.array(pose)[None],
        np.array(board.bow_mm),
        np.zeros((board.count, 2)),
    )
    return Bundle(board, sights, Layout(4 + count, len(cameras), 3 if free_bow else 0)), state


def _linearise(bundle: Bundle, state: BundleState) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Residuals (M,) of one view and their derivatives by the board's pose (M, 6) and by all that views share (M, P)."""
    rows = []
    for sight in bundle.sights:
        residual, jacobian, index = bundle.linearise_sighting(state, sight)
        full = np.zeros((2 * len(residual), bundle.layout.boards_at + POSE))
        full[:, index] = jacobian.reshape(len(full), -1)
        rows.append((residual.ravel(), full))
    everything = np.concatenate([full for _, full in rows])
    return np.concatenate([residual for residual, _ in rows]), everything[:, -POSE:], everything[:, :-POSE]


def _predict_rms(by_board: FloatArray, by_rest: FloatArray, sigmas: FloatArray, covariance: FloatArray) -> float:
    """Expected rms distance of a held-back view's corners; the board's pose is fitted with the cameras' weights."""
    weighted = by_board / sigmas[:, None]
    taken = by_board @ np.linalg.pinv(weighted)  # part of the whitened residuals that the fitted pose absorbs
    noise = np.diag(sigmas) - taken
    left = by_rest - taken @ (by_rest / sigmas[:, None])
    total = np.sum(noise**2) + np.einsum("mp,pq,mq->", left, covariance, left, optimize=True)
    return float(np.sqrt(total / (len(sigmas) / 2)))


def _range_mm(solution: CameraArraySolution, camera: str) -> float:
    place = solution.calibration.cameras[camera].reference_from_camera
    middle = solution.board.middle_mm
    return float(np.median([np.linalg.norm(pose.apply(middle) - place.translation_mm) for pose in solution.boards.values()]))


def _covariance_of_difference(first: CameraArraySolution, second: CameraArraySolution, given: Sequence[str]) -> FloatArray:
    """Return the covariance (P, P) of what two halves estimate differently; errors of given cameras are common to both.

    With B = dp/dc of what was estimated by the given cameras c, of covariance C, the halves share B₁ C B₂ᵀ.
    """
    held = [index for index, label in enumerate(first.parameters) if label.partition(".")[0] in given]
    one, other = first.covariance, second.covariance
    size = np.sqrt(np.diag(one)[held])
    size[size == 0] = 1.0
    inverse = np.linalg.pinv(one[np.ix_(held, held)] / np.outer(size, size), hermitian=True) / np.outer(size, size)
    shared = one[:, held] @ inverse @ other[held]
    return np.asarray(one + other - shared - shared.T)


def _halves(
    name: str, first: CameraArraySolution, second: CameraArraySolution, apart: FloatArray, pixels: FloatArray, range_mm: float
) -> HalvesCheck:
    one, other = (solution.calibration.cameras[name] for solution in (first, second))
    spread = np.trace(projection_covariance(one, first.parameters, apart, pixels, range_mm), axis1=1, axis2=2)
    difference = projection_difference(one.pinhole, other.pinhole, pixels, range_mm)
    return HalvesCheck(name, float(np.sqrt(np.mean(np.sum(difference**2, axis=1)))), float(np.sqrt(np.mean(spread))))


def _name_device(name: str) -> str:
    return f"the {name}" if name == PROJECTOR else f"camera {name}"


def _common_pixels(name: str, size_px: tuple[int, int], halves: tuple[CameraArrayProblem, CameraArrayProblem]) -> FloatArray:
    """Pixels (N, 2) of a grid over the part of the image in which both halves of the views have corners.

    Outside of it a lens is extrapolated, and what its polynomial does there is decided by other than the noise of the corners.
    """
    pixels = np.stack(np.meshgrid(*(np.linspace(0, side - 1, GRID) for side in size_px)), -1).reshape(-1, 2)
    inside = np.ones(len(pixels), bool)
    for half in halves:
        corners = np.concatenate([one.corners_px for one in half.sightings if one.camera == name])
        inside &= Delaunay(corners[ConvexHull(corners).vertices]).find_simplex(pixels) >= 0
    return np.asarray(pixels[inside])
