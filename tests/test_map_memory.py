"""Memory that is given out again only when nobody looks at it any more."""

from __future__ import annotations

import numpy as np

from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.map_memory import LINE, MapMemory
from tests.fringe.conftest import images_of, ramp, stack_of


def address(array: np.ndarray) -> int:
    return int(array.__array_interface__["data"][0])


def test_memory_is_not_given_out_again_while_a_view_of_it_lives() -> None:
    memory = MapMemory()
    first = memory.empty(100, np.float32)
    place = address(first)
    part = first.reshape(10, 10).view()[3:5]
    del first
    assert address(memory.empty(100, np.float32)) != place
    del part
    again = memory.empty(200, np.uint16)  # as many bytes
    assert address(again) == place
    assert again.dtype == np.uint16 and again.shape == (200,) and again.flags.writeable


def test_an_array_of_nearly_the_same_size_takes_the_place_of_one_that_is_gone() -> None:
    memory = MapMemory()
    first = memory.empty((1000, 3), np.float64)
    place = address(first)
    del first
    again = memory.empty((990, 3), np.float64)  # a cloud with a few points less
    assert again.shape == (990, 3) and again.flags.c_contiguous
    assert address(again) == place


def test_arrays_begin_with_a_line_of_the_cache() -> None:
    memory = MapMemory()
    held = [memory.empty(count, np.float32) for count in (3, 100, 5000, 5000)]
    assert [address(array) % LINE for array in held] == [0, 0, 0, 0]


def test_an_array_without_elements_can_be_had() -> None:
    assert MapMemory().empty(0, np.int16).shape == (0,)


def test_maps_that_are_held_do_not_change_when_another_view_is_decoded_in_the_same_memory() -> None:
    memory = MapMemory()
    first = stack_of(images_of(ramp(), PAPER_PATTERNS))
    other = stack_of(images_of(ramp(first=300, last=800), PAPER_PATTERNS))
    held = decode(first, memory=memory)["left"]
    phase = held.phase_rad.copy()
    decode(other, memory=memory)
    fresh = decode(other)["left"]
    again = decode(other, memory=memory)["left"]  # in the memory of the one before
    assert np.array_equal(held.phase_rad, phase)
    for name in ("phase_rad", "sigma_rad", "modulation", "grey", "state", "exposure_index"):
        assert np.array_equal(getattr(again, name), getattr(fresh, name)), name
