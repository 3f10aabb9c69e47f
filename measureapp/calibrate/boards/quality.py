"""Quality of an image of a board, and the diagnosis of one in which no board was found."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.charuco import suggest_charuco
from measureapp.calibrate.boards.circle_grid import is_whole
from measureapp.calibrate.boards.circle_lattice import detect_circles
from measureapp.calibrate.boards.refine import apply_homography, homography, local_axes, patches_at
from measureapp.calibrate.boards.squares import DetectedSquares, blur, levels_at
from measureapp.calibrate.sightings import BoardDetectionError
from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.geometry.edge_blur import GAUSSIAN_RISE, STRAIGHT, EdgeShape, edge_blurs

FULL_SCALE = 255
CLIPPED_MARK = 0.35  # share of saturated pixels round a mark, half of which is white
CLIPPED_MARKS = 0.5  # share of marks
CLIPPED_IMAGE = 0.08  # share of an image in which no board was found
DARK_LEVEL = 30  # of 255: what is bright stays below
WIDEST_EDGE_PX = 6.0  # from 10 to 90 %; a sharp lens and chip give 2 to 3
WIDEST_EDGE_SHARE = 0.10  # of the distance of marks, where that allows more
WORST_SIGMA_PX = 0.5
WORST_FIT_SHARE = 0.25  # a mark may leave the homography of all by this share of the distance of marks; lenses distort by less
MOST_EDGES = 50  # of each direction
ACROSS_PX, ALONG_PX = 6.0, 2.0  # at most, of what is read to either side of a place on an edge
ALONG_SHARE = 0.5  # of half a side, or of a radius
BORDER = 0.05  # of a marker: less than half the width of its border
STRIPS, STRIP_SHARE = 12, 4
LEAST_SHARE = 0.15  # of a board's marks: fewer in a grid may be anything
SIDE_SHARE = 0.4  # of a side from the middle of a square: between the marker of a ChArUco board and the edge
PRINTED_SQUARE = 0.35  # of the contrast: what the middles of white squares may differ by
BLURRED = "Focus the camera, and keep board and camera still while the image is taken."
EXPOSED_LESS = "Shorten the exposure or dim the light until the board's white is no longer clipped."
EXPOSED_MORE = "Lengthen the exposure or add light until the board's white reaches half of full scale."

Edges = tuple[FloatArray, FloatArray, tuple[float, float], EdgeShape]


def require_usable(grey: ImageArray, board: BoardDescription, ids: IntArray, corners_px: FloatArray, sigma_px: FloatArray) -> float:
    """Return the width of the edges at the marks, px (10 to 90 %, rms of both directions); refuse an image whose marks cannot be trusted.

    Raises
    ------
    CalibrationError
        The marks do not lie as on this board, its white is clipped, it is too dark, blurred, or the marks scatter.
    """
    matrix = homography(board, ids, corners_px)
    axes = local_axes(matrix, board.flat_corners_mm[ids, :2])
    spacing = board.neighbour_mm * float(np.median(np.linalg.norm(axes, axis=2)))
    off = np.linalg.norm(corners_px - apply_homography(matrix, board.flat_corners_mm[ids, :2]), axis=1).max()
    if off > WORST_FIT_SHARE * spacing:
        raise BoardDetectionError(
            f"The marks in the image do not lie as on a {board.label}.",
            "Check the board's size, its dictionary and that nothing mirrors the image.",
            "wrong board",
        )
    _require_levels(grey, corners_px, _half_white(board) * spacing)
    if isinstance(board, CheckerboardDescription) and len(ids) == board.count:
        require_plain(grey, corners_px.reshape(board.rows, board.columns, 2))
    widths = edge_widths(grey, board, corners_px, axes)
    widest = max(WIDEST_EDGE_PX, WIDEST_EDGE_SHARE * spacing)
    if max(widths) > widest:
        raise BoardDetectionError(
            f"The board is blurred: its edges are {max(widths):.1f} px wide, {widest:.1f} px is the most.", BLURRED, "blurred"
        )
    if np.median(sigma_px) > WORST_SIGMA_PX:
        raise BoardDetectionError(
            f"The marks scatter by {np.median(sigma_px):.2f} px about a smooth grid, {WORST_SIGMA_PX} px is the most.",
            "Take a sharper and brighter image of the flat board.",
            "blurred",
        )
    seen = [width**2 for width in widths if width > 0]
    return float(np.sqrt(np.mean(seen))) if seen else 0.0


def edge_widths(grey: ImageArray, board: BoardDescription, corners_px: FloatArray, axes: FloatArray) -> tuple[float, ...]:
    """Return the distances over which edges at the marks rise from 10 to 90 %, px, in both directions of the board; 0 where none is seen.

    They are those of Gaussians with the median blur of the edges.

    Parameters
    ----------
    corners_px : (N, 2), of which `MOST_EDGES` at most are examined, evenly spread
    axes : (N, 2 axes, 2), 1 mm along x and y of the board in the image
    """
    some = slice(None, None, -(-len(corners_px) // MOST_EDGES) or 1)
    blurs = [edge_blurs(grey, *edges) for edges in _edges(board, corners_px[some], axes[some])]
    return tuple(GAUSSIAN_RISE * float(np.median(one)) if len(one) else 0.0 for one in blurs)


def missing(grey: ImageArray, board: BoardDescription, squares: DetectedSquares | None = None) -> BoardDetectionError:
    """Return the error for an image in which ``board`` was not found; ``squares`` is what was found of a checkerboard instead."""
    return (
        poor_image(grey, board)
        or _describe_grid(grey, board, squares)
        or BoardDetectionError(
            f"The {board.label} was not found.",
            "The whole board must be visible, sharp and not over-exposed; check the kind of board and its size.",
            "not found",
        )
    )


def poor_image(grey: ImageArray, board: BoardDescription) -> BoardDetectionError | None:
    """Return the defect of the image as a whole, if any."""
    sample = grey[::4, ::4]
    bright = float(np.percentile(sample, 99))
    if bright < DARK_LEVEL:
        return BoardDetectionError(
            f"The {board.label} was not found: the image is too dark ({bright:.0f} of 255).", EXPOSED_MORE, "too dark"
        )
    clipped = float(np.mean(sample >= FULL_SCALE))
    if clipped > CLIPPED_IMAGE:
        return BoardDetectionError(
            f"The {board.label} was not found: the image is over-exposed ({clipped:.0%} clipped).", EXPOSED_LESS, "over-exposed"
        )
    if is_blurred(grey):
        return BoardDetectionError(f"The {board.label} was not found: nothing in the image is sharp, it is blurred.", BLURRED, "blurred")
    return None


def partly_hidden(board: BoardDescription, count: int) -> BoardDetectionError:
    """Return the error for a board of which only ``count`` marks are visible."""
    return BoardDetectionError(
        f"The {board.label} was not found: only {count} of its {board.count} marks can be seen, the rest is hidden or outside the image.",
        "Show the whole board, or use a ChArUco board, of which a part is enough.",
        "hidden",
    )


def _half_white(board: BoardDescription) -> float:
    """Half the side, over the distance of marks, of a square about a mark of which half is white."""
    return float(np.sqrt(np.pi / 2)) * board.diameter_mm / 2 / board.neighbour_mm if isinstance(board, CirclesDescription) else 0.3


def _require_levels(grey: ImageArray, corners_px: FloatArray, reach_px: float) -> None:
    patches = patches_at(grey, corners_px, max(2, round(reach_px))).reshape(len(corners_px), -1)
    clipped = np.mean(patches >= FULL_SCALE, axis=1) > CLIPPED_MARK
    bright = np.percentile(patches, 90, axis=1)
    if np.mean(clipped) > CLIPPED_MARKS:
        raise BoardDetectionError(
            f"The board is over-exposed: its white is clipped at {np.mean(clipped):.0%} of the marks, which makes them scatter.",
            EXPOSED_LESS,
            "over-exposed",
        )
    if np.median(bright) < DARK_LEVEL:
        raise BoardDetectionError(f"The board is too dark: its white is {np.median(bright):.0f} of 255.", EXPOSED_MORE, "too dark")


def are_squares(grey: ImageArray, grid: FloatArray) -> bool:
    """Whether the cells of a grid of corners are squares of a board, plain along their sides; other rows of the same corners cut across."""
    right, down = grid[:-1, 1:] - grid[:-1, :-1], grid[1:, :-1] - grid[:-1, :-1]
    middles, smooth = grid[:-1, :-1] + 0.5 * right + 0.5 * down, blur(grey)
    sides = [(a, b) for a in (-1.0, -0.5, 0.0, 0.5, 1.0) for b in (-1.0, -0.5, 0.0, 0.5, 1.0) if max(abs(a), abs(b)) == 1.0]
    levels = np.array([levels_at(smooth, middles + SIDE_SHARE * (a * right + b * down)) for a, b in sides])
    contrast = np.percentile(levels, 95) - np.percentile(levels, 5)
    return bool(np.median(np.ptp(levels, axis=0)) <= PRINTED_SQUARE * contrast)


def unexpected_markers() -> BoardDetectionError:
    """Return the error for a board with markers in its squares, described as one without."""
    return BoardDetectionError(
        "The squares of the board are not plain: markers are printed in them.",
        "Describe it as a ChArUco board with its dictionary.",
        "wrong board",
    )


def require_plain(grey: ImageArray, grid: FloatArray) -> None:
    """Refuse squares with something printed in them, which displaces the corners. Raises BoardRefused."""
    right, down = grid[:-1, 1:] - grid[:-1, :-1], grid[1:, :-1] - grid[:-1, :-1]
    middles = grid[:-1, :-1] + 0.5 * right + 0.5 * down
    smooth = blur(grey)
    places = [middles + 0.12 * (a * right + b * down) for a in (-2, -1, 0, 1, 2) for b in (-2, -1, 0, 1, 2)]
    levels = np.array([levels_at(smooth, place) for place in places])
    level = np.median(levels, axis=0)
    contrast = np.percentile(levels, 95) - np.percentile(levels, 5)
    if np.median(np.ptp(levels, axis=0)[level >= np.median(level)]) > PRINTED_SQUARE * contrast:
        raise unexpected_markers()


def _edges(board: BoardDescription, corners_px: FloatArray, axes: FloatArray) -> list[Edges]:
    """Return places on edges of both directions, their normals, how far they are examined across and along, px, and their shape."""
    scale = float(np.linalg.norm(axes, axis=2).min())
    found = []
    for along in (0, 1):
        run = axes[:, along]
        tangent = axes[:, 1 - along] if isinstance(board, CirclesDescription) else run
        length = np.linalg.norm(tangent, axis=1)
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / length[:, None]
        shape = STRAIGHT
        if isinstance(board, CirclesDescription):  # the outline where the axis `along` leaves the circle; its tangent is the other axis
            radius, gap = board.diameter_mm / 2.0, (board.neighbour_mm - board.diameter_mm) / 2.0
            places, straight, across = corners_px + radius * run, radius, min(radius, gap)
            shape = EdgeShape(bend=-np.sum(run * normal, axis=1) / (radius * length**2))
        else:
            straight = 0.5 * board.neighbour_mm
            places, across = corners_px + straight * run, 0.4 * board.neighbour_mm
            if isinstance(board, CharucoDescription):  # the border of a marker, which is black, ends the white of its square
                margin = (board.neighbour_mm - board.marker_mm) / 2.0
                across, shape = (
                    margin + BORDER * board.marker_mm,
                    EdgeShape(bright_px=margin * abs(np.sum(axes[:, 1 - along] * normal, axis=1))),
                )
        found.append((places, normal, (min(max(across * scale, 1.5), ACROSS_PX), min(ALONG_SHARE * straight * scale, ALONG_PX)), shape))
    return found


def blur_px(edges_px: Sequence[float]) -> float:
    """Return the standard deviation of the blur of a camera's images by how wide edges are in them; 0 where none is known."""
    known = [edge for edge in edges_px if edge > 0]
    return float(np.median(known)) / GAUSSIAN_RISE if known else 0.0


