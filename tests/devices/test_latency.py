"""The latency of a projector is found from simulated flips, with the jitter of a compositor and the noise of a camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from measureapp.devices.latency import measure_latency
from measureapp.errors import DeviceError, InputError

FRAME_S = 1 / 60
EXPOSURE_S = 0.005
INTERVAL_S = 0.0125
FLIPS = 50


@dataclass
class Recording:
    """What a camera saw of flips whose true latencies are known."""

    flips_s: np.ndarray
    white: np.ndarray
    starts_s: np.ndarray
    greys: np.ndarray
    true_s: np.ndarray

    def measure(self):
        return measure_latency(self.flips_s, self.white, self.starts_s, self.greys, exposure_s=EXPOSURE_S, frame_s=FRAME_S)


def record(seed: int = 1, hold_s: float = 0.4, noise: float = 0.5, level: float = 150.0, jitter_frames: int = 2) -> Recording:
    """Simulate: the compositor takes the next frame or one of the two after, the projector two more; the camera integrates."""
    rng = np.random.default_rng(seed)
    flips = np.cumsum(rng.uniform(hold_s, hold_s + FRAME_S, FLIPS))
    white = np.arange(FLIPS) % 2 == 0
    vsync = np.ceil(flips / FRAME_S) * FRAME_S
    lit = vsync + FRAME_S * (2 + rng.integers(0, jitter_frames + 1, FLIPS)) + rng.uniform(0, 0.001, FLIPS)
    starts = np.arange(0.0, flips[-1] + hold_s, INTERVAL_S) + rng.uniform(0, 0.001)
    fine = starts[:, None] + np.linspace(0, EXPOSURE_S, 101)[None, :]
    shows = np.searchsorted(lit, fine) - 1
    light = np.where(shows < 0, 0.0, white[shows])
    greys = 12.0 + level * light.mean(axis=1) + rng.normal(0, noise, len(starts))
    return Recording(flips, white, starts, greys, lit - flips)


@pytest.mark.parametrize("seed", range(5))
def test_the_largest_latency_is_found_and_never_too_small(seed: int) -> None:
    recording = record(seed)
    found = recording.measure()
    assert recording.true_s.max() <= found.largest_s <= recording.true_s.max() + INTERVAL_S + 1e-3
    assert recording.true_s.min() <= found.smallest_s <= recording.true_s.min() + INTERVAL_S + 1e-3
    assert abs(found.median_s - np.median(recording.true_s) - INTERVAL_S / 2) < INTERVAL_S
    assert found.wait_s == pytest.approx(found.largest_s + FRAME_S)
    assert found.flips == FLIPS


def test_waiting_for_it_shows_the_new_image_to_every_later_exposure() -> None:
    assert np.all(record(7).true_s <= record(7).measure().wait_s)
    assert np.all(record(8).true_s <= record(7).measure().wait_s)  # another run of the same projector


def test_the_jitter_is_that_of_the_compositor() -> None:
    steady, jumping = record(3, jitter_frames=0).measure(), record(3, jitter_frames=4).measure()
    assert steady.jitter_s < FRAME_S + 2 * INTERVAL_S
    assert jumping.jitter_s > 3 * FRAME_S


def test_a_partly_exposed_image_is_not_the_new_one() -> None:
    recording = record(2)
    partly = np.abs(recording.greys - 12.0) % 150.0
    assert np.any((partly > 15) & (partly < 135)), "the simulation has images that saw both levels"
    assert recording.measure().largest_s >= recording.true_s.max()


def test_a_flip_that_does_not_settle_is_refused() -> None:
    recording = record(4, hold_s=0.12)
    late = recording.greys.copy()
    inside = (recording.starts_s > recording.flips_s[20]) & (recording.starts_s < recording.flips_s[21])
    late[inside] = late[np.flatnonzero(inside)[0] - 1]  # the projector skipped one flip
    recording.greys = late
    with pytest.raises(DeviceError, match="1 of 50 flips did not settle"):
        recording.measure()


def test_levels_that_do_not_differ_are_refused() -> None:
    with pytest.raises(DeviceError, match="Black and white of the projector differ by"):
        record(5, level=2.0, noise=1.0).measure()


def test_flips_faster_than_the_camera_are_refused() -> None:
    recording = record(6)
    recording.starts_s, recording.greys = recording.starts_s[::40], recording.greys[::40]
    with pytest.raises(DeviceError, match="Fewer than two images"):
        recording.measure()


def test_times_that_run_back_are_refused() -> None:
    recording = record(6)
    recording.starts_s = recording.starts_s.copy()
    recording.starts_s[100] -= 1.0
    with pytest.raises(InputError, match="not ascending"):
        recording.measure()


def test_too_few_flips_and_flips_to_one_level_are_refused() -> None:
    recording = record(6)
    with pytest.raises(InputError, match="9 flips are too few"):
        measure_latency(
            recording.flips_s[:9], recording.white[:9], recording.starts_s, recording.greys, exposure_s=EXPOSURE_S, frame_s=FRAME_S
        )
    recording.white = np.ones(FLIPS, bool)
    with pytest.raises(InputError, match="same level"):
        recording.measure()
