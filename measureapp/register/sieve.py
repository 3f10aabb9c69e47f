"""Filters as values: what to keep of a cloud, one after the other, each saying how many points it removed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import InputError
from measureapp.progress import NoProgress, Progress
from measureapp.register import filters
from measureapp.register.cloud_quality import point_spacing_mm

FilterKind = Literal["box", "plane", "radius", "statistical", "islands"]
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

    def keeps(self, points_mm: FloatArray) -> BoolArray:
        """Return which points stay; raises RegistrationError as the filters do."""
        numbers = np.asarray(self.numbers)
        if self.kind == "box":
            return filters.in_box(points_mm, numbers[::2], numbers[1::2])
        if self.kind == "plane":
            return filters.above_plane(points_mm, numbers[:3], float(numbers[3]))
        if self.kind == "radius":
            return filters.crowded(points_mm, float(numbers[0]), int(numbers[1]))
        if self.kind == "statistical":
            return filters.statistical(points_mm, int(numbers[1]), float(numbers[0]))
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
        progress.report(number, len(asked), f"filter: {one.kind}")
        mask = one.keeps(points_mm[stays])
        removed[one.kind] = removed.get(one.kind, 0) + int(np.count_nonzero(~mask))
        stays = stays[mask]
        if len(stays) == 0:
            raise InputError(f"No point is left after the filter {one.kind!r}.", "Widen it; nothing was written.")
    progress.report(1, 1, "filtered")
    return stays, removed
