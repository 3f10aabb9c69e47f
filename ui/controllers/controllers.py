"""All controllers of the window, built once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QElapsedTimer, QObject

from ui.controllers.calibrating import CalibratingController
from ui.controllers.comparison import ComparisonController
from ui.controllers.contouring import ContouringController
from ui.controllers.creating import CreatingController
from ui.controllers.demo import DemoController
from ui.controllers.documents import DocumentsController
from ui.controllers.extending import ExtendingController
from ui.controllers.files import FilesController
from ui.controllers.filtering import FilteringController
from ui.controllers.growing import GrowingController
from ui.controllers.holes import HolesController
from ui.controllers.images import ImagesController
from ui.controllers.jobs import JobRunner
from ui.controllers.nominal import NominalController
from ui.controllers.operator import OperatorController
from ui.controllers.operator_roles import RoleController
from ui.controllers.planning import PlanningController
from ui.controllers.programming import ProgrammingController
from ui.controllers.project import ProjectController
from ui.controllers.recent_calibration import RecentCalibrationController
from ui.controllers.repeats import RepeatsController
from ui.controllers.rig_calibrating import RigCalibratingController
from ui.controllers.rig_control import RigControl
from ui.controllers.rig_editing import RigEditing
from ui.controllers.scanning import ScanController
from ui.controllers.series import SeriesController
from ui.controllers.startup import StartupController
from ui.controllers.stored_images import StoredImagesController
from ui.controllers.tolerancing import Tolerancing
from ui.controllers.view_choices import ViewChoicesController
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind


class Controllers(QObject):
    """All controllers and their job queues."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.jobs = JobRunner(session, self)
        self.background = JobRunner(session, self)
        self.preparing = JobRunner(session, self)  # compiling kernels takes minutes at the first start: nothing waits behind it
        self.drawing = JobRunner(session, self)
        self.explaining = JobRunner(session, self)
        self.imaging = JobRunner(session, self)
        self.solving = JobRunner(session, self)
        self.editing = JobRunner(session, self)
        self.predicting = JobRunner(session, self)
        self.inspecting = JobRunner(session, self)
        self.operating = JobRunner(session, self)
        self.rig = RigControl(session, self.jobs, self)
        self.rig_editing = RigEditing(session, self.editing, self.rig, self)
        self.scanning = ScanController(session, self.jobs, self.background, self.rig, self)
        self.repeats = RepeatsController(session, self.jobs, self.scanning, self)
        self.series = SeriesController(session, self.jobs, self.background, self)
        self.extending = ExtendingController(session, self.jobs, self.scanning, self)
        self.rig_calibrating = RigCalibratingController(session, self.jobs, self.rig, self)
        self.demo = DemoController(session, self.jobs, self.rig, self.scanning, self)
        self.project = ProjectController(session, self.jobs, self)
        self.documents = DocumentsController(session, self.jobs, self.background, self)
        self.comparison = ComparisonController(session, self.background, self)
        self.stored_images = StoredImagesController(session, self.background, self)
        self.holes = HolesController(session, self.explaining, self)
        self.images = ImagesController(session, self.imaging, self)
        self.view_choices = ViewChoicesController(session, self.jobs, self)
        self.files = FilesController(session, self.jobs, self)
        self.filtering = FilteringController(session, self.jobs, self)
        self.growing = GrowingController(session, self.jobs, self)
        self.programming = ProgrammingController(session, self.jobs, self.inspecting, self)
        self.nominal = NominalController(session, self.jobs, self.programming, self)
        self.creating = CreatingController(session, self.drawing, self.programming, self)
        self.contouring = ContouringController(session, self.drawing, self.programming, self)
        self.tolerancing = Tolerancing(session, self.programming)
        self.planning = PlanningController(session, self.jobs, self.predicting, self.background, self)
        self.roles = RoleController(session, self.operating, self.jobs, self)
        self.operator = OperatorController(session, self.operating, self.jobs, self.scanning, self.rig, self)
        self._session, self._calibrating = session, dict[str, CalibratingController]()
        self.recent_calibration = RecentCalibrationController(session, self.background, self)
        self.startup = StartupController(session, self.preparing, self)

    def calibrating(self, kind: Kind) -> CalibratingController:
        """Return the controller of one kind of calibration; it is made when first used."""
        if kind.name not in self._calibrating:
            made = CalibratingController(kind, self._session, self.demo, self.jobs, self.solving, self)
            self._calibrating[kind.name] = made
        return self._calibrating[kind.name]

    @property
    def runners(self) -> tuple[JobRunner, ...]:
        """All queues: foreground and background jobs, start, drawing, explanation of views, images, solving, editing, plans, inspection, operator mode."""
        return (
            self.jobs,
            self.background,
            self.preparing,
            self.drawing,
            self.explaining,
            self.imaging,
            self.solving,
            self.editing,
            self.predicting,
            self.inspecting,
            self.operating,
        )

    def end(self, timeout_ms: int) -> bool:
        """Cancel all jobs and wait for their threads; return whether all have ended. The compilation of a kernel cannot be interrupted."""
        self.planning.prediction.stop()
        self.roles.end()
        for runner in self.runners:
            runner.queue.close()
        clock = QElapsedTimer()
        clock.start()
        ended = all(runner.queue.wait(max(0, timeout_ms - clock.elapsed())) for runner in self.runners)
        self.rig.close()
        return ended
