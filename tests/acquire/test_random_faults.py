"""Thousands of viewpoint cycles with random faults: nothing wrong is ever stored."""

from __future__ import annotations

import numpy as np
import pytest
from acquire.fake_rig import Cell, Truthful, drawn, fake_plan, fake_rig, released

from measureapp.acquire.engine import Engine
from measureapp.acquire.events import RunEnded, ViewpointFailed, ViewpointRetaken
from measureapp.acquire.stopping import reset
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.errors import MeasureError
from measureapp.progress import NoProgress

IMAGE_FAULTS = ("failed", "serial", "read-back", "missing", "double", "stale", "earlier", "half exposed", "torn", "wrapped", "lamp")
AXIS_FAULTS = ("off", "timeout", "stuck")
ANY_DEVICE = ("oserror", "lost")
ONE_IN_IMAGES, ONE_IN_MOVES, ONE_IN_READS, ONE_IN_PATTERNS = 300, 25, 60, 400


def random_faults(seed, often):
    """Return a fault for every call of every device, from the seed alone, so many times as often."""
    random = np.random.default_rng(seed)

    def fault(device, call):
        if device in ("left", "right"):
            return str(random.choice(IMAGE_FAULTS + ANY_DEVICE)) if random.random() < often / ONE_IN_IMAGES else ""
        if device.endswith(" read"):
            return str(random.choice(("creep", "nan"))) if random.random() < often / ONE_IN_READS else ""
        if device == "projector":
            return str(random.choice(("late", *ANY_DEVICE))) if random.random() < often / ONE_IN_PATTERNS else ""
        return str(random.choice(AXIS_FAULTS + ANY_DEVICE)) if random.random() < often / ONE_IN_MOVES else ""

    return fault


def cycles(count, seed, often):
    """Scan ``count`` viewpoints, going on after every stop; return the sink and how often viewpoints failed or were taken again."""
    cell = Cell(fault=random_faults(seed, often))
    sink = Truthful(cell, keep=False)
    plan = fake_plan(count)
    retaken, failed, ends = 0, set(), 0
    with released(fake_rig(cell)) as rig:
        waiting = list(plan.viewpoints)
        while waiting:
            events = []
            task = FringeTask(plan.patterns, plan.bracket.exposures_us, drawn(plan), sink)
            try:
                Engine(rig).run(plan.name, waiting, task, events.append, NoProgress())
            except MeasureError:
                ends += 1
                assert all(device.stops for device in rig.devices)
                reset(rig)
            assert isinstance(events[-1], RunEnded)
            retaken += sum(isinstance(event, ViewpointRetaken) for event in events)
            failed |= {event.viewpoint_id for event in events if isinstance(event, ViewpointFailed)}
            done = set(sink.stacks) | failed
            waiting = [viewpoint for viewpoint in plan if viewpoint.id not in done]
    return sink, retaken, failed, ends


def check(count, seed, often=1):
    sink, retaken, failed, ends = cycles(count, seed, often)
    assert not sink.wrong
    assert len(set(sink.stacks)) == len(sink.stacks), "a viewpoint was stored twice"
    assert len(sink.stacks) + len(failed) == count
    assert retaken > 0.02 * count, "no fault reached the images"
    assert ends > 0.02 * count, "no fault reached the axes"
    assert len(failed) < 0.05 * count


def test_fifty_cycles_with_the_random_faults_of_a_hundred_store_nothing_wrong():
    check(50, seed=1, often=2)


@pytest.mark.slow
def test_two_thousand_cycles_with_random_faults_store_nothing_wrong():
    check(2000, seed=2)
