"""Errors of the print of a calibration board."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.simulate.board_kernel import PRINT_STEP_MM
from measureapp.simulate.effects.waves import Waves, draw_waves
from measureapp.simulate.options import WorldOptions

GLASS_PER_K = 9.0e-6
WAVELENGTHS_MM = (30.0, 300.0)


@dataclass(frozen=True, slots=True, eq=False)
class PrintErrors:
    """Displacement of the print from where the board's description has it: scale of x and y, shear, and local errors."""

    linear: FloatArray  # (2, 2), displacement per mm
    local: Waves

    def at(self, places_mm: FloatArray) -> FloatArray:
        """Return the displacement (N, 2) in mm at places (N, 2) of the board."""
        return np.asarray(places_mm @ self.linear.T + self.local.at(places_mm))

    def on_grid(self, width_mm: float, height_mm: float, first_mm: float) -> FloatArray:
        """Return the displacement (rows, columns, 2) float32 with a node every PRINT_STEP_MM from (first_mm, first_mm) on."""
        columns, rows = (int(np.ceil(size / PRINT_STEP_MM)) + 2 for size in (width_mm, height_mm))
        x, y = np.meshgrid(first_mm + PRINT_STEP_MM * np.arange(columns), first_mm + PRINT_STEP_MM * np.arange(rows))
        return self.at(np.column_stack([x.ravel(), y.ravel()])).reshape(rows, columns, 2).astype(np.float32)


def draw_print(options: WorldOptions, rng: np.random.Generator) -> PrintErrors | None:
    """Draw the errors of a board's print, expansion included; None if there are none."""
    effects = options.board
    common, own, shear = rng.standard_normal(), rng.standard_normal(2), rng.standard_normal()
    warm = GLASS_PER_K * options.warmth.board_excess_k * rng.uniform(0.5, 1.0)
    local = draw_waves(rng, effects.local_mm, WAVELENGTHS_MM, components=2, dimensions=2)
    if not (effects.scale_ppm or effects.local_mm or warm):
        return None
    scale = 1e-6 * effects.scale_ppm * (common + own) / np.sqrt(2.0) + warm
    slant = 0.3e-6 * effects.scale_ppm * shear
    return PrintErrors(read_only([[scale[0], slant], [slant, scale[1]]], np.float64), local)
