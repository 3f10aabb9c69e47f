"""Decoding while a scan still takes images, with injected fakes instead of waiting."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np
import pytest

from measureapp.acquire.tasks.stack import ExposureTaken
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.fringe.streaming import StreamingDecoder
from measureapp.pipeline.live_decoding import LiveDecoding
from tests.fringe.conftest import EXPOSURES_US, images_of, ramp, stack_of

LIMIT_S = 60.0


def exposures(stack: FringeStack) -> list[ExposureTaken]:
    return [
        ExposureTaken("v", stack.patterns, stack.exposures_us, level, {name: images[level] for name, images in stack.images.items()}, 255)
        for level in range(len(stack.exposures_us))
    ]


@pytest.fixture
def stack() -> FringeStack:
    return stack_of(images_of(ramp(), PAPER_PATTERNS, EXPOSURES_US), exposures_us=EXPOSURES_US)


def test_an_exposure_is_decoded_before_the_next_is_complete(stack: FringeStack, monkeypatch: pytest.MonkeyPatch) -> None:
    summed = [threading.Event() for _ in EXPOSURES_US]
    genuine = StreamingDecoder.add

    def add(self: StreamingDecoder, camera: str, exposure_index: int, images: np.ndarray) -> None:
        genuine(self, camera, exposure_index, images)
        summed[exposure_index].set()

    monkeypatch.setattr(StreamingDecoder, "add", add)
    with LiveDecoding() as live:
        for level, taken in enumerate(exposures(stack)):
            assert not any(event.is_set() for event in summed[level:])
            live.exposure_taken(taken)
            assert summed[level].wait(LIMIT_S)  # no later image exists yet
        taken = live.take("v")
        assert taken is not None
        done = taken.wait(LIMIT_S)
    fresh = decode(stack)["left"]
    assert np.array_equal(done["left"].phase_rad, fresh.phase_rad)
    assert np.array_equal(done["left"].state, fresh.state)


def test_a_retaken_viewpoint_begins_anew(stack: FringeStack) -> None:
    spoiled = exposures(stack_of(np.full_like(stack.images["left"], 90), exposures_us=EXPOSURES_US))
    with LiveDecoding() as live:
        for taken in spoiled[:3]:
            live.exposure_taken(taken)
        live.drop("v")
        assert live.take("v") is None
        for taken in [*spoiled[:2], *exposures(stack)]:
            live.exposure_taken(taken)
        again = live.take("v")
        assert again is not None
        done = again.wait(LIMIT_S)
    assert np.array_equal(done["left"].phase_rad, decode(stack)["left"].phase_rad)


def test_a_decoder_that_is_stuck_keeps_the_images_of_two_viewpoints_and_no_more(
    stack: FringeStack, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = threading.Event()
    genuine = StreamingDecoder.add

    def add(self: StreamingDecoder, camera: str, exposure_index: int, images: np.ndarray) -> None:
        assert free.wait(LIMIT_S)
        genuine(self, camera, exposure_index, images)

    monkeypatch.setattr(StreamingDecoder, "add", add)
    with LiveDecoding() as live:
        found = []
        for name in ("a", "b", "c"):
            for taken in exposures(stack):
                live.exposure_taken(replace(taken, viewpoint_id=name))  # returns at once
            found.append(live.take(name))
        assert found[0] is not None
        with pytest.raises(TimeoutError):
            found[0].wait(0.01)
        free.set()
        assert [maps is not None and "left" in maps.wait(LIMIT_S) for maps in found] == [True, True, False]
        for taken in exposures(stack):
            live.exposure_taken(replace(taken, viewpoint_id="d"))
        assert live.take("d") is not None  # it caught up
