"""Colour scales of the clouds: one per colouring, with the edits of the user and their undo."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING

from ui.pages.layers import ColourBy, scale_end, scale_legend, sigma_sample

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
    from ui.viewport.overlay.legend import Legend

KEPT_STEPS = 50


class Scales:
    """Holds the edited legends by quantity; others follow the data."""

    def __init__(self) -> None:
        self._edited: dict[str, Legend] = {}
        self._former: list[tuple[str, Legend | None]] = []

    @property
    def can_undo(self) -> bool:
        """Whether an edit can be undone."""
        return bool(self._former)

    def get(
        self, colour_by: ColourBy, clouds: Collection[PointCloud], placements: Collection[ViewPlacement], *, merged: StitchedCloud | None
    ) -> Legend | None:
        """Return the legend of a colouring, with the range that the user gave it; None where there is no scale.

        The range is that of the views, the same in all stages; the histogram is of what is shown: ``merged``, else the views.
        """
        end = scale_end(colour_by, clouds, placements) if colour_by in {"sigma", "residual"} else 1.0
        legend = scale_legend(colour_by, end, sigma_sample(clouds if merged is None else [merged]), merged=merged is not None)
        if legend is not None and legend.quantity in self._edited:
            legend = replace(self._edited[legend.quantity], histogram=legend.histogram, usual=legend.usual)
        return legend

    def edit(self, legend: Legend) -> None:
        """Keep an edited legend."""
        self._former.append((legend.quantity, self._edited.get(legend.quantity)))
        del self._former[:-KEPT_STEPS]
        self._edited[legend.quantity] = legend

    def undo(self) -> None:
        """Undo the last edit."""
        quantity, former = self._former.pop()
        if former is None:
            self._edited.pop(quantity, None)
        else:
            self._edited[quantity] = former
