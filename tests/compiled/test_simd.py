"""SIMD vectors in compiled loops against NumPy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numba import njit
from numba.core.errors import TypingError

from measureapp.compiled.simd.elements import (
    any_lane,
    bitmask,
    convert,
    count_trailing_zeros,
    floor,
    maximum,
    minimum,
    popcount,
    select,
    sqrt,
)
from measureapp.compiled.simd.memory import (
    gather,
    gather_records,
    load,
    load_records,
    store,
)

LANES, LENGTH = 16, 160
KINDS = (np.float32, np.float64, np.int8, np.uint8, np.int16, np.uint16, np.int32)


def numbers(kind: Any, seed: int) -> np.ndarray:
    """Numbers of both signs where there are such, small enough for products that fit, with equal ones among them."""
    drawn = np.random.default_rng(seed).integers(-11, 12, LENGTH)
    if np.issubdtype(kind, np.floating):
        return (drawn / 4).astype(kind)
    return (drawn if np.issubdtype(kind, np.signedinteger) else abs(drawn)).astype(kind)


def through(step: Callable[[Any, Any], Any]) -> Callable[..., None]:
    """A compiled loop that puts ``step`` of two arrays into a third."""
    compiled = njit(step)

    @njit(error_model="numpy")
    def loop(first: Any, second: Any, out: Any) -> None:
        for j in range(0, LENGTH, LANES):
            store(convert(compiled(load(first, j, LANES), load(second, j, LANES)), out.dtype), out, j)

    return loop


@pytest.mark.parametrize("kind", KINDS)
def test_arithmetic_and_selection_are_those_of_numpy(kind: Any) -> None:
    a, b = numbers(kind, 1), numbers(kind, 2)
    two = kind(2)
    expected = {
        (lambda x, y: x + y * two): a + b * two,
        (lambda x, y: two * x - y): two * a - b,
        (lambda x, y: maximum(two, y)): np.maximum(two, b),
        (lambda x, y: minimum(x, two)): np.minimum(a, two),
        (lambda x, y: select((x < y) & (y != two), x, y)): np.where((a < b) & (b != two), a, b),
        (lambda x, y: select((x >= y) | ~(x == two), two, y)): np.where((a >= b) | ~(a == two), two, b),
    }
    if np.issubdtype(kind, np.signedinteger) or np.issubdtype(kind, np.floating):
        expected[lambda x, y: abs(x) - (-y)] = abs(a) + b
    for step, wanted in expected.items():
        found = np.empty_like(a)
        through(step)(a, b, found)
        assert np.array_equal(found, wanted.astype(kind))


def test_division_roots_and_rounding_are_those_of_numpy_to_float_precision() -> None:
    a, b = numbers(np.float32, 3), numbers(np.float32, 4)
    found = np.empty_like(a)
    through(lambda x, y: x / (abs(y) + np.float32(1)))(a, b, found)
    np.testing.assert_allclose(found, a / (abs(b) + 1), rtol=1e-6)
    through(lambda x, y: sqrt(abs(x)) + floor(y))(a, b, found)
    np.testing.assert_allclose(found, np.sqrt(abs(a)) + np.floor(b), rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("given", KINDS)
@pytest.mark.parametrize("wanted", (np.float32, np.uint8, np.int16, np.int32))
def test_conversions_are_those_of_numpy(given: Any, wanted: Any) -> None:
    a = abs(numbers(given, 5)) if np.issubdtype(wanted, np.unsignedinteger) else numbers(given, 5)
    found = np.empty(LENGTH, wanted)
    through(lambda x, _y: x)(a, a, found)
    assert np.array_equal(found, a.astype(wanted))


def test_integers_shift_and_combine_their_bits() -> None:
    a, b = numbers(np.int32, 6), numbers(np.int32, 7)
    found = np.empty_like(a)
    through(lambda x, y: (x >> np.int32(1)) | (y & np.int32(5)))(a, b, found)
    assert np.array_equal(found, (a >> 1) | (b & 5))
    bytes_, shifted = np.arange(96, 256, dtype=np.uint8), np.empty(LENGTH, np.uint8)
    through(lambda x, _y: x >> np.uint8(3))(bytes_, bytes_, shifted)
    assert np.array_equal(shifted, bytes_ >> 3)


def test_a_table_is_gathered_at_every_lane() -> None:
    table, places = np.arange(40, dtype=np.float32) ** 2, np.random.default_rng(8).integers(0, 40, LENGTH).astype(np.uint16)
    found = np.empty(LENGTH, np.float32)

    @njit
    def look_up(table: Any, places: Any, out: Any) -> None:
        for j in range(0, LENGTH, LANES):
            store(gather(table, convert(load(places, j, LANES), np.int32)), out, j)

    look_up(table, places, found)
    assert np.array_equal(found, table[places])


@pytest.mark.parametrize("kind", KINDS)
def test_masks_are_counted_over_all_lanes_as_by_numpy(kind: Any) -> None:
    a = numbers(kind, 9)

    @njit
    def sum_up(a: Any, bound: Any, out: Any) -> Any:
        for j in range(0, LENGTH, LANES):
            above = load(a, j, LANES) > bound
            row = out[j // LANES]
            row[0], row[1] = popcount(above), any_lane(above)

    found = np.empty((LENGTH // LANES, 2))
    for bound in (kind(1), kind(2), kind(100)):
        sum_up(a, bound, found)
        above = a.reshape(-1, LANES) > bound
        assert np.array_equal(found, np.stack([above.sum(1), above.any(1)], 1))


@pytest.mark.parametrize("width", (1, 2, 3, 4))
@pytest.mark.parametrize("kind", (np.float32, np.float64, np.int32))
def test_records_are_gathered_and_deinterleaved(width: int, kind: Any) -> None:
    count = LENGTH // 2
    table = np.random.default_rng(11).integers(0, 200, (count, width)).astype(kind)
    places = np.random.default_rng(12).integers(0, count, count).astype(np.int32)
    one_by_one, consecutive = np.empty((width, count), kind), np.empty((width, count), kind)

    @njit
    def apart(table: Any, places: Any, columns: Any, read: Any) -> None:
        for j in range(0, count, LANES):
            gathered, loaded = gather_records(table, width, places, j, LANES, width), load_records(table, width * j, LANES, width)
            for number in range(width):
                store(gathered[number], columns[number], j)
                store(loaded[number], read[number], j)

    apart(table.reshape(-1), places, one_by_one, consecutive)
    assert np.array_equal(one_by_one, table[places].T) and np.array_equal(consecutive, table.T)


@pytest.mark.parametrize("kind", (np.float32, np.uint8))
def test_records_may_overlap(kind: Any) -> None:
    table, places = (np.arange(200) ** 2).astype(kind), np.random.default_rng(13).integers(0, 199, LANES).astype(np.int32)
    steps = np.empty(LANES, kind)

    @njit
    def rises(table: Any, places: Any, out: Any) -> None:
        before, behind = gather_records(table, 1, places, 0, LANES, 2)
        store(behind - before, out, 0)

    rises(table, places, steps)
    assert np.array_equal(steps, np.diff(table)[places])


def test_the_true_lanes_of_a_mask_are_enumerated_from_its_bits() -> None:
    a = numbers(np.float32, 14)

    @njit
    def chosen(a: Any, bound: Any, out: Any) -> Any:
        found = 0
        for j in range(0, LENGTH, LANES):
            bits = bitmask(load(a, j, LANES) > bound)
            while bits != np.uint32(0):
                out[found] = j + count_trailing_zeros(bits)
                found += 1
                bits &= bits - np.uint32(1)
        return found

    places = np.empty(LENGTH, np.int64)
    for bound in np.float32([-3, 0, 2.5, 100]):
        assert np.array_equal(places[: chosen(a, bound, places)], np.flatnonzero(a > bound))


def test_operands_of_different_types_or_lengths_do_not_compile() -> None:
    a, out = np.zeros(LENGTH, np.float32), np.zeros(LENGTH, np.int32)

    @njit
    def other_type(a: Any, out: Any) -> None:
        store(load(a, 0, LANES), out, 0)

    @njit
    def other_length(a: Any, out: Any) -> None:
        store(load(a, 0, LANES) + load(a, 0, 2 * LANES), a, 0)

    @njit
    def no_constant(a: Any, out: Any) -> None:
        store(load(a, 0, len(a)), a, 0)

    for loop in (other_type, other_length, no_constant):
        with pytest.raises(TypingError):
            loop(a, out)
