"""Printable calibration boards: SVG at true scale, with a line for checking the scale."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.errors import InputError
from measureapp.geometry.marker_cells import marker_cells
from measureapp.project.atomic import write_text

MARGIN = 2.0  # squares or spacings around the marks: one printed, one white
CHECK_MM = 100.0
FOOT_MM = 14.0


def write_board(path: Path, board: BoardDescription) -> None:
    """Write a board as SVG with its description and a line of 100 mm below. Raises InputError for another file type."""
    if path.suffix.lower() != ".svg":
        raise InputError(f"{path} is not an SVG file.", "Name a file that ends in .svg.")
    corners = board.flat_corners_mm[:, :2]
    unit = board.spacing_mm if isinstance(board, CirclesDescription) else board.neighbour_mm
    low, high = corners.min(axis=0) - MARGIN * unit, corners.max(axis=0) + MARGIN * unit
    width, height = max(high[0] - low[0], CHECK_MM + 2 * unit), high[1] - low[1] + FOOT_MM
    shapes = "\n".join(_shapes(board))
    check = f"M{low[0] + unit:g} {high[1] + 4:g}h{CHECK_MM:g}m0 -2v4m{-CHECK_MM:g} 0v-4"
    write_text(
        path,
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="{low[0]:g} {low[1]:g} {width:g} {height:g}" shape-rendering="crispEdges">\n'
        f'<rect x="{low[0]:g}" y="{low[1]:g}" width="{width:g}" height="{height:g}" fill="white"/>\n{shapes}\n'
        f'<path d="{check}" stroke="black" stroke-width="0.2" fill="none"/>\n'
        f'<text x="{low[0] + unit:g}" y="{high[1] + 9.5:g}" font-size="4" font-family="sans-serif">'
        f"{_words(board)}. The line is {CHECK_MM:g} mm long.</text>\n</svg>\n",
    )


def _words(board: BoardDescription) -> str:
    label = board.label[0].upper() + board.label[1:]
    if isinstance(board, CirclesDescription):
        return f"{label}, spacing {board.spacing_mm:g} mm, diameter {board.diameter_mm:g} mm"
    if isinstance(board, CharucoDescription):
        return f"{label}, squares {board.square_mm:g} mm, markers {board.marker_mm:g} mm, {board.dictionary}"
    return f"{label}, squares {board.neighbour_mm:g} mm"


def _shapes(board: BoardDescription) -> list[str]:
    if isinstance(board, CirclesDescription):
        radius = board.diameter_mm / 2
        return [f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" shape-rendering="auto"/>' for x, y, _ in board.flat_corners_mm]
    if isinstance(board, CharucoDescription):
        return _draw_markers(board)
    assert isinstance(board, CheckerboardDescription)
    squares = np.argwhere(np.indices((board.rows + 1, board.columns + 1)).sum(axis=0) % 2 == 0)
    return [_square((column - 1) * board.square_mm, (row - 1) * board.square_mm, board.square_mm) for row, column in squares]


def _draw_markers(board: CharucoDescription) -> list[str]:
    cells = marker_cells(board.columns, board.rows, board.dictionary, board.legacy_pattern)
    side = board.marker_mm / cells.shape[2]
    edge = (board.square_mm - board.marker_mm) / 2
    shapes = []
    for row, column in np.ndindex(*cells.shape[:2]):
        x, y = (column - 1) * board.square_mm, (row - 1) * board.square_mm
        if cells[row, column, 0, 0] == 2:
            shapes.append(_square(x, y, board.square_mm))
            continue
        shapes += [_square(x + edge + i * side, y + edge + j * side, side) for j, i in np.argwhere(cells[row, column] == 0)]
    return shapes


def _square(x: float, y: float, side: float) -> str:
    return f'<rect x="{x:.6g}" y="{y:.6g}" width="{side:.6g}" height="{side:.6g}"/>'
