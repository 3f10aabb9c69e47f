"""Table of the views: visibility, registration figures and verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHeaderView

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import NOTHING, counted, millimetres
from ui.pages.clouds.view_words import REFUSED, view_verdict
from ui.widgets.data_table import Cell, DataTable, number, verdict_cell
from ui.widgets.empty_rows import EmptyRows

if TYPE_CHECKING:
    from measureapp.data.cloud import ViewPlacement
    from measureapp.data.measurement import ViewResult

HEADERS = ["", "View", "Points", "Correction", "Residual", "Verdict"]
EYE_COLUMN, POINTS_COLUMN, CORRECTION_COLUMN, EYE_WIDTH = 0, 2, 3, 40
TABLE_WIDTH, NARROW = 512, 440


class ViewTable(DataTable):
    """Shows views, and holds the set of hidden ones."""

    hiddenChanged = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__(look, HEADERS, numeric=(2, 3, 4), stretch=5)
        self._look = look
        self._views: Sequence[ViewResult] = ()
        self.hidden: set[str] = set()
        self.setAccessibleName(tr("Views"))
        self.setAccessibleDescription(tr("The space bar shows or hides the selected view."))
        self.horizontalHeader().setSectionResizeMode(EYE_COLUMN, QHeaderView.ResizeMode.Fixed)
        self.setColumnWidth(EYE_COLUMN, EYE_WIDTH)
        self.cellClicked.connect(self._toggle)
        EmptyRows(self, "No views yet. Each viewpoint is listed here once it has been scanned and processed.")

    def show_views(self, views: Sequence[ViewResult], placements: Mapping[str, ViewPlacement]) -> None:
        """Show these views with their placements, as far as registered."""
        self._views = views
        self.set_rows([self._cells(index, view, placements.get(view.viewpoint_id)) for index, view in enumerate(views)])

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Hide the number of points in a narrow table, in a very narrow one the correction, too; the properties show them."""
        super().resizeEvent(event)
        self.setColumnHidden(POINTS_COLUMN, self.width() < TABLE_WIDTH)
        self.setColumnHidden(CORRECTION_COLUMN, self.width() < NARROW)

    def _cells(self, index: int, view: ViewResult, placement: ViewPlacement | None) -> list[Cell]:
        verdict, words, why = view_verdict(view, placement)
        was_placed = placement is not None and not placement.verdict.startswith(REFUSED)
        return [
            Cell("", sign="hidden" if view.viewpoint_id in self.hidden else "eye", tip="Show or hide this view"),
            Cell(view.viewpoint_id, sign=self._look.theme.view(index).name(), bold=True),
            number(counted(len(view.cloud))),
            number(millimetres(placement.correction_mm) if placement is not None and was_placed else NOTHING),
            number(millimetres(placement.residual_mm) if placement is not None and was_placed else NOTHING),
            verdict_cell(verdict, words, why),
        ]

    def _toggle(self, place: int, place_column: int) -> None:
        if place_column == EYE_COLUMN:
            self.hidden.symmetric_difference_update({self._views[place].viewpoint_id})
            self.hiddenChanged.emit()
