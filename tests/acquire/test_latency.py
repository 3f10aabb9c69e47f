"""The latency of a projector is measured with a camera of the rig."""

from __future__ import annotations

import time
from dataclasses import replace

import pytest
from acquire.fake_rig import Cell, fake_rig, released

from measureapp.acquire.latency import measure_projector_latency
from measureapp.errors import DeviceError
from measureapp.progress import NoProgress


class LateCell(Cell):
    """What is shown appears late."""

    latency_s = 0.0

    def mean(self, camera, exposure_us, pattern):
        time.sleep(0.002)  # as an exposure takes its time
        now = time.monotonic()
        if pattern != getattr(self, "requested", None):
            self.before, self.requested, self.since = getattr(self, "requested", -2), pattern, now
        return super().mean(camera, exposure_us, pattern if now >= self.since + self.latency_s else self.before)


@pytest.fixture
def cell():
    return LateCell()


@pytest.fixture
def rig(cell):
    with released(fake_rig(cell)) as made:
        yield replace(made, description=made.description.model_copy(update={"exposures_us": (60_000,)}))


@pytest.mark.parametrize("latency_s", [0.0, 0.03])
def test_the_latency_is_found_within_the_time_between_two_images(rig, cell, latency_s):
    cell.latency_s = latency_s
    found = measure_projector_latency(rig, NoProgress(), flips=12, hold_s=0.25)
    assert found.smallest_s >= latency_s
    assert found.median_s < latency_s + 0.1
    assert found.flips == 12


def test_a_camera_that_does_not_see_the_projector_is_told(rig, cell):
    cell.mean = lambda camera, exposure_us, pattern: 40.0
    with pytest.raises(DeviceError, match="differ by"):
        measure_projector_latency(rig, NoProgress(), flips=10, hold_s=0.2)
