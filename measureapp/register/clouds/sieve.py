"""Filters as values: what to keep of a cloud, one after the other, each saying how many points it removed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import InputError
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.clouds import filters
from measureapp.register.clouds.quality import point_spacing_mm

FilterKind = Literal["box", "plane", "radius", "statistical", "islands"]
MOST_FILTERS = 255
NUMBERS: dict[FilterKind, int] = {"box": 6, "plane": 4, "radius": 2, "statistical": 2, "islands": 1}


@dataclass(frozen=True, slots=True)
class Filter:
    """One filter with its numbers.

    Box: x0, x1, y0, y1, z0, z1 in mm. Plane: its normal, showing to the side that stays, and its distance from the origin in
    mm. Radius: in mm, and how many others a point needs within it. Statistical: standard deviations, and to how many
    neighbours the mean distance is taken. Islands: least area of a connected patch in mm².
    """

    kind: FilterKind
    numbers: tuple[float, ...]

    def __post_init__(self) -> None:
        if len(self.numbers) != NUMBERS[self.kind] or not np.isfinite(self.numbers).all():
            raise InputError(f"The filter {self.kind!r} needs {NUMBERS[self.kind]} numbers.", "Give numbers with commas between them.")
        if self.kind == "box" and not all(low <= high for low, high in zip(self.numbers[::2], self.numbers[1::2], strict=True)):
            raise InputError("The box ends before it begins.", "Give each axis from the smaller to the larger coordinate.")

    def keeps(self, points_mm: FloatArray, progress: Progress = NoProgress()) -> BoolArray:  # noqa: B008 - stateless
        """Return which points stay; raises RegistrationError as the filters do."""
        numbers = np.asarray(self.numbers)
        if self.kind == "box":
            return filters.in_box(points_mm, numbers[::2], numbers[1::2])
        if self.kind == "plane":
            return filters.above_plane(points_mm, numbers[:3], float(numbers[3]))
        if self.kind == "radius":
            return filters.crowded(points_mm, float(numbers[0]), int(numbers[1]), progress)
        if self.kind == "statistical":
            return filters.statistical(points_mm, int(numbers[1]), float(numbers[0]), progress)
        return filters.in_large_patches(points_mm, point_spacing_mm(points_mm), float(numbers[0]))


def sieved(points_mm: FloatArray, asked: Sequence[Filter], progress: Progress | None = None) -> tuple[IntArray, dict[FilterKind, int]]:
    """Return the indices of the points that pass all filters, and how many points each kind of filter removed.

    Raises
    ------
    InputError
        A filter leaves no point.
    """
    progress = progress or NoProgress()
    stays, removed = np.arange(len(points_mm)), dict[FilterKind, int]()
    for number, one in enumerate(asked):
        part = PartOf(progress, number / len(asked), (number + 1) / len(asked))
        part.report(0, 1, f"filter: {one.kind}")
        mask = one.keeps(points_mm[stays], part)
        removed[one.kind] = removed.get(one.kind, 0) + int(np.count_nonzero(~mask))
        stays = stays[mask]
        if len(stays) == 0:
            raise InputError(f"No point is left after the filter {one.kind!r}.", "Widen it; nothing was written.")
    progress.report(1, 1, "filtered")
    return stays, removed


@dataclass(frozen=True, slots=True, eq=False)
class FilterChain:
    """Filters one after the other on one cloud, and how many of them each of its points passed; every step can be gone back."""

    filters: tuple[Filter, ...]
    passed: IntArray  # (N,) uint8, of the points of the unfiltered cloud

    @classmethod
    def none(cls, count: int) -> FilterChain:
        """Return no filter on so many points."""
        return cls((), np.zeros(count, np.uint8))

    @property
    def stays(self) -> BoolArray:
        """Which points passed all filters, (N,)."""
        return np.asarray(self.passed >= len(self.filters))

    def then(self, wanted: Filter, points_mm: FloatArray, progress: Progress | None = None) -> FilterChain:
        """Return this chain with one more filter; ``points_mm`` (N, 3) is the unfiltered cloud.

        Raises
        ------
        InputError
            The filter leaves no point, or there are 255 already.
        """
        if len(self.filters) == MOST_FILTERS:
            raise InputError(f"There are {MOST_FILTERS} filters already.", "Take some back, or apply fewer that take away more.")
        left = np.flatnonzero(self.stays)
        stays, _ = sieved(points_mm[left], (wanted,), progress)
        passed = self.passed.copy()
        passed[left[stays]] += 1
        return FilterChain((*self.filters, wanted), passed)

    @classmethod
    def of(cls, filters: Sequence[Filter], points_mm: FloatArray, progress: Progress | None = None) -> FilterChain:
        """Return these filters one after the other on a cloud; raises as `then`."""
        chain = cls.none(len(points_mm))
        for number, wanted in enumerate(filters):
            part = None if progress is None else PartOf(progress, number / len(filters), (number + 1) / len(filters))
            chain = chain.then(wanted, points_mm, part)
        return chain

    def without_last(self) -> FilterChain:
        """Return this chain without its last filter."""
        left = self.filters[:-1]
        return FilterChain(left, np.minimum(self.passed, len(left)).astype(np.uint8))
