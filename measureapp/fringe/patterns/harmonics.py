"""Harmonics of a projected waveform, the phase error they leave in N steps, and its correction.

A projector whose light does not follow the levels linearly shows, instead of a cosine, the waveform
cos φ + Σ b_k cos(kφ + ψ_k). Of N equally shifted images the harmonics k = mN ± 1 fall onto the fundamental, so that the
arctangent gives the argument of

    e^(iφ) + Σ_(k = mN+1) b_k e^(i(kφ + ψ_k)) + Σ_(k = mN−1) b_k e^(−i(kφ + ψ_k)),

a phase error of the orders mN: to first order ∓b_k sin(mNφ + ψ_k). Three steps suffer from the second and fourth harmonic, four
from the third and fifth, five from the fourth and sixth (K. A. Stetson, W. R. Brohinsky, Applied Optics 24(21), 3631-3637, 1985).
"""

from __future__ import annotations

import numpy as np
from pydantic import Field

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.model import Model
from measureapp.errors import DecodeError

PhaseCorrection = tuple[tuple[int, float, float], ...]  # (k, a, p): the measured phase is a sin(kφ + p) too large

TABLE = 4096
MULTIPLES = 4  # of the steps, up to which the correction has terms
NEGLIGIBLE_RAD = 1e-4
TILE_PX = 64
LEAST_TILE = 200  # usable pixels that determine a tile's harmonics
SIGNIFICANT = 3.0
LEAST_PIXELS = 5000


class Harmonic(Model):
    """One harmonic of a waveform, against its fundamental cos φ."""

    order: int = Field(ge=2)
    share: float = Field(ge=0, le=1, description="b_k, amplitude over that of the fundamental")
    phase_rad: float = Field(description="ψ_k, against the fundamental's crest")
    spread: float = Field(default=0.0, ge=0, description="rms by which the complex share differs over the image")


Waveform = tuple[Harmonic, ...]


def phase_error(waveform: Waveform, steps: int, phase_rad: FloatArray) -> FloatArray:
    """Return by how much ``steps`` equally shifted images give the phase too large, at true phases, in radians."""
    measured = np.exp(1j * phase_rad)
    for harmonic in waveform:
        term = harmonic.share * np.exp(1j * (harmonic.order * phase_rad + harmonic.phase_rad))
        if (harmonic.order - 1) % steps == 0:
            measured = measured + term
        if (harmonic.order + 1) % steps == 0:
            measured = measured + np.conj(term)
    return np.asarray(np.angle(measured * np.exp(-1j * phase_rad)))


def error_rms(waveform: Waveform, steps: int) -> float:
    """Return the root mean square of the phase error over a period, in radians."""
    return float(np.sqrt(np.mean(phase_error(waveform, steps, _circle()) ** 2)))


def kept_rms(waveform: Waveform, steps: int) -> float:
    """Return the residual phase error after a correction by mean harmonics, where they differ over the image, in radians."""
    squares = [h.spread**2 / 2 for h in waveform if (h.order - 1) % steps == 0 or (h.order + 1) % steps == 0]
    return float(np.sqrt(sum(squares)))


def phase_correction(waveform: Waveform, steps: int) -> PhaseCorrection:
    """Return the correction of wrapped phases of ``steps`` images; not to first order only.

    The error is tabulated over the true phase, turned into a function of the measured phase, and expanded into its Fourier
    series, which has the orders mN alone; those above four times the steps or below 0.1 mrad are omitted. So is the constant term,
    which would shift the phases of all cameras equally. Raises DecodeError where the harmonics are too strong for so few steps.
    """
    true = _circle()
    error = phase_error(waveform, steps, true)
    measured = true + error
    if np.any(np.diff(measured) <= 0):
        raise DecodeError(
            f"The harmonics of the projector are too strong for {steps} steps: equal phases come from different places.",
            "Use more steps, or patterns corrected beforehand.",
        )
    around = np.concatenate([measured - 2 * np.pi, measured, measured + 2 * np.pi])
    series = np.fft.rfft(np.interp(true, around, np.tile(error, 3))) * 2 / TABLE
    # a sin(kx + p) has the coefficient a e^(ip) / i
    terms = [(order, 1j * series[order]) for order in range(steps, (MULTIPLES + 1) * steps, steps)]
    return tuple((order, float(abs(term)), float(np.angle(term))) for order, term in terms if abs(term) > NEGLIGIBLE_RAD)


