"""Table model of the dimensions: immutable rows, of which names, nominals and tolerances are edited in place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QObject, Qt
from PySide6.QtGui import QFont, QPalette

from measureapp import __version__
from measureapp.data.datum_letters import common_datums
from measureapp.data.dimension import of_other_versions
from ui.controllers.program_rows import STATUS_WORDS, DimensionRow
from ui.look.language.words import tr, translated
from ui.look.wording import NOTHING, dimension_words, quantity, sentence_case
from ui.pages.inspection.dimension_rows import datum_words, tolerance
from ui.widgets.data_table import SIGN_ROLE, VERDICT_WORDS, Index

ROW_ROLE = Qt.ItemDataRole.UserRole + 1  # the DimensionRow
SORT_ROLE = Qt.ItemDataRole.UserRole + 2  # what a column is sorted by
STATUS_ROLE = Qt.ItemDataRole.UserRole + 3
FRAME_ROLE = Qt.ItemDataRole.UserRole + 4  # the feature control frame that is drawn in place of the text
DIGITS = 3
OTHER_VERSION = "*"  # behind U of a row that another version evaluated than the rest; the notice above the lists explains it
WORST_FIRST = ("fail", "not proven", "not measured", "", "pass", "no tolerance")


class Column(IntEnum):
    """Columns, from the left."""

    STATUS = 0
    NAME = 1
    NOMINAL = 2
    TOLERANCE = 3
    MEASURED = 4
    DEVIATION = 5
    UNCERTAINTY = 6
    VERDICT = 7
    ALIGNMENT = 8


HEADERS = {
    Column.STATUS: "",
    Column.NAME: "Dimension",
    Column.NOMINAL: "Nominal",
    Column.TOLERANCE: "Tolerance",
    Column.MEASURED: "Measured",
    Column.DEVIATION: "Deviation",
    Column.UNCERTAINTY: "U",
    Column.VERDICT: "Verdict",
    Column.ALIGNMENT: "Alignment",
}
HEADER_TIPS = {
    Column.STATUS: "Status: current, being measured, stale, or not measurable",
    Column.NOMINAL: "Nominal, in italics where it is that of the CAD model",
    Column.TOLERANCE: "Limits as deviations from the nominal. Type ±0.1, +0.1/-0.05, max 0.05, H7 or 2768-m.",
    Column.MEASURED: "Measured value, in mm unless a unit is given",
    Column.DEVIATION: "Measured minus nominal",
    Column.UNCERTAINTY: "Expanded uncertainty (k = 2)",
    Column.ALIGNMENT: "Alignment of the part that the value refers to",
}
NUMERIC = frozenset({Column.NOMINAL, Column.TOLERANCE, Column.MEASURED, Column.DEVIATION, Column.UNCERTAINTY})
RESULTS = (Column.MEASURED, Column.DEVIATION, Column.UNCERTAINTY)
RENEWED = {"calculating": "Measuring…", "stale": "Stale"}  # in place of a verdict that no longer holds
EDITABLE = (Column.NAME, Column.NOMINAL, Column.TOLERANCE)
COPIED = tuple(column for column in Column if column is not Column.STATUS)


@dataclass(frozen=True)
class CellEdit:
    """What was typed into a cell, and for which rows."""

    ids: tuple[int, ...]
    column: Column
    text: str


def cell_text(row: DimensionRow, column: Column) -> str:
    """Return what a cell shows."""
    unit, found = row.unit, row.found
    printed = "" if unit == "mm" else unit
    if column is Column.NAME:
        return dimension_words(row.name)
    if column is Column.NOMINAL:
        return quantity(row.nominal, printed, DIGITS)
    if column is Column.TOLERANCE:
        return _tolerance_text(row, printed)
    if column is Column.ALIGNMENT:
        return sentence_case(row.aligned_by) or NOTHING
    if column is Column.VERDICT and row.is_outdated and (found is not None or row.status == "calculating"):
        return RENEWED[row.status]
    if found is None:
        return "" if column is Column.STATUS else NOTHING
    values = {
        Column.MEASURED: quantity(found.measured, printed, DIGITS),
        Column.DEVIATION: quantity(found.deviation, printed, DIGITS, signed=True),
        Column.UNCERTAINTY: quantity(found.round_uncertainty(DIGITS), printed, DIGITS),
        Column.VERDICT: VERDICT_WORDS.get(row.verdict, row.verdict),
    }
    return values.get(column, "")


def edit_text(row: DimensionRow, column: Column) -> str:
    """Return what the editor of a cell starts with."""
    if column is Column.NAME:
        return row.name
    if column is Column.NOMINAL:
        return f"{row.nominal:g}"
    if row.entry is not None and row.entry.tolerance is not None:
        return row.entry.tolerance
    limits = row.limits if row.entry is None else row.entry.limits
    if limits is None:
        return ""
    lower, upper = limits
    if row.is_zone:
        return f"max {upper:g}"
    return f"±{upper:g}" if -lower == upper else f"{upper:+g}/{lower:+g}"


def _tolerance_text(row: DimensionRow, unit: str) -> str:
    if row.limits is None:
        return NOTHING
    words = tolerance(*row.limits, unit)
    return f"{words} {row.source}" if row.source else words


def sort_key(row: DimensionRow, column: Column) -> Any:
    """Return what a column is sorted by."""
    found = row.found
    if column is Column.NAME:
        return row.name.casefold()
    if column is Column.NOMINAL:
        return row.nominal
    if column is Column.TOLERANCE:
        return float("-inf") if row.limits is None else row.limits[1] - row.limits[0]
    if column is Column.VERDICT:
        return rank(row)
    if column is Column.ALIGNMENT:
        return row.aligned_by.casefold()
    if column is Column.STATUS:
        return list(STATUS_WORDS).index(row.status)
    value = None if found is None else {4: found.measured, 5: found.deviation, 6: found.uncertainty}[int(column)]
    return float("-inf") if value is None else value


def rank(row: DimensionRow) -> tuple[int, float]:
    """Return the place of a row in the order of the worst first: the verdict, then the share of its tolerance."""
    found, share = row.found, 0.0
    if found is not None and found.deviation is not None and row.limits is not None:
        lower, upper = row.limits
        limit = upper if found.deviation >= 0 else lower
        share = abs(found.deviation) / max(abs(limit), 1e-9)
    return WORST_FIRST.index(row.verdict if row.verdict in WORST_FIRST else ""), -share


class DimensionModel(QAbstractTableModel):
    """Shows rows and passes edits on; the rows change only when they are set."""

    def __init__(self, edit: Callable[[CellEdit], bool], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._edit = edit
        self.rows: tuple[DimensionRow, ...] = ()
        self.of_other_versions = frozenset[int]()  # numbers of the rows that another version evaluated than the rest

    def set_rows(self, rows: Sequence[DimensionRow]) -> bool:
        """Show these rows; return whether rows came, went or moved, which resets the view."""
        now, marked = tuple(rows), self.of_other_versions
        others = of_other_versions((row.found for row in now if row.found is not None), __version__)
        self.of_other_versions = frozenset(row.id for row in now if any(row.found is one for one in others))
        if [row.id for row in now] == [row.id for row in self.rows]:
            before, self.rows = self.rows, now
            for place, (old, new) in enumerate(zip(before, now, strict=True)):
                self._tell_changes(place, old, new)
            if marked != self.of_other_versions and now:
                self.dataChanged.emit(self.index(0, Column.UNCERTAINTY), self.index(len(now) - 1, Column.UNCERTAINTY))
            return False
        self.beginResetModel()
        self.rows = now
        self.endResetModel()
        return True

    def _tell_changes(self, place: int, old: DimensionRow, new: DimensionRow) -> None:
        touched = [
            column
            for column in Column
            if cell_text(old, column) != cell_text(new, column)
            or (column is Column.STATUS and old.status != new.status)
            or (column is Column.VERDICT and old.verdict != new.verdict)
            or (column is Column.NOMINAL and old.is_linked != new.is_linked)
            or (column is Column.TOLERANCE and old.frame != new.frame)
        ]
        if touched:
            self.dataChanged.emit(self.index(place, min(touched)), self.index(place, max(touched)))

    def shown_text(self, row: DimensionRow, column: Column) -> str:
        """Return what a cell shows, in the language of the window and with its marks."""
        return translated(cell_text(row, column)) + (OTHER_VERSION if self._is_marked(row, column) else "")

    def _is_marked(self, row: DimensionRow, column: Column) -> bool:
        return column is Column.UNCERTAINTY and row.id in self.of_other_versions

    def _version_tip(self, row: DimensionRow) -> str:
        known = "" if row.found is None else row.found.version
        words = (
            tr("Evaluated by version {version} of MeasureApp", version=known)
            if known
            else tr("Evaluated by an earlier version of MeasureApp")
        )
        return "\n".join(filter(None, (words, translated(_tip(row, Column.UNCERTAINTY)))))

    def place_of(self, row_id: int) -> int:
        """Return the place of a row by its number; -1: there is none."""
        return next((place for place, row in enumerate(self.rows) if row.id == row_id), -1)

    def rowCount(self, parent: Index | None = None) -> int:
        """Return the number of rows."""
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, _parent: Index | None = None) -> int:
        """Return the number of columns."""
        return len(Column)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the heading of a column."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        column = Column(section)
        if role == Qt.ItemDataRole.DisplayRole:
            return translated(HEADERS[column])
        if role == Qt.ItemDataRole.ToolTipRole:
            return translated(HEADER_TIPS.get(column, ""))
        return _alignment(column) if role == Qt.ItemDataRole.TextAlignmentRole else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return which cells can be edited: those of the program, if it is at hand."""
        row, column = self.rows[index.row()], Column(index.column())
        editable = row.entry is not None and column in EDITABLE and not (column is Column.NOMINAL and row.is_zone)
        base = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        return base | Qt.ItemFlag.ItemIsEditable if editable else base

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Pass an edit on."""
        if role != Qt.ItemDataRole.EditRole:
            return False
        return self._edit(CellEdit((self.rows[index.row()].id,), Column(index.column()), str(value)))

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return what a cell shows."""
        row, column = self.rows[index.row()], Column(index.column())
        if role == Qt.ItemDataRole.DisplayRole:
            return self.shown_text(row, column)
        if role == Qt.ItemDataRole.EditRole:
            return edit_text(row, column) if column in EDITABLE else cell_text(row, column)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(column)
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._version_tip(row) if self._is_marked(row, column) else translated(_tip(row, column))
        if role == SIGN_ROLE:
            return row.verdict if column is Column.VERDICT and not row.is_outdated else ""
        if role == SORT_ROLE:
            return sort_key(row, column)
        if role == Qt.ItemDataRole.ForegroundRole and column in RESULTS and row.is_outdated:
            return QPalette().brush(QPalette.ColorRole.Dark)
        if role == Qt.ItemDataRole.FontRole and column is Column.NOMINAL and row.is_linked:
            return _italic()
        if role == Qt.ItemDataRole.AccessibleTextRole and column is Column.STATUS:
            return translated(STATUS_WORDS[row.status])
        if role == FRAME_ROLE:
            return row.frame if column is Column.TOLERANCE else None
        return {ROW_ROLE: row, STATUS_ROLE: row.status if column is Column.STATUS else None}.get(role)


