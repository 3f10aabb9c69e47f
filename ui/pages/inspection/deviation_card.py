"""Deviations from the nominal in figures: histogram, key figures, extremes, what was not measured; and how they are displayed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QFrame

from ui.charts.deviation_histogram import DeviationHistogram
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import counted, millimetres, percent
from ui.pages.inspection.deviation_display import DeviationDisplay
from ui.viewport.overlay.legend import Legend
from ui.widgets.basic import Button, column, label, row
from ui.widgets.not_measured import NotMeasuredLegend
from ui.widgets.number_field import NumberField
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from ui.session import Comparison


TOLERANCE = "Symmetric tolerance band of the colours in mm; it does not affect verdicts"
CARRIERS = {"cad": "On the CAD model", "points": "On the points"}
STORE_TIP = "Store colours, range and tolerance band with the inspection program: they are used again here and in reports"
SMOOTH = "Smooth the colours"
SMOOTH_TIP = "Average the colours of neighbouring points; values, extremes and the histogram use every point as measured"


class DeviationCard(QFrame):
    """Figures of the deviations beside the picture; the legend is in the picture."""

    storeAsked = Signal()  # of the colour scale, with the inspection program

    def __init__(self, look: Look, display: DeviationDisplay) -> None:
        super().__init__()
        self.setObjectName("card")
        self._display = display
        self.histogram = DeviationHistogram(look)
        self.words, self.bands, self.extremes = (label("", "soft", wrap=True) for _ in range(3))
        self.unmeasured = NotMeasuredLegend(look)
        self.on = Segments(CARRIERS, name="Colours")
        self.on.valueChanged.connect(display.set_carrier)
        self.smooth = QCheckBox(translated(SMOOTH))
        self.smooth.setToolTip(translated(SMOOTH_TIP))
        self.smooth.setChecked(display.smooth)
        self.smooth.toggled.connect(display.set_smooth)
        self.tolerance = NumberField()
        self.tolerance.setRange(0.001, 100.0)
        self.tolerance.setDecimals(3)
        self.tolerance.setSingleStep(0.01)
        self.tolerance.setSuffix(" mm")
        self.tolerance.setFixedWidth(120)
        self.tolerance.setAccessibleName(translated(TOLERANCE))
        self.tolerance.setToolTip(translated(TOLERANCE))
        self.tolerance.valueChanged.connect(display.set_tolerance)
        self.store = Button("Store", look, "", "quiet", STORE_TIP)
        self.store.clicked.connect(self.storeAsked)
        band = row(label("Tolerance band ±", "soft"), self.tolerance, 0, self.store)
        self.setLayout(
            column(
                row(self.on, self.smooth, 0, spacing=16),
                band,
                self.words,
                self.bands,
                self.extremes,
                self.histogram,
                self.unmeasured,
                margin=16,
                spacing=8,
            )
        )
        display.changed.connect(self._show_display)
        self._comparison: Comparison | None = None
        self._can_store = False

    def allow_storing(self, allowed: bool) -> None:
        """Offer to store the scale, or not: a program must be open, and free to be changed."""
        self._can_store = allowed
        self._offer_storing()

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Show these deviations, or nothing."""
        self._comparison = comparison
        if comparison is None:
            return
        found, statistics = comparison.deviation, comparison.statistics
        mean, rms, p95 = (
            (found.mean_mm, found.rms_mm, found.p95_mm)
            if statistics is None
            else (statistics.mean_mm, statistics.rms_mm, statistics.p95_mm)
        )
        self.words.setText(
            tr(
                "Mean {mean}, rms {rms}; 95 % within {p95}.",
                mean=millimetres(mean, signed=True),
                rms=millimetres(rms),
                p95=millimetres(p95),
            )
        )
        self.unmeasured.say(
            tr("Not measured: {unmeasured_share} of the nominal's surface", unmeasured_share=percent(found.unmeasured_share))
        )
        if statistics is not None:
            self.extremes.setText(translated(_extremes(comparison)))
            missing = statistics.no_data
            self.unmeasured.say(
                tr(
                    "Not measured: {total} of the nominal's surface (not seen {not_seen}, filled {filled}, too far {too_far})",
                    total=percent(missing.total),
                    not_seen=percent(missing.not_seen),
                    filled=percent(missing.filled),
                    too_far=percent(missing.too_far),
                )
            )
        self._show_display()

    def _show_display(self) -> None:
        legend = self._display.legend
        if self._comparison is None or legend is None:
            return
        self.smooth.setEnabled(self._display.on == "points")
        self._show_legend(legend)
        self._offer_storing()
        inside, below, above = self._display.shares()
        self.bands.setText(
            tr(
                "{inside} within the tolerance band, {below} below, {above} above.",
                inside=percent(inside),
                below=percent(below),
                above=percent(above),
            )
        )

    def _offer_storing(self) -> None:
        shown = self._comparison is not None and self._display.legend is not None
        self.store.setEnabled(shown and self._can_store and not self._display.is_stored)

    def _show_legend(self, legend: Legend) -> None:
        assert self._comparison is not None
        self.histogram.show_values(self._comparison.deviation.distances_mm, legend)
        if legend.tolerance is not None:
            blocked = self.tolerance.blockSignals(True)
            self.tolerance.setValue(max(abs(limit) for limit in legend.tolerance))
            self.tolerance.blockSignals(blocked)


def _extremes(comparison: Comparison) -> str:
    statistics = comparison.statistics
    assert statistics is not None
    found = [
        tr(words, value=millimetres(one.value_mm, signed=True))
        for words, one in (("Minimum {value}", statistics.minimum), ("maximum {value}", statistics.maximum))
        if one is not None
    ]
    listed = ", ".join(found)
    words = tr("{listed}, each confirmed by its neighbours.", listed=listed) if found else tr("No extreme that its neighbours confirm.")
    lost = tr(
        " {lost} points lie farther than {search_mm} from the nominal.",
        lost=counted(statistics.lost),
        search_mm=millimetres(statistics.search_mm, 1),
    )
    return tr("{words}{lost}", words=words, lost=lost) if statistics.lost else words
