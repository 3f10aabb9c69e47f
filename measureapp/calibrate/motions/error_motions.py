"""Error motions of table and guide as parameters of the kinematic chain, with priors whose scales the calibration data refine."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_triangular

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.poses import apply_changes, left_jacobians
from measureapp.calibrate.projection import cross_matrices
from measureapp.data.axis_motions import GUIDE, ORDERS, TABLE, WAVES, AxisMotions, fourier, half_waves
from measureapp.data.calibration import RotationAxis

POSE = 6
KINDS = ((0, 1), (2, 3), (4,), (5, 6, 7), (8, 9, 10))  # components with one scale: tilt, radial, axial; turns and shifts of the slide
LARGEST_FACTOR = 30.0  # by which the data may change a scale
SCALES, SWEEPS = 41, 3  # tried of each kind over its range, one kind after the other
RMS_OF_SINE = np.sqrt(0.5)
TINY = 1e-300


@dataclass(frozen=True, slots=True, eq=False)
class MotionModel:
    """The error motions to estimate: their frames, and the prior standard deviation of each component.

    Coefficients are independent a priori, their standard deviations fall with the inverse of order and wave number: what turns or slides
    on bearings departs most from its course over long distances [1]_.

    References
    ----------
    .. [1] R. Donaldson, ANSI/ASME B89.3.4, Axes of rotation.
    """

    point_mm: FloatArray  # (3,), in the guide frame, about which the table tilts
    axes: FloatArray  # (3, 3), rows: x, y and the table's axis, in the guide frame
    limits_mm: FloatArray  # (2,), of the guide
    sigma: FloatArray  # (TABLE + GUIDE,), rms of each motion: tilt (2) in rad, radial (2), axial; turns (3) in rad and shifts (3) of the slide; 0: none

    @property
    def free(self) -> tuple[BoolArray, BoolArray]:
        """Which components (TABLE,) and (GUIDE,) are estimated."""
        return self.sigma[:TABLE] > 0, self.sigma[TABLE:] > 0

    @property
    def components(self) -> IntArray:
        """The component (M,) to which each coefficient belongs."""
        table, guide = self.free
        return np.concatenate([np.repeat(np.flatnonzero(table), 2 * ORDERS), np.repeat(TABLE + np.flatnonzero(guide), WAVES)])

    @property
    def size(self) -> int:
        """How many coefficients there are."""
        return len(self.components)

    @property
    def prior_sigma(self) -> FloatArray:
        """Standard deviations (M,) of the coefficients."""
        return self.sigma[self.components] * self._shares()

    def _shares(self) -> FloatArray:
        """Return the standard deviation (M,) of each coefficient for motions of rms 1."""
        orders, waves = 1 / np.repeat(np.arange(1, ORDERS + 1), 2), 1 / np.arange(1, WAVES + 1)
        table, guide = self.free
        turned, slid = orders * np.sqrt(2 / np.sum(orders**2)), waves * np.sqrt(2 / np.sum(waves**2))
        return np.concatenate([np.tile(turned, int(table.sum())), np.tile(slid, int(guide.sum()))])

    def table_design(self, angles_rad: FloatArray) -> FloatArray:
        """Return how the motions (N, 6, M) of the table top (turn about `point_mm`, shift, in the guide frame) follow the coefficients."""
        ways = np.zeros((POSE, TABLE))
        ways[:3, :2], ways[3:, 2:] = self.axes[:2].T, self.axes.T
        return self._design(ways, self.free[0], fourier(angles_rad), first=True)

    def guide_design(self, positions_mm: FloatArray) -> FloatArray:
        """Return how the motions (N, 6, M) of the robot's base (turn about its origin, shift) follow the coefficients."""
        return self._design(np.eye(GUIDE), self.free[1], half_waves(positions_mm, self.limits_mm), first=False)

    def _design(self, ways: FloatArray, free: BoolArray, terms: FloatArray, *, first: bool) -> FloatArray:
        own = np.einsum("pc,nk->npck", ways[:, free], terms).reshape(len(terms), POSE, -1)
        other = np.zeros((len(terms), POSE, self.size - own.shape[2]))
        return np.concatenate([own, other] if first else [other, own], axis=2)

    def motions(self, coefficients: FloatArray, explained_mm: float) -> AxisMotions:
        """Return the error motions with coefficients (M,)."""
        table, guide = (np.zeros(shape) for shape in ((TABLE, 2 * ORDERS), (GUIDE, WAVES)))
        free, split = self.free, 2 * ORDERS * int(self.free[0].sum())
        table[free[0]] = coefficients[:split].reshape(-1, 2 * ORDERS)
        guide[free[1]] = coefficients[split:].reshape(-1, WAVES)
        return AxisMotions(
            self.point_mm, self.axes, self.limits_mm, table, guide, self.sigma[:TABLE], self.sigma[TABLE:], explained_mm=explained_mm
        )


