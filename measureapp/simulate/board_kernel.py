"""Compiled loop that lights a printed board; see `kernels` for how such loops are run."""

from __future__ import annotations

import numpy as np
from numba import njit

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.simulate.kernels import (
    LENS_STEP_PX,
    NOT_LIT,
    PLAIN_SUMS,
    interpolated,
    projector_pixel,
    radiance,
    undistorted,
)

PRINT_STEP_MM = 2.0  # between the nodes of a print's errors
SUPERSAMPLES = 7  # per axis, of a pixel on an edge of the printed pattern


@njit(**PLAIN_SUMS)
def _bow(x, y, bow):  # type: ignore[no-untyped-def]
    """Height of a bowed board; ``bow`` = height at the centre, centre x, centre y, radius of zero height."""
    return bow[0] * (1.0 - ((x - bow[1]) ** 2 + (y - bow[2]) ** 2) / (bow[3] * bow[3]))


@njit(**PLAIN_SUMS)
def _on_board(x, y, coma, pose, bow):  # type: ignore[no-untyped-def]
    """Intersect the ray of normalised image coordinates with the board; ``pose`` is board_from_camera, ``coma`` as in `pixel_rays`."""
    aside, down = coma[0] * (x - coma[2]), coma[0] * (y - coma[3])
    x, y = x + aside, y + down
    ox = pose[0, 3] - coma[1] * (pose[0, 0] * aside + pose[0, 1] * down)
    oy = pose[1, 3] - coma[1] * (pose[1, 0] * aside + pose[1, 1] * down)
    oz = pose[2, 3] - coma[1] * (pose[2, 0] * aside + pose[2, 1] * down)
    dx = pose[0, 0] * x + pose[0, 1] * y + pose[0, 2]
    dy = pose[1, 0] * x + pose[1, 1] * y + pose[1, 2]
    dz = pose[2, 0] * x + pose[2, 1] * y + pose[2, 2]
    if dz <= 0.0:
        return 1e9, 1e9, 0.0
    s = -oz / dz
    for _ in range(2):
        s = (_bow(ox + s * dx, oy + s * dy, bow) - oz) / dz
    return ox + s * dx, oy + s * dy, oz + s * dz


@njit(**PLAIN_SUMS)
def _paint(x, y, layout, cells, colours, shift):  # type: ignore[no-untyped-def]
    """Albedo of the board at a point; 0 beyond its white margin.

    ``layout`` = size of a circle (0: there are squares), square or spacing, columns, rows, side of a marker (0: none), and the place of the
    first node of ``shift`` (rows, columns, 2), the displacement in mm of the print from where the layout has it, with a node every
    PRINT_STEP_MM; ``cells`` (rows + 1, columns + 1, n, n) are the markers in the squares, see `marker_cells`.
    """
    dx, dy = interpolated(shift, x - layout[5], y - layout[6], PRINT_STEP_MM)
    x -= dx
    y -= dy
    if layout[0] > 0.0:
        return _paint_circles(x, y, layout, colours)
    i = np.floor(x / layout[1])
    j = np.floor(y / layout[1])
    if i < -2 or j < -2 or i > layout[2] or j > layout[3]:
        return 0.0
    if i < -1 or j < -1 or i > layout[2] - 1 or j > layout[3] - 1:
        return colours[0]
    if layout[4] > 0.0:
        return _paint_marked(x, y, int(i), int(j), layout, cells, colours)
    return colours[1] if (int(i) + int(j)) % 2 == 0 else colours[0]


@njit(**PLAIN_SUMS)
def _paint_circles(x, y, layout, colours):  # type: ignore[no-untyped-def]
    """Albedo of an asymmetric circle grid: dark circles at ((2j + i mod 2), i) times the spacing."""
    unit = layout[1]
    last_x, last_y = 2.0 * layout[2] - 1.0, layout[3] - 1.0
    if x < -2.0 * unit or y < -2.0 * unit or x > (last_x + 2.0) * unit or y > (last_y + 2.0) * unit:
        return 0.0
    nearest = np.round(y / unit)
    for row in range(max(0, int(nearest) - 1), min(int(last_y), int(nearest) + 1) + 1):
        odd = row % 2
        column = np.round((x / unit - odd) / 2.0)
        if 0.0 <= column < layout[2] and (x - (2.0 * column + odd) * unit) ** 2 + (y - row * unit) ** 2 < layout[0] ** 2 / 4.0:
            return colours[1]
    return colours[0]


