"""Times of board detection in images of 5 MP; run with ``-m slow``.

Processor time, so that other work on the machine counts little; the answer itself comes sooner, as parts run on several threads.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.errors import CalibrationError
from tests.calibrate.virtual_board import BOARDS, FULL, shot

pytestmark = pytest.mark.slow
LIMIT_S = 0.3
ROUNDS = 8


def fastest_s(work: Callable[[], object]) -> float:
    times = []
    for _ in range(ROUNDS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


@pytest.mark.parametrize("kind", list(BOARDS))
def test_a_board_in_5_megapixels_is_found_in_time(kind: str) -> None:
    image = shot(BOARDS[kind], 35, size=FULL).image
    taken = fastest_s(lambda: find_board(image, BOARDS[kind]))
    assert taken < LIMIT_S


@pytest.mark.parametrize("kind", list(BOARDS))
def test_a_miss_in_5_megapixels_is_reported_in_time(kind: str) -> None:
    part = shot(BOARDS[kind], 35, size=FULL).image.copy()
    part[:, :1100] = 40
    part[900:] = 40

    def missed() -> None:
        with pytest.raises(CalibrationError):
            find_board(np.ascontiguousarray(part[:, ::-1]), BOARDS[kind])

    taken = fastest_s(missed)
    assert taken < LIMIT_S
