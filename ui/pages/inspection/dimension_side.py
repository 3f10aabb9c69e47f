"""Side panel of the Inspection page: verdict, dimensions and features, decision rule, deviations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.program_rows import DimensionRow, letters_shown
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.inspection.alignment_panel import AlignmentPanel
from ui.pages.inspection.cell_edits import apply_edit
from ui.pages.inspection.contour_bar import ContourBar
from ui.pages.inspection.create_bar import CreateBar
from ui.pages.inspection.datum_menu import DatumMenu
from ui.pages.inspection.deviation_card import DeviationCard
from ui.pages.inspection.deviation_display import NOT_COMPARED, DeviationDisplay
from ui.pages.inspection.dimension_rows import Selection, decision_rule, features_of, rule_name
from ui.pages.inspection.dimension_table import DimensionTable
from ui.pages.inspection.feature_actions import FeatureActions
from ui.pages.inspection.feature_table import FeatureTable
from ui.pages.inspection.filter_bar import FilterBar
from ui.pages.inspection.no_alignment import NoAlignment
from ui.pages.inspection.other_versions import OtherVersions
from ui.pages.inspection.row_actions import RowActions
from ui.pages.inspection.save_bar import SaveBar
from ui.pages.inspection.tolerance_editor import ToleranceEditor
from ui.widgets.basic import column, label, row, scrolled
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.data.consistency import Consistency
    from measureapp.data.measurement import Inspection
    from ui.session import Comparison

TABLE_WIDTH, LEAST_LIST = 680, 108  # px; a list shows its heading and two rows
LISTS = {"dimensions": "Dimensions", "features": "Features", "alignment": "Alignment", "deviation": "Deviation"}


class DimensionSide(QWidget):
    """Shows an inspection, and holds its selected row."""

    selected = Signal()
    closerAsked = Signal()

    def __init__(self, look: Look, controllers: Controllers, display: DeviationDisplay) -> None:
        super().__init__()
        self._look, self._programming = look, controllers.programming
        programming = self._programming
        self._inspection: Inspection | None = None
        self.deviation = DeviationCard(look, display)
        self.list = Segments(LISTS, name="List")
        self.filter, self.save = FilterBar(look), SaveBar(look, programming)
        self.table = DimensionTable(look, self._edit)
        self.features = FeatureTable(look)
        self.create = CreateBar(look, controllers.creating, controllers.contouring, self.features)
        self._contouring, self.contour = controllers.contouring, ContourBar(look, controllers.contouring)
        self._contouring.changed.connect(self._show_create)
        self._contouring.created.connect(self.features.select_names)
        self.alignment = AlignmentPanel(look, programming, controllers.creating)
        self.tolerance = ToleranceEditor(look, controllers.tolerancing, controllers.creating)
        self.create.dimensionAdded.connect(self._await)
        self._awaited = ""  # name of the dimension that was added last
        self.actions, self.datums = RowActions(look, self.table, programming), DatumMenu(self.features, programming)
        self.feature_actions = FeatureActions(look, self.features, programming)
        self.table.frameAsked.connect(self._edit_frame)
        self.actions.toleranceAsked.connect(self._begin_frame)
        self.create.tolerance.clicked.connect(self._begin_frame)
        self.tolerance.closed.connect(self._end_frame)
        self.table.rowSelected.connect(self._tell)
        self.features.chosen.connect(self._tell)
        self.list.valueChanged.connect(self._show_list)
        self.filter.changed.connect(lambda: self.table.set_filter(self.filter.chips(), self.filter.words()))
        self.table.closerAsked.connect(self.closerAsked)
        self.features.doubleClicked.connect(self.closerAsked)
        self.rule, self.checks = label("", "small", wrap=True), label("", "small", wrap=True)
        self.checks.hide()
        self._lists = QStackedWidget()
        self._lists.addWidget(self.table)
        self._lists.addWidget(self.features)
        self._lists.addWidget(self.alignment)
        self._figures = scrolled(self.deviation)
        self._lists.addWidget(self._figures)
        self._lists.addWidget(self.tolerance)
        self._lists.setMinimumHeight(LEAST_LIST)  # rather than that of the highest of them: the bars below are not squeezed
        self._show_create()
        self.unaligned = NoAlignment(look, programming)
        self.versions = OtherVersions(look, programming)
        self.list.set_available("deviation", False, NOT_COMPARED)
        self.unaligned.choose.clicked.connect(lambda: self.list.setValue("alignment"))
        beside = column(
            self.checks,
            self.unaligned,
            self.versions,
            row(self.list, 0),
            self.filter,
            self._lists,
            self.create,
            self.contour,
            self.save,
            self.rule,
            spacing=8,
        )
        beside.setStretch(5, 1)
        self.setLayout(beside)

    @property
    def rows(self) -> Sequence[DimensionRow]:
        """The dimensions, in the order of the program."""
        return self.table.rows

    @property
    def selection(self) -> Selection:
        """Return dimension and features of the selected row, or the selected features."""
        if self._inspection is None:
            return Selection()
        known = {feature.name: feature for feature in self._inspection.features}
        if self.list.value() == "features":
            return Selection(None, tuple(known[name] for name in self.features.names() if name in known))
        chosen = self.table.current_row()
        if chosen is None or chosen.found is None:
            return Selection()
        features = [feature for _, feature in features_of(chosen.found, known) if feature is not None]
        return Selection(chosen.found, tuple(features))

    def show_inspection(self, inspection: Inspection | None) -> None:
        """Show these dimensions and features; None keeps the present ones behind the empty page."""
        self._inspection = inspection
        if inspection is None:
            return
        self.show_rows()
        self.alignment.show_inspection(inspection)
        self.unaligned.show_program()
        self.rule.setText(tr("Lengths in mm, U for k = 2, verdicts by {rule_name}.", rule_name=rule_name()))
        self.rule.setToolTip(translated(decision_rule()))

    def show_checks(self, consistency: Consistency) -> None:
        """Show below the verdict what the checks of the error model leave unexplained, with its likely cause; each check as a tip."""
        self.checks.setText(translated(consistency.sentence))
        self.checks.setToolTip(
            "\n".join(tr("{name:upper}: {sentence}", name=check.name, sentence=check.sentence) for check in consistency.checks)
        )
        self.checks.setVisible(consistency.worst is not None)

    @property
    def is_picking(self) -> bool:
        """Whether clicks select faces."""
        return any(one.pick.isChecked() for one in (self.create, self.alignment, self.tolerance))

    def end_picking(self) -> None:
        """Let clicks select points again."""
        for one in (self.create, self.alignment, self.tolerance):
            one.pick.setChecked(False)

    def show_rows(self) -> None:
        """Show the rows of the edited program; the worst is selected if none was."""
        if self._inspection is not None:
            state = self._programming.state
            letters = letters_shown(None if state is None else state.program, self._inspection)
            self.features.show_features(self._inspection.features, letters, () if state is None else state.program.features)
        rows = self._programming.rows()
        had_none = self.table.current_id() < 0
        self.table.set_rows(rows)
        self.filter.show_rows(rows)
        self.versions.show_rows(rows, self.table.dimensions.of_other_versions)
        added = next((row.id for row in rows if row.name == self._awaited), None)
        if added is not None:
            self._awaited = ""
            self.table.select(added)
        elif had_none:
            self.table.select_first()
        self._show_create()

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Show the deviations from the nominal, if there are any."""
        self.deviation.show_comparison(comparison)
        self.list.set_available("deviation", comparison is not None, NOT_COMPARED)
        if comparison is None and self.list.value() == "deviation":
            self.list.setValue("dimensions")

    def select_failing(self) -> None:
        """Select the worst dimension."""
        self.list.setValue("dimensions")
        self.table.sort_worst_first()
        self.table.select_first()

    def _edit(self, edit):  # type: ignore[no-untyped-def]
        return apply_edit(self._programming, self.table.rows, edit)

    def _show_list(self) -> None:
        shown = {"dimensions": self.table, "features": self.features, "alignment": self.alignment, "deviation": self._figures}
        self._lists.setCurrentWidget(shown[self.list.value()])
        self.filter.setVisible(self.list.value() == "dimensions")
        self.rule.setVisible(self.list.value() == "dimensions")
        self._show_create()
        self.selected.emit()

    def _begin_frame(self) -> None:
        """Choose a new tolerance, of the selected features or that of the current dimension."""
        row = self.table.current_row()
        names = (
            self.features.names() if self.list.value() == "features" else () if row is None or row.entry is None else row.entry.features[:1]
        )
        self.tolerance.begin(names)
        self._open_frame()

    def _edit_frame(self, name: str) -> None:
        if self._programming.can_change and self.tolerance.edit(name):
            self._open_frame()

    def _open_frame(self) -> None:
        """Show the editor in place of the list, until it is closed or another list is chosen."""
        self._lists.setCurrentIndex(self._lists.count() - 1)
        for one in (self.filter, self.rule):
            one.hide()
        self._show_create()
        self.tolerance.kind.setFocus()

    def _end_frame(self, name: str) -> None:
        if name:
            self._await(name)
        self._show_list()

    def _show_create(self) -> None:
        is_list = self._lists.currentIndex() < self._lists.count() - 1  # not the editor of a tolerance
        offered = is_list and self.list.value() == "features" and self._programming.state is not None
        if not offered:
            self._contouring.cancel()
        self.create.setVisible(offered and not self.contour.is_on)
        self.contour.setVisible(offered and self.contour.is_on)
        self.save.keep_away(self.contour.isVisibleTo(self))  # there is nothing to save before the feature is created
        if self.create.isHidden():
            self.create.pick.setChecked(False)
        if is_list:
            self.tolerance.pick.setChecked(False)
        if not is_list or self.list.value() != "alignment":
            self.alignment.pick.setChecked(False)

    def _await(self, name: str) -> None:
        """Select a new dimension in its table, also before it is measured."""
        self._awaited = name
        self.list.setValue("dimensions")
        self.show_rows()

    def _tell(self) -> None:
        self.selected.emit()
