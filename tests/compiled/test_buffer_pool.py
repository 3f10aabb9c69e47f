"""The buffer pool reuses a buffer only when no array or view refers to it any more."""

from __future__ import annotations

import numpy as np

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES, BufferPool
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from tests.fringe.conftest import images_of, ramp, stack_of


def address(array: np.ndarray) -> int:
    return int(array.__array_interface__["data"][0])


def test_a_buffer_is_not_reused_while_a_view_of_it_lives() -> None:
    pool = BufferPool()
    first = pool.empty(100, np.float32)
    place = address(first)
    part = first.reshape(10, 10).view()[3:5]
    del first
    assert address(pool.empty(100, np.float32)) != place
    del part
    again = pool.empty(200, np.uint16)  # as many bytes
    assert address(again) == place
    assert again.dtype == np.uint16 and again.shape == (200,) and again.flags.writeable


def test_arrays_of_nearly_equal_size_share_a_buffer() -> None:
    pool = BufferPool()
    first = pool.empty((1000, 3), np.float64)
    place = address(first)
    del first
    again = pool.empty((990, 3), np.float64)  # a cloud with a few points less
    assert again.shape == (990, 3) and again.flags.c_contiguous
    assert address(again) == place


def test_arrays_begin_at_a_cache_line() -> None:
    pool = BufferPool()
    held = [pool.empty(count, np.float32) for count in (3, 100, 5000, 5000)]
    assert [address(array) % CACHE_LINE_BYTES for array in held] == [0, 0, 0, 0]


def test_an_empty_array_can_be_allocated() -> None:
    assert BufferPool().empty(0, np.int16).shape == (0,)


def test_maps_that_are_held_do_not_change_when_another_view_is_decoded_with_the_same_pool() -> None:
    pool = BufferPool()
    first = stack_of(images_of(ramp(), PAPER_PATTERNS))
    other = stack_of(images_of(ramp(first=300, last=800), PAPER_PATTERNS))
    held = decode(first, memory=pool)["left"]
    phase = held.phase_rad.copy()
    decode(other, memory=pool)
    fresh = decode(other)["left"]
    again = decode(other, memory=pool)["left"]  # in the buffers of the one before
    assert np.array_equal(held.phase_rad, phase)
    for name in ("phase_rad", "sigma_rad", "modulation", "grey", "state", "exposure_index"):
        assert np.array_equal(getattr(again, name), getattr(fresh, name)), name