@njit(**PLAIN_SUMS)
def _paint_marked(x, y, i, j, layout, cells, colours):  # type: ignore[no-untyped-def]
    """Albedo of a ChArUco square: black without a marker; a marker is centred in a white square."""
    size = cells.shape[2]
    if cells[j + 1, i + 1, 0, 0] == 2:
        return colours[1]
    edge = (layout[1] - layout[4]) / 2.0
    m = int(np.floor((x - i * layout[1] - edge) / layout[4] * size))
    n = int(np.floor((y - j * layout[1] - edge) / layout[4] * size))
    if m < 0 or n < 0 or m >= size or n >= size:
        return colours[0]
    return colours[0] if cells[j + 1, i + 1, n, m] == 1 else colours[1]


@njit(**PLAIN_SUMS)
def _is_inside_square(x, y, across, down, layout, shift):  # type: ignore[no-untyped-def]
    """Tell whether a footprint lies in one square of a board without markers; a print's errors may shift it by a tenth of its size."""
    if layout[0] > 0.0 or layout[4] > 0.0:
        return False
    dx, dy = interpolated(shift, x - layout[5], y - layout[6], PRINT_STEP_MM)
    u, v = (x - dx) / layout[1], (y - dy) / layout[1]
    u -= np.floor(u)
    v -= np.floor(v)
    wide = 1.1 * (abs(across[0]) + abs(down[0])) / layout[1]
    high = 1.1 * (abs(across[1]) + abs(down[1])) / layout[1]
    return wide < u < 1.0 - wide and high < v < 1.0 - high


@njit(**PLAIN_SUMS)
def _averaged(x, y, across, down, layout, cells, colours, shift):  # type: ignore[no-untyped-def]
    """Albedo averaged over a footprint about a point; ``across`` and ``down`` lead to the middles of its sides."""
    albedo = _paint(x, y, layout, cells, colours, shift)
    if _is_inside_square(x, y, across, down, layout, shift):
        return albedo
    ax, ay = across
    bx, by = down
    if (
        albedo == _paint(x + ax + bx, y + ay + by, layout, cells, colours, shift)
        and albedo == _paint(x - ax - bx, y - ay - by, layout, cells, colours, shift)
        and albedo == _paint(x + ax - bx, y + ay - by, layout, cells, colours, shift)
        and albedo == _paint(x - ax + bx, y - ay + by, layout, cells, colours, shift)
    ):
        return albedo
    total = 0.0
    for m in range(SUPERSAMPLES):
        for n in range(SUPERSAMPLES):
            p = (2 * m + (2 * n + 1.0) / SUPERSAMPLES) / SUPERSAMPLES - 1.0
            q = (2 * n + (2 * m + 1.0) / SUPERSAMPLES) / SUPERSAMPLES - 1.0
            total += _paint(x + p * ax + q * bx, y + p * ay + q * by, layout, cells, colours, shift)
    return total / (SUPERSAMPLES * SUPERSAMPLES)


@njit(cache=True, nogil=True, error_model="numpy", fastmath=True)
def light_board(
    start: int,
    stop: int,
    box: IntArray,
    k: FloatArray,
    d: FloatArray,
    residual: FloatArray,
    coma: FloatArray,
    board_from_camera: FloatArray,
    light: FloatArray,
    light_from_board: FloatArray,
    light_k: FloatArray,
    light_d: FloatArray,
    standoff_mm: float,
    layout: FloatArray,
    cells: ImageArray,
    colours: FloatArray,
    shift: FloatArray,
    bow: FloatArray,
    out: FloatArray,
) -> None:
    """Compute the illumination of the board inside ``box`` (see `pixel_rays`) into ``out`` (H, W, 4), as `light_surface`.

    The printed pattern is averaged over each pixel's footprint on the board, a parallelogram without distortion; the sample positions
    are sheared so that edges along pixel rows are antialiased as well.
    """
    for row in range(start, stop):
        aside, down = 0.0, 0.0
        for column in range(box[2], box[3]):
            out[row, column, 0] = NOT_LIT
            out[row, column, 1:] = 0.0
            du, dv = interpolated(residual, float(column), float(row), LENS_STEP_PX)
            xn, yn, aside, down = undistorted(column + du, row + dv, k, d, aside, down)
            x, y, z = _on_board(xn, yn, coma, board_from_camera, bow)
            if x > 1e8:
                continue
            xr, yr, _ = _on_board(xn + 0.5 / k[0], yn, coma, board_from_camera, bow)
            xd, yd, _ = _on_board(xn, yn + 0.5 / k[1], coma, board_from_camera, bow)
            albedo = _averaged(x, y, (xr - x, yr - y), (xd - x, yd - y), layout, cells, colours, shift)
            if albedo == 0.0:
                continue
            to_light = (light[0] - x, light[1] - y, light[2] - z)
            out[row, column, 3] = albedo
            out[row, column, 2] = radiance((0.0, 0.0, -1.0), to_light, (0.0, 0.0, -1.0), (albedo, 0.0, 1.0), standoff_mm)
            u, v = projector_pixel((x, y, z), light_from_board, light_k, light_d)
            out[row, column, 0] = u
            out[row, column, 1] = v
