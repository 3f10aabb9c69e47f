"""What noise does to the width of a zone, by simulation: widths are extremes, which noise moves in one direction.

The propagation of small changes knows of no such shift (JCGM 101, clause 5.10: where the model is not linear, distributions
are propagated by Monte Carlo).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr

from measureapp.arrays import FloatArray
from measureapp.data.inspection_program import Criterion
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import Scaled, fit, state_of
from measureapp.geometry.shapes import MODELS
from measureapp.geometry.zone_models import ZONES

LEVELS = (1.0, 3.0, 8.0)  # variance of the noise added, in those of the noise that is there
SQUARE_ROOT, SMOOTH, QUADRATIC = 0.5, 0.75, 1.0  # exponents of the growth with the variance
SHIFT_KNOWN_TO = 0.07  # of itself: a single set of points shows it; by simulation of flat faces of 60 to 300 cells
ROUNDS = 30
COVERAGE = 0.95
SEED = 14
TINY = 1e-12


@dataclass(frozen=True, slots=True, eq=False)
class Zone:
    """Distances of extracted points from their shape, and what small changes of the shape do to them."""

    distances_mm: FloatArray  # (K, N): K = 2 for an axis in space
    derivatives: FloatArray  # (K, N, P)
    noise_mm: FloatArray  # (N,), standard deviations of the distances

    @classmethod
    def of(cls, shape: Shape, points_mm: FloatArray, noise_mm: FloatArray) -> Zone:
        """Linearise at the least-squares fit; form errors are small beside the shape. Raises FitError."""
        points = np.asarray(points_mm, np.float64)
        scaled = Scaled.of(points)
        model = MODELS["line"] if shape == "line" else ZONES[shape]
        distances, derivatives = model.evaluate(state_of(fit(shape, points), scaled), scaled.points)
        return cls(distances * scaled.scale_mm, derivatives, noise_mm)

    @classmethod
    def of_profile(cls, position: FloatArray, height_mm: FloatArray, noise_mm: FloatArray) -> Zone:
        """The strip about a profile over a straight line."""
        return cls(height_mm[None], np.stack([position, np.ones_like(position)], axis=1)[None], noise_mm)

    def widths(self, added_mm: FloatArray, criterion: Criterion) -> FloatArray:
        """Return the widths (D,) of the zones with noise (D, K, N) added.

        The least greatest distance is approached by C. L. Lawson's reweighting (thesis, UCLA, 1961), for all draws at once.
        """
        draws, many, parameters = len(added_mm), self.distances_mm.shape[1], self.derivatives.shape[2]
        noisy = self.distances_mm + added_mm
        outer = np.einsum("knp,knq->npq", self.derivatives, self.derivatives).reshape(many, -1)
        weights, widths = np.full((draws, many), 1 / many), np.full(draws, np.inf)
        for _ in range(ROUNDS if criterion == "minimum-zone" else 1):
            normal = (weights @ outer).reshape(draws, parameters, parameters)
            normal += TINY * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(parameters)
            right = np.einsum("dn,dkn,knp->dp", weights, noisy, self.derivatives, optimize=True)
            rest = noisy - np.einsum("dp,knp->dkn", np.linalg.solve(normal, right[..., None])[..., 0], self.derivatives, optimize=True)
            if len(self.distances_mm) == 1 and criterion == "least-squares":
                return np.asarray(np.ptp(rest[:, 0], axis=1))
            far = np.sqrt(np.sum(rest**2, axis=1))
            widths = np.minimum(widths, 2 * far.max(axis=1))
            weights = weights * (far + TINY)
            weights /= weights.sum(axis=1, keepdims=True)
        return widths


def noise_of_width(zones: Sequence[Zone], criterion: Criterion, draws: int) -> float:
    """Return half the expanded uncertainty of the greatest of some widths: twice it holds the width without noise in 95 of 100 cases.

    Noise of once, three and eight times the variance is added. How the mean width grows from one to the next tells what the
    noise that was there already has added (simulation and extrapolation: J. R. Cook and L. A. Stefanski, JASA 89, 1994):
    with the noise itself where many places are nearly the furthest, with its variance where a smooth form has single ones.
    The scatter of the widths comes from the smallest noise.
    """
    rng = np.random.default_rng(SEED)
    units = [rng.standard_normal((draws, *zone.distances_mm.shape)) for zone in zones]

    def widths(level: float) -> FloatArray:
        added = [np.sqrt(level) * zone.noise_mm * unit for zone, unit in zip(zones, units, strict=True)]
        return np.max([zone.widths(noise, criterion) for zone, noise in zip(zones, added, strict=True)], axis=0)

    made = [widths(level) for level in LEVELS]
    shift = _shift([float(one.mean()) for one in made])
    return _holding(shift, float(np.hypot(made[0].std(ddof=1), SHIFT_KNOWN_TO * shift))) / 2


def _shift(means: Sequence[float]) -> float:
    """By how much the noise that is there has widened the zone, when a width grows by c·vᵉ with the variance v."""
    rise, further = max(means[1] - means[0], 0.0), max(means[2] - means[1], 0.0)
    if rise <= TINY:
        return 0.0
    one, two, three = (1 + level for level in LEVELS)
    exponents = np.linspace(SQUARE_ROOT, QUADRATIC, 51)
    ratios = (three**exponents - two**exponents) / (two**exponents - one**exponents)
    exponent = float(np.interp(further / rise, ratios, exponents))
    if exponent < SMOOTH:  # undecided: the greater shift, which is that of many nearly furthest places
        exponent = SQUARE_ROOT
    return rise / (two**exponent - one**exponent)


def _holding(shift: float, sigma: float) -> float:
    """Return the half width about 0 that a normal error about ``shift`` keeps within in 95 of 100 cases."""
    if sigma <= TINY:
        return abs(shift)
    return float(brentq(lambda u: ndtr((u - shift) / sigma) - ndtr((-u - shift) / sigma) - COVERAGE, 0.0, abs(shift) + 6 * sigma))
