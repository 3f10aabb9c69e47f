"""The tools above the table of viewpoints."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QInputDialog, QWidget

from ui.controllers.planning import PlanningController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, row
from ui.widgets.plan_tree import PlanTree

EVENLY = 6
ASK_ANGLES = "Table angles in degrees, separated by commas:"


class PlanTools(QWidget):
    """Adds, copies, groups, moves and removes viewpoints; undo and redo."""

    def __init__(self, look: Look, planning: PlanningController, tree: PlanTree) -> None:
        super().__init__()
        self._planning, self._tree = planning, tree
        self.here = Button("", look, "home", "quiet", "Add the present position of the connected rig")
        self.copy = Button("", look, "copy", "quiet", "Duplicate the selected rows (Ctrl+D)")
        self.repeat = Button("", look, "axis", "quiet", "Repeat the selected viewpoints at several table angles, as a group")
        self.ungroup = Button("", look, "ungroup", "quiet", "Replace the selected group by its viewpoints")
        self.up = Button("", look, "up", "quiet", "Move up in the scan order (Alt+Up)")
        self.down = Button("", look, "down", "quiet", "Move down in the scan order (Alt+Down)")
        self.remove = Button("", look, "remove", "quiet", "Remove the selected rows (Del)")
        self.undo = Button("", look, "undo", "quiet", "Undo")
        self.redo = Button("", look, "redo", "quiet", "Redo")
        self.order = Button("", look, "guide", "quiet", "Order all viewpoints so that the axes move least; groups are dissolved")
        edits = (self.here, self.copy, self.repeat, self.ungroup, self.up, self.down, self.order, self.remove)
        self.setLayout(row(*edits, 0, self.undo, self.redo, spacing=4))
        self._connect()

    def _connect(self) -> None:
        planning, tree = self._planning, self._tree
        self.here.clicked.connect(lambda: planning.add_here(None))
        self.copy.clicked.connect(lambda: planning.duplicate(tree.names()))
        self.repeat.clicked.connect(self._ask_repeat)
        self.ungroup.clicked.connect(self._ungroup)
        self.up.clicked.connect(lambda: self._move(-1))
        self.down.clicked.connect(lambda: self._move(1))
        self.order.clicked.connect(planning.shorten)
        self.remove.clicked.connect(self._remove)
        self.undo.clicked.connect(planning.undo)
        self.redo.clicked.connect(planning.redo)
        keys = (
            (QKeySequence.StandardKey.Delete, self.remove),
            (QKeySequence("Ctrl+D"), self.copy),
            (QKeySequence("Alt+Up"), self.up),
            (QKeySequence("Alt+Down"), self.down),
        )
        for key, button in keys:
            QShortcut(key, tree, button.click, context=Qt.ShortcutContext.WidgetShortcut)

    def show_state(self) -> None:
        """Enable what is possible with the selection."""
        names, stack, plan = self._tree.names(), self._planning.stack, self._planning.plan
        singles = set() if plan is None else {viewpoint.id for viewpoint in plan.viewpoints}
        for button in (self.copy, self.up, self.down, self.remove):
            button.setEnabled(bool(names))
        self.repeat.setEnabled(bool(names) and singles.issuperset(names))
        self.ungroup.setEnabled(bool(names) and not singles.intersection(names))
        self.here.setEnabled(self._planning.can_add_here)
        self.order.setEnabled(plan is not None and len(plan) > 2)
        self.undo.setEnabled(stack.canUndo())
        self.redo.setEnabled(stack.canRedo())
        self.undo.setToolTip(tr("Undo: {undotext}", undotext=stack.undoText()) if stack.canUndo() else tr("Nothing to undo"))
        self.redo.setToolTip(tr("Redo: {redotext}", redotext=stack.redoText()) if stack.canRedo() else tr("Nothing to redo"))

    def _remove(self) -> None:
        from measureapp.planning import edit

        names = self._tree.names()
        self._planning.edit("Remove", lambda plan: edit.remove(plan, names))

    def _move(self, by: int) -> None:
        from measureapp.planning import edit

        names = self._tree.names()
        self._planning.edit("Move", lambda plan: edit.move(plan, names, by), names)

    def _ungroup(self) -> None:
        from measureapp.planning import edit

        name = self._tree.names()[0]
        self._planning.edit("Ungroup", lambda plan: edit.ungroup(plan, name))

    def _ask_repeat(self) -> None:
        start = ", ".join(f"{360 * step // EVENLY}" for step in range(EVENLY))
        self.asking = QInputDialog(self)
        self.asking.setWindowTitle(tr("Repeat at table angles"))
        self.asking.setLabelText(ASK_ANGLES)
        self.asking.setTextValue(start)
        self.asking.textValueSelected.connect(self.repeat_at)
        self.asking.finished.connect(self.asking.deleteLater)
        self.asking.open()

    def repeat_at(self, text: str) -> None:
        """Make the selected viewpoints a group at these table angles."""
        from measureapp.planning import edit
        from measureapp.planning.plan_index import PlanIndex

        names = self._tree.names()
        try:
            angles = [float(part) for part in text.split(",") if part.strip()]
        except ValueError:
            self._planning.say(tr("{text!r} is not a list of angles.", text=text), "Write numbers separated by commas.")
            return
        plan = self._planning.plan
        if plan is not None and names:
            group = PlanIndex(plan).free_name("ring01")
            self._planning.edit("Repeat", lambda plan: edit.repeat(plan, names, angles, group), (group,))