def is_blurred(grey: ImageArray) -> bool:
    """Whether the steepest edges of the image, taken as blurred by a Gaussian, are too wide; a quarter of its rows is examined."""
    rows = max(len(grey) // (STRIPS * STRIP_SHARE), 8)
    strips = [blur(grey[at : at + rows]) for at in np.linspace(0, max(len(grey) - rows, 0), STRIPS).astype(int)]
    slope = np.concatenate(
        [np.hypot(cv2.Sobel(one, cv2.CV_32F, 1, 0, scale=0.125), cv2.Sobel(one, cv2.CV_32F, 0, 1, scale=0.125)) for one in strips]
    )
    low, high = np.percentile(np.concatenate(strips)[:, ::4], (1, 99))
    steepest = max(float(np.percentile(slope, 99.9)), 1e-3)
    return bool(high - low > DARK_LEVEL and GAUSSIAN_RISE * (high - low) / (np.sqrt(2 * np.pi) * steepest) > WIDEST_EDGE_PX)


def _describe_grid(grey: ImageArray, board: BoardDescription, squares: DetectedSquares | None) -> BoardDetectionError | None:
    """Describe the grid found instead of ``board``."""
    if isinstance(board, CharucoDescription):
        return suggest_charuco(grey, board)
    if isinstance(board, CirclesDescription):
        circles = detect_circles(grey)
        if circles is None or circles.count < LEAST_SHARE * board.count:
            return None
        columns, rows = circles.size
        spans, own = sorted((2 * columns, rows)), sorted((2 * board.columns, board.rows))
        larger = spans[0] > own[0] or spans[1] > own[1]
        whole = columns > 1 and is_whole(grey, board.model_copy(update={"columns": columns, "rows": rows}))
        return _another(board, f"{columns} × {rows} circles", circles.count, whole=whole, larger=larger)
    if squares is None:
        return None
    longer, shorter = squares.size
    larger = longer > max(board.columns, board.rows) or shorter > min(board.columns, board.rows)
    return _another(board, f"{longer} × {shorter} corners", squares.count, whole=squares.is_whole, larger=larger)


def _another(board: BoardDescription, looks_like: str, count: int, *, whole: bool, larger: bool) -> BoardDetectionError:
    if whole or larger:
        return BoardDetectionError(
            f"The {board.label} was not found: the board in the image looks like one of {looks_like}.",
            f"Give the size of the board that was used, or use the {board.label}.",
            "wrong board",
        )
    return partly_hidden(board, count)
