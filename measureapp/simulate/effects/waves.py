"""Smooth random fields as sums of plane waves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only

NUMBER = 12


@dataclass(frozen=True, slots=True, eq=False)
class Waves:
    """A smooth field: every component is a sum of plane waves over the coordinates; its rms is its amplitude."""

    vectors: FloatArray  # (C, K, D), radians per unit of the coordinates
    phases: FloatArray  # (C, K)
    rms: float  # of every component

    def at(self, places: FloatArray) -> FloatArray:
        """Return the field (N, C) at places (N, D)."""
        if self.rms == 0.0:
            return np.zeros((len(places), len(self.vectors)))
        found = np.zeros((len(places), len(self.vectors)))
        for k in range(self.vectors.shape[1]):
            found += np.cos(places @ self.vectors[:, k].T + self.phases[:, k])
        return self.rms * np.sqrt(2.0 / self.vectors.shape[1]) * found


def draw_waves(rng: np.random.Generator, rms: float, wavelengths: tuple[float, float], *, components: int, dimensions: int) -> Waves:
    """Draw a field whose wavelengths are log-uniform between two limits and whose directions are isotropic."""
    direction = rng.normal(size=(components, NUMBER, dimensions))
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
    low, high = np.log(wavelengths)
    length = np.exp(rng.uniform(low, high, (components, NUMBER, 1)))
    return Waves(read_only(2.0 * np.pi * direction / length), read_only(rng.uniform(0.0, 2.0 * np.pi, (components, NUMBER))), rms)


def sampled(waves: Waves, width: int, height: int, step: float) -> FloatArray:
    """Return the field on a grid (rows, columns, C) float32 that covers ``width`` × ``height`` with one node every ``step``."""
    columns, rows = int(np.ceil(width / step)) + 2, int(np.ceil(height / step)) + 2
    x, y = np.meshgrid(np.arange(columns) * step, np.arange(rows) * step)
    return waves.at(np.column_stack([x.ravel(), y.ravel()])).reshape(rows, columns, -1).astype(np.float32)
