"""What is wrong with the plan, and what it would see of the part; found in the background after every edit."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.plan_part import PlanPart, PreparedPart
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.geometry.kinematics.arm import ArmModel
    from measureapp.pipeline.plan_check import PlanCheck

AFTER_EDIT_MS = 120  # so that held-down arrows do not start a check each
MOST_VIEWPOINTS = 500  # whose coverage is predicted
KEPT_VIEWS = 1000
Key = tuple["FlangePose", float, float]


@dataclass(frozen=True, eq=False)
class Prediction:
    """What was found for one plan."""

    plan: ScanPlan
    check: PlanCheck
    seen: np.ndarray | None = None  # (V, N) bool, which samples of the part each viewpoint measures; None: no nominal, or too many
    reason: np.ndarray | None = None  # (V, N) uint8, `Unseen`
    coverage: float | None = None  # share of the surface
    twice: float | None = None  # share that two viewpoints or more see
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
        self.share_done = 1.0
        self._plan: ScanPlan | None = None
        self._job: Job | None = None
        self._seen = SeenCache()
        self._arm: tuple[RigDescription, ArmModel | None] | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(AFTER_EDIT_MS)
        self._timer.timeout.connect(self._start)

    @property
    def is_current(self) -> bool:
        """Whether what was found belongs to the plan shown."""
        return self.now is not None and self.now.plan is self._plan and self._job is None and not self._timer.isActive()

    def arm(self) -> ArmModel | None:
        """Return the model of the rig's robot; None without one."""
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
        self._timer.start()

    @Slot()
    def _start(self) -> None:
        plan, rig, part = self._plan, self._session.rig, self._part.prepared
        if plan is None or rig is None:
            return
        if self._job is not None:
            self._timer.start()  # the cancelled one has not ended yet
            return
        arm, cache = self.arm(), self._seen
        self._job = self._runner.run(
            "Checking the plan",
            lambda job: _predict(plan, rig, arm, part, cache, job),
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


class SeenCache:
    """What single viewpoints see, so that an edit of one does not compute the others again. Used by one job at a time."""

    def __init__(self) -> None:
        self._of: tuple[PreparedPart, RigDescription] | None = None
        self._kept: OrderedDict[Key, np.ndarray] = OrderedDict()

    def begin(self, part: PreparedPart, rig: RigDescription) -> None:
        """Forget what belongs to another part or rig."""
        if self._of is None or self._of[0] is not part or self._of[1] is not rig:
            self._of = (part, rig)
            self._kept.clear()

    def reasons(self, viewpoints: tuple[Viewpoint, ...], job: Job) -> np.ndarray:
        """Return the reasons (V, N) of all viewpoints, an `Unseen` each."""
        from measureapp.planning.coverage.visibility import seen_by

        assert self._of is not None
        part, rig = self._of
        missing = {key: viewpoint for viewpoint in viewpoints if (key := _key(viewpoint)) not in self._kept}
        if missing:
            found = seen_by(tuple(missing.values()), part.samples, rig, part.scene, progress=job)
            self._kept |= dict(zip(missing, found.reason, strict=True))
        rows = [self._kept[_key(viewpoint)] for viewpoint in viewpoints]
        while len(self._kept) > max(KEPT_VIEWS, len(viewpoints)):
            self._kept.popitem(last=False)
        return np.stack(rows)


def _key(viewpoint: Viewpoint) -> Key:
    return viewpoint.flange, viewpoint.guide_mm, viewpoint.table_deg


def _predict(plan: ScanPlan, rig: RigDescription, arm: ArmModel | None, part: PreparedPart | None, cache: SeenCache, job: Job) -> Prediction:
    """Check a plan and predict its coverage; runs on a job's thread."""
    from measureapp.pipeline.plan_check import check_plan_on_rig

    check = check_plan_on_rig(plan, rig, arm, job)
    if part is None:
        return Prediction(plan, check, note="Choose the nominal of the part to see the predicted coverage.")
    if len(plan) > MOST_VIEWPOINTS:
        return Prediction(plan, check, note=f"Coverage is predicted for up to {MOST_VIEWPOINTS} viewpoints.")
    job.emit_event(Prediction(plan, check, note="The coverage is being predicted…"))
    cache.begin(part, rig)
    viewpoints = tuple(plan)
    reason = cache.reasons(viewpoints, job)
    blocked = np.array([bool(check.of(viewpoint.id)) for viewpoint in viewpoints])
    counts = np.count_nonzero(reason[~blocked] == 0, axis=0)  # what cannot be reached measures nothing
    areas = part.samples.areas_mm2
    return Prediction(
        plan, check, reason == 0, reason, float(areas[counts > 0].sum() / areas.sum()), float(areas[counts > 1].sum() / areas.sum())
    )
