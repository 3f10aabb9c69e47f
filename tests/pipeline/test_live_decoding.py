"""Decoding while a scan still takes images, with injected fakes instead of waiting."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from measureapp.acquire.tasks.fringes import ExposureTaken
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.errors import DecodeError
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
        done = live.maps(stack)
    assert done is not None
    fresh = decode(stack)["left"]
    assert np.array_equal(done[0]["left"].phase_rad, fresh.phase_rad)
    assert np.array_equal(done[0]["left"].state, fresh.state)


def test_a_retaken_viewpoint_begins_anew(stack: FringeStack) -> None:
    spoiled = exposures(stack_of(np.full_like(stack.images["left"], 90), exposures_us=EXPOSURES_US))
    with LiveDecoding() as live:
        for taken in spoiled[:3]:
            live.exposure_taken(taken)
        live.drop("v")
        assert live.maps(stack) is None
        for taken in [*spoiled[:2], *exposures(stack)]:
            live.exposure_taken(taken)
        done = live.maps(stack)
    assert done is not None
    assert np.array_equal(done[0]["left"].phase_rad, decode(stack)["left"].phase_rad)


def test_images_that_contradict_the_set_are_refused(stack: FringeStack) -> None:
    images = stack.images["left"].copy()
    images[2, 3] = images[2, 2]
    wrong = stack_of(images, exposures_us=EXPOSURES_US)
    with LiveDecoding() as live:
        for taken in exposures(wrong):
            live.exposure_taken(taken)
        with pytest.raises(DecodeError, match="Image 4 of camera 'left' at 60000 µs is the same as image 3"):
            live.maps(wrong)
