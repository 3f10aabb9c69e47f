"""The scan plan that is being edited: every change can be undone, and is checked in the background."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoCommand, QUndoStack

from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.plan_generation import Wanted, generate, order
from ui.controllers.plan_part import PlanPart
from ui.controllers.plan_prediction import PlanPrediction
from ui.look.field_words import PROBLEMS, problem_sentence
from ui.look.language.words import tr
from ui.look.wording import percent, several
from ui.messages import SHOW_RIG
from ui.session import Session

if TYPE_CHECKING:
    import numpy as np

    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.planning.coverage.result import GeneratedPlan
    from ui.workers.job import Job

NO_RIG = ("No rig is chosen.", "Choose a rig on the page Rig first.")
UNDO_LIMIT = 200
NEW_NAME = "view01"
Edit = Callable[["ScanPlan"], "ScanPlan"]


class PlanningController(QObject):
    """Holds the plan on the Plan page. Views watch `changed`; `selectAsked` names what an edit has made."""

    changed = Signal()
    selectAsked = Signal(tuple)  # names

    def __init__(self, session: Session, runner: JobRunner, background: JobRunner, files: JobRunner, parent: QObject | None = None) -> None:
        """``files``: reads and writes plans, also while another job runs."""
        super().__init__(parent)
        self._session, self._runner, self._files = session, runner, files
        self.plan: ScanPlan | None = None
        self.file: Path | None = None
        self.stack = QUndoStack(self)
        self.stack.setUndoLimit(UNDO_LIMIT)
        self.part = PlanPart(session, background, self)
        self.prediction = PlanPrediction(session, background, self.part, self)
        session.planChanged.connect(self._follow_session)
        session.rigChanged.connect(self._predict)
        self.part.changed.connect(self._predict)

    # what there is

    @property
    def is_used(self) -> bool:
        """Whether the session scans with this plan."""
        return self.plan is not None and self._session.plan == self.plan

    def set_watched(self, watched: bool) -> None:
        """Check and predict only while the plan is shown."""
        self.part.set_watched(watched)
        self.prediction.set_watched(watched)

    @Slot()
    def undo(self) -> None:
        """Undo the last step."""
        self.stack.undo()
        self._show()

    @Slot()
    def redo(self) -> None:
        """Redo the step undone last."""
        self.stack.redo()
        self._show()

    def _show(self) -> None:
        self.changed.emit()
        self._predict()

    @Slot()
    def _predict(self) -> None:
        self.prediction.predict(self.plan)

    # edits

    def edit(self, words: str, change: Edit, select: Sequence[str] = ()) -> bool:
        """Change the plan; ``words`` name the step for undo. Returns whether it was changed; a refusal is told in the status strip."""
        if self.plan is None:
            return False
        try:
            changed = change(self.plan)
        except MeasureError as error:
            self.refuse(error)
            return False
        if changed == self.plan:
            return False
        self._push(words, changed)
        if select:
            self.selectAsked.emit(tuple(select))
        return True

    @property
    def can_add_here(self) -> bool:
        """Whether the position of the rig is known."""
        return self._session.cell.readback is not None

    def say(self, text: str, hint: str) -> None:
        """Tell why an entry cannot be used."""
        self._session.tell(text, hint, "warning")

    def refuse(self, error: MeasureError) -> None:
        """Tell why an entry cannot be taken over; editors show the former value again."""
        from pydantic import ValidationError

        cause = error.__cause__
        problem = cause.errors(include_url=False)[0] if isinstance(cause, ValidationError) else None
        if problem is not None and problem["type"] in PROBLEMS and str(problem["msg"]) in error.message:  # it names the field as files do
            words = tr("This is impossible: {problem}", problem=problem_sentence(problem))
            self._session.tell(words, error.hint, "warning")
        else:
            self._session.tell(error.message, error.hint, "warning")
        self.changed.emit()

    def duplicate(self, names: Sequence[str]) -> None:
        """Copy viewpoints or groups."""
        from measureapp.planning import edit

        made: list[str] = []

        def change(plan: ScanPlan) -> ScanPlan:
            changed, new = edit.duplicate(plan, names)
            made.extend(new)
            return changed

        if self.edit("Duplicate", change):
            self.selectAsked.emit(tuple(made))

    def add(self, viewpoint: Viewpoint, after: str | None) -> None:
        """Add a viewpoint; without a plan, begin one."""
        from measureapp.planning import edit

        try:
            changed = edit.add(self.plan, viewpoint, after, name=self._session.part or "plan")
        except MeasureError as error:
            self._session.tell(error.message, error.hint, "warning")
            return
        self._push(tr("Add {id}", id=viewpoint.id), changed)
        self.selectAsked.emit((viewpoint.id,))

    def free_name(self) -> str:
        """Return a name that no viewpoint has."""
        from measureapp.planning.plan_index import PlanIndex

        return NEW_NAME if self.plan is None else PlanIndex(self.plan).free_name(NEW_NAME)

    def add_here(self, after: str | None) -> None:
        """Add a viewpoint at the present position of the connected rig, as it was read back last."""
        from math import degrees

        from measureapp.data.plan import FlangePose, Viewpoint

        readback = self._session.cell.readback
        if readback is None:
            self._session.tell(
                "The position of the rig is not known.", "Connect the rig on the page Rig first.", "warning", remedy=SHOW_RIG
            )
            return
        flange = FlangePose.of(readback.base_from_flange)
        at = Viewpoint(id=self.free_name(), flange=flange, guide_mm=readback.guide_mm, table_deg=degrees(readback.table_rad))
        self.add(at, after)

    def add_default(self) -> None:
        """Add a viewpoint that looks at the middle of the table from the robot's side."""
        import numpy as np

        self.add_facing(np.array([0.0, 0.0, 40.0]), np.array([-1.0, 0.0, 1.0]), None)

    def add_facing(self, point_mm: np.ndarray, normal: np.ndarray, after: str | None) -> None:
        """Add a reachable viewpoint that looks at a point (3,) of the part along its surface normal."""
        from measureapp.planning.aim import viewpoint_facing

        rig = self._session.rig
        if rig is None:
            self._session.tell(*NO_RIG, "warning", remedy=SHOW_RIG)
            return
        try:
            found = viewpoint_facing(rig, self.prediction.arm_model, self.free_name(), point_mm, normal)
        except MeasureError as error:
            self._session.tell(error.message, error.hint, "warning")
            return
        self.add(found, after)

    def _push(self, words: str, plan: ScanPlan | None) -> None:
        self.stack.push(PlanStep(self, words, self.plan, plan))
        self._show()

    # the generator

    def generate(self, viewpoints: int | None, coverage: float) -> None:
        """Replace the plan by a generated one: of a number of viewpoints, or as many as the coverage needs."""
        rig, part = self._session.rig, self.part.prepared
        if rig is None or part is None:
            self._session.tell(*NO_RIG, "warning", remedy=SHOW_RIG)
            return
        if self._session.refuse_during_job():
            return
        asked = Wanted(self.plan, viewpoints, coverage)
        self._runner.run("Generating a plan", lambda job: generate(asked, rig, part, job), self._show_generated)

    @Slot(object)
    def _show_generated(self, made: GeneratedPlan) -> None:
        self._push("Generate", made.plan)
        self._session.tell(
            tr(
                "{count} {planned_share} of the surface, {planned_of_allowed} of what the rig can.",
                count=several(len(made.plan), "viewpoint measures", "viewpoints measure"),
                planned_share=percent(made.planned_share),
                planned_of_allowed=percent(made.planned_of_allowed),
            ),
            " ".join(made.problems),
            "warning" if made.problems else "done",
        )

    @Slot()
    def shorten(self) -> None:
        """Order the viewpoints so that the axes move least."""
        plan, rig = self.plan, self._session.rig
        if plan is not None and rig is not None and not self._session.refuse_during_job():
            arm = self.prediction.arm_model
            self._runner.run("Ordering the viewpoints", lambda job: order(plan, rig, arm, job), self._show_ordered)

    @Slot(object)
    def _show_ordered(self, names: list[str]) -> None:
        from measureapp.planning import edit

        self.edit("Order of the viewpoints", lambda plan: edit.reorder(plan, names))

    # files and the project

    @Slot(object)
    def open(self, path: Path) -> None:
        """Show the plan in a file; the former one comes back by undo."""

        def work(job: Job) -> tuple[Path, ScanPlan]:
            from measureapp.project.plan_file import read_plan

            job.report(0, 1, path.name)
            return path, read_plan(path)

        self._files.run(tr("Opening {name}", name=path.name), work, self._opened, quiet=True)

    @Slot(object)
    def _opened(self, found: tuple[Path, ScanPlan]) -> None:
        self.file, plan = found
        self._push(tr("Open {name}", name=self.file.name), plan)
        self._session.tell(tr("{name} is open: {count} viewpoints.", name=self.file.name, count=len(plan)), "", "done")

    @Slot(object)
    def save(self, path: Path) -> None:
        """Write the plan to a file."""
        plan = self.plan
        if plan is None:
            return

        def work(job: Job) -> Path:
            from measureapp.project.plan_file import write_plan

            job.report(0, 1, path.name)
            write_plan(path, plan)
            return path

        self._files.run(tr("Saving {name}", name=path.name), work, self._saved, quiet=True)

    @Slot(object)
    def _saved(self, path: Path) -> None:
        self.file = path
        self.stack.setClean()
        self._session.tell(tr("The plan is saved as {name}.", name=path.name), "", "done")

    @Slot()
    def use(self) -> None:
        """Scan with this plan; it is stored in the open project, if there is one."""
        plan, folder = self.plan, self._session.folder
        if plan is None or self._session.refuse_during_job():
            return

        def work(job: Job) -> ScanPlan:
            from measureapp.project.folder import ProjectFolder

            job.report(0, 1, plan.name)
            if folder is not None and (folder / "project.json").is_file():
                ProjectFolder.open(folder).save_plan(plan)
            return plan

        self._runner.run("Storing the plan", work, self._use, quiet=True)

    @Slot(object)
    def _use(self, plan: ScanPlan) -> None:
        if self._session.plan != plan:
            self._session.start_viewpoints(tuple(viewpoint.id for viewpoint in plan))
            self._session.set_plan(plan)
        where = "" if self._session.folder is None else " It is stored in the project."
        self._session.tell(
            tr("The next scan uses this plan of {count} viewpoints.{where}", count=len(plan), where=where),
            "Go on with the page Scan.",
            "done",
        )
        self.changed.emit()

    @Slot()
    def _follow_session(self) -> None:
        """Show the plan of an opened project; the former one comes back by undo."""
        plan = self._session.plan
        if plan is not None and plan != self.plan:
            self._push("Open the project's plan", plan)
        else:
            self.changed.emit()


class PlanStep(QUndoCommand):
    """One change of the plan, which is immutable: both versions are kept."""

    def __init__(self, planning: PlanningController, words: str, before: ScanPlan | None, after: ScanPlan | None) -> None:
        super().__init__(words)
        self._planning, self._before, self._after = planning, before, after

    def undo(self) -> None:
        """Show the plan before the change."""
        self._planning.plan = self._before

    def redo(self) -> None:
        """Show the plan after the change."""
        self._planning.plan = self._after
