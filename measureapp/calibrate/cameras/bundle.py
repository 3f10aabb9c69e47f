"""Bundle adjustment: all cameras and all board positions at once, with analytic derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from scipy.sparse import csr_array

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.calibrate.least_squares import Minimum, NormalEquations, minimise
from measureapp.calibrate.poses import apply_changes, invert_poses
from measureapp.calibrate.projection import apply_intrinsic_changes, cross_matrices, project_with_derivatives
from measureapp.data.board import BoardDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.progress import Progress

POSE = 6
BOW = 3  # quadratic departure of the board from a plane
IN_PLANE = 2  # coordinates of a mark in the plane of the board
HUBER_FACTOR = 3.0  # residuals beyond this many standard deviations count linearly
NOISE_ROUNDS = 4
SAME_NOISE = 0.02  # relative change of a camera's noise that is not worth another adjustment
LEAST_SIGMA_PX = 1e-6
TINY = 1e-30


@dataclass(frozen=True, slots=True, eq=False)
class BundleState:
    """Lenses, camera poses, board poses, the board's bow and its marks. Camera 0 is the reference and does not move."""

    pinholes: tuple[PinholeCamera, ...]
    reference_from_camera: FloatArray  # (C, 4, 4)
    reference_from_board: FloatArray  # (V, 4, 4)
    bow_mm: FloatArray  # (3,), factors of the board's `bow_terms`
    marks_mm: FloatArray  # (M, 2), displacement of every mark in the plane of the board from where the board has it


@dataclass(frozen=True, slots=True, eq=False)
class IndexedSighting:
    """The corners of board position ``view`` in camera ``camera``, with those that count."""

    camera: int
    view: int
    corners_px: FloatArray  # (N, 2)
    used: BoolArray  # (N,)
    ids: IntArray | None = None  # (N,), which corners of the board they are; None: all, in order
    spread: FloatArray | None = None  # (N,), standard deviations over the camera's usual one; None: all have that


@dataclass(frozen=True, slots=True, eq=False)
class SeenByCamera:
    """The corners that one camera sees, N in all, sight after sight."""

    camera: int
    views: IntArray  # (S,), board position of every sight
    firsts: IntArray  # (S,), its first corner
    views_of_corners: IntArray  # (N,)
    ids: IntArray  # (N,)
    corners_px: FloatArray  # (N, 2)
    used: BoolArray  # (N,)
    spread: FloatArray  # (N,)

    @classmethod
    def by(cls, camera: int, sights: Sequence[IndexedSighting]) -> SeenByCamera:
        """Return the corners of sights, one or more, of one camera."""
        counts = np.array([len(sight.corners_px) for sight in sights])
        views = np.array([sight.view for sight in sights])
        ids = [np.arange(count) if sight.ids is None else sight.ids for sight, count in zip(sights, counts, strict=True)]
        return cls(
            camera,
            views,
            np.cumsum(counts) - counts,
            np.repeat(views, counts),
            np.concatenate(ids),
            np.concatenate([sight.corners_px for sight in sights]),
            np.concatenate([sight.used for sight in sights]),
            np.concatenate([spread_of(sight) for sight in sights]),
        )


@dataclass(frozen=True, slots=True)
class Layout:
    """Index of each parameter in the vector: per camera lens and (but for the reference) pose, the bow, the marks, then the boards."""

    lens: int  # parameters of a lens
    cameras: int
    bow: int  # BOW, or 0 where the board counts as flat
    marks: int = 0  # IN_PLANE times the marks of the board, or 0 where these are where the board has them

    @property
    def bow_at(self) -> int:
        """Index of the first parameter of the board's bow."""
        return self.cameras * (self.lens + POSE) - POSE

    @property
    def marks_at(self) -> int:
        """Index of the first displacement of a mark."""
        return self.bow_at + self.bow

    @property
    def boards_at(self) -> int:
        """Index of the first board pose, which is the number of parameters that all views share."""
        return self.marks_at + self.marks

    def lens_at(self, camera: int) -> int:
        """Index of the first lens parameter of a camera."""
        return camera * (self.lens + POSE) - (POSE if camera else 0)

    def pose_at(self, camera: int) -> int:
        """Index of the first pose parameter of a camera that is not the reference."""
        return self.lens_at(camera) + self.lens

    def board_at(self, view: int) -> int:
        """Index of the first parameter of a board pose."""
        return self.boards_at + POSE * view


