"""Times of decoding and reconstruction at the paper's full resolution; run with ``-m slow``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.reconstruct.rectifier import Rectifier
from tests.fringe.conftest import EXPOSURES_US, images_of
from tests.reconstruct.conftest import make_head, plane

Benchmark = Callable[..., Any]
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def full_stack() -> FringeStack:
    """One camera of 2592 × 1944 px, five exposures of eight images, 4 % of it saturated at the longest."""
    column = np.broadcast_to(np.linspace(4, 1018, 2592), (243, 2592))
    mean, modulation = np.full(column.shape, 110.0), np.full(column.shape, 80.0)
    mean[:, :100], modulation[:, :100] = 400, 300
    images = np.tile(images_of(column, PAPER_PATTERNS, EXPOSURES_US, mean, modulation), (1, 1, 8, 1))
    images.flags.writeable = False
    return FringeStack("v", PAPER_PATTERNS, EXPOSURES_US, {"left": images}, 255)


@pytest.mark.parametrize("rule", ["combined", "paper"])
def test_decoding_one_camera(benchmark: Benchmark, full_stack: FringeStack, rule: str) -> None:
    settings = DecodeSettings(rule=rule)
    decode(full_stack, settings)
    decoded = benchmark.pedantic(decode, (full_stack, settings), rounds=5)
    assert decoded["left"].valid.mean() > 0.97


@pytest.mark.parametrize("binning", [4, 2])
def test_reconstructing_a_view_of_three_cameras(benchmark: Benchmark, binning: int) -> None:
    head = make_head(binning)
    maps = head.phase_maps(plane(550, 0.2, 0.1), 0.012, 1)
    rectifier = Rectifier(head.cameras)
    reconstruct(maps, head.cameras, rectifier=rectifier)
    made = benchmark.pedantic(reconstruct, (maps, head.cameras), {"rectifier": rectifier}, rounds=2)
    assert len(made.cloud) > 0.95 * maps["left"].valid.sum()
