"""Noise correction of zone widths: widths are extremes, which noise always increases.

Linear propagation does not show this bias (JCGM 101, clause 5.10: non-linear models require Monte Carlo). It depends on the number of
points near the extremes, which is estimated from the heights themselves, see `estimate_noise_free_heights`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.inspection_program import Criterion
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import Scaled, fit, state_of
from measureapp.geometry.shapes import MODELS
from measureapp.geometry.zone_models import ZONES
from measureapp.inspection.features.feature_errors import ErrorSource, principal_errors
from measureapp.inspection.tolerances.empirical_bayes import estimate_noise_free_heights
from measureapp.inspection.value import Budget

SHIFT_DRAWS = 40  # for the mean bias, known to a sixth of the scatter of a single width
COVERAGE = 0.95
NOISE_ALONE = 0.975  # widths up to this quantile of those of pure noise are compatible with a perfect shape
ROUNDS = 30
SEED = 14
TINY = 1e-12


@dataclass(frozen=True, slots=True, eq=False)
class Zone:
    """Linearised zone: distances of extracted points from a shape, and their derivatives."""

    distances_mm: FloatArray  # (K, N): K = 2 for an axis in space
    derivatives: FloatArray  # (K, N, P)
    noise_mm: FloatArray  # (N,), standard deviations of the distances
    view_contributions: Mapping[ErrorSource, FloatArray] = field(default_factory=dict)  # (K N, M), errors of the distances by the views

    @classmethod
    def of(cls, shape: Shape, points_mm: FloatArray, noise_mm: FloatArray, by_views: Mapping[ErrorSource, FloatArray]) -> Zone:
        """Linearise at the least-squares fit, as form deviations are small compared with the shape. Raises FitError."""
        points = np.asarray(points_mm, np.float64)
        scaled = Scaled.of(points)
        model = MODELS["line"] if shape == "line" else ZONES[shape]
        distances, derivatives = model.evaluate(state_of(fit(shape, points), scaled), scaled.points)
        return cls(distances * scaled.scale_mm, derivatives, noise_mm, by_views)

    @classmethod
    def of_profile(
        cls, position: FloatArray, height_mm: FloatArray, noise_mm: FloatArray, by_views: Mapping[ErrorSource, FloatArray]
    ) -> Zone:
        """Return the strip about a profile over a straight line."""
        return cls(height_mm[None], np.stack([position, np.ones_like(position)], axis=1)[None], noise_mm, by_views)

    def fit_residuals(self, heights_mm: FloatArray) -> FloatArray:
        """Return the residuals (D, K, N) of heights from their own least-squares fits."""
        return self._rest(heights_mm, np.ones((len(heights_mm), heights_mm.shape[2])))

    def widths(self, heights_mm: FloatArray, criterion: Criterion) -> FloatArray:
        """Return the widths (D,) of the zones of heights (D, K, N) above the shape."""
        return self.fit_lawson(heights_mm, criterion)[0]

    def fit_lawson(self, heights_mm: FloatArray, criterion: Criterion) -> tuple[FloatArray, FloatArray]:
        """Minimum zone by Lawson's algorithm: return the widths (D,), and the weights (D, N) of the equivalent least-squares fits.

        Iterative reweighting for all draws at once (C. L. Lawson, thesis, UCLA, 1961); finally only the contact points have weight.
        """
        draws, many = len(heights_mm), heights_mm.shape[2]
        weights = np.full((draws, many), 1 / many)
        if criterion == "least-squares":
            return self._width(self._rest(heights_mm, weights)), weights
        widths = np.full(draws, np.inf)
        for _ in range(ROUNDS):
            far = np.sqrt(np.sum(self._rest(heights_mm, weights) ** 2, axis=1))
            widths = np.minimum(widths, 2 * far.max(axis=1))
            heavier = weights * (far + TINY)
            weights = heavier / heavier.sum(axis=1, keepdims=True)
        return widths, weights

    def ranges(self, heights_mm: FloatArray, weights: FloatArray) -> FloatArray:
        """Return the ranges (D,) of heights (D, K, N) about their weighted fits (weights (N,))."""
        return self._width(self._rest(heights_mm, np.broadcast_to(weights, (len(heights_mm), len(weights)))))

    @staticmethod
    def _width(rest_mm: FloatArray) -> FloatArray:
        """Return the range of distances (D, 1, N); for an axis in space twice the greatest distance."""
        if rest_mm.shape[1] == 1:
            return np.asarray(np.ptp(rest_mm[:, 0], axis=1))
        return np.asarray(2 * np.sqrt(np.sum(rest_mm**2, axis=1)).max(axis=1))

    def _rest(self, heights_mm: FloatArray, weights: FloatArray) -> FloatArray:
        """Return the residuals of heights (D, K, N) from their weighted least-squares fits (weights (D, N))."""
        parameters = self.derivatives.shape[2]
        products = np.einsum("knp,knq->npq", self.derivatives, self.derivatives).reshape(self.derivatives.shape[1], -1)
        normal = (weights @ products).reshape(len(weights), parameters, parameters)
        normal += TINY * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(parameters)
        derivatives = self.derivatives.reshape(-1, parameters)
        right = (weights[:, None] * heights_mm).reshape(len(weights), -1) @ derivatives
        change = np.linalg.solve(normal, right[..., None])[..., 0]
        return np.asarray(heights_mm - (change @ derivatives.T).reshape(heights_mm.shape))


@dataclass(frozen=True, slots=True)
class NoiseFreeWidth:
    """Width of a zone, corrected for noise."""

    value_mm: float
    sigma_mm: float  # half the expanded uncertainty
    shift_mm: float  # bias by noise, subtracted
    by_noise: bool = False  # explained by noise alone: the interval extends to zero


def estimate_noise_free_width(zones: Sequence[Zone], width_mm: float, criterion: Criterion, draws: int) -> NoiseFreeWidth:
    """Parametric bootstrap: estimate the greatest of several widths without the bias of noise.

    Noise-free heights are estimated, noise is added to them again, and the resulting increase of their range is subtracted from the
    measured width (B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap, 1993, 6.5). The same evaluation of ``draws``
    simulated measurements of the estimated form gives its errors. The expanded uncertainty is the 95 % quantile of their magnitude, bias
    included (JCGM 101, 7.7), because errors of extremes are not normal. If noise alone explains the width, the interval extends to zero;
    as a form deviation is never negative, it is then one-sided.

    Parameters
    ----------
    zones : linearised at the least-squares fits; evaluated by ``criterion``
    width_mm : greatest measured width of the zones
    """
    if max(float(zone.noise_mm.max()) for zone in zones) <= TINY:
        return NoiseFreeWidth(width_mm, 0.0, 0.0)
    rng = np.random.default_rng(SEED)
    shifted = _Shift.of(zones, criterion, rng)
    form = separate_noise(zones, [zone.distances_mm for zone in zones])
    noise = [zone.noise_mm * rng.standard_normal((draws, *zone.distances_mm.shape)) for zone in zones]
    made = [one[None] + added for one, added in zip(form, noise, strict=True)]
    true = _greatest(zones, [one[None] for one in form], criterion)[0]
    shifts = shifted.by([zone.fit_residuals(one) for zone, one in zip(zones, made, strict=True)])
    errors = _greatest(zones, made, criterion) - shifts - true
    shift = shifted.by([zone.distances_mm[None] for zone in zones])[0]
    value, reach = max(width_mm - shift, 0.0), float(np.quantile(np.abs(errors), COVERAGE))
    by_noise = width_mm <= float(np.quantile(_greatest(zones, noise, criterion), NOISE_ALONE))
    return NoiseFreeWidth(value, (max(reach, value) if by_noise else reach) / 2, width_mm - value, by_noise)


def propagate_view_errors(zones: Sequence[Zone], criterion: Criterion) -> Budget:
    """Propagate the errors of the views to the greatest of several widths; return the budget.

    Along every principal direction of the errors the larger of both changes counts, as in `propagate`.
    """
    heights = [zone.distances_mm[None] for zone in zones]
    base = _greatest(zones, heights, criterion)[0] if zones[0].view_contributions else 0.0
    variances: dict[str, float] = {}
    for source in zones[0].view_contributions:
        columns = np.vstack([zone.view_contributions[source] for zone in zones])
        rows = np.cumsum([zone.distances_mm.size for zone in zones])[:-1]
        changes = np.split(principal_errors(columns, np.ones(len(columns))).T, rows, axis=1)
        sides = [
            _greatest(
                zones, [at + sign * change.reshape(-1, *at.shape[1:]) for at, change in zip(heights, changes, strict=True)], criterion
            )
            for sign in (1.0, -1.0)
        ]
        larger = np.max([np.abs(side - base) for side in sides], axis=0)
        variances[source.contribution] = variances.get(source.contribution, 0.0) + float(larger @ larger)
    return {name: float(np.sqrt(variance)) for name, variance in variances.items()}


def _greatest(zones: Sequence[Zone], heights_mm: Sequence[FloatArray], criterion: Criterion) -> FloatArray:
    """Return the greatest of the zones' widths (D,) for heights (D, K, N) of each zone."""
    return np.asarray(np.max([zone.widths(one, criterion) for zone, one in zip(zones, heights_mm, strict=True)], axis=0))


