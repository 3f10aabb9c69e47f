"""Files of uncertainty maps: the numbers as npz, and a colour picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np

from measureapp.arrays import ImageArray
from measureapp.data.uncertainty import ProjectionUncertainty, UncertaintyMap
from measureapp.project.atomic import replacing

SCHEMA_VERSION = 1
TILE_WIDTH, TITLE_HEIGHT = 480, 28


def write_uncertainty(path: Path, found: UncertaintyMap) -> None:
    """Write ``found`` as npz: per camera ``left_x_px``, ``left_y_px``, ``left_sigma_px`` and the volume's arrays."""
    arrays: dict[str, Any] = {"schema_version": SCHEMA_VERSION, "sentence": found.sentence}
    for name, one in found.projection.items():
        arrays |= {
            f"{name}_x_px": one.x_px,
            f"{name}_y_px": one.y_px,
            f"{name}_sigma_px": one.sigma_px,
            f"{name}_total_sigma_px": one.total_sigma_px,
            f"{name}_range_mm": one.range_mm,
        }
    if found.volume is not None:
        volume = found.volume
        arrays |= {
            "points_mm": volume.points_mm,
            "covariance_mm2": volume.covariance_mm2,
            "cameras_seeing": volume.cameras_seeing,
            "length_mm": volume.length_mm,
            "length_sigma_mm": volume.length_sigma_mm,
            "worst_length_sigma_mm": volume.worst_length_sigma_mm,
            "worst_length_at_mm": volume.worst_length_at_mm,
        }
    with replacing(Path(path)) as temporary, temporary.open("wb") as file:
        np.savez_compressed(file, **arrays)


def write_uncertainty_picture(path: Path, found: UncertaintyMap) -> None:
    """Draw the maps of all cameras side by side as PNG, dark for small uncertainty."""
    largest = max(float(one.sigma_px.max()) for one in found.projection.values())
    tiles = [_tile(one, largest) for one in found.projection.values()]
    height = max(tile.shape[0] for tile in tiles)
    padded = [cv2.copyMakeBorder(tile, 0, height - tile.shape[0], 0, 4, cv2.BORDER_CONSTANT) for tile in tiles]
    with replacing(Path(path)) as temporary:
        temporary.write_bytes(cv2.imencode(".png", np.hstack(padded))[1].tobytes())


def _tile(one: ProjectionUncertainty, largest: float) -> ImageArray:
    height = round(TILE_WIDTH * float(one.y_px[-1] + 1) / float(one.x_px[-1] + 1))
    levels = (255 * one.sigma_px / max(largest, 1e-12)).astype(np.uint8)
    picture = cv2.applyColorMap(cv2.resize(levels, (TILE_WIDTH, height), interpolation=cv2.INTER_CUBIC), cv2.COLORMAP_VIRIDIS)
    title = np.zeros((TITLE_HEIGHT, TILE_WIDTH, 3), np.uint8)
    text = f"{one.camera}: {one.sigma_px.min():.3f} to {one.sigma_px.max():.3f} px at {one.range_mm:.0f} mm"
    cv2.putText(title, text, (6, 20), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255), 1, cv2.LINE_AA)
    return np.asarray(np.vstack([title, picture]))
