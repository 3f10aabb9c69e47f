"""Small images of a checkerboard as an ideal lens would see it."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from measureapp.data.board import CheckerboardDescription

BOARD = CheckerboardDescription(columns=8, rows=5, square_mm=20.0)
WIDTH, HEIGHT, FOCAL = 400, 300, 520.0
FINER = 4  # the board is drawn so much finer than it is seen, then averaged
BASELINE_MM = 60.0
TILTS_DEG = ((0, 0, 0), (25, 0, 10), (-25, 0, -10), (0, 28, 5), (0, -28, -5), (20, 20, 30), (-20, 18, -20), (15, -25, 15))


def picture(
    turn_deg: tuple[float, float, float], shift_mm: tuple[float, float, float], board: CheckerboardDescription = BOARD
) -> np.ndarray:
    """The board turned about its middle and moved, (H, W) uint8."""
    pixels_per_mm = 4.0
    squares = np.indices((board.rows + 1, board.columns + 1)).sum(axis=0) % 2
    side = int(board.square_mm * pixels_per_mm)
    flat = np.kron(np.where(squares == 0, 40, 200), np.ones((side, side))).astype(np.uint8)
    flat = cv2.copyMakeBorder(flat, side, side, side, side, cv2.BORDER_CONSTANT, value=200)
    middle = (np.array(flat.shape[::-1]) - 1) / 2
    board_from_flat = np.array([[1, 0, -middle[0]], [0, 1, -middle[1]], [0, 0, pixels_per_mm]]) / pixels_per_mm
    turn = cv2.Rodrigues(np.deg2rad(np.array(turn_deg, float)))[0]
    lens = np.array([[FOCAL * FINER, 0, WIDTH * FINER / 2], [0, FOCAL * FINER, HEIGHT * FINER / 2], [0, 0, 1]])
    image_from_board = lens @ np.column_stack([turn[:, 0], turn[:, 1], np.array(shift_mm, float)])
    seen = cv2.warpPerspective(flat, image_from_board @ board_from_flat, (WIDTH * FINER, HEIGHT * FINER), borderValue=90)
    small = cv2.resize(cv2.GaussianBlur(seen, (0, 0), 2.0), (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    noise = np.random.default_rng(abs(hash((turn_deg, shift_mm))) % 2**32).normal(0, 1.0, small.shape)
    return np.clip(small + noise, 0, 255).astype(np.uint8)


def record(folder: Path, views: int = 8, cameras: tuple[str, ...] = ("left", "right")) -> Path:
    """Write a stereo pair of images of each of so many positions of the board."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, turn in enumerate(TILTS_DEG[:views]):
        place = (18.0 * (number % 3 - 1), 12.0 * (number % 2) - 6.0, 340.0 + 25.0 * (number % 4))
        for index, camera in enumerate(cameras):
            seen = picture(turn, (place[0] - BASELINE_MM * (index - 0.5), place[1], place[2]))
            cv2.imwrite(str(folder / f"{camera}{number + 1:02d}.png"), seen)
    return folder