@dataclass(frozen=True, slots=True, eq=False)
class Bundle:
    """Bundle adjustment of given sightings of a given board.

    Residuals are counted in standard deviations of the camera that saw them: a projector whose pixels come from phases is
    not as sharp as a camera. `cost`, the normal equations and `huber` are in these units.
    """

    board: BoardDescription
    sights: tuple[IndexedSighting, ...]
    layout: Layout
    huber: float = np.inf
    sigmas_px: tuple[float, ...] = ()  # per camera, standard deviation of one coordinate of a corner; empty: 1 px
    mark_weights: FloatArray | None = None  # (M, M), 1/mm², inverse covariance of the marks' displacements along x, as along y
    flat_mm: FloatArray = field(init=False, repr=False)  # (M, 3), the board's marks without bow
    bow_terms: FloatArray = field(init=False, repr=False)  # (M, 3)
    seen: tuple[SeenByCamera, ...] = field(
        init=False, repr=False
    )  # the sights by camera: evaluated together, which takes a tenth of the time

    def __post_init__(self) -> None:
        object.__setattr__(self, "flat_mm", read_only(self.board.flat_corners_mm))
        object.__setattr__(self, "bow_terms", read_only(self.board.bow_terms))
        cameras = sorted({sight.camera for sight in self.sights})
        seen = (SeenByCamera.by(camera, [sight for sight in self.sights if sight.camera == camera]) for camera in cameras)
        object.__setattr__(self, "seen", tuple(seen))

    def sigma_px(self, camera: int) -> float:
        """Return the standard deviation of one coordinate of a corner in a camera."""
        return self.sigmas_px[camera] if self.sigmas_px else 1.0

    def residuals(self, state: BundleState, sight: IndexedSighting) -> FloatArray:
        """Return projected minus detected corners (N, 2)."""
        return self.residuals_of(state, SeenByCamera.by(sight.camera, [sight]))

    def residuals_of(self, state: BundleState, seen: SeenByCamera) -> FloatArray:
        """Return the same of all corners (N, 2) of a camera."""
        camera = invert_poses(state.reference_from_camera[seen.camera])
        turned, centres = self._on_boards(state, seen)
        points = (turned + centres) @ camera[:3, :3].T + camera[:3, 3]
        return np.asarray(state.pinholes[seen.camera].project(points) - seen.corners_px)

    def _on_boards(self, state: BundleState, seen: SeenByCamera) -> tuple[FloatArray, FloatArray]:
        """Return the corners (N, 3) of the boards as bowed and turned in ``state``, and the origins (N, 3) of their boards."""
        corners = np.array(self.flat_mm[seen.ids])
        corners[:, :IN_PLANE] += state.marks_mm[seen.ids]
        corners[:, 2] += self.bow_terms[seen.ids] @ state.bow_mm
        turned = np.empty_like(corners)
        for view, first, last in zip(seen.views, seen.firsts, [*seen.firsts[1:], len(corners)], strict=True):
            np.matmul(corners[first:last], state.reference_from_board[view, :3, :3].T, out=turned[first:last])
        return turned, state.reference_from_board[seen.views_of_corners, :3, 3]

    def cost(self, state: BundleState) -> float:
        """Return the robust sum of squares; displaced marks count by what is known of the board."""
        total = float(np.sum(state.marks_mm * self._pull_of_marks(state)))
        for seen in self.seen:
            length = self._whitened_lengths(state, seen)
            total += float(np.sum(np.where(length <= self.huber, length**2, self.huber * (2 * length - self.huber))))
        return total

    def linearise(self, state: BundleState) -> NormalEquations:
        """Return the normal equations, with Huber's weights [1]_.

        References
        ----------
        .. [1] P. J. Huber, Annals of Mathematical Statistics 35(1), 73-101, 1964.
        """
        size = self.layout.board_at(len(state.reference_from_board))
        hessian, gradient = np.zeros((size, size)), np.zeros(size)
        for seen in self.seen:
            residual, shared, by_board, index = self._derivatives(state, seen)
            sigma = self.sigma_px(seen.camera) * seen.spread
            weight = self._weight(np.linalg.norm(residual, axis=1) / sigma) * seen.used / sigma**2
            weighted = shared * weight[:, None, None]
            flat = weighted.reshape(-1, len(index))
            hessian[np.ix_(index, index)] += flat.T @ shared.reshape(-1, len(index))
            gradient[index] += flat.T @ residual.ravel()
            weighted_board = by_board * weight[:, None, None]
            for view, first, last in zip(seen.views, seen.firsts, [*seen.firsts[1:], len(residual)], strict=True):
                at, rows = self.layout.board_at(view), slice(2 * first, 2 * last)
                pulling = weighted_board[first:last].reshape(-1, POSE).T
                across = flat[rows].T @ by_board[first:last].reshape(-1, POSE)
                hessian[at : at + POSE, at : at + POSE] += pulling @ by_board[first:last].reshape(-1, POSE)
                hessian[index, at : at + POSE] += across
                hessian[at : at + POSE, index] += across.T
                gradient[at : at + POSE] += pulling @ residual[first:last].ravel()
            if self.layout.marks:
                self._add_marks(state, seen, (weight, residual), (weighted, by_board, index), (hessian, gradient))
        if self.layout.marks:
            marks = slice(self.layout.marks_at, self.layout.boards_at)
            gradient[marks] += self._pull_of_marks(state).ravel()
            if self.mark_weights is not None:
                hessian[marks, marks] += np.kron(self.mark_weights, np.eye(IN_PLANE))
        return NormalEquations(hessian, gradient, self.cost(state))

    def _add_marks(
        self,
        state: BundleState,
        seen: SeenByCamera,
        pulls: tuple[FloatArray, FloatArray],
        others: tuple[FloatArray, FloatArray, IntArray],
        normal: tuple[FloatArray, FloatArray],
    ) -> None:
        """Add to hessian and gradient ``normal`` what one camera knows of the marks, each of which few of its corners show.

        Parameters
        ----------
        pulls : weights (N,) and residuals (N, 2)
        others : weighted derivatives by the parameters that all views share, derivatives by board poses, and which the shared ones are
        """
        (weight, residual), (weighted, by_board, index), (hessian, gradient) = pulls, others, normal
        own = slice(self.layout.marks_at, self.layout.boards_at)
        by_mark = _spread_out(self._by_marks(state, seen), IN_PLANE * seen.ids, self.layout.marks)
        heavy = by_mark.multiply(np.repeat(weight, 2)[:, None]).tocsr()
        boards = _spread_out(by_board, POSE * seen.views_of_corners, POSE * len(state.reference_from_board))
        hessian[own, own] += (by_mark.T @ heavy).toarray()
        gradient[own] += heavy.T @ residual.ravel()
        for rows, across in (
            (index, (by_mark.T @ weighted.reshape(-1, len(index))).T),
            (np.arange(self.layout.boards_at, len(gradient)), (boards.T @ heavy).toarray()),
        ):
            hessian[rows, own] += across
            hessian[own, rows] += across.T

    def _by_marks(self, state: BundleState, seen: SeenByCamera) -> FloatArray:
        """Return the derivatives (N, 2, 2) of the pixels by the displacements of the marks they show."""
        turned, centres = self._on_boards(state, seen)
        place = state.reference_from_camera[seen.camera]
        _, by_point, _ = project_with_derivatives(state.pinholes[seen.camera], (turned + centres - place[:3, 3]) @ place[:3, :3])
        in_camera = place[:3, :3].T @ state.reference_from_board[seen.views_of_corners][:, :3, :IN_PLANE]
        return np.asarray(by_point @ in_camera)

    def _pull_of_marks(self, state: BundleState) -> FloatArray:
        """Return what is known of the board times the displacements, (M, 2)."""
        return np.zeros_like(state.marks_mm) if self.mark_weights is None else np.asarray(self.mark_weights @ state.marks_mm)

    def _weight(self, length: FloatArray) -> FloatArray:
        return np.where(length <= self.huber, 1.0, self.huber / np.maximum(length, TINY))

    def _whitened_lengths(self, state: BundleState, seen: SeenByCamera) -> FloatArray:
        """The lengths of the residuals that count, in standard deviations."""
        lengths = np.linalg.norm(self.residuals_of(state, seen)[seen.used], axis=1)
        return np.asarray(lengths / (self.sigma_px(seen.camera) * seen.spread[seen.used]))

    def linearise_sighting(self, state: BundleState, sight: IndexedSighting) -> tuple[FloatArray, FloatArray, IntArray]:
        """Return residuals (N, 2), their derivatives (N, 2, K) and which parameters these are (K,): the shared ones, then the board's pose."""
        residual, shared, by_board, index = self._derivatives(state, SeenByCamera.by(sight.camera, [sight]))
        board_at = self.layout.board_at(sight.view)
        return residual, np.concatenate([shared, by_board], axis=2), np.concatenate([index, np.arange(board_at, board_at + POSE)])

    def _derivatives(self, state: BundleState, seen: SeenByCamera) -> tuple[FloatArray, FloatArray, FloatArray, IntArray]:
        """Return residuals (N, 2), their derivatives by shared parameters (N, 2, K) and by board poses (N, 2, 6), and which the shared are (K,)."""
        turned, centres = self._on_boards(state, seen)
        place = state.reference_from_camera[seen.camera]
        from_centre = turned + centres - place[:3, 3]
        into_camera = place[:3, :3].T
        pixels, by_point, by_lens = project_with_derivatives(state.pinholes[seen.camera], from_centre @ into_camera.T)
        by_reference = by_point @ into_camera
        by_board = np.concatenate([-by_reference @ cross_matrices(turned), by_reference], axis=2)
        layout = self.layout
        blocks, lens_at = [by_lens], layout.lens_at(seen.camera)
        index = [np.arange(lens_at, lens_at + layout.lens)]
        if layout.bow:
            normals = state.reference_from_board[seen.views_of_corners][:, :3, 2]
            blocks.append(np.einsum("nij,nj->ni", by_reference, normals)[:, :, None] * self.bow_terms[seen.ids][:, None, :])
            index.append(np.arange(layout.bow_at, layout.marks_at))
        if seen.camera:
            blocks.append(np.concatenate([by_reference @ cross_matrices(from_centre), -by_reference], axis=2))
            index.append(np.arange(layout.pose_at(seen.camera), layout.pose_at(seen.camera) + POSE))
        return pixels - seen.corners_px, np.concatenate(blocks, axis=2), by_board, np.concatenate(index)

    def apply_step(self, state: BundleState, step: FloatArray) -> BundleState:
        """Return the state after a step of all parameters."""
        layout = self.layout
        lenses, places = [], [state.reference_from_camera[0]]
        for camera, pinhole in enumerate(state.pinholes):
            at = layout.lens_at(camera)
            lenses.append(apply_intrinsic_changes(pinhole, step[at : at + layout.lens]))
            if camera:
                at = layout.pose_at(camera)
                places.append(apply_changes(state.reference_from_camera[camera], step[at : at + POSE]))
        boards = apply_changes(state.reference_from_board, step[layout.boards_at :].reshape(-1, POSE))
        bow = state.bow_mm + step[layout.bow_at : layout.marks_at] if layout.bow else state.bow_mm
        marks = state.marks_mm + step[layout.marks_at : layout.boards_at].reshape(-1, IN_PLANE) if layout.marks else state.marks_mm
        return BundleState(tuple(lenses), np.array(places), boards, bow, marks)

    def variance(self, state: BundleState) -> float:
        """Return the variance of a residual in units of the one assumed by `sigmas_px`; 1 where that was right."""
        length = np.concatenate([self._whitened_lengths(state, seen) for seen in self.seen])
        known = float(np.sum(state.marks_mm * self._pull_of_marks(state)))  # as many observations as there are displacements
        freedom = 2 * len(length) + self.layout.marks - self.layout.board_at(len(state.reference_from_board))
        return (float(np.sum(self._weight(length) * length**2)) + known) / max(freedom, 1)


