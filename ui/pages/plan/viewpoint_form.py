"""Editors of the selected viewpoints, and of the plan as a whole."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from measureapp.errors import MeasureError
from ui.look.language.words import later, tr, translated
from ui.look.wording import several
from ui.pages.plan.plan_aims import PlanAims
from ui.widgets.basic import CalmComboBox, Form, column, label, row
from ui.widgets.number_fields import NumberFields
from ui.widgets.number_list import NumberList
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
    from ui.controllers.planning import PlanningController

SECTIONS = {"aim": "Aim", "pose": "Robot pose", "plan": "Whole plan"}
TIPS = {
    "aim": "Where the head looks, from which side, elevation and distance",
    "pose": "Position and direction of the robot's flange, as its controller states them",
    "plan": "Name, patterns, exposures and waiting time of the plan",
}
EXPOSURES_TIP = "From long to short, in ms, separated by commas; empty: those of the plan"
SETTLE_TIP = "Wait before images are taken, in s; empty: that of the plan"


class ViewpointForm(QWidget):
    """Shows the selected viewpoints; every entry is one step that can be undone."""

    changed = Signal()

    def __init__(self, planning: PlanningController, aims: PlanAims) -> None:
        super().__init__()
        self._planning, self._aims = planning, aims
        self._names: tuple[str, ...] = ()
        self._viewpoints: tuple[Viewpoint, ...] = ()
        self.section = Segments(SECTIONS, name="Properties of", tips=TIPS)
        self.target = NumberFields(("x of the target", "y of the target", "z of the target"), "mm", 1)
        self.direction = NumberFields(("Azimuth", "Elevation", "Roll"), "°", 2)
        self.distance = NumberFields(("Stand-off",), "mm", 1)
        self.position = NumberFields(("x of the flange", "y of the flange", "z of the flange"), "mm", 2)
        self.quaternion = NumberFields(("w", "x", "y", "z"), "", 5)
        self.guide, self.table = NumberFields(("Guide",), "mm", 2), NumberFields(("Table",), "°", 3)
        self.exposures = NumberList("Exposures", EXPOSURES_TIP, "ms")
        self.settle = NumberList("Waiting time", SETTLE_TIP, "s", most=1)
        self.note = label("", "small", wrap=True)
        self._pages = {"aim": self._aim_page(), "pose": self._pose_page(), "plan": self._plan_page()}
        self._common = QWidget()
        common = Form(self._common)
        common.setVerticalSpacing(4)
        common.add("Guide, table", _beside(self.guide, self.table))
        common.add("Exposures, wait", _beside(self.exposures, self.settle))
        self.setLayout(column(self.section, self.note, *self._pages.values(), self._common, 0, spacing=4))
        self._connect()
        self._show_section()

    def _aim_page(self) -> QWidget:
        page = QWidget()
        form = Form(page)
        form.setVerticalSpacing(4)
        form.add("Target x, y, z", self.target)
        form.add("Azimuth, elevation, roll", self.direction)
        form.add("Stand-off", self.distance)
        return page

    def _pose_page(self) -> QWidget:
        page = QWidget()
        form = Form(page)
        form.setVerticalSpacing(4)
        form.add("Flange x, y, z", self.position)
        form.add("Quaternion w, x, y, z", self.quaternion)
        return page

    def _plan_page(self) -> QWidget:
        self.plan_name = QLineEdit()
        self.plan_name.setAccessibleName(tr("Name of the plan"))
        self.patterns = CalmComboBox()
        self.patterns.setAccessibleName(tr("Patterns of the plan"))
        self.patterns.setSizeAdjustPolicy(CalmComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.plan_exposures = NumberList("Exposures of the plan", "From long to short, in ms, separated by commas", "ms")
        self.plan_settle = NumberList("Waiting time of the plan", "Wait before images are taken, in s; empty: that of the rig", "s", most=1)
        page = QWidget()
        form = Form(page)
        form.setVerticalSpacing(4)
        rows = (("Name", self.plan_name), ("Patterns", self.patterns), ("Exposures", self.plan_exposures), ("Wait", self.plan_settle))
        for name, editor in rows:
            form.add(name, editor)
        return page

    def _connect(self) -> None:
        self.section.valueChanged.connect(self._show_section)
        self.target.valueChanged.connect(self._aim)
        self.direction.valueChanged.connect(self._aim)
        self.distance.valueChanged.connect(self._aim)
        self.position.valueChanged.connect(self._move)
        self.quaternion.valueChanged.connect(self._move)
        self.guide.valueChanged.connect(lambda value: self.set_axis("guide_mm", value[0]))
        self.table.valueChanged.connect(lambda value: self.set_axis("table_deg", value[0]))
        self.exposures.valueChanged.connect(self._expose)
        self.settle.valueChanged.connect(self._wait)
        self.plan_name.editingFinished.connect(self._rename_plan)
        self.patterns.activated.connect(self._choose_patterns)
        self.plan_exposures.valueChanged.connect(self._expose_plan)
        self.plan_settle.valueChanged.connect(self._wait_plan)

    def show_selection(self, names: Sequence[str], viewpoints: Sequence[Viewpoint]) -> None:
        """Show these viewpoints; of several only what can be set together."""
        self._names, self._viewpoints = tuple(names), tuple(viewpoints)
        one = self._viewpoints[0] if len(self._viewpoints) == 1 else None
        aim = None if one is None else self._aims.aim(one)
        self.target.setValue(None if aim is None else aim.target_mm)
        look = None if aim is None else aim.look_at
        self.direction.setValue(None if look is None else (look.azimuth_deg, look.elevation_deg, look.roll_deg))
        self.distance.setValue(None if look is None else (look.distance_mm,))
        self.position.setValue(None if one is None else one.flange.position_mm)
        self.quaternion.setValue(None if one is None else one.flange.quaternion_wxyz)
        for editor, axis in ((self.guide, "guide_mm"), (self.table, "table_deg")):
            values = {getattr(viewpoint, axis) for viewpoint in self._viewpoints}
            editor.setValue((values.pop(),) if len(values) == 1 else None)
        exposures = {viewpoint.exposures_us for viewpoint in self._viewpoints}
        settle = {viewpoint.settle_s for viewpoint in self._viewpoints}
        common_us, common_s = (exposures.pop() if len(exposures) == 1 else None), (settle.pop() if len(settle) == 1 else None)
        self.exposures.setValue(None if common_us is None else [exposure_us / 1000 for exposure_us in common_us])
        self.settle.setValue(None if common_s is None else [common_s])
        for widget in (self.target, self.direction, self.distance, self.position, self.quaternion):
            widget.setEnabled(one is not None)
        self._common.setEnabled(bool(self._viewpoints))
        self._show_note()

    def show_plan(self, plan: ScanPlan | None) -> None:
        """Show the plan as a whole."""
        if plan is None:
            return
        from ui.look.pattern_words import PATTERN_WORDS

        self.plan_name.setText(translated(plan.name))
        self.plan_exposures.setValue([exposure_us / 1000 for exposure_us in plan.bracket.exposures_us])
        self.plan_settle.setValue(None if plan.settle_s is None else [plan.settle_s])
        self.exposures.set_default(", ".join(f"{exposure_us / 1000:g}" for exposure_us in plan.bracket.exposures_us))
        self.settle.set_default(later("plan") if plan.settle_s is not None else later("rig"))
        chosen = self._aims.pattern_name(plan.patterns)
        self.patterns.clear()
        for name in self._aims.pattern_sets():
            self.patterns.addItem(translated(PATTERN_WORDS[name].title) if name in PATTERN_WORDS else name, name)
        if chosen is None:
            self.patterns.addItem(plan.patterns.name, "")
        self.patterns.setCurrentIndex(self.patterns.findData(chosen or ""))

    def _show_section(self) -> None:
        section = self.section.value()
        for name, page in self._pages.items():
            page.setVisible(name == section)
        self._common.setVisible(section != "plan")
        self._show_note()

    def _show_note(self) -> None:
        count = len(self._viewpoints)
        words = (
            "" if count == 1 else "Select a viewpoint to change it." if not count else tr("{rows} selected.", rows=several(count, "row"))
        )
        self.note.setText(translated(words))
        self.note.setVisible(bool(words) and self.section.value() != "plan")

    # steps

    def set_axis(self, axis: str, value: float) -> None:
        """Set guide or table of the selected viewpoints; the robot keeps its pose."""
        from measureapp.planning import edit

        names = self._names
        self._planning.edit(
            tr("Set the {words}", words="guide" if axis == "guide_mm" else "table"), lambda plan: edit.change(plan, names, **{axis: value})
        )

    def _aim(self) -> None:
        target, direction, distance = self.target.value(), self.direction.value(), self.distance.value()
        if len(self._viewpoints) != 1 or not (target and direction and distance):
            return
        flange = self._aims.flange(self._viewpoints[0], (target[0], target[1], target[2]), direction, distance[0])
        if isinstance(flange, MeasureError):
            self._planning.refuse(flange)
        else:
            self._set_pose("Aim", flange)

    def _move(self) -> None:
        position, quaternion = self.position.value(), self.quaternion.value()
        if position and quaternion:
            flange = self._aims.pose(position, quaternion)
            if isinstance(flange, MeasureError):
                self._planning.refuse(flange)
            else:
                self._set_pose("Move the robot", flange)

    def _set_pose(self, words: str, flange: FlangePose) -> None:
        from measureapp.planning import edit

        names = self._names
        self._planning.edit(words, lambda plan: edit.change(plan, names, flange=flange))

    def _expose(self, values: Sequence[float]) -> None:
        from measureapp.planning import edit

        names, exposures_us = self._names, [round(value * 1000) for value in values] or None
        self._planning.edit("Set exposures", lambda plan: edit.set_exposures(plan, names, exposures_us))

    def _wait(self, values: Sequence[float]) -> None:
        from measureapp.planning import edit

        names = self._names
        self._planning.edit("Set the waiting time", lambda plan: edit.set_settle(plan, names, values[0] if values else None))

    def _rename_plan(self) -> None:
        name = self.plan_name.text().strip()
        self._set_plan("Rename the plan", name=name or "plan")

    def _choose_patterns(self) -> None:
        chosen = self._aims.pattern_sets().get(self.patterns.currentData())
        if chosen is not None:
            self._set_plan("Choose patterns", patterns=chosen)

    def _expose_plan(self, values: Sequence[float]) -> None:
        self._set_plan("Set exposures", bracket={"exposures_us": [round(value * 1000) for value in values]})

    def _wait_plan(self, values: Sequence[float]) -> None:
        self._set_plan("Set the waiting time", settle_s=values[0] if values else None)

    def _set_plan(self, words: str, **fields: object) -> None:
        from measureapp.planning import edit

        self._planning.edit(words, lambda plan: edit.set_plan(plan, **fields))


def _beside(one: QWidget, other: QWidget) -> QWidget:
    pair = QWidget()
    layout = row(one, other, spacing=8)
    layout.setStretch(0, 2)
    layout.setStretch(1, 1)
    pair.setLayout(layout)
    return pair