def correct_phase(phase_rad: FloatArray, correction: PhaseCorrection) -> FloatArray:
    """Return φ − Σ a sin(kφ + p): the NumPy statement of the decoder's correction of wrapped phases."""
    error = np.zeros_like(phase_rad)
    for order, amplitude, offset in correction:
        error += amplitude * np.sin(order * phase_rad + offset)
    return np.asarray(phase_rad - error)


def waveform_of_steps(images: FloatArray, shift_sign: int, usable: BoolArray) -> Waveform:
    """Estimate the harmonics from a dense set of equally shifted images, from the second to the last below half their number.

    Each harmonic is turned back by k times the phase of the fundamental and averaged with the fundamental's power as weight.

    Parameters
    ----------
    images : (N, H, W), N >= 6, linear grey levels in shift order
    usable : (H, W), neither saturated nor dark

    Raises
    ------
    DecodeError
        Fewer than six images, or too few usable pixels.
    """
    steps = len(images)
    if steps < 6:
        raise DecodeError(f"{steps} shifted images do not separate harmonics from noise.", "Record six or more steps; twelve are good.")
    _check_pixels(int(usable.sum()))
    fundamental = _harmonic(images, 1, shift_sign)
    power = np.where(usable, np.abs(fundamental) ** 2, 0.0)
    turned = fundamental / np.maximum(np.abs(fundamental), 1e-12)
    made = []
    for order in range(2, (steps - 1) // 2 + 1):
        # z · |I₁| is the share times the power
        weighted = _harmonic(images, order, shift_sign) * np.conj(turned) ** order * np.sqrt(power)
        mean = complex(weighted[usable].sum() / power.sum())
        spread = _spread(weighted, power, usable, mean)
        made.append(Harmonic(order=order, share=min(1.0, abs(mean)), phase_rad=float(np.angle(mean)), spread=spread))
    return tuple(made)


def waveform_of_histogram(phase_rad: FloatArray, steps: int) -> Waveform:
    """Estimate the harmonic that disturbs ``steps`` images from their own wrapped phases, without a dense set.

    True phases of a scene with many fringes are spread evenly; the error a sin(kφ + p) makes them denser by −k a cos(kφ + p).
    The Fourier coefficient of the order N therefore gives the error, as if it came from harmonic N − 1 alone; it is accepted
    when it is three times as large as the neighbouring orders, which no error of N steps can have.

    Parameters
    ----------
    phase_rad : (M,), wrapped phases of usable pixels

    Returns
    -------
    The harmonic of order N − 1; empty when the phases show no error beyond their own unevenness

    Raises
    ------
    DecodeError
        Too few pixels.

    References
    ----------
    .. [1] X. Chen, J. Xi, Y. Jin, Phase error compensation method using smoothing spline approximation for a three-dimensional
       shape measurement system based on gray-code and phase-shift light projection, Optical Engineering 47(11), 113601, 2008.
    """
    _check_pixels(phase_rad.size)
    moments = {order: complex(np.exp(-1j * order * phase_rad).mean()) for order in (steps - 1, steps, steps + 1)}
    if abs(moments[steps]) < SIGNIFICANT * max(abs(moments[steps - 1]), abs(moments[steps + 1])):
        return ()
    error = -2 / steps * moments[steps]
    return (Harmonic(order=steps - 1, share=min(1.0, abs(error)), phase_rad=float(np.angle(-error))),)


def _harmonic(images: FloatArray, order: int, shift_sign: int) -> FloatArray:
    steps = len(images)
    weights = np.exp(-2j * np.pi * shift_sign * order * np.arange(steps) / steps) * 2 / steps
    return np.asarray(np.tensordot(weights, images, 1))


def _spread(weighted: FloatArray, power: FloatArray, usable: BoolArray, mean: complex) -> float:
    """Return the rms difference of the tiles' own shares from the mean."""
    height, width = usable.shape
    squares = []
    for top in range(0, height, TILE_PX):
        for left in range(0, width, TILE_PX):
            tile = np.s_[top : top + TILE_PX, left : left + TILE_PX]
            chosen = usable[tile]
            if chosen.sum() >= LEAST_TILE:
                squares.append(abs(complex(weighted[tile][chosen].sum() / power[tile].sum()) - mean) ** 2)
    return float(np.sqrt(np.mean(squares))) if squares else 0.0


def _check_pixels(count: int) -> None:
    if count < LEAST_PIXELS:
        raise DecodeError(
            f"Only {count} pixels show fringes that are neither saturated nor dark; {LEAST_PIXELS} are needed.",
            "Record a bright, matt surface that fills the image.",
        )


def _circle() -> FloatArray:
    return np.arange(TABLE) * (2 * np.pi / TABLE)
