"""Filter chain of a cloud: filters as values, applied one after the other, with undo."""

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
    """One filter with its parameters.

    Box: x0, x1, y0, y1, z0, z1 in mm. Plane: normal towards the side to keep, and distance from the origin in mm. Radius: radius in mm,
    and least number of other points within it. Statistical: standard deviations, and number of neighbours of the mean distance.
    Islands: least area of an isolated patch in mm².
    """

    kind: FilterKind
    numbers: tuple[float, ...]

    def __post_init__(self) -> None:
        if len(self.numbers) != NUMBERS[self.kind] or not np.isfinite(self.numbers).all():
            raise InputError(f"The filter {self.kind!r} needs {NUMBERS[self.kind]} numbers.", "Separate the numbers by commas.")
        if self.kind == "box" and not all(low <= high for low, high in zip(self.numbers[::2], self.numbers[1::2], strict=True)):
            raise InputError(
                "The box is empty: a lower limit exceeds its upper limit.", "Give each axis from the smaller to the larger value."
            )

    def mask(self, points_mm: FloatArray, progress: Progress = NoProgress()) -> BoolArray:  # noqa: B008 - stateless
        """Return which points to keep; raises RegistrationError as the filters do."""
        numbers = np.asarray(self.numbers)
        if self.kind == "box":
            return filters.in_box(points_mm, numbers[::2], numbers[1::2])
        if self.kind == "plane":
            return filters.above_plane(points_mm, numbers[:3], float(numbers[3]))
        if self.kind == "radius":
            return filters.radius_inliers(points_mm, float(numbers[0]), int(numbers[1]), progress)
        if self.kind == "statistical":
            return filters.statistical_inliers(points_mm, int(numbers[1]), float(numbers[0]), progress)
        return filters.in_large_components(points_mm, point_spacing_mm(points_mm), float(numbers[0]))


def apply_filters(
    points_mm: FloatArray, requested: Sequence[Filter], progress: Progress | None = None
) -> tuple[IntArray, dict[FilterKind, int]]:
    """Apply filters in order; return the indices of the points that pass all of them, and the number each kind removed.

    Raises
    ------
    InputError
        A filter leaves no point.
    """
    progress = progress or NoProgress()
    stays, removed = np.arange(len(points_mm)), dict[FilterKind, int]()
    for number, one in enumerate(requested):
        part = PartOf(progress, number / len(requested), (number + 1) / len(requested))
        part.report(0, 1, f"filter: {one.kind}")
        mask = one.mask(points_mm[stays], part)
        removed[one.kind] = removed.get(one.kind, 0) + int(np.count_nonzero(~mask))
        stays = stays[mask]
        if len(stays) == 0:
            raise InputError(f"The filter {one.kind!r} removes all points.", "Widen it. Nothing was changed.")
    progress.report(1, 1, "filtered")
    return stays, removed


@dataclass(frozen=True, slots=True, eq=False)
class FilterChain:
    """Filters applied in order to one cloud, with the number of filters each point passed, so that every step can be undone."""

    filters: tuple[Filter, ...]
    passed: IntArray  # (N,) uint8, of the points of the unfiltered cloud

    @classmethod
    def empty(cls, count: int) -> FilterChain:
        """Return the chain without filters on ``count`` points."""
        return cls((), np.zeros(count, np.uint8))

    @property
    def kept_mask(self) -> BoolArray:
        """Which points passed all filters, (N,)."""
        return np.asarray(self.passed >= len(self.filters))

    def append(self, wanted: Filter, points_mm: FloatArray, progress: Progress | None = None) -> FilterChain:
        """Return this chain with one more filter; ``points_mm`` (N, 3) is the unfiltered cloud.

        Raises
        ------
        InputError
            The filter removes all points, or there are 255 filters already.
        """
        if len(self.filters) == MOST_FILTERS:
            raise InputError(f"There are {MOST_FILTERS} filters already.", "Undo some, or apply fewer and stricter ones.")
        left = np.flatnonzero(self.kept_mask)
        stays, _ = apply_filters(points_mm[left], (wanted,), progress)
        passed = self.passed.copy()
        passed[left[stays]] += 1
        return FilterChain((*self.filters, wanted), passed)

    @classmethod
    def build(cls, filters: Sequence[Filter], points_mm: FloatArray, progress: Progress | None = None) -> FilterChain:
        """Apply these filters in order to a cloud; raises as `append`."""
        chain = cls.empty(len(points_mm))
        for number, wanted in enumerate(filters):
            part = None if progress is None else PartOf(progress, number / len(filters), (number + 1) / len(filters))
            chain = chain.append(wanted, points_mm, part)
        return chain

    def without_last(self) -> FilterChain:
        """Return this chain without its last filter."""
        left = self.filters[:-1]
        return FilterChain(left, np.minimum(self.passed, len(left)).astype(np.uint8))
