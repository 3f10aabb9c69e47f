"""Side panel of the Inspection page: verdict, dimensions, decision rule, deviations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent, QShortcut
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.pages.inspection.deviation_card import DeviationCard
from ui.pages.inspection.dimension_rows import Selection, branches_of, decision_rule, find_selection, rule_name
from ui.widgets.basic import column, label, row
from ui.widgets.data_tree import DataTree
from ui.widgets.verdict_banner import VerdictBanner

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.measurement import Inspection
    from ui.session import Comparison

HEADERS = ["Dimension", "Nominal", "Measured", "Deviation", "U", "Verdict"]
VERDICTS = ("pass", "fail", "not proven", "not measured")
UNLIMITED = 16_777_215  # Qt's largest height of a widget
TABLE_WIDTH, DEVIATION_HEIGHT = 584, 400
SHARES = (0, 0, 1000, 0, 500, 1)  # stretch factors: space is left empty only if table and histogram are at full size


class DimensionSide(QWidget):
    """Shows an inspection, and holds its selected row."""

    rowSelected = Signal(int, int)  # row, leaf below it; -1: the row itself
    closerAsked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._inspection: Inspection | None = None
        self._is_compared = False
        self.banner, self.deviation = VerdictBanner(look), DeviationCard(look)
        self.deviation.setMaximumHeight(DEVIATION_HEIGHT)
        self.summary = {verdict: label("", "strong") for verdict in VERDICTS}
        self.counts = QWidget()
        self.counts.setLayout(row(*self.summary.values(), 0, spacing=16))
        self.table = DataTree(look, HEADERS, numeric=(1, 2, 3, 4), stretch=0)
        self.table.setAccessibleName("Dimensions")
        self.table.setAccessibleDescription("The right arrow expands a row, Enter zooms to its features.")
        QShortcut(Qt.Key.Key_Return, self.table, self.closerAsked, context=Qt.ShortcutContext.WidgetShortcut)
        self.table.rowSelected.connect(self.rowSelected)
        self.table.heightChanged.connect(self._share_height)
        self.table.setExpandsOnDoubleClick(False)
        self.table.doubleClicked.connect(self.closerAsked)
        self.rule = label("", "small", wrap=True)
        beside = column(self.banner, self.counts, self.table, self.rule, self.deviation, 0, spacing=12)
        for place, share in enumerate(SHARES):
            beside.setStretch(place, share)
        self.setLayout(beside)

    @property
    def dimensions(self) -> Sequence[Dimension]:
        """Return the dimensions shown."""
        return () if self._inspection is None else self._inspection.dimensions

    @property
    def selection(self) -> Selection:
        """Return dimension and features of the selected row or leaf."""
        return find_selection(self._inspection, *self.table.selected())

    def show_inspection(self, inspection: Inspection | None) -> None:
        """Show these dimensions; None keeps the present ones behind the empty page."""
        self._inspection = inspection
        if inspection is None:
            return
        for name, shown in self.summary.items():
            count = sum(found.verdict == name for found in inspection.dimensions)
            shown.setText(f"{count} {name}")
            shown.setStyleSheet(f"color: {self._look.theme.verdict(name).name()}")
            shown.setVisible(count > 0)
        self.rule.setText(f"Lengths in mm, U for k = 2, verdicts by {rule_name()}.")
        self.rule.setToolTip(decision_rule())
        self.table.set_branches(branches_of(inspection.dimensions, inspection.features))
        self.banner.show_verdicts([found.verdict for found in inspection.dimensions])
        self._share_height()

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Show the deviations from the nominal, or use their space for the table."""
        self._is_compared = comparison is not None
        self.deviation.show_comparison(comparison)
        self._share_height()

    def show_role(self, *, is_operator: bool) -> None:
        """Show operators one large verdict, engineers the number of each."""
        self.banner.setVisible(is_operator and bool(self.dimensions))
        self.counts.setVisible(not is_operator)

    def select_failing(self) -> None:
        """Select the first dimension that does not pass."""
        failing = [place for place, found in enumerate(self.dimensions) if found.verdict != "pass"]
        self.table.select(failing[0] if failing else 0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Hide the nominal values in a narrow table; the properties show them."""
        super().resizeEvent(event)
        self.table.setColumnHidden(HEADERS.index("Nominal"), self.width() < TABLE_WIDTH)

    def _share_height(self) -> None:
        """Give the histogram the height that the table does not need."""
        self.table.setMaximumHeight(self.table.fitted_height() if self._is_compared else UNLIMITED)
