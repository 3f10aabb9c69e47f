"""Files of phase maps: NumPy archives."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from measureapp.data.phase import PhaseMap
from measureapp.project.atomic import replacing


def write_phase_map(path: Path, phase_map: PhaseMap) -> None:
    """Write an `.npz`, atomically. Raises StorageError.

    `mask` is the `PixelState` of every pixel (0: valid), `snr` modulation over noise, `exposure_index` the exposure used. The map of
    the orthogonal fringes of a set with both directions has the same names with the prefix `across_`.
    """
    with replacing(path) as temporary, temporary.open("wb") as file:
        np.savez(file, **_arrays(phase_map, ""))


def _arrays(phase_map: PhaseMap, prefix: str) -> dict[str, Any]:
    across = {} if phase_map.orthogonal is None else _arrays(phase_map.orthogonal, "across_")
    return {
        f"{prefix}phase_rad": phase_map.phase_rad,
        f"{prefix}modulation": phase_map.modulation,
        f"{prefix}sigma_rad": phase_map.sigma_rad,
        f"{prefix}snr": phase_map.snr,
        f"{prefix}grey": phase_map.grey,
        f"{prefix}mask": phase_map.state,
        f"{prefix}exposure_index": phase_map.exposure_index,
        f"{prefix}pitch_px": phase_map.pitch_px,
        f"{prefix}projector_px": phase_map.projector_px,
        f"{prefix}direction": phase_map.direction,
        **across,
    }
