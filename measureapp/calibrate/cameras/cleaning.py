"""Outlier rejection in a bundle adjustment: corners, sightings, and boards that moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.calibrate.cameras.bundle import POSE, Bundle, BundleState, IndexedSighting, spread_of
from measureapp.calibrate.cameras.camera import BAD_VIEW_FACTOR, BAD_VIEW_FLOOR_PX, LEAST_VIEWS, bad_view_reason
from measureapp.calibrate.sightings import Rejection, rms
from measureapp.errors import CalibrationError

FAR_CORNER_FACTOR = 5.5  # distance in standard deviations of a coordinate; noise alone passes it once in four million corners
LARGEST_FAR_SHARE = 0.25  # a sighting with more far corners than this shows something else
CHI_SQUARE_MEDIAN = 5.35  # of six degrees of freedom
MOVED_FACTOR = 25.0  # a board that disagrees this many times more than the median view moved; real boards scatter up to 15 times
Names = tuple[tuple[str, ...], tuple[str, ...]]  # cameras, views


@dataclass(frozen=True, slots=True)
class CornerRejection:
    """One rejected corner of a used sighting, with the reason."""

    camera: str
    view: str
    corner: int
    distance_px: float
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class Cleaned:
    """The sightings kept in a bundle, and the rejections."""

    kept: list[IndexedSighting]
    rejected: list[Rejection]
    corners: list[CornerRejection]

    @property
    def anything(self) -> bool:
        """Whether something was rejected."""
        return bool(self.rejected or self.corners)


@dataclass(frozen=True, slots=True, eq=False)
class _Alone:
    """The board pose of one sighting alone, linearised at the common solution."""

    sight: IndexedSighting
    residuals_px: FloatArray  # (N, 2), with the board pose of this sighting alone
    information: FloatArray  # (6, 6) of the board's pose
    gradient: FloatArray  # (6,)
    far: BoolArray  # (N,), corners too far off
    limits_px: FloatArray  # (N,), beyond which a corner is far

    @property
    def rms_px(self) -> float:
        return rms(self.residuals_px, self.sight.used & ~self.far)


def reject_corners(bundle: Bundle, state: BundleState, names: Names) -> Cleaned:
    """Reject far corners, sightings whose corners fit no board pose, and those of a board that moved.

    Every sighting is evaluated with the board pose fitted to it alone, so that a board that moved between the images of two
    cameras is distinguished from corners found in a wrong place. Of the sightings of one view at most one is left out as moved:
    with three cameras the one that the two others contradict. The statistic is Hotelling's T² of the difference of two
    estimates of the pose, compared with its median over the views, so that a lens model that does not fit perfectly raises no alarm.
    """
    evaluated = [_fit_alone(bundle, state, sight) for sight in bundle.sights]
    medians = [
        float(np.median([one.rms_px for one in evaluated if one.sight.camera == camera] or [0.0])) for camera in range(len(names[0]))
    ]
    found = Cleaned([], [], [])
    fitting = [one for one in evaluated if not _misfits(one, medians[one.sight.camera], names, found)]
    moved = _find_moved_boards(fitting)
    for one in fitting:
        camera, view = names[0][one.sight.camera], names[1][one.sight.view]
        if id(one.sight) in moved:
            found.rejected.append(Rejection(camera, view, moved[id(one.sight)]))
            continue
        for corner in np.flatnonzero(one.far & one.sight.used):
            distance = float(np.linalg.norm(one.residuals_px[corner]))
            number = int(corner if one.sight.ids is None else one.sight.ids[corner])
            reason = f"lies {distance:.2f} px from its expected position; {one.limits_px[corner]:.2f} px is the limit"
            found.corners.append(CornerRejection(camera, view, number, distance, reason))
        found.kept.append(replace(one.sight, used=one.sight.used & ~one.far))
    return found


def _fit_alone(bundle: Bundle, state: BundleState, sight: IndexedSighting) -> _Alone:
    residual, jacobian, _ = bundle.linearise_sighting(state, sight)
    by_board, spread = jacobian[:, :, -POSE:], spread_of(sight)
    sigma = bundle.sigma_px(sight.camera) * spread
    left, far, limits_px = residual, np.zeros(len(residual), bool), BAD_VIEW_FLOOR_PX * spread
    for _ in range(3):  # far corners bias the step, so they are excluded from the next
        used = sight.used & ~far
        flat = (by_board[used] / sigma[used, None, None]).reshape(-1, POSE)
        values = (residual[used] / sigma[used, None]).ravel()
        information, gradient = flat.T @ flat, flat.T @ values
        if np.count_nonzero(used) < POSE:
            return _Alone(sight, residual, information, gradient, sight.used, limits_px)
        left = residual - by_board @ np.linalg.solve(information, gradient)
        usual = max(1.4826 * float(np.median(np.abs((left / spread[:, None])[sight.used]))), bundle.sigma_px(sight.camera))
        limits_px = np.maximum(FAR_CORNER_FACTOR * usual * spread, BAD_VIEW_FLOOR_PX)
        far = np.linalg.norm(left, axis=1) > limits_px
    return _Alone(sight, left, information, gradient, far, limits_px)


def _misfits(one: _Alone, median_px: float, names: Names, found: Cleaned) -> bool:
    """Note a sighting that fits no board position."""
    camera, view = names[0][one.sight.camera], names[1][one.sight.view]
    share = float(np.mean(one.far[one.sight.used])) if one.sight.used.any() else 1.0
    if share > LARGEST_FAR_SHARE:
        found.rejected.append(Rejection(camera, view, f"{share:.0%} of its corners were found in a wrong place"))
    elif one.rms_px > max(BAD_VIEW_FACTOR * median_px, BAD_VIEW_FLOOR_PX):
        found.rejected.append(Rejection(camera, view, bad_view_reason(one.rms_px, median_px)))
    else:
        return False
    return True


def _find_moved_boards(evaluated: Sequence[_Alone]) -> dict[int, str]:
    """Sightings (by id) whose board pose contradicts the other cameras' images of the same view, with the reason."""
    views: dict[int, list[_Alone]] = {}
    for one in evaluated:
        views.setdefault(one.sight.view, []).append(one)
    tests = {view: [_against_others(one, own) for one in own] for view, own in views.items() if len(own) > 1}
    values = [value for own in tests.values() for value, _ in own]
    limit = MOVED_FACTOR * max(float(np.median(values)), CHI_SQUARE_MEDIAN) if values else np.inf
    moved = {}
    for view, own in tests.items():
        worst = int(np.argmax([value for value, _ in own]))
        value, change = own[worst]
        if value > limit and np.linalg.norm(change) > 0:
            angle, distance = float(np.rad2deg(np.linalg.norm(change[:3]))), float(np.linalg.norm(change[3:]))
            moved[id(views[view][worst].sight)] = (
                f"it shows the board {distance:.2f} mm and {angle:.2f}° from the board pose of the other cameras: "
                "the board moved between the images, or they belong to different positions"
            )
    return moved


def _against_others(one: _Alone, view: Sequence[_Alone]) -> tuple[float, FloatArray]:
    """Squared Mahalanobis distance between the board pose of one sighting and that of the others in its view, and their difference (6,)."""
    others = np.sum([other.information for other in view if other is not one], axis=0)
    gradient = np.sum([other.gradient for other in view if other is not one], axis=0)
    change = np.linalg.solve(others, gradient) - np.linalg.solve(one.information, one.gradient)
    both = np.linalg.inv(one.information) + np.linalg.inv(others)
    return float(change @ np.linalg.solve(both, change)), change


def drop_empty_views(
    state: BundleState, sights: Sequence[IndexedSighting], names: Names, known_cameras: int
) -> tuple[BundleState, list[IndexedSighting], Names]:
    """Drop board positions without sightings. Raises CalibrationError where too few are left for a camera that is not known."""
    for camera, name in list(enumerate(names[0]))[known_cameras:]:
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
