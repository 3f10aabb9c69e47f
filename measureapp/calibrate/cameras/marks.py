"""How far the marks of a board are from where it has them, as the images of a calibration show it.

A board is seen from so many sides that its marks can be measured by the same images that calibrate the cameras [1]_. What images do not
show is the board's size, and with few marks little of its shape; a normal distribution of the displacements stands in for that. It has a
part that every mark has alone and one that neighbours share (paper that stretched, a plotter's error), the latter with the squared
exponential covariance of [2]_. Its three parameters are those under which the residuals are the most probable: section 5.4.1 of [2]_.

References
----------
.. [1] J.-M. Lavest, M. Viala, M. Dhome, Do we really need an accurate calibration pattern to achieve a reliable camera calibration?,
   ECCV 1998, LNCS 1406, 158-174.
.. [2] C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for Machine Learning, MIT Press, 2006.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import lu_factor, lu_solve
from scipy.optimize import minimize
from scipy.spatial.distance import pdist, squareform

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.bundle import IN_PLANE, Bundle, BundleState
from measureapp.calibrate.least_squares import Minimum
from measureapp.data.board import BoardDescription

LEAST_SHARE = 1.5e-4  # of the distance of neighbouring marks: smaller displacements move no lens by what anybody measures
SURE = 30.0  # twice the logarithm of how much more probable the residuals are if the marks are displaced; noise alone: below 10
FIRST_LENGTHS = (1.5, 4.0)  # distances of neighbouring marks over which neighbours share displacements, from which the search begins
SEARCH = {"xatol": 0.05, "fatol": 0.1, "maxiter": 150}  # logarithms: 5 % of a length


@dataclass(frozen=True, slots=True)
class MarkScatter:
    """Normal distribution of the marks' displacements along x, and of those along y, independent of each other."""

    own_mm: float  # standard deviation of the part that every mark has alone
    shared_mm: float = 0.0  # the same of the part that neighbours share
    length_mm: float = 1.0  # over which they share it

    @property
    def rms_mm(self) -> float:
        """Standard deviation of one coordinate of a mark."""
        return float(np.hypot(self.own_mm, self.shared_mm))

    def covariance(self, marks_mm: FloatArray) -> FloatArray:
        """Return the covariance (M, M), mm², of the displacements of marks (M, 2) along x, as along y."""
        shared = self.shared_mm**2 * np.exp(-0.5 * squareform(pdist(marks_mm, "sqeuclidean")) / self.length_mm**2)
        return np.asarray(shared + self.own_mm**2 * np.eye(len(marks_mm)))

    def weights(self, board: BoardDescription) -> FloatArray:
        """Return the inverse (M, M), 1/mm², of the covariance of a board's marks."""
        return np.asarray(np.linalg.inv(self.covariance(board.flat_corners_mm[:, :IN_PLANE])))


@dataclass(frozen=True, slots=True, eq=False)
class _Evidence:
    """What the images know of the displacements when lenses, cameras and boards follow them: cost = dᵀ A d + 2 bᵀ d + constant."""

    information: FloatArray  # (2 M, 2 M), A
    pull: FloatArray  # (2 M,), b
    marks_mm: FloatArray  # (M, 2)

    def gain(self, scatter: MarkScatter) -> float:
        """Return twice the logarithm of how much more probable the residuals are with displaced marks than without."""
        covariance = scatter.covariance(self.marks_mm)  # the same along x and y, and none between them: half of the products are zero
        product = (covariance @ self.information.reshape(len(covariance), -1)).reshape(self.information.shape)
        np.fill_diagonal(product, np.diag(product) + 1.0)
        factors = lu_factor(product)
        spread = float(np.sum(np.log(np.abs(np.diag(factors[0])))))
        pulled = (covariance @ self.pull.reshape(len(covariance), IN_PLANE)).ravel()
        return float(self.pull @ lu_solve(factors, pulled)) - spread


def find_scatter(bundle: Bundle, minimum: Minimum[BundleState], known_cameras: int = 0) -> MarkScatter | None:
    """Return how the marks of a board scatter about where it has them; None where they do by nothing that matters.

    Parameters
    ----------
    bundle, minimum : of an adjustment that takes the marks for known
    known_cameras : how many of the first cameras were given, and follow no mark
    """
    evidence = _evidence(bundle, minimum, bundle.layout.lens_at(known_cameras) if known_cameras else 0)
    apart = bundle.board.neighbour_mm
    alone = _most_probable(evidence, (np.log(LEAST_SHARE * apart),))
    if alone.own_mm < LEAST_SHARE * apart or evidence.gain(alone) < SURE:
        return None
    smooth = [
        _most_probable(evidence, (np.log(0.5 * alone.own_mm), np.log(alone.own_mm), np.log(share * apart))) for share in FIRST_LENGTHS
    ]
    return max([alone, *smooth], key=evidence.gain)


def _evidence(bundle: Bundle, minimum: Minimum[BundleState], held: int) -> _Evidence:
    """Eliminate everything but the marks and the first ``held`` parameters, which stay as they are (Schur complement)."""
    layout = replace(bundle.layout, marks=minimum.state.marks_mm.size)
    normal = replace(bundle, layout=layout).linearise(minimum.state)
    own = np.zeros(len(normal.gradient), bool)
    own[layout.marks_at : layout.boards_at] = True
    variance = bundle.variance(minimum.state)
    others = ~own
    others[:held] = False
    across = normal.hessian[np.ix_(others, own)]
    follow = minimum.covariance()[held:, held:] @ across
    information = normal.hessian[np.ix_(own, own)] - across.T @ follow
    pull = normal.gradient[own] - follow.T @ normal.gradient[others]
    return _Evidence((information + information.T) / (2 * variance), pull / variance, bundle.flat_mm[:, :IN_PLANE])


def _most_probable(evidence: _Evidence, start: tuple[float, ...]) -> MarkScatter:
    """Return the scatter of the greatest gain near the logarithms ``start`` of its parameters."""
    least, most = float(np.log(pdist(evidence.marks_mm).min() / 3.0)), float(np.log(pdist(evidence.marks_mm).max()))

    def scatter_of(logarithms: FloatArray) -> MarkScatter:
        own, *shared = np.exp(logarithms)
        if not shared:
            return MarkScatter(float(own))
        return MarkScatter(float(own), float(shared[0]), float(np.exp(np.clip(logarithms[2], least, most))))

    return scatter_of(minimize(lambda at: -evidence.gain(scatter_of(at)), start, method="Nelder-Mead", options=SEARCH).x)
