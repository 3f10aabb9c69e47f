"""What noise does to the width of a zone: widths are extremes, which noise moves in one direction.

The propagation of small changes knows of no such shift (JCGM 101, clause 5.10: where the model is not linear, distributions
are propagated by Monte Carlo). The shift depends on how many places lie nearly furthest, which is estimated from the heights
themselves, see `noise_free_heights`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.inspection_program import Criterion
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import Scaled, fit, state_of
from measureapp.geometry.shapes import MODELS
from measureapp.geometry.zone_models import ZONES
from measureapp.inspection.features.errors import Source, principal
from measureapp.inspection.tolerances.noise_free import noise_free_heights
from measureapp.inspection.value import Budget

SHIFT_DRAWS = 40  # for the mean shift: known to a sixth of the scatter of a single width
NOISE_ALONE = 0.975  # widths up to this quantile of those of noise alone leave a perfect shape possible
ROUNDS = 30
SEED = 14
TINY = 1e-12


@dataclass(frozen=True, slots=True, eq=False)
class Zone:
    """Distances of extracted points from their shape, and what small changes of the shape do to them."""

    distances_mm: FloatArray  # (K, N): K = 2 for an axis in space
    derivatives: FloatArray  # (K, N, P)
    noise_mm: FloatArray  # (N,), standard deviations of the distances
    by_views: Mapping[Source, FloatArray] = field(default_factory=dict)  # (K N, M), errors of the distances because of the views

    @classmethod
    def of(cls, shape: Shape, points_mm: FloatArray, noise_mm: FloatArray, by_views: Mapping[Source, FloatArray]) -> Zone:
        """Linearise at the least-squares fit; form errors are small beside the shape. Raises FitError."""
        points = np.asarray(points_mm, np.float64)
        scaled = Scaled.of(points)
        model = MODELS["line"] if shape == "line" else ZONES[shape]
        distances, derivatives = model.evaluate(state_of(fit(shape, points), scaled), scaled.points)
        return cls(distances * scaled.scale_mm, derivatives, noise_mm, by_views)

    @classmethod
    def of_profile(cls, position: FloatArray, height_mm: FloatArray, noise_mm: FloatArray, by_views: Mapping[Source, FloatArray]) -> Zone:
        """The strip about a profile over a straight line."""
        return cls(height_mm[None], np.stack([position, np.ones_like(position)], axis=1)[None], noise_mm, by_views)

    def fitted(self, heights_mm: FloatArray) -> FloatArray:
        """Return heights (D, K, N) from their own least-squares fits."""
        weights = np.full((len(heights_mm), heights_mm.shape[2]), 1.0)
        return self._rest(heights_mm, weights, self._products())

    def widths(self, heights_mm: FloatArray, criterion: Criterion) -> FloatArray:
        """Return the widths (D,) of the zones of heights (D, K, N) above the shape.

        The least greatest distance is approached by C. L. Lawson's reweighting (thesis, UCLA, 1961), for all draws at once.
        """
        draws, many = len(heights_mm), heights_mm.shape[2]
        products = self._products()
        weights, widths = np.full((draws, many), 1 / many), np.full(draws, np.inf)
        for _ in range(ROUNDS if criterion == "minimum-zone" else 1):
            rest = self._rest(heights_mm, weights, products)
            if len(self.derivatives) == 1 and criterion == "least-squares":
                return np.asarray(np.ptp(rest[:, 0], axis=1))
            far = np.sqrt(np.sum(rest**2, axis=1))
            widths = np.minimum(widths, 2 * far.max(axis=1))
            weights = weights * (far + TINY)
            weights /= weights.sum(axis=1, keepdims=True)
        return widths

    def _products(self) -> FloatArray:
        return np.einsum("knp,knq->npq", self.derivatives, self.derivatives).reshape(self.derivatives.shape[1], -1)

    def _rest(self, heights_mm: FloatArray, weights: FloatArray, products: FloatArray) -> FloatArray:
        """Heights from their weighted least-squares fits."""
        parameters = self.derivatives.shape[2]
        normal = (weights @ products).reshape(len(weights), parameters, parameters)
        normal += TINY * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(parameters)
        right = np.einsum("dn,dkn,knp->dp", weights, heights_mm, self.derivatives, optimize=True)
        change = np.linalg.solve(normal, right[..., None])[..., 0]
        return np.asarray(heights_mm - np.einsum("dp,knp->dkn", change, self.derivatives, optimize=True))


@dataclass(frozen=True, slots=True)
class TrueWidth:
    """The width that a zone would have without noise."""

    value_mm: float
    sigma_mm: float  # half the expanded uncertainty
    shift_mm: float  # by which noise had widened the zone: taken off


def width_without_noise(zones: Sequence[Zone], width_mm: float, criterion: Criterion, draws: int) -> TrueWidth:
    """Estimate the greatest of some widths as it would be without noise.

    A parametric bootstrap (B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap, 1993, 6.5): the heights without
    noise are estimated, noise is added to them again, and what it does to their range is taken off the width measured. The same
    evaluation, that estimate included, of ``draws`` simulated measurements of the estimated form tells by how much it errs; the
    root mean square of those errors, bias included, is the standard uncertainty. Where noise alone could have made the
    width, the uncertainty reaches down to zero.

    Parameters
    ----------
    zones : at the least-squares fits; their widths are taken by ``criterion``
    width_mm : greatest of the zones' widths as measured
    """
    if max(float(zone.noise_mm.max()) for zone in zones) <= TINY:
        return TrueWidth(width_mm, 0.0, 0.0)
    rng = np.random.default_rng(SEED)
    heights = _Heights.of(zones, rng)
    form = heights.noise_free([zone.distances_mm for zone in zones])
    noise = [zone.noise_mm * rng.standard_normal((draws, *zone.distances_mm.shape)) for zone in zones]
    made = [one[None] + added for one, added in zip(form, noise, strict=True)]
    true = _greatest(zones, [one[None] for one in form], criterion)[0]
    fitted = [zone.fitted(one) for zone, one in zip(zones, made, strict=True)]
    shifts = np.array([heights.shift([one[number] for one in fitted]) for number in range(draws)])
    errors = _greatest(zones, made, criterion) - shifts - true
    shift = heights.shift([zone.distances_mm for zone in zones])
    value, sigma = max(width_mm - shift, 0.0), float(np.sqrt(np.mean(errors**2)))
    if width_mm <= float(np.quantile(_greatest(zones, noise, criterion), NOISE_ALONE)):
        sigma = max(sigma, value / 2)
    return TrueWidth(value, sigma, width_mm - value)


def widths_by_views(zones: Sequence[Zone], criterion: Criterion) -> Budget:
    """Return what the errors of the views add to the standard uncertainty of the greatest of some widths, by shares.

    Along every principal direction of the errors the larger change to either side counts, as in `propagated`.
    """
    heights = [zone.distances_mm[None] for zone in zones]
    base = _greatest(zones, heights, criterion)[0] if zones[0].by_views else 0.0
    variances: dict[str, float] = {}
    for source in zones[0].by_views:
        columns = np.vstack([zone.by_views[source] for zone in zones])
        rows = np.cumsum([zone.distances_mm.size for zone in zones])[:-1]
        changes = np.split(principal(columns, np.ones(len(columns))).T, rows, axis=1)
        sides = [
            _greatest(
                zones, [at + sign * change.reshape(-1, *at.shape[1:]) for at, change in zip(heights, changes, strict=True)], criterion
            )
            for sign in (1.0, -1.0)
        ]
        larger = np.max([np.abs(side - base) for side in sides], axis=0)
        variances[source.share] = variances.get(source.share, 0.0) + float(larger @ larger)
    return {share: float(np.sqrt(variance)) for share, variance in variances.items()}


def _greatest(zones: Sequence[Zone], heights_mm: Sequence[FloatArray], criterion: Criterion) -> FloatArray:
    """Return the greatest of the zones' widths (D,) for heights (D, K, N) of each zone."""
    return np.asarray(np.max([zone.widths(one, criterion) for zone, one in zip(zones, heights_mm, strict=True)], axis=0))


