"""Times of matching and reconstructing a view of the paper's full resolution, as ratios to a copy of its images; run with ``-m slow``."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from time import perf_counter
from typing import Any

import cv2
import numpy as np
import pytest

from measureapp.arrays import in_bands
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct.match import match_rows
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.tables import pair_tables
from tests.reconstruct.conftest import Head, make_head, plane

Benchmark = Callable[..., Any]
pytestmark = pytest.mark.slow

CAMERA_BYTES = 40 * 2592 * 1944
ROUNDS = 7
MOST_OF_PAIR, MOST_OF_VIEW, LEAST_OF_TRIANGULATION = 3.2, 10.0, 500.0  # asked for


@pytest.fixture(scope="module")
def head() -> Head:
    return make_head(1)


@pytest.fixture(scope="module")
def maps(head: Head) -> dict[str, PhaseMap]:
    return head.phase_maps(plane(550, 0.2, 0.1), 0.012, 1)


@pytest.fixture(scope="module")
def rectifier(head: Head, maps: dict[str, PhaseMap]) -> Rectifier:
    made = Rectifier(head.cameras)
    reconstruct(maps, head.cameras, rectifier=made)
    return made


def memory_copy(size: int) -> Callable[[], object]:
    """Return a copy of ``size`` bytes by two threads."""
    source, target = np.ones(size, np.uint8), np.zeros(size, np.uint8)
    halves = (slice(0, size // 2), slice(size // 2, size))

    def work() -> object:
        with ThreadPoolExecutor(2) as pool:
            return list(pool.map(lambda half: np.copyto(target[half], source[half]), halves))

    return work


def alternating(own: Callable[[], object], peer: Callable[[], object]) -> tuple[float, float]:
    """Return the shortest times of both, measured in turns so that other work on the machine meets both."""
    times = []
    for _ in range(ROUNDS):
        pair = []
        for work in (own, peer):
            start = perf_counter()
            work()
            pair.append(perf_counter() - start)
        times.append(pair)
    own_s, peer_s = np.min(times, axis=0)
    return float(own_s), float(peer_s)


def noted(benchmark: Benchmark, own: Callable[[], object], peer: Callable[[], object], asked: float) -> float:
    """Write the ratio of both times beside the asked one into the benchmark's record and return it."""
    own_s, peer_s = alternating(own, peer)
    benchmark.extra_info.update({"ms": own_s * 1e3, "peer_ms": peer_s * 1e3, "ratio": own_s / peer_s, "asked": asked})
    benchmark.pedantic(own, rounds=1)
    return own_s / peer_s


def matching(maps: dict[str, PhaseMap], rectifier: Rectifier) -> Callable[[], list[int]]:
    """Return the match of left and right, tables included; the slopes of the phase maps are made once per view and camera."""
    views = {name: PhaseView.of(maps[name], 3.0) for name in ("left", "right")}
    skip = (views["left"].state != 0).view(np.uint8)
    width = skip.shape[1]

    def work() -> list[int]:
        tables = pair_tables("left", ("right",), views, maps["left"], rectifier)["right"]

        def rows(start: int, stop: int) -> int:
            out = [np.empty((stop - start, width), dtype) for dtype in (np.float32, np.float32, np.float32, np.int32, np.uint8)]
            return match_rows("left", "right", views, tables, skip, rectifier, (start, stop), out)

        return in_bands(rows, len(skip), 40)

    return work


def test_matching_a_pair(benchmark: Benchmark, maps: dict[str, PhaseMap], rectifier: Rectifier) -> None:
    match = matching(maps, rectifier)
    assert sum(match()) > 0.9 * 4_055_000
    assert noted(benchmark, match, memory_copy(CAMERA_BYTES), MOST_OF_PAIR) <= MOST_OF_PAIR


def test_triangulating_a_point_beside_opencv(benchmark: Benchmark, maps: dict[str, PhaseMap], rectifier: Rectifier) -> None:
    """The depth is computed where a match is found: the whole match is timed, more than a triangulation."""
    match = matching(maps, rectifier)
    count = sum(match())
    some = np.random.default_rng(1).uniform(100, 1800, (2, 20_000))
    cameras = [np.hstack([np.eye(3), np.zeros((3, 1))]), np.hstack([np.eye(3), np.array([[-350.0], [0], [0]])])]
    own_s, peer_s = alternating(match, lambda: cv2.triangulatePoints(*cameras, some, some + 1))
    ratio = (peer_s / some.shape[1]) / (own_s / count)
    benchmark.extra_info.update({"ns_per_point": own_s / count * 1e9, "opencv_ns": peer_s / some.shape[1] * 1e9, "ratio": ratio})
    benchmark.pedantic(match, rounds=1)
    assert ratio >= LEAST_OF_TRIANGULATION


def test_reconstructing_a_view_of_three_cameras(benchmark: Benchmark, head: Head, maps: dict[str, PhaseMap], rectifier: Rectifier) -> None:
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert len(made.cloud) > 0.95 * maps["left"].valid.sum()
    work = lambda: reconstruct(maps, head.cameras, rectifier=rectifier)  # noqa: E731
    assert noted(benchmark, work, memory_copy(3 * CAMERA_BYTES), MOST_OF_VIEW) <= MOST_OF_VIEW