def _alignment(column: Column) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignRight if column in NUMERIC else Qt.AlignmentFlag.AlignLeft
    return side | Qt.AlignmentFlag.AlignVCenter


def _italic() -> QFont:
    font = QFont()
    font.setItalic(True)
    return font


def frame_words(row: DimensionRow) -> str:
    """Return a feature control frame in words, with the limit of the last result where a material condition widens it."""
    assert row.frame is not None
    datums = common_datums(row.entry) if row.entry is not None else row.found.datums if row.found is not None else ()
    kind = translated(sentence_case(row.frame.characteristic.replace("_", " ")))
    stated = ", ".join(words for words in (row.frame.zone(), datum_words(datums, row.frame.datums) if row.frame.datums else "") if words)
    allowed = row.limits
    bonus = "" if allowed is None or allowed[1] <= row.frame.width_mm else tr("; with its bonus {upper}", upper=quantity(allowed[1], "mm"))
    return tr("{kind}: {stated}{bonus}", kind=kind, stated=stated, bonus=bonus)


def _tip(row: DimensionRow, column: Column) -> str:
    reason = "" if row.found is None else row.found.reason
    if column in (Column.STATUS, Column.VERDICT) and reason and row.status in ("failed", "current"):
        return reason
    if column in (Column.VERDICT, *RESULTS) and row.is_outdated and row.found is not None:
        return tr(
            "Before the change: {value}, {verdict}",
            value=quantity(row.found.measured, row.unit),
            verdict=VERDICT_WORDS.get(row.verdict, row.verdict),
        )
    if column is Column.STATUS:
        return translated(STATUS_WORDS[row.status])
    if column in (Column.TOLERANCE, Column.UNCERTAINTY) and row.found is not None and row.found.warning:
        return row.found.warning
    if column is Column.TOLERANCE and row.frame is not None:
        return frame_words(row)
    if column is Column.NOMINAL and row.entry is not None and not row.is_zone:
        return "Follows the nominal features" if row.is_linked else "Typed"
    if column is Column.TOLERANCE and row.limits is None:
        return "No tolerance: there is no verdict"
    return cell_text(row, column)
