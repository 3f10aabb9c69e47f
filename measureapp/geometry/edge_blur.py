"""Blur of an image from single edges in it, determined at its own pixels.

Reading an image between its pixels widens edges, those of sharp cameras by a third. So the values of the pixels near an edge are taken as
they are, each at its own distance from the edge, and a step blurred by a Gaussian is fitted to them (as ISO 12233 bins them; decision 15).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr

from measureapp.arrays import FloatArray, ImageArray

GAUSSIAN_RISE = 2.563  # from 10 to 90 % of an edge, over the standard deviation of its blur
FIRST_BLUR_PX = 0.7
LEAST_BLUR_PX, MOST_BLUR_PX = 0.1, 20.0
STEPS = 6  # of Levenberg and Marquardt
MOST_CHANGE = 0.7  # of the logarithm of the blur in one step
FIRST_DAMPING, LESS_DAMPING, MORE_DAMPING = 1e-2, 0.2, 5.0
PARAMETERS = 5  # dark level, step, offset, tilt, logarithm of the blur
BROAD_PX = 1e4  # a bright side without an end


@dataclass(frozen=True)
class EdgeShape:
    """How edges run, and what lies behind their bright sides.

    Attributes
    ----------
    bend : (N,), curvature, 1/px, positive where edges bend towards their normals
    bright_px : (N,), the width of the bright side; behind it the image is as dark as before the edge
    """

    bend: FloatArray | float = 0.0
    bright_px: FloatArray | float = BROAD_PX


STRAIGHT = EdgeShape()


def edge_blurs(
    image: FloatArray | ImageArray, places: FloatArray, normals: FloatArray, reach: tuple[float, float], shape: EdgeShape = STRAIGHT
) -> FloatArray:
    """Return the standard deviations of the blur at edges, pixel and lens together, (M,) px; M < N where edges lie at the border or are none.

    Parameters
    ----------
    image : (H, W)
    places, normals : (N, 2), a point of each edge to about 1 px, and the unit vector across it, to either side
    reach : px across and along an edge from its place, to which it is examined
    """
    across, along, levels, bright_px = _near(image, places, normals, reach, shape)
    if not len(levels):
        return np.empty(0)
    across, found = _first(across, levels, reach[0])
    damping = np.full(len(found), FIRST_DAMPING)
    left, slopes = _compare(found, across, along, levels, bright_px)
    for _ in range(STEPS):
        turned = np.swapaxes(slopes, 1, 2)
        normal = turned @ slopes
        normal += np.eye(PARAMETERS) * (damping[:, None, None] * normal + 1e-9)
        step = np.linalg.solve(normal, turned @ left[..., None])[..., 0]
        step[:, 4] = np.clip(step[:, 4], -MOST_CHANGE, MOST_CHANGE)
        tried = found + step
        tried[:, 4] = np.clip(tried[:, 4], np.log(LEAST_BLUR_PX), np.log(MOST_BLUR_PX))
        left_then, slopes_then = _compare(tried, across, along, levels, bright_px)
        better = np.sum(left_then**2, axis=1) < np.sum(left**2, axis=1)
        found = np.where(better[:, None], tried, found)
        left, slopes = np.where(better[:, None], left_then, left), np.where(better[:, None, None], slopes_then, slopes)
        damping *= np.where(better, LESS_DAMPING, MORE_DAMPING)
    return np.asarray(np.exp(found[abs(found[:, 2]) < reach[0], 4]))


def _near(
    image: FloatArray | ImageArray, places: FloatArray, normals: FloatArray, reach: tuple[float, float], shape: EdgeShape
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return distances across and along the edges and the values, (M, P) each, of the pixels within reach, and the widths (M, 1) of bright sides.

    Edges that do not lie in the image whole are left out.
    """
    a, b = (np.arange(-np.floor(most), np.floor(most) + 1.0) for most in reach)
    a, b = (one.ravel() for one in np.meshgrid(a, b))
    tangents = np.column_stack([-normals[:, 1], normals[:, 0]])
    wanted = places[:, None] + a[:, None] * normals[:, None] + b[:, None] * tangents[:, None]
    pixels = np.rint(wanted).astype(int)
    inside = np.all((pixels >= 0) & (pixels < np.array(image.shape[::-1])), axis=(1, 2))
    apart = pixels[inside] - places[inside, None]
    across, along = (np.einsum("npi,ni->np", apart, one[inside]) for one in (normals, tangents))
    bend, bright_px = (np.broadcast_to(one, len(places))[inside, None] for one in (shape.bend, shape.bright_px))
    return across - 0.5 * bend * along**2, along, image[pixels[inside, :, 1], pixels[inside, :, 0]].astype(float), bright_px


def _first(across: FloatArray, levels: FloatArray, reach: float) -> tuple[FloatArray, FloatArray]:
    """Return the distances (M, P) from dark to bright, and parameters (M, 5) to start from."""
    before, behind = (np.average(levels, axis=1, weights=abs(across - side * reach / 2) < reach / 2) for side in (-1.0, 1.0))
    across = np.where((behind < before)[:, None], -across, across)
    dark, bright = np.percentile(levels, (10.0, 90.0), axis=1)
    none = np.zeros(len(levels))
    return across, np.column_stack([dark, bright - dark, none, none, none + np.log(FIRST_BLUR_PX)])


def _compare(
    found: FloatArray, across: FloatArray, along: FloatArray, levels: FloatArray, bright_px: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return what the blurred step leaves of the values (M, P), and its derivatives by the parameters (M, P, 5)."""
    low, step, offset, tilt = (found[:, one : one + 1] for one in range(4))
    blur = np.exp(found[:, 4:])
    rising = (across - offset - tilt * along) / blur
    falling = rising - bright_px / blur
    rise = ndtr(rising) - ndtr(falling)
    up, down = (step * np.exp(-0.5 * one**2) / np.sqrt(2.0 * np.pi) for one in (rising, falling))
    slopes = [np.ones_like(rise), rise, (down - up) / blur, along * (down - up) / blur, falling * down - rising * up]
    return levels - low - step * rise, np.stack(slopes, axis=-1)