def motion_model(noise: AxisNoise, axis: RotationAxis, near_mm: FloatArray, *, guide: bool) -> MotionModel | None:
    """Return the motions to estimate for axes with this noise; None where they are stated to have none.

    Parameters
    ----------
    axis : approximately, in the guide frame
    near_mm : (3,), the table tilts about the point of the axis next to this one
    guide : whether the guide moved
    """
    table = np.array([noise.table_tilt_rad] * 2 + [noise.table_radial_mm] * 2 + [noise.table_axial_mm])
    slide = np.array([noise.slide_rad] * 3 + [noise.slide_mm] * 3) * guide
    sigma = RMS_OF_SINE * np.concatenate([table, slide])
    if not sigma.any():
        return None
    z = axis.direction
    x = np.eye(3)[int(np.argmin(np.abs(z)))]
    x = (x - (x @ z) * z) / np.linalg.norm(x - (x @ z) * z)
    point = axis.point_mm + float(z @ (near_mm - axis.point_mm)) * z
    return MotionModel(point, np.array([x, np.cross(z, x), z]), np.array([noise.slide_from_mm, noise.slide_to_mm]), sigma)


@dataclass(frozen=True, slots=True, eq=False)
class MovedAxes:
    """Table top and base as the error motions displace them at N sightings, and how that follows the coefficients."""

    model: MotionModel
    by_table: FloatArray  # (N, 6, M)
    by_guide: FloatArray  # (N, 6, M)
    table: FloatArray  # (N, 6), present motion of the table top
    guide: FloatArray  # (N, 6), of the base

    @classmethod
    def at(cls, model: MotionModel, coefficients: FloatArray, angles_rad: FloatArray, positions_mm: FloatArray) -> MovedAxes:
        """Return the motions with coefficients (M,) at angles and positions (N,)."""
        by_table, by_guide = model.table_design(angles_rad), model.guide_design(positions_mm)
        return cls(model, by_table, by_guide, by_table @ coefficients, by_guide @ coefficients)

    @property
    def table_poses(self) -> FloatArray:
        """The motion of the table top (N, 4, 4), guide ← guide."""
        moved = self.base_poses_of(self.table)
        point = self.model.point_mm
        moved[:, :3, 3] += point - moved[:, :3, :3] @ point
        return moved

    @property
    def base_poses(self) -> FloatArray:
        """The motion of the robot's base (N, 4, 4), base ← base."""
        return self.base_poses_of(self.guide)

    @staticmethod
    def base_poses_of(changes: FloatArray) -> FloatArray:
        """Return turns about the origin and shifts (N, 6) as matrices (N, 4, 4)."""
        return apply_changes(np.tile(np.eye(4), (len(changes), 1, 1)), changes)

    def board_changes(self, boards_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return turns and shifts (N, 3, M) of boards that are at (N, 3) on the moved table, by the coefficients."""
        return _turn_and_shift(self.by_table, self.table, boards_mm - self.model.point_mm - self.table[:, 3:])

    def sensor_changes(self, levers_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return turns and shifts (N, 3, M) of cameras that are (N, 3) away from the robot's base at rest, by the coefficients."""
        return _turn_and_shift(self.by_guide, self.guide, levers_mm - self.guide[:, 3:])


def _turn_and_shift(design: FloatArray, motion: FloatArray, levers_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    turn = left_jacobians(motion[:, :3]) @ design[:, :3]
    return turn, design[:, 3:] - cross_matrices(levers_mm) @ turn


def refine_scales(model: MotionModel, precision: FloatArray, pull: FloatArray, spread: float) -> tuple[MotionModel, float]:
    """Return the model with the scales of its motions as the data have them: the rms over their posterior (empirical Bayes) [1]_.

    Also returned is by how much the likeliest scales raise the logarithm of the posterior over that of the stated ones.

    The coefficients are integrated out; the logarithm of each scale has a normal prior about the stated one with standard deviation ``spread``.
    What the poses of the calibration do not show keeps the stated scale, with the spread of its prior in it. The posterior can have several
    maxima, where the sightings contradict the chain otherwise: each scale is looked for over its whole range, and never leaves it.

    Parameters
    ----------
    precision, pull : (M, M) and (M,), what the sightings alone tell of the coefficients c: exp(-½ cᵀ A c + bᵀ c)

    References
    ----------
    .. [1] C. M. Bishop, Pattern Recognition and Machine Learning, 2006, section 3.5.
    """
    present = [kind for kind in KINDS if np.isin(model.components, kind).any()]
    rows = [np.isin(model.components, kind) for kind in present]
    stated, range_ = model.prior_sigma, np.linspace(-1.0, 1.0, SCALES) * np.log(LARGEST_FACTOR)

    def cost(logs: FloatArray) -> float:
        sigma = stated * np.exp(sum((log * row for log, row in zip(logs, rows, strict=True)), np.zeros(len(stated))))
        inner = np.eye(len(sigma)) + sigma[:, None] * precision * sigma
        root = np.linalg.cholesky(inner)
        explained = solve_triangular(root, sigma * pull, lower=True, check_finite=False)
        return float(np.sum(np.log(np.diag(root))) - 0.5 * explained @ explained + 0.5 * np.sum((logs / spread) ** 2))

    likeliest, costs = np.zeros(len(rows)), np.zeros((len(rows), SCALES))
    for _ in range(SWEEPS):
        for place in range(len(rows)):
            others = np.arange(len(rows)) != place
            costs[place] = [cost(np.where(others, likeliest, log)) for log in range_]
            likeliest[place] = range_[np.argmin(costs[place])]
    weights = np.exp(costs.min(axis=1, keepdims=True) - costs)
    factors = np.sqrt(weights @ np.exp(2 * range_) / weights.sum(axis=1))
    sigma = model.sigma.copy()
    for factor, kind in zip(factors, present, strict=True):
        sigma[list(kind)] *= factor
    return replace(model, sigma=sigma), cost(np.zeros(len(rows))) - cost(likeliest)


def evidence_of(
    hessian: FloatArray,
    rows: IntArray,
    prior_sigma: FloatArray,
    at: FloatArray,
    variance: float,
    cameras: tuple[FloatArray, FloatArray, FloatArray] | None,
) -> tuple[FloatArray, FloatArray]:
    """Return precision (M, M) and pull (M,) of the coefficients by the sightings alone, with all else integrated out.

    Parameters
    ----------
    hessian : (P, P), of all parameters at the minimum, where its gradient is zero, with the coefficients' prior ``prior_sigma`` (M,)
    rows : (M,), of the coefficients among the P parameters
    at : (M,), the coefficients at the minimum
    variance : factor of all covariances by the residuals
    cameras : mixed derivatives (P, C), normal matrix (C, C) with the cameras' prior, and gradient (C,), where they are not parameters
    """
    slope = np.zeros(len(hessian))
    if cameras is not None:
        mixed, own, pulled = cameras
        hessian = np.block([[hessian, mixed], [mixed.T, own]])
        slope = np.concatenate([slope, pulled])
    rest = np.setdiff1d(np.arange(len(hessian)), rows)
    scale = np.sqrt(np.maximum(np.diag(hessian), TINY))
    unit, slope = hessian / np.outer(scale, scale), slope / scale
    across = unit[np.ix_(rest, rows)]
    solved = np.linalg.solve(unit[np.ix_(rest, rest)], np.column_stack([across, slope[rest]]))
    schur = (unit[np.ix_(rows, rows)] - across.T @ solved[:, :-1]) * np.outer(scale[rows], scale[rows])
    pull = schur @ at - scale[rows] * (slope[rows] - across.T @ solved[:, -1])
    return (schur - np.diag(prior_sigma**-2.0)) / variance, pull / variance
