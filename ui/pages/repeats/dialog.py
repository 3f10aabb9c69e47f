"""Repeated measurements of one part: chosen or made, compared, reported."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QCheckBox, QDialog, QListWidget, QListWidgetItem, QSpinBox, QWidget

from ui.controllers.repeats import RepeatsController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import several, with_hint
from ui.pages.repeats.rows import HEADERS, NUMERIC, rows_of
from ui.session import Session
from ui.settings.dialogs import choose_folder
from ui.widgets.basic import Button, Form, card, column, label, row
from ui.widgets.data_table import DataTable

if TYPE_CHECKING:
    from measureapp.data.repeats import RepeatStudy
    from measureapp.errors import MeasureError

SMALLEST = (1240, 640)
SIDE_WIDTH = 320
MOST = 50
PURPOSE = (
    "Mean, spread and deviation of every dimension over several measurements of one part, "
    "and whether the stated uncertainty explains the spread."
)
ASK = "Add at least two projects with dimensions of the same inspection program."
CLAMP = "Clamp the part again, then continue with measurement {number} of {count}."
RUNS = "Measurement {number} of {count} is running."
AGAIN = "Every measurement becomes a project beside the open one."


class RepeatsDialog(QDialog):
    """Projects on the left, table and conclusions on the right."""

    def __init__(self, look: Look, session: Session, repeats: RepeatsController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Repeated measurements"))
        self.setMinimumSize(*SMALLEST)
        self._session, self._repeats = session, repeats
        self.study: RepeatStudy | None = None
        self.projects = QListWidget()
        self.projects.setAccessibleName(tr("Projects"))
        self.add = Button("Add…", look, "add", tip="Add the project of one measurement")
        self.remove = Button("Remove", look, "remove", "quiet", "Take the chosen project from the list; nothing is deleted")
        self.one_part = QCheckBox(tr("One part under several names"))
        self.count = QSpinBox()
        self.count.setRange(1, MOST)
        self.count.setValue(2)
        self.count.lineEdit().setTextMargins(6, 0, 0, 0)
        self.reclamp = QCheckBox(tr("Clamp again before each"))
        self.again = Button("Measure again", look, "again", tip=AGAIN)
        self.go_on = Button("Continue", look, "run", "primary", "The part is clamped; begin the measurement")
        self.end = Button("End", look, "", "quiet", "Measure no further; what was measured is kept")
        self.series = label(AGAIN, "soft", wrap=True)
        self.table = DataTable(look, list(HEADERS), numeric=NUMERIC, stretch=0)
        self.words = label(ASK, "body", wrap=True)
        self.compare = Button("Compare", look, "inspection", "primary")
        self.save = Button("Save the report…", look, "export", tip="PDF, table (CSV) and JSON")
        self.close_button = Button("Close", look)
        self._lay_out()
        self._connect()
        self._show()

    def _lay_out(self) -> None:
        form = Form()
        form.add("Measurements", self.count)
        chosen = card(label("Measurements of one part", "heading"), self.projects, row(self.add, self.remove, 0), self.one_part, margin=16)
        chosen.layout().setStretch(1, 1)
        made = card(
            label("Measure again", "heading"),
            form,
            self.reclamp,
            self.series,
            row(0, self.end, self.again, self.go_on),
            margin=16,
            spacing=8,
        )
        side = QWidget()
        side.setFixedWidth(SIDE_WIDTH)
        side.setLayout(column(chosen, made, spacing=12))
        found = card(self.table, self.words, margin=16, spacing=12)
        found.layout().setStretch(0, 1)
        middle = row(side, found, spacing=12)
        middle.setStretch(1, 1)
        footer = row(self.close_button, 0, self.save, self.compare)
        layout = column(label("Repeated measurements", "title"), label(PURPOSE, "soft", wrap=True), middle, footer, margin=16, spacing=12)
        layout.setStretch(2, 1)
        self.setLayout(layout)

    def _connect(self) -> None:
        repeats = self._repeats
        self.add.clicked.connect(self._choose)
        self.remove.clicked.connect(self._take_away)
        self.projects.itemSelectionChanged.connect(self._show)
        self.compare.clicked.connect(self._compare)
        self.save.clicked.connect(self._save)
        self.close_button.clicked.connect(self.close)
        self.again.clicked.connect(lambda: repeats.measure_again(self.count.value(), reclamp=self.reclamp.isChecked()))
        self.go_on.clicked.connect(repeats.clamped)
        self.end.clicked.connect(repeats.stop)
        repeats.compared.connect(self._show_study)
        repeats.refused.connect(self._show_refusal)
        repeats.measured.connect(self.add_project)
        repeats.changed.connect(self._show)
        self._session.busyChanged.connect(self._show)

    def begin(self) -> None:
        """Show the dialog, with the open project as the first measurement."""
        source = self._repeats.source
        if source is not None and not self.folders():
            self.add_project(source)
        self._show()
        self.show()
        self.raise_()

    def folders(self) -> tuple[Path, ...]:
        """Return the chosen projects."""
        return tuple(Path(self.projects.item(place).toolTip()) for place in range(self.projects.count()))

    @Slot(object)
    def add_project(self, folder: Path) -> None:
        """Add a project to the list."""
        if folder not in self.folders():
            item = QListWidgetItem(folder.name)
            item.setToolTip(str(folder))
            self.projects.addItem(item)
        self._show()

    def _choose(self) -> None:
        known = self.folders()
        chosen = choose_folder(self, "Add the project of one measurement", "projects", known[-1].parent if known else None)
        if chosen is not None:
            self.add_project(chosen)

    def _take_away(self) -> None:
        for item in self.projects.selectedItems():
            self.projects.takeItem(self.projects.row(item))
        self._show()

    def _compare(self) -> None:
        self._repeats.compare(self.folders(), self.one_part.isChecked())

    def _save(self) -> None:
        if self.study is None:
            return
        chosen = choose_folder(self, "Folder for the report of repeats", "exports")
        if chosen is not None:
            self._repeats.write(self.study, chosen)

    @Slot(object)
    def _show_study(self, study: RepeatStudy) -> None:
        self.study = study
        self.table.set_rows(rows_of(study))
        self.words.setText(
            tr(
                "{count} by the program {program}. {list}",
                count=several(len(study.measurements), "measurement"),
                program=study.program,
                list=" ".join(study.sentences),
            )
        )
        self._show()

    @Slot(object)
    def _show_refusal(self, error: MeasureError) -> None:
        self.study = None
        self.table.set_rows([])
        self.words.setText(with_hint(error.message, error.hint))
        self._show()

    @Slot()
    def _show(self) -> None:
        busy, series = bool(self._session.busy_with), self._repeats.series
        waits = self._repeats.is_waiting
        self.remove.setEnabled(bool(self.projects.selectedItems()))
        self.compare.setEnabled(not busy and len(self.folders()) > 1)
        self.compare.setToolTip(tr("Evaluate mean and spread") if len(self.folders()) > 1 else translated(ASK))
        self.save.setEnabled(not busy and self.study is not None)
        can = self._repeats.source is not None and series is None and not busy
        self.again.setVisible(series is None)
        self.again.setEnabled(can)
        self.go_on.setVisible(waits)
        self.end.setVisible(waits)
        for editor in (self.count, self.reclamp):
            editor.setEnabled(can)
        if series is None:
            self.series.setText(
                translated(AGAIN)
                if self._repeats.source is not None
                else tr("Open a calibrated project with a plan to measure its part again.")
            )
        else:
            self.series.setText(tr(CLAMP if waits else RUNS, number=series.number, count=series.count))