@dataclass(frozen=True, slots=True, eq=False)
class _Heights:
    """The heights of all zones side by side, and the noise by which their range is shifted."""

    starts: IntArray  # (Z,), first column of each zone
    noise_mm: FloatArray  # (N,)
    draws_mm: FloatArray  # (SHIFT_DRAWS, K, N)

    @classmethod
    def of(cls, zones: Sequence[Zone], rng: np.random.Generator) -> _Heights:
        counts = [zone.distances_mm.shape[1] for zone in zones]
        noise = np.concatenate([zone.noise_mm for zone in zones])
        draws = noise * rng.standard_normal((SHIFT_DRAWS, len(zones[0].distances_mm), len(noise)))
        return cls(np.cumsum([0, *counts[:-1]]), noise, draws)

    def noise_free(self, heights_mm: Sequence[FloatArray]) -> list[FloatArray]:
        together = noise_free_heights(np.concatenate(heights_mm, axis=1), self.noise_mm)
        return np.split(together, self.starts[1:], axis=1)

    def shift(self, heights_mm: Sequence[FloatArray]) -> float:
        """Return by how much noise widens the greatest range, on average."""
        form = np.concatenate(self.noise_free(heights_mm), axis=1)
        return float(self._ranges(form[None] + self.draws_mm).mean() - self._ranges(form[None])[0])

    def _ranges(self, heights_mm: FloatArray) -> FloatArray:
        """Greatest range (D,) of the heights (D, K, N) of any zone; for an axis in space twice the greatest distance."""
        if heights_mm.shape[1] > 1:
            return np.asarray(2 * np.sqrt(np.sum(heights_mm**2, axis=1)).max(axis=1))
        flat = heights_mm[:, 0]
        return np.asarray((np.maximum.reduceat(flat, self.starts, axis=1) - np.minimum.reduceat(flat, self.starts, axis=1)).max(axis=1))
