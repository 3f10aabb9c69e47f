"""How deviations are displayed: the legend in the picture, on the CAD model or the points, smoothed for the eye or not."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from measureapp.inspection.surface.colour_scale import ColourScale
from ui.look.language.words import tr
from ui.look.wording import millimetres
from ui.viewport.overlay.legend import Fractions, Histogram, Legend

if TYPE_CHECKING:
    from measureapp.data.deviation_scale import DeviationScale
    from ui.session import Comparison

QUANTITY = "Surface deviation"
NOT_COMPARED = "Available when the points have been compared with the nominal (CAD)."
Carrier = Literal["cad", "points"]


class DeviationDisplay(QObject):
    """Holds the legend and the choices of the display; what the user set stays when the part is compared again."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.legend: Legend | None = None
        self.on: Carrier = "cad"
        self.smooth = True
        self._chosen: Legend | None = None  # as the user set it
        self._read: DeviationScale | None = None  # of the inspection program
        self._comparison: Comparison | None = None

    @property
    def tolerance_mm(self) -> tuple[float, float]:
        """The tolerance band of the legend."""
        return (0.0, 0.0) if self.legend is None or self.legend.tolerance is None else self.legend.tolerance

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Use these deviations."""
        self._comparison = comparison
        if comparison is not None:
            self._read = comparison.scale
        self.legend = None if comparison is None else self._complete(self._chosen or usual_legend(comparison))
        self.changed.emit()

    @property
    def _stored(self) -> DeviationScale:
        from measureapp.data.deviation_scale import DeviationScale  # brings pydantic, for which the window does not wait

        return self._read or DeviationScale()

    @property
    def is_stored(self) -> bool:
        """Whether the legend is the one that the inspection program holds."""
        return self._chosen is None or self.scale == self._stored

    @property
    def scale(self) -> DeviationScale:
        """The colour scale as an inspection program stores it."""
        if self._chosen is None:
            return self._stored
        from measureapp.data.deviation_scale import DeviationScale

        one = self._chosen
        return DeviationScale(
            tolerance_mm=one.tolerance or self._stored.tolerance_mm,
            range_mm=(one.low, one.high),
            ramp="blue-white-red" if one.ramp == "growing" else one.ramp,
            steps=one.steps,
            go_no_go=one.go_no_go,
            swapped=one.swapped,
        )

    def take_stored(self, scale: DeviationScale) -> None:
        """Use the scale that the inspection program holds now, after it was stored, undone or read anew."""
        if scale == self._stored:
            return
        self._read, self._chosen = scale, None
        if self._comparison is not None:
            self._comparison = replace(self._comparison, scale=scale)
            self.legend = self._complete(usual_legend(self._comparison))
        self.changed.emit()

    def forget(self) -> None:
        """Return to the default display, for another project."""
        self._chosen = None

    @Slot(object)
    def take_legend(self, legend: Legend) -> None:
        """Use the legend as edited in the picture."""
        self._chosen = legend
        self.legend = self._complete(legend)
        self.changed.emit()

    def set_tolerance(self, half_mm: float) -> None:
        """Use a symmetrical tolerance band."""
        if self.legend is not None:
            self.take_legend(self.legend.with_tolerance(-half_mm, half_mm))

    def set_carrier(self, on: Carrier) -> None:
        """Colour the CAD model or the points."""
        self.on = on
        self._renew()

    def set_smooth(self, smooth: bool) -> None:
        """Smooth the colours of the points, or show each deviation as measured."""
        self.smooth = smooth
        self._renew()

    def shares(self) -> tuple[float, float, float]:
        """Return the shares of the points inside, below and above the tolerance band."""
        if self._comparison is None or self.legend is None or self.legend.tolerance is None:
            return 0.0, 0.0, 0.0
        return _shares(self._comparison, self.legend.tolerance)

    def _renew(self) -> None:
        if self.legend is not None:
            self.legend = self._complete(self.legend)
        self.changed.emit()

    def _complete(self, legend: Legend) -> Legend:
        comparison = self._comparison
        if comparison is None:
            return legend
        statistics = comparison.statistics
        missing = comparison.deviation.unmeasured_share if statistics is None else statistics.no_data.total
        fractions = Fractions(*_shares(comparison, legend.tolerance or (legend.low, legend.high)), missing)
        return replace(legend, fractions=fractions, note=self._note(comparison))

    def _note(self, comparison: Comparison) -> str:
        """State what the colours are: means on the CAD model, smoothed or single deviations."""
        if self.on == "cad" and comparison.map is not None:
            return "Mean of the points nearby"
        if self.smooth and comparison.smoothed is not None:
            return tr("Smoothed, radius {radius_mm}", radius_mm=millimetres(comparison.smoothed.radius_mm, 1))
        return "Each point"


def usual_legend(comparison: Comparison) -> Legend:
    """Return the legend of the inspection program's scale; where that leaves the range open, it covers the band and nearly all points."""
    from measureapp.inspection.surface.statistics import default_range_mm

    distances, stored = _within(comparison), comparison.scale
    high = default_range_mm(distances, stored.tolerance_mm)
    scale = ColourScale.of(stored, (-high, high))
    return Legend(
        QUANTITY,
        scale.low,
        scale.high,
        ramp=scale.ramp,
        steps=scale.steps,
        tolerance=scale.tolerance,
        go_no_go=scale.go_no_go,
        swapped=scale.swapped,
        histogram=Histogram.of(distances),
        usual=(scale.low, scale.high),
    )


def _within(comparison: Comparison) -> np.ndarray:
    distances = comparison.deviation.distances_mm
    return distances if comparison.statistics is None else distances[np.abs(distances) <= comparison.statistics.search_mm]


def _shares(comparison: Comparison, limits_mm: tuple[float, float]) -> tuple[float, float, float]:
    """Return the shares of points inside, below and above limits, counted as the core counts them."""
    statistics = comparison.statistics
    if statistics is not None and statistics.tolerance_mm == limits_mm:
        return statistics.inside, statistics.below, statistics.above
    distances = _within(comparison)
    count = max(len(distances), 1)
    below, above = (int(np.count_nonzero(side)) / count for side in (distances < limits_mm[0], distances > limits_mm[1]))
    return max(0.0, 1.0 - below - above), below, above
