"""Series of parts: the table of dimensions, and the run chart of the chosen one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QComboBox, QDialog, QLineEdit, QWidget

from ui.charts.run_chart import Run, RunChart
from ui.controllers.series import ReadSeries, SeriesController
from ui.look.language.retranslating import GIVEN
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import with_hint
from ui.pages.series.rows import HEADERS, NUMERIC, rows_of, summary
from ui.session import Session
from ui.settings.dialogs import choose_folder
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.data_table import DataTable

if TYPE_CHECKING:
    from measureapp.errors import MeasureError

SMALLEST = (1120, 640)
CHART_HEIGHT = 210
PURPOSE = "Trend and capability of every dimension over all parts that were measured by one program."
NONE_YET = "No series yet. Operator mode files every part; a measurement that is open here is added by the button below."
REASON = "Reason, if this part was measured before"


class SeriesDialog(QDialog):
    """A program is chosen above; below are its dimensions and a run chart."""

    def __init__(self, look: Look, session: Session, series: SeriesController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Series of parts"))
        self.setMinimumSize(*SMALLEST)
        self._session, self._series = session, series
        self.found: ReadSeries | None = None
        self.programs = QComboBox()
        self.programs.setProperty(GIVEN, True)
        self.programs.setAccessibleName(tr("Program"))
        self.words = label(NONE_YET, "body", wrap=True)
        self.table = DataTable(look, list(HEADERS), numeric=NUMERIC, stretch=0)
        self.chart = RunChart(look)
        self.chart.setFixedHeight(CHART_HEIGHT)
        self.remark = label("", "soft", wrap=True)
        self.reason = QLineEdit()
        self.reason.setPlaceholderText(translated(REASON))
        self.file = Button("Add this measurement", look, "add", tip="Add the open measurement to the series of its program")
        self.save = Button("Save the report…", look, "export", tip="PDF with run charts, table (CSV) and JSON")
        self.close_button = Button("Close", look)
        self._lay_out()
        self.programs.textActivated.connect(series.choose)
        self.table.selectionModel().currentRowChanged.connect(lambda current, _former: self._show_chart(current.row()))
        self.file.clicked.connect(lambda: series.file(self.reason.text().strip()))
        self.save.clicked.connect(self._save)
        self.close_button.clicked.connect(self.close)
        series.listed.connect(self._show_programs)
        series.read.connect(self._show_series)
        series.refused.connect(self._show_refusal)
        session.busyChanged.connect(self._show_buttons)
        self._show_buttons()

    def _lay_out(self) -> None:
        chosen = row(label("Program", "field"), self.programs, 0, spacing=8)
        found = card(self.words, self.table, self.chart, self.remark, margin=16, spacing=12)
        found.layout().setStretch(1, 1)
        footer = row(self.close_button, 16, self.reason, self.file, 0, self.save)
        footer.setStretch(2, 1)
        layout = column(label("Series of parts", "title"), label(PURPOSE, "soft", wrap=True), chosen, found, footer, margin=16, spacing=12)
        layout.setStretch(3, 1)
        self.setLayout(layout)

    def begin(self) -> None:
        """Show the dialog and read which series there are."""
        self._series.find()
        self.show()
        self.raise_()

    @Slot(object)
    def _show_programs(self, programs: tuple[str, ...]) -> None:
        wanted = self.programs.currentText() if self.found is None else self.found.program
        self.programs.clear()
        self.programs.addItems(programs)
        self.programs.setEnabled(bool(programs))
        place = self.programs.findText(wanted, Qt.MatchFlag.MatchExactly)
        if place >= 0:
            self.programs.setCurrentIndex(place)
        if programs and (self.found is None or place < 0):
            self._series.choose(self.programs.currentText())

    @Slot(object)
    def _show_series(self, found: ReadSeries) -> None:
        self.found = found
        self.programs.setCurrentIndex(self.programs.findText(found.program, Qt.MatchFlag.MatchExactly))
        self.words.setText(translated(summary(found)))
        self.table.set_rows(rows_of(found.trends))
        self._show_chart(0)
        self._show_buttons()

    @Slot(object)
    def _show_refusal(self, error: MeasureError) -> None:
        self.words.setText(with_hint(error.message, error.hint))

    def _show_chart(self, place: int) -> None:
        known = self.found is not None and 0 <= place < len(self.found.trends)
        trend = self.found.trends[place] if self.found is not None and known else None
        self.chart.show_run(None if trend is None else Run(trend.name, trend.unit, trend.values, trend.limits, trend.mean))
        self.remark.setText("" if trend is None else f"{trend.name}: {trend.remark}" if trend.remark else translated(trend.name))

    def _show_buttons(self) -> None:
        busy = bool(self._session.busy_with)
        self.save.setEnabled(not busy and self.found is not None and bool(self.found.runs))
        self.file.setEnabled(not busy and self._session.inspection is not None and self._session.folder is not None)
        self.reason.setEnabled(self.file.isEnabled())

    def _save(self) -> None:
        folder = choose_folder(self, "Folder for the report of the series", "exports")
        if folder is not None and self.found is not None:
            self._series.write(self.found, folder)
