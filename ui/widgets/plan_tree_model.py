"""Model of a scan plan as a tree: single viewpoints, and groups with their viewpoints below."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QObject, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QFont

from ui.look.language.words import tr, translated
from ui.look.wording import exposure, quantity, several
from ui.widgets.data_table import SIGN_ROLE

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint, ViewpointGroup

Index = QModelIndex | QPersistentModelIndex
HEADERS = ("Viewpoint", "From", "Elevation", "Guide", "Table", "Exposures")
NAME, AZIMUTH, ELEVATION, GUIDE, TABLE, EXPOSURES = range(6)
EDITABLE = (NAME, GUIDE, TABLE)
TOP = 0xFFFFFFFF  # internal id of rows without a parent; of a group's viewpoints it is the group's row
SHOWN = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
CHANGED = SHOWN | Qt.ItemFlag.ItemIsEditable
Aims = Callable[["Viewpoint"], tuple[float, float]]  # azimuth and elevation, in degrees


@dataclass(frozen=True)
class RowState:
    """Whether a viewpoint can be scanned: "pass", "fail" with the reasons, or "not measured" before that is known."""

    sign: str
    tip: str = ""


UNCHECKED = RowState("not measured", "Not checked yet")


class PlanTreeModel(QAbstractItemModel):
    """Rows of a plan; texts are made when they are shown. An edited cell is sent as `cellEdited`."""

    cellEdited = Signal(str, int, str)  # name, column, text

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._plan: ScanPlan | None = None
        self._made: dict[int, tuple[Viewpoint, ...]] = {}  # the viewpoints of groups, by number
        self._places: dict[str, tuple[int, int]] = {}  # row and group's row of every name, made when it is first asked for
        self._states: Mapping[str, RowState] = {}
        self._aims: Aims | None = None

    def set_plan(self, plan: ScanPlan | None, aims: Aims | None) -> bool:
        """Show a plan; ``aims`` returns from where a viewpoint looks. Returns whether the rows are the same, with other contents."""
        keeps_rows = plan is not None and self._plan is not None and _has_same_rows(self._plan, plan)
        if not keeps_rows:
            self.beginResetModel()
        self._plan, self._aims, self._made, self._places = plan, aims, {}, {}
        if not keeps_rows:
            self.endResetModel()
        return keeps_rows

    def set_states(self, states: Mapping[str, RowState]) -> None:
        """Set which viewpoints can be scanned; others are not checked yet. The tree paints them again."""
        self._states = states

    # names and rows

    @property
    def _singles(self) -> int:
        return 0 if self._plan is None else len(self._plan.viewpoints)

    def rows_of_groups(self) -> range:
        """Return the top rows of the groups, which are below the single viewpoints."""
        return range(self._singles, self.rowCount())

    def group_at(self, index: Index) -> ViewpointGroup | None:
        """Return the group of a top row; None for a viewpoint."""
        if self._plan is None or index.internalId() != TOP or index.row() < self._singles:
            return None
        return self._plan.groups[index.row() - self._singles]

    def viewpoint_at(self, index: Index) -> Viewpoint:
        """Return the viewpoint of a row; of a group its first."""
        return self.viewpoint_of(index.row(), int(index.internalId()))

    def viewpoint_of(self, row: int, above: int) -> Viewpoint:
        """Return the viewpoint of a row below the row of a group, or at the `TOP`; of a group its first."""
        assert self._plan is not None
        if above != TOP:
            return self._of_group(above)[row]
        return self._plan.viewpoints[row] if row < self._singles else self._of_group(row)[0]

    def name_at(self, index: Index) -> str:
        """Return the name of a row."""
        return self.name_of(index.row(), int(index.internalId()))

    def name_of(self, row: int, above: int) -> str:
        """Return the name of a row below the row of a group, or at the `TOP`."""
        assert self._plan is not None
        is_group = above == TOP and row >= self._singles
        return self._plan.groups[row - self._singles].id if is_group else self.viewpoint_of(row, above).id

    def find(self, name: str) -> QModelIndex:
        """Return the row with this name; an invalid index if there is none."""
        if not self._places and self._plan is not None:
            self._places = self._all_places(self._plan)
        if name not in self._places:
            return QModelIndex()
        return self.createIndex(self._places[name][0], 0, self._places[name][1])

    def _all_places(self, plan: ScanPlan) -> dict[str, tuple[int, int]]:
        places = {}
        for number, group in enumerate(plan.groups):
            above = self._singles + number
            places |= {viewpoint.id: (row, above) for row, viewpoint in enumerate(self._of_group(above))}
            places[group.id] = (above, TOP)
        return places | {viewpoint.id: (row, TOP) for row, viewpoint in enumerate(plan.viewpoints)}

    def _of_group(self, row: int) -> tuple[Viewpoint, ...]:
        assert self._plan is not None
        if row not in self._made:
            self._made[row] = self._plan.groups[row - self._singles].viewpoints()
        return self._made[row]

    # what Qt asks

    def index(self, row: int, column: int, parent: Index | None = None) -> QModelIndex:
        """Return the index of a cell."""
        if parent is not None and parent.isValid():
            return self.createIndex(row, column, parent.row())
        return self.createIndex(row, column, TOP)

    def parent(self, index: Index | None = None) -> Any:
        """Return the group of a viewpoint."""
        if index is None:
            return QObject.parent(self)
        if not index.isValid() or index.internalId() == TOP:
            return QModelIndex()
        return self.createIndex(int(index.internalId()), 0, TOP)

    def rowCount(self, parent: Index | None = None) -> int:
        """Return the number of rows below an index."""
        if self._plan is None:
            return 0
        if parent is None or not parent.isValid():
            return self._singles + len(self._plan.groups)
        group = self.group_at(parent)
        return 0 if group is None or parent.column() else len(group.poses) * len(group.table_deg)

    def columnCount(self, _parent: Index | None = None) -> int:
        """Return the number of columns."""
        return len(HEADERS)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the heading of a column."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return translated(HEADERS[section])
        return _side(section) if role == Qt.ItemDataRole.TextAlignmentRole else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return what can be done with a cell."""
        column = index.column()
        if column not in EDITABLE:
            return SHOWN
        named = index.internalId() == TOP
        is_group = named and index.row() >= self._singles
        return CHANGED if (named if column == NAME else not is_group) else SHOWN

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return what a cell shows."""
        if role == Qt.ItemDataRole.DisplayRole:
            return translated(self._text(index))
        if role == Qt.ItemDataRole.EditRole:
            return self._edited_text(index)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _side(index.column())
        if role == SIGN_ROLE and index.column() == NAME:
            return self._state(index).sign
        if role == Qt.ItemDataRole.ToolTipRole:
            return translated(self._state(index).tip or self._text(index))
        if role == Qt.ItemDataRole.FontRole and index.column() == NAME and index.internalId() == TOP:
            font = QFont()
            font.setWeight(QFont.Weight.DemiBold)
            return font
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Send what was entered; the plan itself is changed by who listens."""
        if role != Qt.ItemDataRole.EditRole or str(value) == self._edited_text(index):
            return False
        self.cellEdited.emit(self.name_at(index), index.column(), str(value).strip())
        return True

    def _state(self, index: Index) -> RowState:
        group = self.group_at(index)
        if group is None:
            return self._states.get(self.viewpoint_at(index).id, UNCHECKED)
        states = [self._states.get(viewpoint.id, UNCHECKED) for viewpoint in self._of_group(index.row())]
        failing = [state for state in states if state.sign == "fail"]
        if failing:
            return RowState("fail", tr("{count} cannot be scanned. {tip}", count=several(len(failing), "viewpoint"), tip=failing[0].tip))
        return next((state for state in states if state.sign != "pass"), states[0])

    def _text(self, index: Index) -> str:
        column, group = index.column(), self.group_at(index)
        if group is not None:
            return self._group_text(group, column)
        viewpoint = self.viewpoint_at(index)
        if column == NAME:
            return viewpoint.id
        if column in (AZIMUTH, ELEVATION):
            return "" if self._aims is None else quantity(self._aims(viewpoint)[column - AZIMUTH], "°", 1)
        if column == GUIDE:
            return quantity(viewpoint.guide_mm, "mm", 1)
        if column == TABLE:
            return quantity(viewpoint.table_deg, "°", 1)
        return _exposures(viewpoint.exposures_us)

    def _group_text(self, group: ViewpointGroup, column: int) -> str:
        if column == NAME:
            count = len(group.poses) * len(group.table_deg)
            return f"{group.id} ({count})" if count > 1 else group.id
        if column == GUIDE:
            return several(len(group.poses), "pose")
        if column == TABLE:
            angles = len(group.table_deg)  # a text of its own: a noun alone would read as the kind of a dimension in other languages
            return tr("{count} angle" if angles == 1 else "{count} angles", count=angles)
        return _exposures(group.exposures_us) if column == EXPOSURES else ""

    def _edited_text(self, index: Index) -> str:
        column, group = index.column(), self.group_at(index)
        if column == NAME:
            return group.id if group is not None else self.viewpoint_at(index).id
        viewpoint = self.viewpoint_at(index)
        return f"{viewpoint.guide_mm:.10g}" if column == GUIDE else f"{viewpoint.table_deg:.10g}"


def _has_same_rows(before: ScanPlan, after: ScanPlan) -> bool:
    """Return whether two plans have the same rows: at most one of them renamed, groups of the same sizes."""
    sizes = [[(len(group.poses), len(group.table_deg)) for group in plan.groups] for plan in (before, after)]
    if sizes[0] != sizes[1] or len(before.viewpoints) != len(after.viewpoints):
        return False
    tops = zip((*before.viewpoints, *before.groups), (*after.viewpoints, *after.groups), strict=True)
    return sum(one is not other and one.id != other.id for one, other in tops) <= 1


def _exposures(exposures_us: tuple[int, ...] | None) -> str:
    if exposures_us is None:
        return "plan's"
    return exposure(exposures_us[0]) if len(exposures_us) == 1 else f"{len(exposures_us)}, {exposure(exposures_us[0])}…"


def _side(column: int) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignLeft if column in (NAME, EXPOSURES) else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter
