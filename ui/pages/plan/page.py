"""Page Plan: the viewpoints in a table and in the cell, edited together, checked and predicted after every edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtGui import QHideEvent, QKeySequence, QResizeEvent, QShortcut, QShowEvent
from PySide6.QtWidgets import QSplitter, QWidget

from ui.actions.actions import REDO_KEYS
from ui.controllers.controllers import Controllers
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import duration, percent, quantity, several, storage
from ui.pages.plan import preview
from ui.pages.plan.generate_dialog import GenerateDialog
from ui.pages.plan.plan_aims import PlanAims
from ui.pages.plan.plan_tools import PlanTools
from ui.pages.plan.ray import first_hit
from ui.pages.plan.viewpoint_form import ViewpointForm
from ui.pages.plan.viewpoint_properties import viewpoint_properties
from ui.pages.viewport_page import Composer, ViewportPage
from ui.session import Session
from ui.settings.dialogs import choose_file, choose_new
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.coverage_legend import CoverageLegend
from ui.widgets.empty_state import EmptyState
from ui.widgets.plan_tree import PlanTree
from ui.widgets.plan_tree_model import GUIDE, NAME, RowState
from ui.widgets.properties_panel import Properties
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from ui.controllers.plan_prediction import Prediction

EMPTY = (
    "No scan plan yet",
    "A plan lists the viewpoints of a scan. Generate one from the nominal of the part, open a file, or add viewpoints one by one.",
)
PLANS = "Scan plans (*.toml *.json)"
NOMINALS = "Nominals (*.stl *.ply *.obj *.step *.stp)"
SIDE_WIDTH = 560
ROOM_FOR_TOOLS = 1500
CLICK_HINT = "Click the part where a new viewpoint should look."


class PlanPage(ViewportPage):
    """Table, editors and 3-D preview of a plan."""

    name, word, wants_room = "plan", "Plan", True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "plan", *EMPTY, "Generate a plan…", "grow"))
        self.planning = controllers.planning
        self.aims = PlanAims(session)
        self.tree, self.form = PlanTree(look), ViewpointForm(self.planning, self.aims)
        self.tools = PlanTools(look, self.planning, self.tree)
        self.shown = Segments(preview.SHOWN, name="Colours of the part", tips=preview.SHOWN_TIPS)
        self.problem, self.hint = label("", "problem", wrap=True), label("", "soft")
        self.legend = CoverageLegend(look)
        self._lay_out(look)
        self._connect(session)

    def _lay_out(self, look: Look) -> None:
        self.open_file = Button("Open…", look, "open", "quiet", "Open a scan plan (TOML or JSON)")
        self.save_file = Button("Save as…", look, "export", "quiet", "Save the plan as TOML or JSON")
        self.generate = Button("Generate…", look, "grow", tip="Choose viewpoints by what they are predicted to measure")
        self.use = Button("Use for the scan", look, "scan", "primary", "Scan with this plan; it is stored in the open project")
        for button in (self.open_file, self.save_file, self.generate, self.use):
            self.action_row.addWidget(button)
        self.open_quiet = Button("Open a plan…", look, "open")
        self.begin = Button("Add a viewpoint", look, "add", tip="Begin with one viewpoint aimed at the middle of the table")
        for button in (self.begin, self.open_quiet):
            self.empty.add_quiet(button)
        fit = Button("Show all", look, "fit", "quiet", "Show everything from the front")
        fit.clicked.connect(self.view.reset_camera)
        self.choose_part = Button("Part…", look, "file", "quiet", "Choose the nominal of the part")
        self.on_part = Button("Add on the part", look, "add", "quiet", CLICK_HINT)
        self.on_part.setCheckable(True)
        self.tool_buttons = (fit, self.choose_part, self.on_part)
        tools = row(self.shown, *self.tool_buttons, 0, self.hint)
        picture = column(tools, card(self.view, self.legend, self.problem, margin=8, spacing=4), spacing=12)
        picture.setStretch(1, 1)
        self.problem.hide()
        split = QSplitter(Qt.Orientation.Vertical)
        split.setObjectName("plan")
        split.setChildrenCollapsible(False)
        upper = QWidget()
        upper.setLayout(column(self.tools, self.tree, spacing=8))
        split.addWidget(upper)
        lower = card(self.form, margin=12)
        split.addWidget(lower)
        split.setStretchFactor(0, 1)
        self.side, self.side_width = split, SIDE_WIDTH
        layout = row(picture, split, spacing=16)
        layout.setStretch(0, 1)
        self.body.setLayout(layout)

    def _connect(self, session: Session) -> None:
        planning = self.planning
        self.empty.triggered.disconnect()
        self.empty.triggered.connect(self.ask_generate)
        self.generate.clicked.connect(self.ask_generate)
        self.begin.clicked.connect(planning.add_default)
        for button in (self.open_file, self.open_quiet):
            button.clicked.connect(self._choose_file)
        self.save_file.clicked.connect(self._choose_target)
        self.use.clicked.connect(planning.use)
        self.choose_part.clicked.connect(self._choose_part)
        self.on_part.toggled.connect(self._show_hint)
        self.shown.valueChanged.connect(self.redraw)
        self.shown.valueChanged.connect(self._show_legend)
        self.view.rayClicked.connect(self._click_part)
        self.tree.selectionMoved.connect(self._show_selection)
        self.tree.rows.cellEdited.connect(self._edit_cell)
        self.follow(planning.changed, self._show)
        planning.selectAsked.connect(self.tree.select)
        self.follow(planning.prediction.changed, self._show_prediction)
        planning.part.changed.connect(self.redraw)
        self.follow(session.rigChanged, self._show)
        self.follow(session.busyChanged, self._show_actions, self._show_busy)
        self.follow(session.cellChanged, self.tools.show_state)
        keys = (*((key, planning.redo) for key in REDO_KEYS), ("Ctrl+Shift+O", self._choose_file))
        for key, action in keys:
            QShortcut(QKeySequence(key), self, action, context=Qt.ShortcutContext.WidgetWithChildrenShortcut)

    # showing

    @Slot()
    def _show(self) -> None:
        plan = self.planning.plan
        self.show_filled(plan is not None)
        with QSignalBlocker(self.tree):  # all that follows from the selection is shown once, below
            self.tree.show_plan(plan, self.aims.angles)
            if plan is not None and not self.tree.names():
                self.tree.select((next(iter(plan)).id,))
        self.form.show_plan(plan)
        self._say_prediction()
        self._show_selection()
        self._show_actions()

    @Slot()
    def _show_busy(self) -> None:
        if self.session.busy_with and self.planning.plan is None:
            self.say_running("Planning…", "The plan is being made.")
        else:
            self.empty.say(*EMPTY)

    @Slot()
    def _show_actions(self) -> None:
        self.use.setEnabled(not self.planning.is_used and not self.session.busy_with)
        self.use.setToolTip(
            tr("The scan uses this plan") if self.planning.is_used else tr("Scan with this plan; it is stored in the open project")
        )
        self.generate.setEnabled(not self.session.busy_with)
        self.tools.show_state()

    @Slot()
    def _show_selection(self) -> None:
        self.form.show_selection(self.tree.names(), self.tree.viewpoints())
        self.tools.show_state()
        self._show_chosen()

    def _show_chosen(self) -> None:
        """Show what is known of the selected viewpoint: what prevents it, what it sees, its properties, its picture."""
        self._show_problem()
        self._show_legend()
        viewpoint = self.tree.current_viewpoint()
        plan, rig = self.planning.plan, self.session.rig
        if viewpoint is not None and plan is not None and rig is not None:
            self.show_properties(viewpoint_properties(plan, viewpoint, rig, self._prediction()))
        else:
            self.show_properties(Properties("Properties", note="Select a viewpoint to see its properties."))
        self.redraw()

    def _prediction(self) -> Prediction | None:
        return self.planning.prediction.now

    @Slot()
    def _show_prediction(self) -> None:
        self._say_prediction()
        if self.planning.plan is not None:
            self._show_chosen()

    def _say_prediction(self) -> None:
        """Say below the heading, and in the rows, what the check has found."""
        plan, found = self.planning.plan, self._prediction()
        if plan is None:
            self.state.setText(tr("No scan plan."))
            return
        viewpoints = several(len(plan), "viewpoint")
        if found is not None and found.plan is plan:
            count = len(found.check.sentences())
            size = tr("about {time_s}, {bytes}", time_s=duration(found.check.time_s), bytes=storage(found.check.bytes))
            verdict = several(count, "problem") if count else "nothing prevents the scan"
            said = tr("{viewpoints}, {size} · {verdict}.", viewpoints=viewpoints, size=size, verdict=translated(verdict))
            sentences = found.check.sentences()
            self.tree.show_states(
                {
                    viewpoint.id: RowState("fail", " ".join(sentences[viewpoint.id])) if viewpoint.id in sentences else RowState("pass")
                    for viewpoint in plan
                }
            )
        else:
            said = tr("{viewpoints}, {verdict}", viewpoints=viewpoints, verdict=tr("being checked…"))
            self.tree.show_states({})
        self.state.setText(said)

    def _show_problem(self) -> None:
        """Say below the picture why the selected viewpoint, or the whole plan, cannot be scanned."""
        found, viewpoint = self._prediction(), self.tree.current_viewpoint()
        sentences = {} if found is None or found.plan is not self.planning.plan else found.check.sentences()
        words = [
            *sentences.get("", []),
            *([] if viewpoint is None else [f"{viewpoint.id}: {one}" for one in sentences.get(viewpoint.id, [])]),
        ]
        self.problem.setText(translated("\n".join(words)))
        self.problem.setVisible(bool(words))

    @Slot()
    def _show_legend(self) -> None:
        """Say what the colours of the part mean, with their shares."""
        found, viewpoint = self._prediction(), self.tree.current_viewpoint()
        if found is None or found.plan is not self.planning.plan or self.shown.value() == "part":
            self.legend.show_swatches((), "")
        elif found.coverage is None:
            self.legend.show_swatches((), found.note)
        elif self.shown.value() == "coverage":
            self.legend.show_swatches(*preview.coverage_legend(found.coverage))
        else:
            row_number = -1 if viewpoint is None else found.row(viewpoint.id)
            share = 0.0 if row_number < 0 else found.coverage.share(found.coverage.seen[row_number])
            self.legend.show_swatches(
                (
                    (preview.OFTEN, tr("Measured {share}", share=percent(share))),
                    (None, tr("Not measured {percent}", percent=percent(1 - share))),
                ),
                "",
            )

    def showEvent(self, event: QShowEvent) -> None:
        """Check the plan from now on."""
        super().showEvent(event)
        self.planning.set_watched(True)

    def hideEvent(self, event: QHideEvent) -> None:
        """Check nothing that nobody sees."""
        super().hideEvent(event)
        self.planning.set_watched(False)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Reduce the tools beside the colours to icons earlier than other pages do."""
        super().resizeEvent(event)
        for button in (*self.tool_buttons, self.open_file, self.save_file):
            button.set_compact(self.width() < ROOM_FOR_TOOLS)

    def _scenery(self) -> preview.Scenery | None:
        rig = self.session.rig
        if rig is None:
            return None
        shown: preview.Shown = self.shown.value()  # type: ignore[assignment]
        return preview.Scenery(
            rig, self.tree.current_viewpoint(), self.tree.viewpoints(), self._prediction(), self.planning.part.prepared, shown
        )

    def composer(self) -> Composer | None:
        """Compose the bodies of the cell and the part."""
        scenery = self._scenery()
        if scenery is None or self.planning.plan is None:
            return None
        self.view.frame(preview.framed(scenery), preview.OPENING)
        return preview.composer(scenery, self.look.theme)

    # doing

    def undo_last(self) -> None:
        """Undo the last edit."""
        self.planning.undo()

    def end_clicking(self) -> None:
        """Clicks on the part add no viewpoints any more."""
        self.on_part.setChecked(False)

    @Slot()
    def _show_hint(self) -> None:
        has_part = self.planning.part.prepared is not None
        self.hint.setText("" if not self.on_part.isChecked() else translated(CLICK_HINT) if has_part else tr("Choose the part first."))

    @Slot(object, object)
    def _click_part(self, origin: np.ndarray, direction: np.ndarray) -> None:
        """Add a viewpoint that looks at the place of the part under the mouse."""
        part, scenery = self.planning.part.prepared, self._scenery()
        if not self.on_part.isChecked() or part is None or scenery is None:
            return
        hit = first_hit(part.corners_mm, preview.guide_from_part(scenery), origin, direction)
        if hit is not None:
            self.planning.add_facing(*hit, self.after())

    def after(self) -> str | None:
        """Return the single viewpoint behind which a new one is added; None: as the last one."""
        plan, names = self.planning.plan, self.tree.names()
        singles = set() if plan is None else {viewpoint.id for viewpoint in plan.viewpoints}
        return next((name for name in reversed(names) if name in singles), None)

    @Slot(str, int, str)
    def _edit_cell(self, name: str, cell: int, text: str) -> None:
        from measureapp.planning import edit

        if cell == NAME:
            if self.planning.edit(tr("Rename {name}", name=name), lambda plan: edit.rename(plan, name, text), (text,)):
                return
        else:
            value = _number(text)
            if value is None:
                self.session.tell(
                    tr("{text!r} is not a number.", text=text),
                    tr("Enter the {words}.", words="guide in mm" if cell == GUIDE else "table in degrees"),
                    "warning",
                )
            else:
                axis = "guide_mm" if cell == GUIDE else "table_deg"
                self.planning.edit(tr("Set {value}", value=quantity(value, "")), lambda plan: edit.change(plan, (name,), **{axis: value}))

    @Slot()
    def ask_generate(self) -> None:
        """Ask what a generated plan has to achieve."""
        self.dialog = GenerateDialog(self.look, self.planning, self)
        self.dialog.partAsked.connect(self._choose_part)
        self.dialog.finished.connect(self.dialog.deleteLater)
        self.dialog.open()

    @Slot()
    def _choose_file(self) -> None:
        chosen = choose_file(self, "Open a scan plan", PLANS, "plans")
        if chosen is not None:
            self.planning.open(chosen)

    @Slot()
    def _choose_target(self) -> None:
        plan = self.planning.plan
        if plan is None:
            return
        path = choose_new(self, "Save the scan plan", "plan.toml", "plans", PLANS, self.planning.file)
        if path is not None:
            self.planning.save(path if path.suffix else path.with_suffix(".toml"))

    @Slot()
    def _choose_part(self) -> None:
        chosen = choose_file(self, "Choose the nominal of the part", NOMINALS, "nominals")
        if chosen is not None:
            self.planning.part.choose(chosen)


def _number(text: str) -> float | None:
    from math import isfinite

    try:
        value = float(text.replace("\u2212", "-").replace(",", "."))
    except ValueError:
        return None
    return value if isfinite(value) else None