def adjust(
    board: BoardDescription,
    sights: Sequence[IndexedSighting],
    start: BundleState,
    *,
    free_bow: bool,
    mark_weights: FloatArray | None = None,
    known_cameras: int = 0,
    progress: Progress | None = None,
) -> tuple[Minimum[BundleState], Bundle]:
    """Minimise the robust reprojection error over lenses, camera poses, board poses and, if requested, the board's bow and its marks.

    Each camera's noise is estimated from its own residuals, and the adjustment repeated until the noise no longer changes.
    The first ``known_cameras`` stay as they are; without ``mark_weights`` (M, M), 1/mm², so do the marks.

    Returns
    -------
    minimum : the solution; its hessian counts residuals in units of the bundle's `sigmas_px`
    bundle : with the noise as it was weighted in the end
    """
    state = start
    for _ in range(NOISE_ROUNDS):
        bundle = robust_bundle(board, sights, state, free_bow=free_bow, mark_weights=mark_weights)
        held = bundle.layout.lens_at(known_cameras) if known_cameras else 0
        minimum = minimise(state, partial(_linearise_beyond, bundle, held), bundle.cost, bundle.apply_step, progress=progress)
        state = minimum.state
        if np.allclose(robust_sigmas(bundle, state), bundle.sigmas_px, rtol=SAME_NOISE):
            break
    return minimum, bundle


