"""The noise of a camera from fringe images alone: the residuals of N > 3 steps."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.fringe import FringeStack, PhaseShiftGroup
from measureapp.errors import CalibrationError
from measureapp.fringe.noise.photon_transfer import NoiseEstimate, fit_transfer
from measureapp.fringe.noise.transfer_points import BINS, LEAST_PIXELS, TransferPoint, bin_pixels

MOST_HARMONICS = 4
MOST_PIXELS = 400_000
MOST_CLIPPED = 0.01  # share of the pixels of one brightness that may be black or saturated in a step
MOST_HARMONIC = 0.1  # of the variance that a second harmonic may add


def noise_of_stack(stack: FringeStack, camera: str) -> NoiseEstimate:
    """Estimate the noise of a camera from its fringe images: a fallback where there are no flats, and a check of a model.

    N steps leave N − 3 sums in which the ideal fringes cancel; for N = 4 it is (I₀ − I₁ + I₂ − I₃)/2 with the variance σ_I². Its mean
    over the steps is that of the pixel's mean grey level, so that photon transfer applies. The harmonics of a projector
    without gamma correction fall into the same sums. From six steps on as many harmonics as fit, (N − 2)/2 and at most four,
    are removed with the fringes; of five steps only the part of the residual orthogonal to the second harmonic
    is used; of four steps only brightnesses at which no second harmonic shows. What remains: light that flickers between
    the images, motion, edges, and images that are not raw all count as noise. Flats are better wherever they can be taken.

    Raises
    ------
    CalibrationError
        No group has four steps or more, or too few pixels and brightnesses are neither black nor saturated.
    """
    points: list[TransferPoint] = []
    for exposure in range(len(stack.exposures_us)):
        start = 0
        for group in stack.patterns.groups:
            images = stack.images[camera][exposure, start : start + group.count]
            start += group.count
            if isinstance(group, PhaseShiftGroup) and group.steps >= 4:
                points += _points(images.reshape(group.steps, -1), stack.saturation)
    if not points:
        raise CalibrationError(
            f"The fringe images of camera {camera!r} do not show its noise: no group of four steps or more "
            "with enough light and without harmonics of the projector.",
            "Take flat images and use `measureapp noise`.",
        )
    return fit_transfer(points, stack.saturation, camera, 0.0, 1.0)


def _points(images: ImageArray, saturation: float) -> list[TransferPoint]:
    images = images[:, :: max(1, images.shape[1] // MOST_PIXELS)]
    usable = np.asarray((images.max(axis=0) < saturation) & (images.min(axis=0) > 0))
    number = (images.mean(axis=0) * (BINS / saturation)).astype(np.int64)
    whole = np.bincount(number, usable, BINS + 1) >= (1 - MOST_CLIPPED) * np.bincount(number, minlength=BINS + 1)
    usable &= whole[number]
    number = number[usable]
    values = images[:, usable].astype(np.float32)
    count = len(values)
    harmonics = min(MOST_HARMONICS, max(1, (count - 2) // 2))
    fitted = _basis(count, harmonics) @ values
    mean = values.mean(axis=0, dtype=np.float64)
    if count == 5:
        return bin_pixels(mean, _residual_orthogonal_to_harmonic(values, fitted), 1, np.ones(len(mean), bool), number) if len(mean) else []
    freedom = count - len(fitted)
    variance = np.maximum((values * values).sum(axis=0) - (fitted * fitted).sum(axis=0), 0.0).astype(np.float64) / freedom
    if count == 4:
        number = np.where(_has_harmonic(variance, fitted, number)[number], BINS, number)  # the last bin is not used
        keep = number < BINS
        mean, variance, number = mean[keep], variance[keep], number[keep]
    return bin_pixels(mean, variance, freedom, np.ones(len(mean), bool), number) if len(mean) else []


def _residual_orthogonal_to_harmonic(values: FloatArray, fitted: FloatArray) -> FloatArray:
    """Return the squared residual of five steps orthogonal to the second harmonic."""
    second = _basis(5, 2)[3:] @ values
    fringe = fitted[1] + 1j * fitted[2]
    turned = (second[0] + 1j * second[1]) * np.conj(fringe**2) / np.maximum(np.abs(fringe) ** 2, 1e-6)
    return np.asarray(turned.imag.astype(np.float64) ** 2)


def _has_harmonic(variance: FloatArray, fitted: FloatArray, number: IntArray) -> BoolArray:
    """Return for each brightness whether the residual of four steps is larger where a second harmonic would show, (BINS + 1,)."""
    cosine, sine = fitted[1].astype(np.float64), fitted[2].astype(np.float64)
    strong = np.abs(cosine**2 - sine**2) > 0.5**0.5 * (cosine**2 + sine**2)
    found = np.ones(BINS + 1, bool)
    for chosen in range(BINS):
        here = number == chosen
        shown, hidden = variance[here & strong], variance[here & ~strong]
        if min(len(shown), len(hidden)) >= LEAST_PIXELS // 3:
            scatter = np.hypot(shown.std() / len(shown) ** 0.5, hidden.std() / len(hidden) ** 0.5)
            found[chosen] = shown.mean() - hidden.mean() > MOST_HARMONIC * hidden.mean() + 2 * scatter
    return found


def _basis(count: int, harmonics: int) -> FloatArray:
    """Return orthonormal rows (1 + 2 · harmonics, N): mean, then cosine and sine of every harmonic of the shift."""
    shifts = 2 * np.pi * np.arange(count) / count
    rows = [np.full(count, count**-0.5)]
    for order in range(1, harmonics + 1):
        rows += [(2 / count) ** 0.5 * np.cos(order * shifts), (2 / count) ** 0.5 * np.sin(order * shifts)]
    return np.array(rows, np.float32)
