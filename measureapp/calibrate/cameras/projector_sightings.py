"""Projector coordinates of the marks of a board, from the phases around them in a camera image.

The phases of vertical and horizontal fringes determine which projector pixel lights a camera pixel [1]_: the projector is an inverse camera.
Around a mark both phases are smooth functions of the camera's pixel, so each is fitted by a quadratic polynomial over the pixels
nearer to it than its neighbours are, weighted by their own standard deviations, and read at the mark. Dark squares weigh little by
themselves; the mixing of light and dark pixels at edges is symmetric about a corner or a circle's centre and cancels.

References
----------
.. [1] S. Zhang, P. S. Huang, Optical Engineering 45(8), 083601, 2006.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, read_only
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.phase import PhaseMap

WINDOW_SHARE = 0.8  # radius of the window over the distance of the nearest mark
LEAST_RADIUS_PX = 3.0
LEAST_PIXELS = 24  # four times the coefficients
FAR_FACTOR = 4.0  # pixels farther from the polynomial, in robust standard deviations, do not count
LEAST_CORNERS = 8
RANK_TOLERANCE = 1e-12  # of the normal equations of a polynomial over the unit disc: what is below is a direction without pixels
PROJECTOR = "projector"


def device_title(name: str) -> str:
    """Return the name of a camera or the projector as the start of a sentence."""
    return "Projector" if name == PROJECTOR else f"Camera {name}"


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorPixels:
    """Which pixel of the projector lights each pixel of a camera around the board: the data from which the projector's marks are read."""

    corner_px: tuple[int, int]  # column and row of the camera's pixel that comes first
    pixels: FloatArray  # (2, H, W) float32, the projector's column and row
    sigma_px: FloatArray  # (2, H, W) float16, 0 where there is no phase

    def __post_init__(self) -> None:
        object.__setattr__(self, "pixels", read_only(self.pixels, np.float32, (2, None, None)))
        object.__setattr__(self, "sigma_px", read_only(self.sigma_px, np.float16, self.pixels.shape))

    @classmethod
    def around(cls, sighting: Sighting, vertical: PhaseMap) -> ProjectorPixels | None:
        """Return those around the marks of a sighting; None where the phase map has fringes of one direction only."""
        if vertical.orthogonal is None:
            return None
        reach = _radii(sighting.corners_px).max() + 1
        height, width = vertical.state.shape
        low = np.clip(np.floor(sighting.corners_px.min(axis=0) - reach), 0, [width - 1, height - 1]).astype(int)
        high = np.clip(np.ceil(sighting.corners_px.max(axis=0) + reach) + 1, low + 1, [width, height]).astype(int)
        part, maps = np.s_[low[1] : high[1], low[0] : high[0]], (vertical, vertical.orthogonal)
        sigma = [np.where(phase.valid[part], phase.sigma_rad[part] * phase.pixel_of_phase()[0], 0.0) for phase in maps]
        return cls((int(low[0]), int(low[1])), np.stack([phase.column_px[part] for phase in maps]), np.stack(sigma).astype(np.float16))


def projector_sighting(sighting: Sighting, lit: ProjectorPixels | None, projector: str = PROJECTOR) -> Sighting | Rejection:
    """Return the projector's sighting of the marks detected by one camera, or the reason for its rejection.

    Parameters
    ----------
    sighting : the marks in the camera that the phases belong to
    lit : which pixels of the projector light them; None where only the fringes of one direction are known

    Returns
    -------
    Sighting or Rejection : projector pixels (column, row) of the marks around which both phases are known, with their
        standard deviations
    """
    if lit is None:
        return Rejection(projector, sighting.view, "the fringes run in one direction only; vertical and horizontal ones are needed")
    radii, places = _radii(sighting.corners_px), sighting.corners_px - lit.corner_px
    sigmas = np.asarray(lit.sigma_px, np.float32)
    readings = [interpolate_at(values, sigma, sigma > 0, places, radii) for values, sigma in zip(lit.pixels, sigmas, strict=True)]
    known = np.isfinite(readings[0][0]) & np.isfinite(readings[1][0])
    if np.count_nonzero(known) < LEAST_CORNERS:
        return Rejection(
            projector, sighting.view, f"the phases around {np.count_nonzero(known)} marks are known; {LEAST_CORNERS} are needed"
        )
    pixels = np.column_stack([values for values, _ in readings])[known]
    sigma = np.sqrt(np.mean([deviations[known] ** 2 for _, deviations in readings], axis=0))
    return Sighting(projector, sighting.view, pixels, sighting.ids[known], sigma)


def interpolate_at(
    values: FloatArray, sigma: FloatArray, valid: BoolArray, places_px: FloatArray, radii_px: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Interpolate a map at sub-pixel positions by a weighted quadratic fit around each.

    Parameters
    ----------
    values, sigma, valid : (H, W)
    places_px : (N, 2), x and y
    radii_px : (N,)

    Returns
    -------
    read : (N,), NaN where fewer than 24 pixels around a place are valid or they lie on one side of it; the caller drops these
    deviations : (N,), standard deviations of the values
    """
    pairs = [_read_one(values, sigma, valid, place, radius) for place, radius in zip(places_px, radii_px, strict=True)]
    read, deviations = np.array(pairs).reshape(-1, 2).T
    return read, deviations


def _read_one(values: FloatArray, sigma: FloatArray, valid: BoolArray, place: FloatArray, radius: float) -> tuple[float, float]:
    nothing = (np.nan, np.nan)
    height, width = values.shape
    left, top = np.maximum(np.ceil(place - radius).astype(int), 0)
    right, bottom = np.minimum(np.floor(place + radius).astype(int) + 1, [width, height])
    if right <= left or bottom <= top:
        return nothing
    window = np.s_[top:bottom, left:right]
    x, y = (np.arange(left, right) - place[0]) / radius, (np.arange(top, bottom)[:, None] - place[1]) / radius
    use = valid[window] & (x * x + y * y <= 1)
    rows, columns = np.nonzero(use)
    x, y = x[columns], y[rows, 0]
    if not _is_surrounded(x, y):
        return nothing
    terms = np.stack([np.ones(len(x)), x, y, x * x, x * y, y * y])
    weight, seen = 1.0 / np.asarray(sigma[window][use], float), np.asarray(values[window][use], float)
    for _ in range(2):  # without the pixels far off, once
        weighted = terms * weight
        inverse = np.linalg.pinv(weighted @ weighted.T, rcond=RANK_TOLERANCE)
        found = inverse @ (weighted @ (seen * weight))
        off = np.abs(seen - found @ terms) * weight
        spread = max(1.4826 * float(np.median(off)), 1.0)
        near = off <= FAR_FACTOR * spread
        if near.all():
            break
        terms, weight, seen = terms[:, near], weight[near], seen[near]
        if len(seen) < LEAST_PIXELS:
            return nothing
    return float(found[0]), spread * float(np.sqrt(inverse[0, 0]))


def _is_surrounded(x: FloatArray, y: FloatArray) -> bool:
    """Whether there are pixels enough, and on all four sides."""
    least = max(LEAST_PIXELS // 4, len(x) // 5)
    return len(x) >= LEAST_PIXELS and all(np.count_nonzero(side) >= least for side in (x > 0, x < 0, y > 0, y < 0))


def _radii(corners_px: FloatArray) -> FloatArray:
    """Radii (N,) of the windows, a fraction of the distance to the nearest other mark."""
    apart = np.linalg.norm(corners_px[:, None] - corners_px[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    return np.asarray(np.maximum(WINDOW_SHARE * apart.min(axis=1), LEAST_RADIUS_PX))