def _linearise_beyond(bundle: Bundle, held: int, state: BundleState) -> NormalEquations:
    """Return the normal equations with the first ``held`` parameters fixed."""
    normal = bundle.linearise(state)
    if not held:
        return normal
    hessian, gradient = np.eye(len(normal.gradient)), np.zeros(len(normal.gradient))
    hessian[held:, held:], gradient[held:] = normal.hessian[held:, held:], normal.gradient[held:]
    return NormalEquations(hessian, gradient, normal.cost)


def robust_bundle(
    board: BoardDescription,
    sights: Sequence[IndexedSighting],
    state: BundleState,
    *,
    free_bow: bool,
    mark_weights: FloatArray | None = None,
) -> Bundle:
    """Return the bundle of ``sights`` with weights and Huber limits from the residuals at ``state``."""
    marks = 0 if mark_weights is None else state.marks_mm.size
    layout = Layout(4 + len(state.pinholes[0].distortion), len(state.pinholes), BOW if free_bow else 0, marks)
    plain = Bundle(board, tuple(sights), layout)
    return Bundle(board, tuple(sights), layout, HUBER_FACTOR * float(np.sqrt(2)), robust_sigmas(plain, state), mark_weights)


def _spread_out(blocks: FloatArray, firsts: IntArray, size: int) -> csr_array:
    """Return derivatives (N, 2, K) as a sparse matrix (2 N, size), the columns of each pair of rows beginning at its first (N,)."""
    count, _, own = blocks.shape
    columns = np.repeat(firsts, 2)[:, None] + np.arange(own)
    return csr_array((blocks.ravel(), columns.ravel(), np.arange(0, blocks.size + 1, own)), shape=(2 * count, size))


def robust_sigmas(bundle: Bundle, state: BundleState) -> tuple[float, ...]:
    """Return each camera's standard deviation of one pixel coordinate, by the median of the absolute residuals."""
    sigmas = [LEAST_SIGMA_PX] * len(state.pinholes)
    for seen in bundle.seen:
        off = np.abs(bundle.residuals_of(state, seen) / seen.spread[:, None])[seen.used]
        sigmas[seen.camera] = max(1.4826 * float(np.median(off)), LEAST_SIGMA_PX)
    return tuple(sigmas)


def spread_of(sight: IndexedSighting) -> FloatArray:
    """Return the standard deviation (N,) of every corner over the usual one of its camera."""
    return np.ones(len(sight.corners_px)) if sight.spread is None else sight.spread
