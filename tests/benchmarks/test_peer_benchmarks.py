"""Decoding beside OpenCV's structured-light module and scikit-image on the same images; run with ``-m slow``."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.fringe.phase_shift import wrapped_phase
from tests.fringe.conftest import images_of
from tests.peer_environment import peer_python

Benchmark = Callable[..., Any]
pytestmark = pytest.mark.slow
PEERS = Path(__file__).parent / "peers"  # OpenCV with contrib modules (Apache 2.0), scikit-image (BSD 3-clause)
LEAST_RATIO = 2.0  # 7 on a quiet machine; the fastest peer wraps three images by one Fourier transform and unwraps none


@pytest.fixture(scope="module")
def images() -> np.ndarray:
    """Eight images of one exposure, 2592 × 1944 px."""
    column = np.broadcast_to(np.linspace(4, 1018, 2592), (243, 2592))
    return np.tile(images_of(column, PAPER_PATTERNS)[0], (1, 8, 1))


def test_decoding_is_faster_than_opencv_contrib_and_scikit_image(benchmark: Benchmark, images: np.ndarray, tmp_path: Path) -> None:
    python = peer_python("structured-light", PEERS / "requirements.lock")
    np.save(tmp_path / "images.npy", images)
    np.save(tmp_path / "wrapped.npy", wrapped_phase(images[:4].astype(np.float32))[0].astype(np.float32))
    stack = FringeStack("v", PAPER_PATTERNS, (100_000,), {"left": images[None]}, 255)
    decode(stack)
    benchmark.pedantic(decode, (stack,), rounds=9)
    command = [str(python), str(PEERS / "run_peers.py"), str(tmp_path / "images.npy"), str(tmp_path / "wrapped.npy")]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    ours = benchmark.stats.stats.min
    ratios = {name: seconds / ours for name, seconds in answer["seconds"].items()}
    benchmark.extra_info.update({"times ours": ratios, **answer["versions"]})

    assert min(ratios.values()) > LEAST_RATIO
