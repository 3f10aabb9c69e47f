"""Tables and limits of a sequence."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from measureapp.errors import LimitError

from .conftest import module


def eight(exposure_us: int = 60_000, period_us: int = 130_000, images: tuple[int, ...] = (4, 5, 6)) -> Any:
    return module("sequence").play_patterns(0, 8, images, 4, exposure_us=exposure_us, period_us=period_us)


def check(sequence: Any, load_s: float = 0.2) -> None:
    module("sequence").check_times(sequence, "LightCrafter", dict.fromkeys(range(256), load_s))


def test_eight_patterns_are_green_red_and_blue_of_three_images_with_a_swap_at_each() -> None:
    # number<<2 | internal trigger; blue LED<<4 | 8 bits; black after (2) and swap (4)
    assert eight().pattern_table().hex(" ") == "00 48 06 04 48 02 08 48 02 00 48 06 04 48 02 08 48 02 00 48 06 04 48 02"
    assert eight().image_table() == bytes([4, 5, 6])


def test_a_table_of_exactly_two_images_is_sent_in_reverse_order() -> None:
    six = module("sequence").play_patterns(0, 6, (4, 5), 4, exposure_us=9000, period_us=10000)
    assert six.image_table() == bytes([5, 4])


def test_a_run_that_begins_within_an_image_swaps_at_its_first_pattern() -> None:
    run = module("sequence").play_patterns(2, 3, (4, 5, 6), 4, exposure_us=9000, period_us=10000)
    assert [(entry.number, entry.swap) for entry in run.entries] == [(2, True), (0, True), (1, False)]
    assert run.images == (4, 5)


@pytest.mark.parametrize(("bits", "shortest"), [(1, 235), (2, 700), (3, 1570), (4, 1700), (5, 2000), (6, 2500), (7, 4500), (8, 8333)])
def test_an_exposure_below_the_limit_of_its_bit_depth_is_refused(bits: int, shortest: int) -> None:
    made = module("sequence")

    def of(exposure_us: int) -> Any:
        return made.PatternSequence((made.PatternEntry(0, bits, 4, swap=True),), (0,), exposure_us, exposure_us, repeat=True)

    check(of(shortest))
    with pytest.raises(LimitError, match=f"patterns of {bits} bits") as refused:
        check(of(shortest - 1))
    assert f"{shortest} µs" in refused.value.hint


def test_an_exposure_without_the_dark_gap_is_refused() -> None:
    check(eight(exposure_us=129_770))
    with pytest.raises(LimitError, match="129771 µs in a period of 130000 µs"):
        check(eight(exposure_us=129_771))


def test_an_image_that_would_come_too_late_is_refused_with_the_shortest_period() -> None:
    check(eight(9000, 66_667))
    with pytest.raises(LimitError, match="200 ms to load flash image 6") as refused:
        check(eight(9000, 66_666))
    assert "66667 µs" in refused.value.hint


def test_two_images_need_no_loading_time() -> None:
    check(module("sequence").play_patterns(0, 6, (4, 5), 4, exposure_us=9000, period_us=10_000))


def test_a_set_longer_than_the_table_is_refused() -> None:
    with pytest.raises(LimitError, match="at most 128 patterns"):
        check(module("sequence").play_patterns(0, 129, tuple(range(43)), 4, exposure_us=9000, period_us=100_000))


def test_the_identity_of_a_set_depends_on_every_pixel_and_on_its_size() -> None:
    identify = module("sequence").pattern_hash
    images = np.zeros((2, 4, 6), np.uint8)
    other = images.copy()
    other[1, 3, 5] = 1
    assert len({identify(images), identify(other), identify(images.reshape(2, 6, 4)), identify(images[:1])}) == 4
    assert identify(images) == identify(np.asfortranarray(images))
