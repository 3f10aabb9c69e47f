"""Phase shifting: from equally shifted sinusoids to the wrapped phase. For whole images in NumPy."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import DecodeError


def shift_weights(steps: int, shift_sign: int) -> tuple[FloatArray, FloatArray]:
    """Return the weights (N,) whose sums with the images are N/2 · B sin(phase) and N/2 · B cos(phase)."""
    if steps < 3:
        raise DecodeError(
            f"{steps} shifted images do not determine mean, modulation and phase.", "Record at least three steps of every pitch."
        )
    shifts = 2.0 * np.pi * np.arange(steps) / steps
    return -shift_sign * np.sin(shifts), np.cos(shifts)


def wrapped_phase(images: FloatArray, shift_sign: int = -1) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Recover the wrapped phase of N equally shifted fringe images [1]_.

    Image ``n`` is modelled as ``A + B * cos(phase + shift_sign * 2*pi*n/N)``.

    Parameters
    ----------
    images : (N, ...) float, N >= 3; linear grey levels, in shift order
    shift_sign : -1 or 1

    Returns
    -------
    phase_rad : (...), in (-pi, pi]
    modulation : (...), ``B`` in grey levels; masking by it is the caller's decision
    mean : (...), ``A`` in grey levels

    Raises
    ------
    DecodeError
        Fewer than three images, which leaves A, B and phase undetermined.

    References
    ----------
    .. [1] J. H. Bruning et al., Applied Optics 13(11), 2693-2703, 1974.
    """
    sine_weights, cosine_weights = shift_weights(len(images), shift_sign)
    sine = np.tensordot(sine_weights, images, 1)
    cosine = np.tensordot(cosine_weights, images, 1)
    return np.arctan2(sine, cosine), 2.0 / len(images) * np.hypot(sine, cosine), images.mean(axis=0)
