"""What is wrong with the plan, and what it would see of the part; found in the background after every edit."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.plan_part import PlanPart, PreparedPart
from ui.look.language.words import tr
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.geometry.kinematics.arm import ArmModel
    from measureapp.pipeline.plan_check import PlanCheck, PlanChecker
    from measureapp.pipeline.plan_coverage import PlanCoverage

AFTER_EDIT_MS = 120  # so that held-down arrows do not start a check each
MOST_VIEWPOINTS = 500  # whose coverage is predicted
KEPT_VIEWS = 1000
Key = tuple["FlangePose", float, float]


@dataclass(frozen=True, eq=False)
class Prediction:
    """What was found for one plan."""

    plan: ScanPlan
    check: PlanCheck
    checker: PlanChecker  # with the bodies of the cell
    part: PreparedPart | None
    coverage: PlanCoverage | None = None
    note: str = ""  # why there is no coverage

    def row(self, viewpoint_id: str) -> int:
        """Return the number of a viewpoint in the plan; -1 if it has none of this name."""
        return next((number for number, viewpoint in enumerate(self.plan) if viewpoint.id == viewpoint_id), -1)


class PlanPrediction(QObject):
    """Checks the newest plan; a check of an older one is cancelled."""

    changed = Signal()

    def __init__(self, session: Session, runner: JobRunner, part: PlanPart, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._part = session, runner, part
        self.now: Prediction | None = None
        self._plan: ScanPlan | None = None
        self._job: Job | None = None
        self._known = Known()
        self._is_watched = False
        self._arm: tuple[RigDescription, ArmModel | None] | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(AFTER_EDIT_MS)
        self._timer.timeout.connect(self._start)

    @property
    def is_current(self) -> bool:
        """Whether what was found belongs to the plan shown."""
        return self.now is not None and self.now.plan is self._plan and self._job is None and not self._timer.isActive()

    @property
    def arm_model(self) -> ArmModel | None:
        """The model of the rig's robot; None without one."""
        from measureapp.errors import MeasureError
        from measureapp.project.geometry.robot_file import arm_of

        rig = self._session.rig
        if rig is None:
            return None
        if self._arm is None or self._arm[0] is not rig:
            try:
                self._arm = (rig, arm_of(rig))
            except MeasureError as error:
                self._session.tell(error.message, error.hint, "error")
                self._arm = (rig, None)
        return self._arm[1]

    def predict(self, plan: ScanPlan | None) -> None:
        """Check a plan soon."""
        self._plan = plan
        if self._job is not None:
            self._job.cancel()
        if plan is None:
            self.now = None
            self.changed.emit()
            return
        if self._is_watched:
            self._timer.start()

    def set_watched(self, watched: bool) -> None:
        """Check only while somebody looks at the plan; what was left out is made up for."""
        self._is_watched = watched
        if watched and self._plan is not None and not self.is_current:
            self._timer.start()

    def stop(self) -> None:
        """Check nothing any more; the window is being closed."""
        self._plan = None
        self._timer.stop()
        if self._job is not None:
            self._job.cancel()

    @Slot()
    def _start(self) -> None:
        plan, rig, part = self._plan, self._session.rig, self._part.prepared
        if plan is None or rig is None:
            return
        if self._job is not None:
            self._timer.start()  # the cancelled one has not ended yet
            return
        arm, known = self.arm_model, self._known
        self._job = self._runner.run(
            "Checking the plan",
            lambda job: _predict(plan, Cell(rig, arm, part), known, job),
            self._show,
            on_event=self._show_check,
            on_stopped=self._end,
            quiet=True,
        )
        self.changed.emit()

    @Slot(object)
    def _show_check(self, found: Prediction) -> None:
        """Show limits at once; the coverage comes later."""
        if found.plan is self._plan:
            self.now = found
            self.changed.emit()

    @Slot(object)
    def _show(self, found: Prediction) -> None:
        self._job = None
        if found.plan is self._plan:
            self.now = found
        self.changed.emit()

    @Slot()
    def _end(self) -> None:
        self._job = None
        self.changed.emit()


@dataclass(frozen=True, eq=False)
class Cell:
    """The rig and the part for which a plan is checked."""

    rig: RigDescription
    arm: ArmModel | None
    part: PreparedPart | None

    def is_same(self, other: Cell) -> bool:
        """Whether what was found for one is valid for the other."""
        return self.rig is other.rig and self.part is other.part


class Known:
    """What was found about single viewpoints and moves, so that an edit of one does not check the others again. Used by one job at a time."""

    def __init__(self) -> None:
        self._cell: Cell | None = None
        self._checker: PlanChecker | None = None
        self._seen: OrderedDict[Key, np.ndarray] = OrderedDict()

    def checker(self, cell: Cell) -> PlanChecker:
        """Return the checker of a cell; what belongs to another rig or part is forgotten."""
        from measureapp.pipeline.plan_check import PlanChecker

        if self._checker is None or self._cell is None or not self._cell.is_same(cell):
            self._checker = PlanChecker(cell.rig, cell.arm, None if cell.part is None else cell.part.solid)
            self._cell = cell
            self._seen.clear()
        return self._checker

    def reasons(self, part: PreparedPart, rig: RigDescription, viewpoints: tuple[Viewpoint, ...], job: Job) -> np.ndarray:
        """Return the reasons (V, N) of all viewpoints, an `Unseen` each."""
        from measureapp.planning.coverage.visibility import seen_by

        missing = {key: viewpoint for viewpoint in viewpoints if (key := _key(viewpoint)) not in self._seen}
        if missing:
            found = seen_by(tuple(missing.values()), part.samples, rig, part.scene, progress=job)
            self._seen |= dict(zip(missing, found.reason, strict=True))
        rows = [self._seen[_key(viewpoint)] for viewpoint in viewpoints]
        while len(self._seen) > max(KEPT_VIEWS, len(viewpoints)):
            self._seen.popitem(last=False)
        return np.stack(rows)


def _key(viewpoint: Viewpoint) -> Key:
    return viewpoint.flange, viewpoint.guide_mm, viewpoint.table_deg


def _predict(plan: ScanPlan, cell: Cell, known: Known, job: Job) -> Prediction:
    """Check a plan and predict its coverage; runs on a job's thread."""
    from measureapp.pipeline.plan_coverage import PlanCoverage

    checker, part = known.checker(cell), cell.part
    found = Prediction(plan, checker.check(plan, job), checker, part)
    if part is None:
        return replace(found, note="Choose the nominal of the part to see the predicted coverage.")
    if len(plan) > MOST_VIEWPOINTS:
        return replace(found, note=tr("Coverage is predicted for up to {most_viewpoints} viewpoints.", most_viewpoints=MOST_VIEWPOINTS))
    job.emit_event(replace(found, note="The coverage is being predicted…"))
    viewpoints = tuple(plan)
    sentences = found.check.sentences()
    blocked = np.array([viewpoint.id in sentences for viewpoint in viewpoints])
    return replace(found, coverage=PlanCoverage.of(known.reasons(part, cell.rig, viewpoints, job), part.samples, blocked))
