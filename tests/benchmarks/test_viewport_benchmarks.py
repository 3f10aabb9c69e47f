"""Turning large clouds where the processor draws: frames a second and memory, off-screen at 1280 × 960."""

from __future__ import annotations

import os

os.environ["QT_QPA_PLATFORM"] = "offscreen"

import resource
import time

import numpy as np
import pytest

from ui.look.look import Look
from ui.viewport.cloud_view import CloudView
from ui.viewport.layers import CloudLayer
from ui.viewport.shuffled import ShuffledCloud, shuffled

LEARNING_FRAMES, FRAMES = 8, 20
LEAST_FRAMES_PER_S = 10.0
pytestmark = pytest.mark.slow


def wavy_ball(count: int) -> ShuffledCloud:
    rng = np.random.default_rng(1)
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points *= (100.0 / np.linalg.norm(points, axis=1))[:, None]
    points *= 1.0 + 0.05 * np.sin(points[:, :1] / 8.0)
    return shuffled([CloudLayer(points, np.abs(points * 2).astype(np.uint8))])


@pytest.mark.timeout(600)
@pytest.mark.parametrize("millions", [5, 30])
def test_a_cloud_turns_at_ten_frames_a_second(qtbot, millions: int, record_property) -> None:
    view = CloudView(Look("light"))
    qtbot.addWidget(view)
    view.resize(1280, 960)
    view.show()
    view.activate()
    view.set_clouds((), wavy_ball(millions * 1_000_000))
    inner, scene = view._view, view._scene
    scene.reset_camera()
    scene.set_moving(True)
    seconds = []
    for _ in range(LEARNING_FRAMES + FRAMES):
        started = time.perf_counter()
        scene.renderer.GetActiveCamera().Azimuth(3.0)
        inner.refresh()
        view.screenshot()
        seconds.append(time.perf_counter() - started)
    shown = scene.frame_points
    scene.set_moving(False)
    started = time.perf_counter()
    inner.refresh()
    view.screenshot()
    complete_s = time.perf_counter() - started
    frames_per_s = 1.0 / float(np.median(seconds[LEARNING_FRAMES:]))
    peak_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    told = f"{millions} M points: {frames_per_s:.1f} frames/s with {shown} of them, all in {complete_s:.1f} s, peak {peak_mib:.0f} MiB"
    print(told)
    record_property("told", told)
    assert scene._drawn == len(scene._blocks)
    assert frames_per_s >= LEAST_FRAMES_PER_S
    view.close_view()
    view.close()