def separate_noise(zones: Sequence[Zone], heights_mm: Sequence[FloatArray]) -> list[FloatArray]:
    """Estimate the noise-free heights (K, N) of all zones, assuming one distribution for all of them."""
    together = estimate_noise_free_heights(np.concatenate(heights_mm, axis=1), np.concatenate([zone.noise_mm for zone in zones]))
    return np.split(together, np.cumsum([one.shape[1] for one in heights_mm[:-1]]), axis=1)


@dataclass(frozen=True, slots=True, eq=False)
class _Shift:
    """Bias of the greatest width by noise."""

    zones: Sequence[Zone]
    criterion: Criterion
    draws_mm: Sequence[FloatArray]  # (SHIFT_DRAWS, K, N) for each zone

    @classmethod
    def of(cls, zones: Sequence[Zone], criterion: Criterion, rng: np.random.Generator) -> _Shift:
        return cls(zones, criterion, [zone.noise_mm * rng.standard_normal((SHIFT_DRAWS, *zone.distances_mm.shape)) for zone in zones])

    def by(self, heights_mm: Sequence[FloatArray]) -> FloatArray:
        """Return the mean bias for each of D measured heights (D, K, N).

        A zone follows the noise of its contact points, so that few contacts mean little bias: the fits of all draws use the weights of the
        noise-free contacts.
        """
        forms = [separate_noise(self.zones, [one[number] for one in heights_mm]) for number in range(len(heights_mm[0]))]
        weights = [zone.fit_lawson(np.stack(own), self.criterion)[1] for zone, *own in zip(self.zones, *forms, strict=True)]
        return np.array([self._mean(form, [one[number] for one in weights]) for number, form in enumerate(forms)])

    def _mean(self, form_mm: Sequence[FloatArray], weights: Sequence[FloatArray]) -> float:
        ranges = [
            zone.ranges(np.concatenate([form[None], form + draws]), weight)
            for zone, form, draws, weight in zip(self.zones, form_mm, self.draws_mm, weights, strict=True)
        ]
        greatest = np.max(ranges, axis=0)
        return float(greatest[1:].mean() - greatest[0])
