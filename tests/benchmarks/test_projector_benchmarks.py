"""Camera and projector at 2592 × 1944 px against OpenCV's triangulation; run with ``-m slow``."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter
from typing import Any

import cv2
import numpy as np
import pytest

from measureapp.data.phase import PhaseMap
from measureapp.reconstruct.diagnosis.diagnose import diagnose
from measureapp.reconstruct.projector.depth import triangulate_with_projector
from measureapp.reconstruct.rectification.rectifier import Rectifier
from tests.reconstruct.conftest import plane
from tests.reconstruct.projector_scene import HEAD, ProjectorHead, make_head

Benchmark = Callable[..., Any]
pytestmark = pytest.mark.slow
OPENCV_POINTS = 200_000
LEAST_RATIO = 15
PLANE = plane(550, 0.2, 0.1)


@pytest.fixture(scope="module")
def view() -> tuple[ProjectorHead, dict[str, PhaseMap]]:
    head = make_head({"left": HEAD["left"]}, binning=1)
    return head, head.phase_maps(PLANE)


def test_triangulating_with_the_projector(benchmark: Benchmark, view: tuple[ProjectorHead, dict[str, PhaseMap]]) -> None:
    head, maps = view
    rays = Rectifier(head.cameras).rays("left")
    camera = head.cameras.cameras["left"]
    ours, theirs = [], []
    chosen = np.flatnonzero(maps["left"].valid)[:OPENCV_POINTS]
    flat = rays.reshape(-1, 2)[chosen].astype(np.float64)
    points = np.column_stack([flat, np.ones(len(flat))]) * head.depth_mm("left", PLANE).ravel()[chosen, None]
    projector_from_camera = head.projector.reference_from_projector.inverse() @ camera.reference_from_camera
    lit = projector_from_camera.apply(points)
    poses = np.eye(3, 4), np.array(projector_from_camera.matrix[:3])
    seen = np.ascontiguousarray(flat.T), np.ascontiguousarray((lit[:, :2] / lit[:, 2:]).T)

    def both() -> Any:
        start = perf_counter()
        made = triangulate_with_projector(maps["left"], camera, head.projector, None, rays)
        middle = perf_counter()
        cv2.triangulatePoints(*poses, *seen)
        ours.append((middle - start) / maps["left"].phase_rad.size)
        theirs.append((perf_counter() - middle) / OPENCV_POINTS)
        return made

    both()
    made = benchmark.pedantic(both, rounds=7)
    benchmark.extra_info |= {"ms": 1e3 * min(ours) * rays[..., 0].size, "ratio to cv2.triangulatePoints": min(theirs) / min(ours)}
    assert (made.depth_mm > 0).sum() == maps["left"].valid.sum()
    assert min(theirs) / min(ours) > LEAST_RATIO


def test_diagnosing_a_view(benchmark: Benchmark, view: tuple[ProjectorHead, dict[str, PhaseMap]]) -> None:
    head, maps = view
    assert benchmark.pedantic(diagnose, (maps, head.cameras), rounds=3) == ()
