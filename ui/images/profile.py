"""Numbers along a line through an image."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

Pixel = tuple[int, int]  # row, column


@dataclass(frozen=True, eq=False)
class Profile:
    """The pixels of a line, and values of them by name."""

    rows: np.ndarray  # (N,) int
    columns: np.ndarray  # (N,) int
    distance_px: np.ndarray  # (N,), from the first end
    values: Mapping[str, np.ndarray]  # (N,) each, NaN where there is none

    def csv(self) -> str:
        """Return a table with a header, dot and comma; cells without value are empty."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["distance_px", "row", "column", *self.values])
        for place in range(len(self.rows)):
            numbers = [float(values[place]) for values in self.values.values()]
            writer.writerow(
                [
                    f"{self.distance_px[place]:.3f}",
                    int(self.rows[place]),
                    int(self.columns[place]),
                    *(f"{number:.7g}" if np.isfinite(number) else "" for number in numbers),
                ]
            )
        return text.getvalue()

    def save(self, path: Path) -> None:
        """Write the table to a file. Raises OSError, StorageError."""
        from measureapp.project.atomic import write_text

        write_text(path, self.csv())


def profile(ends: tuple[Pixel, Pixel], layers: Mapping[str, np.ndarray]) -> Profile:
    """Take the values of the pixels nearest to a line, one for every pixel along its longer side.

    Parameters
    ----------
    ends : two pixels (row, column) inside the layers
    layers : arrays (H, W) of one size, by name
    """
    (top, left), (bottom, right) = ends
    count = max(abs(bottom - top), abs(right - left)) + 1
    rows = np.rint(np.linspace(top, bottom, count)).astype(int)
    columns = np.rint(np.linspace(left, right, count)).astype(int)
    distance = np.hypot(rows - top, columns - left)
    return Profile(rows, columns, distance, {name: np.asarray(layer[rows, columns], float) for name, layer in layers.items()})
