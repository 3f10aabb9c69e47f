"""Reading of the depth buffer of the last picture: what is visible at a pixel, and which places are hidden."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from ui.viewport.pick import Pick
from ui.viewport.point_index import nearest_point
from ui.viewport.scene import Scene

PICK_REACH_PX = 5
BACKGROUND = 1.0 - 1e-7
HIDING_RANGE = 0.012  # of the depth range, by which something must be in front of a place to hide it
LEAST_REACH_MM = 1e-3


def depths(window: vtkRenderWindow, x_px: int, y_px: int, reach_px: int) -> tuple[np.ndarray, int, int]:
    """Return the depth buffer around a pixel, rows from the bottom, and its lower left pixel; empty outside the picture."""
    width, height = window.GetSize()
    left, bottom = max(0, x_px - reach_px), max(0, y_px - reach_px)
    right, top = min(width - 1, x_px + reach_px), min(height - 1, y_px + reach_px)
    if right < left or top < bottom:
        return np.empty((0, 0)), left, bottom
    data = vtkFloatArray()
    window.GetZbufferData(left, bottom, right, top, data)
    return vtk_to_numpy(data).reshape(top - bottom + 1, right - left + 1).copy(), left, bottom


def pick_at(scene: Scene, window: vtkRenderWindow, x_px: float, y_px: float) -> Pick:
    """Return what is at a pixel (from the lower left) of the scene's picture, which must be the last one drawn."""
    here, direction = scene.camera.ray(x_px, y_px)
    found, left, bottom = depths(window, round(x_px), round(y_px), PICK_REACH_PX)
    rows, columns = np.nonzero(found < BACKGROUND)
    gaps = np.hypot(columns + left - x_px, rows + bottom - y_px)
    near = np.flatnonzero(gaps <= PICK_REACH_PX)
    if not len(near):
        return Pick(here, direction)
    chosen = near[np.argmin(gaps[near])]
    x, y = float(columns[chosen] + left), float(rows[chosen] + bottom)
    position, _ = scene.camera.ray(x, y, float(found[rows[chosen], columns[chosen]]))
    clip = scene.clip.corners if scene.clip is not None and scene.clip.is_on else None
    point = nearest_point(scene.cloud, scene.index, position, clip) if len(scene.cloud) else None
    reach = max(2.0 * PICK_REACH_PX * scene.camera.mm_per_px, LEAST_REACH_MM)
    if point is None or point[1] > reach:
        return Pick(here, direction, position)
    return Pick(here, direction, position, *scene.cloud.origin(point[0]))


def hidden_places(scene: Scene, window: vtkRenderWindow, places_mm: np.ndarray) -> set[int]:
    """Return the indices of those places (N, 3) that something hides in the last picture."""
    if not len(places_mm):
        return set()
    matrix = scene.camera.projection()
    placed = places_mm @ matrix[:, :3].T + matrix[:, 3]
    own = (placed[:, 2] / placed[:, 3] + 1.0) / 2.0
    pixels = np.rint(scene.camera.pixels(places_mm)).astype(int)
    made = set()
    for index, ((x, y), depth) in enumerate(zip(pixels.tolist(), own.tolist(), strict=True)):
        found, _, _ = depths(window, x, y, 2)
        if found.size and float(found.max()) < depth - HIDING_RANGE:
            made.add(index)
    return made
