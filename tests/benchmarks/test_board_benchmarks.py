"""Board detection in images of 5 MP beside OpenCV's own finder of checkerboards, in the same run; run with ``-m slow``.

Processor time, so that other work on the machine counts little; the answer itself comes sooner, as parts run on several threads.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.errors import CalibrationError
from tests.calibrate.virtual_board import BOARDS, FULL, shot

pytestmark = pytest.mark.slow
MOST_OF_OPENCV = 0.5  # of the processor time that OpenCV takes to find the checkerboard
ROUNDS, ROUNDS_OF_OPENCV = 8, 3


def fastest_s(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


@pytest.fixture(scope="module")
def opencv_s() -> float:
    """Processor time in which OpenCV finds the checkerboard in the same image."""
    board = BOARDS["checkerboard"]
    image = np.ascontiguousarray(shot(board, 35, size=FULL).image)
    assert cv2.findChessboardCornersSB(image, (board.columns, board.rows))[0]
    return fastest_s(lambda: cv2.findChessboardCornersSB(image, (board.columns, board.rows)), ROUNDS_OF_OPENCV)


@pytest.mark.parametrize("kind", list(BOARDS))
def test_a_board_in_5_megapixels_is_found_in_time(kind: str, opencv_s: float) -> None:
    image = shot(BOARDS[kind], 35, size=FULL).image
    taken = fastest_s(lambda: find_board(image, BOARDS[kind]))
    assert taken < MOST_OF_OPENCV * opencv_s


@pytest.mark.parametrize("kind", list(BOARDS))
def test_a_miss_in_5_megapixels_is_reported_in_time(kind: str, opencv_s: float) -> None:
    part = shot(BOARDS[kind], 35, size=FULL).image.copy()
    part[:, :1100] = 40
    part[900:] = 40

    def missed() -> None:
        with pytest.raises(CalibrationError):
            find_board(np.ascontiguousarray(part[:, ::-1]), BOARDS[kind])

    taken = fastest_s(missed)
    assert taken < MOST_OF_OPENCV * opencv_s
