"""Clouds in random order, so that any first part is a representative sample of the whole; independent of VTK."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ui.viewport.colouring import UNKNOWN
from ui.viewport.layers import CloudLayer

SEED = 0
LEAST_BLOCK, LARGEST_BLOCK = 10_000, 60_000  # points; a busy software renderer draws the largest within 0.1 s
CHUNK = 1_000_000
LIGHT = np.array([-1.0, -1.1, 0.85], np.float32) / np.float32(np.linalg.norm([-1.0, -1.1, 0.85]))  # from the initial viewing direction
AMBIENT, FRONT, BACK = 0.4, 0.62, 0.45  # weights of the light; back faces are lit more weakly, so that they show relief too
READ_AMBIENT = 0.75  # for colours of a scale: the hue means the same everywhere, and the shape is still seen


@dataclass(frozen=True, eq=False)
class ShuffledCloud:
    """All points of some layers in one random order: 19 bytes a point."""

    points_mm: np.ndarray  # (N, 3) float32
    colours: np.ndarray  # (N, 3) uint8, shaded
    order: np.ndarray  # (N,) int32, index of each point in the concatenated layers
    starts: np.ndarray  # (L + 1,) int64, first index of each layer
    bounds_mm: tuple[np.ndarray, ...]  # least and greatest coordinates, (3,) each; () without points

    def __len__(self) -> int:
        return len(self.points_mm)

    def origin(self, place: int) -> tuple[int, int]:
        """Return layer and index in the layer of a point."""
        original = int(self.order[place])
        layer = int(np.searchsorted(self.starts, original, side="right") - 1)
        return layer, original - int(self.starts[layer])

    def blocks(self) -> list[slice]:
        """Return blocks to be drawn in order: small ones first, so that any budget is met closely."""
        made, start = [], 0
        while start < len(self):
            size = int(np.clip(start // 4, LEAST_BLOCK, LARGEST_BLOCK))
            made.append(slice(start, min(start + size, len(self))))
            start += size
        return made


def shuffle(layers: Sequence[CloudLayer]) -> ShuffledCloud:
    """Shuffle the points of all layers, with colours shaded by their normals; slow for millions of points."""
    starts = np.concatenate([[0], np.cumsum([len(layer.points_mm) for layer in layers])]).astype(np.int64)
    points = np.concatenate([np.empty((0, 3), np.float32), *(np.asarray(layer.points_mm, np.float32) for layer in layers)])
    colours = np.concatenate([np.empty((0, 3), np.uint8), *(_shade(layer) for layer in layers)])
    order = np.arange(len(points), dtype=np.int32)
    np.random.default_rng(SEED).shuffle(order)
    bounds = (points.min(axis=0), points.max(axis=0)) if len(points) else ()
    return ShuffledCloud(points[order], colours[order], order, starts, bounds)


def _shade(layer: CloudLayer) -> np.ndarray:
    """Shade the colours in a fixed light; the colour of unmeasured points is kept, because it identifies them."""
    colours = np.asarray(layer.colours, np.uint8)
    if layer.normals is None:
        return colours
    ambient = READ_AMBIENT if layer.to_read else AMBIENT
    lit = (1.0 - ambient) / (1.0 - AMBIENT)
    shaded = np.empty_like(colours)
    for start in range(0, len(colours), CHUNK):
        part = slice(start, start + CHUNK)
        towards = np.asarray(layer.normals[part], np.float32) @ LIGHT
        light = ambient + lit * np.where(towards > 0, FRONT * towards, -BACK * towards)
        shaded[part] = np.minimum(colours[part] * light[:, None], 255.0)
    unknown = (colours == UNKNOWN).all(axis=1)
    shaded[unknown] = colours[unknown]
    return shaded
