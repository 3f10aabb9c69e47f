"""Blur of a part's images, from its own edges: it may be another than that of the board with which the cameras were calibrated.

Where the part's outline, its edges and shadows are steps of brightness, their images are as wide as the blur of the camera, as edges of the
board are. What is no step, such as the horizon of a round body, is wider by amounts of its own, so that widths scatter: then nothing is
known of the blur, and that of the board stays.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap
from measureapp.geometry.edge_blur import edge_blurs

PIXELS = 320_000  # of the rows examined, in bands over the whole image
BAND_ROWS = 32
SMOOTH_PX = 0.8
LEAST_SLOPE, LEAST_STEP = 0.06, 0.12  # of the range of grey levels: per px, and from one side of an edge to the other
REACH_PX, LEVEL_PX = 4.0, 2.5  # length of a profile to either side, and where its levels begin
ALONG_PX = 2.0  # to either side of a profile, of an edge
UNEVEN = 0.04  # change of a level along its side, relative to the step
LEAST_EDGES, MOST_EDGES = 100, 400
SCATTER = 0.12  # of the blurs of edges, half of them lie within: more is no blur of steps
KNOWN = 0.05  # relative: by less, edges of part and board do not differ significantly
MOST_PLACES = 30_000  # read at once: OpenCV takes fewer than 32 768 rows


def with_blur_of_part(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> CameraArrayCalibration:
    """Return the cameras with the blur of the part's images, where its edges determine it and it differs from the board's.

    Cameras whose blur is unknown keep it so.
    """
    found = dict(cameras.cameras)
    for name, phase_map in phase_maps.items():
        camera = found.get(name)
        if camera is None or camera.blur_px <= 0.0:
            continue
        blur_px = edge_blur_px(read_only(phase_map.grey, np.float32))
        if blur_px is not None and abs(blur_px / camera.blur_px - 1.0) > KNOWN:
            found[name] = replace(camera, blur_px=blur_px)
    return replace(cameras, cameras=found)


def edge_blur_px(grey: FloatArray) -> float | None:
    """Return the standard deviation of the blur in an image (H, W) float32, the median of its edges; None if they do not determine it."""
    low, high = np.percentile(grey[::4, ::4], (1.0, 99.5))
    if high <= low:
        return None
    bands = _bands(grey)
    blurs = np.concatenate([_blurs(band, float(high - low), MOST_EDGES // len(bands)) for band in bands])
    if len(blurs) < LEAST_EDGES:
        return None
    lower, median, upper = np.percentile(blurs, (25.0, 50.0, 75.0))
    return float(median) if upper - lower < SCATTER * median else None


def _bands(grey: FloatArray) -> list[FloatArray]:
    height, width = grey.shape
    number = max(1, min(height, PIXELS // width) // BAND_ROWS)
    if number * BAND_ROWS * 2 > height:
        return [grey]
    return [grey[start : start + BAND_ROWS] for start in np.linspace(0, height - BAND_ROWS, number).astype(int)]


def _blurs(grey: FloatArray, contrast: float, most: int) -> FloatArray:
    """Return the blurs (N,) of edges between even levels, px; of many only as many as stated, evenly spread."""
    smooth = cv2.GaussianBlur(grey, (0, 0), SMOOTH_PX)
    across, down = (cv2.Sobel(smooth, cv2.CV_32F, *order, scale=0.125) for order in ((1, 0), (0, 1)))
    slope = np.hypot(across, down)
    border = round(2 * REACH_PX)
    row, column = np.nonzero(slope[border:-border, border:-border] > LEAST_SLOPE * contrast)
    row, column = row + border, column + border
    normal = np.column_stack([across[row, column], down[row, column]]) / np.maximum(slope[row, column], 1e-9)[:, None]
    before, own, after = (_read(slope, column, row, normal, np.array([apart]), cv2.INTER_LINEAR)[:, 0] for apart in (-1.0, 0.0, 1.0))
    steepest: BoolArray = (own > before) & (own >= after)
    place = (0.5 * (before - after) / np.minimum(before - 2.0 * own + after, -1e-9))[steepest]
    columns, rows, normals = column[steepest], row[steepest], normal[steepest]
    sides = [np.arange(one * LEVEL_PX, one * REACH_PX + 0.1 * one, 0.5 * one) for one in (-1.0, 1.0)]
    dark, bright = (_read(grey, columns, rows, normals, place[:, None] + side, cv2.INTER_LINEAR) for side in sides)
    rise = bright.mean(axis=1) - dark.mean(axis=1)
    change = np.maximum(abs(dark[:, -1] - dark[:, 0]), abs(bright[:, -1] - bright[:, 0]))
    even = np.flatnonzero((rise > LEAST_STEP * contrast) & (change < UNEVEN * rise))
    even = even[:: max(1, -(-len(even) // most))]
    places = np.column_stack([columns[even], rows[even]]) + place[even, None] * normals[even]
    return edge_blurs(grey, places, normals[even], (REACH_PX, ALONG_PX))


def _read(image: FloatArray, column: IntArray, row: IntArray, normal: FloatArray, apart: FloatArray, how: int) -> FloatArray:
    """Return the image at places (N, M) that lie ``apart`` from pixels (N,) along their normals."""
    if not len(column):
        return np.zeros((0, np.atleast_2d(apart).shape[1]))
    x = (column[:, None] + apart * normal[:, :1]).astype(np.float32)
    y = (row[:, None] + apart * normal[:, 1:]).astype(np.float32)
    starts = range(0, len(x), MOST_PLACES)
    return np.concatenate([cv2.remap(image, x[one : one + MOST_PLACES], y[one : one + MOST_PLACES], how) for one in starts])
