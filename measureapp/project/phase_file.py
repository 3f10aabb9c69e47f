"""Phase maps on disk: NumPy archives that other programs can read."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from measureapp.data.phase import PhaseMap
from measureapp.project.atomic import replacing


def write_phase_map(path: Path, phase_map: PhaseMap) -> None:
    """Write an `.npz`, whole or not at all; `mask` holds the `PixelState` of every pixel (0: valid). Raises StorageError."""
    with replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(
            file,
            phase_rad=phase_map.phase_rad,
            modulation=phase_map.modulation,
            sigma_rad=phase_map.sigma_rad,
            mask=phase_map.state,
            exposure_index=phase_map.exposure_index,
            pitch_px=phase_map.pitch_px,
            projector_px=phase_map.projector_px,
        )
