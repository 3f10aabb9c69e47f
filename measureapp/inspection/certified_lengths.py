"""Certified lengths measured with the part: what they correct, and what is left of the uncertainty of the other lengths.

What no residual shows - a scale, a symmetric vergence, stations that are all too deep - displaces a certified length as well as the others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.length_certificate import KnownLength
from measureapp.data.shown_number import shown_number
from measureapp.inspection.features.feature_errors import CERTIFICATE
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.propagation import covariance, propagate
from measureapp.inspection.value import Value

Measure = Callable[[Sequence[Feature]], float]
CONTRADICTED = 3.0  # standard deviations of measured less certified length
LEAST_GAIN = 0.01  # of the standard uncertainty; a smaller one is not worth a correction


@dataclass(frozen=True, slots=True, eq=False)
class CertifiedLength:
    """A certified length as measured: its features, and the function from them to the length."""

    name: str
    measure: Measure
    found: tuple[FoundFeature, ...]
    known: KnownLength
    assumed_mm: float = 0.0  # standard uncertainty of the measured length that is assumed beyond the errors of its features


@dataclass(frozen=True, slots=True)
class CertifiedLengths:
    """The certified lengths of a program; without any, values are as measured."""

    lengths: tuple[CertifiedLength, ...] = ()
    contradiction: str = ""  # what is wrong with the first that contradicts its uncertainty: then nothing is corrected

    @classmethod
    def of(cls, lengths: Sequence[CertifiedLength]) -> CertifiedLengths:
        """Return the certified lengths, compared with their measured values: more than three standard deviations are a contradiction."""
        for one in lengths:
            measured = cls().value(one.measure, one.found)
            off_mm = measured.value - one.known.length_mm
            sigma_mm = float(np.linalg.norm([measured.sigma, one.assumed_mm, one.known.sigma_mm]))
            if abs(off_mm) > CONTRADICTED * sigma_mm:
                return cls(tuple(lengths), _contradiction(one.name, off_mm, 2 * sigma_mm))
        return cls(tuple(lengths))

    def value(self, measure: Measure, found: Sequence[FoundFeature]) -> Value:
        """Return the best estimate of a length from its features and the certified lengths, with its uncertainty budget.

        With the joint covariance C of the length and of R certified ones, by the errors that their features share, the generalised least
        squares estimate is m - k (r - c) with k = C_mr (C_rr + U_c)⁻¹: m and r measured, c certified, U_c the certificates' variances
        (JCGM 102, 6; the conditional mean of normal errors). The errors of this difference are propagated as those of any value, so that
        what both share cancels, and the certificates are a contribution of their own.

        Where a certified length contradicts its uncertainty nothing is corrected, and the value says why it proves nothing.
        """
        plain = Value(*propagate(measure, found), doubt=self.contradiction)
        if not self.lengths or self.contradiction:
            return plain
        parts = [(measure, tuple(found)), *((one.measure, one.found) for one in self.lengths)]
        ends = np.cumsum([0, *(len(features) for _, features in parts)])

        def values(features: Sequence[Feature]) -> FloatArray:
            return np.array([one(features[start:end]) for (one, _), (start, end) in zip(parts, pairwise(ends), strict=True)])

        joint = [feature for _, features in parts for feature in features]
        shared = covariance(values, joint)
        certified, sigmas = np.array([(one.known.length_mm, one.known.sigma_mm) for one in self.lengths]).T
        gains = np.linalg.solve(shared[1:, 1:] + np.diag(sigmas**2), shared[0, 1:])
        value, budget = propagate(lambda features: float(values(features) @ [1.0, *-gains] + gains @ certified), joint)
        corrected = Value(value, {**budget, CERTIFICATE: float(np.linalg.norm(gains * sigmas))})
        if corrected.sigma > (1 - LEAST_GAIN) * plain.sigma:
            return plain
        return replace(corrected, how=_correction(", ".join(one.name for one in self.lengths), plain, corrected))


def _contradiction(name: str, off_mm: float, expanded_mm: float) -> str:
    return (
        f"The certified length {name} is off by {shown_number(off_mm, 4, signed=True)} mm, more than its uncertainty of {expanded_mm:.4f} mm (k = 2) explains: "
        "check its features and its certificate, or calibrate again"
    )


def _correction(names: str, plain: Value, corrected: Value) -> str:
    by_mm, before_mm, after_mm = corrected.value - plain.value, 2 * plain.sigma, 2 * corrected.sigma
    return f"corrected by {shown_number(by_mm, 4, signed=True)} mm by the certified length {names}, U {before_mm:.4f} → {after_mm:.4f} mm"
