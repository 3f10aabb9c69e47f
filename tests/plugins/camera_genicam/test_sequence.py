"""Images are numbered by the identifiers that cameras give them: gaps and repeats show."""

from __future__ import annotations

from collections.abc import Iterable

import pytest

from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import SequenceError

MANY = 10**6


def numbers_of(*sequences: Iterable[int]) -> list[list[int]]:
    driver = load_driver(None, "camera_genicam", "camera")
    numbers = driver.module.FrameNumbers()
    result = []
    for identifiers in sequences:
        numbers.begin(result[-1][-1] + 1 if result else 0)
        result.append([numbers.number(identifier, MANY) for identifier in identifiers])
    return result


@pytest.mark.parametrize("first", [0, 1, 65400])
def test_images_are_counted_from_zero_whatever_the_first_identifier(first: int) -> None:
    assert numbers_of(range(first, first + 4)) == [[0, 1, 2, 3]]


@pytest.mark.parametrize("second", [(1, 2), (4, 5)])
def test_a_camera_may_begin_again_or_count_on_with_the_next_sequence(second: tuple[int, int]) -> None:
    assert numbers_of((1, 2, 3), second) == [[0, 1, 2], [0, 1]]


@pytest.mark.parametrize("second", [(2, 3), (5, 6)])
def test_a_first_image_that_is_lost_is_missing_in_the_next_sequence_too(second: tuple[int, int]) -> None:
    assert numbers_of((1, 2, 3), second) == [[0, 1, 2], [1, 2]]


@pytest.mark.parametrize("second", [(1, 2), (3, 4), (4, 5)])  # begins again; counts on without, and with the image that was lost
def test_after_a_sequence_whose_last_image_never_came_the_next_one_is_counted_from_zero(second: tuple[int, int]) -> None:
    numbers = load_driver(None, "camera_genicam", "camera").module.FrameNumbers()
    numbers.begin(0)
    assert [numbers.number(identifier, 3) for identifier in (1, 2)] == [0, 1]
    numbers.begin(3)
    assert [numbers.number(identifier, 2) for identifier in second] == [0, 1]
    numbers.begin(2)
    with pytest.raises(SequenceError, match="Image 2 arrived after 1 triggers"):  # complete before: a lost first image shows again
        numbers.number(second[-1] + 2, 1)


def test_lost_images_leave_a_gap() -> None:
    assert numbers_of((1, 2, 5, 6)) == [[0, 1, 4, 5]]


@pytest.mark.parametrize(
    ("identifiers", "numbers"),
    [((65534, 65535, 1, 2), [0, 1, 2, 3]), ((65535, 0, 1), [0, 1, 2]), ((65535, 65536), [0, 1]), ((65534, 2), [0, 3])],
)
def test_identifiers_of_16_bit_wrap_with_or_without_zero_and_longer_ones_do_not(identifiers: tuple[int, ...], numbers: list[int]) -> None:
    assert numbers_of(identifiers) == [numbers]


@pytest.mark.parametrize("identifiers", [(7, 7), (7, 8, 7), (100_000, 100_001, 100_000)])
def test_an_image_that_arrives_twice_is_refused_and_the_next_one_counted_right(identifiers: tuple[int, ...]) -> None:
    driver = load_driver(None, "camera_genicam", "camera")
    numbers = driver.module.FrameNumbers()
    numbers.begin(0)
    *good, repeated = identifiers
    for identifier in good:
        numbers.number(identifier, MANY)
    with pytest.raises(SequenceError, match="twice or late"):
        numbers.number(repeated, MANY)
    assert numbers.number(max(good) + 1, MANY) == len(good)


@pytest.mark.parametrize("unknown", [True, False])
def test_damaged_images_count_also_when_their_identifier_is_unknown(unknown: bool) -> None:
    driver = load_driver(None, "camera_genicam", "camera")
    numbers = driver.module.FrameNumbers()
    for first, before in ((1, 0), (1, 3), (4, 3)):  # a camera that begins again, then one that counts on
        numbers.begin(before)
        numbers.damaged(0 if unknown else first, MANY)
        assert numbers.number(first + 1, MANY) == 1
        numbers.damaged(0 if unknown else first + 2, MANY)


def test_more_images_than_triggers_are_refused() -> None:
    driver = load_driver(None, "camera_genicam", "camera")
    numbers = driver.module.FrameNumbers()
    numbers.begin(0)
    numbers.number(1, triggers=1)
    with pytest.raises(SequenceError, match="Image 2 arrived after 1 triggers"):
        numbers.number(2, triggers=1)
