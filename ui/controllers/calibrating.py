"""The result of a wizard: evaluation, comparison with the previous calibration, acceptance."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers import result as results
from ui.controllers.collecting import CollectingController
from ui.controllers.collecting_nouns import RigSetup
from ui.controllers.demo import DemoController
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_connection import VIRTUAL, truth_of
from ui.controllers.stored_sessions import project_on_disk
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind, Known
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.data.rig import RigDescription
    from ui.look.demo_settings import Resolution
    from ui.workers.job import Job


class CalibratingController(QObject):
    """Evaluates and accepts a collected calibration."""

    concluded = Signal(object)  # Result
    checking = Signal(float)  # fraction of the cross-validation
    checked = Signal(object)  # Result after it, or as it was where the check was stopped

    def __init__(
        self, kind: Kind, session: Session, demo: DemoController, collecting: JobRunner, solving: JobRunner, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.kind = kind
        self._session, self._demo, self._solving = session, demo, solving
        self.collecting = CollectingController(kind, session, collecting, solving, self)
        self.result: results.Result | None = None
        self._job: Job | None = None
        self._check: Job | None = None  # with views held back

    @property
    def is_concluding(self) -> bool:
        """Whether the result is being evaluated."""
        return self._job is not None

    @property
    def has_previous(self) -> bool:
        """Whether there is a calibration that would be replaced."""
        return self.kind.previous(self._known) is not None

    @property
    def _known(self) -> Known:
        from measureapp.calibrate.draft.draft import Known

        return Known(self._session.cameras, self._session.calibration)

    def rig_setup(self) -> RigSetup | None:
        """Return which rig can take the images; None while it is not loaded."""
        from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder

        rig, project, settings = self._session.rig, project_on_disk(self._session), self._demo.settings
        if rig is None:
            return None
        board = DEFAULT_BOARD if project is None else ProjectFolder.open(project).settings.board
        resolution = self._calibrated_resolution(rig) or settings.resolution
        return RigSetup(rig.name, rig.driver == VIRTUAL, project is not None, resolution, settings.seed, board)

    def _calibrated_resolution(self, rig: RigDescription) -> Resolution | None:
        """Return the resolution at which the cameras were calibrated, where this wizard keeps them fixed."""
        from measureapp.data.rig import BINNING

        known = self._session.cameras
        if known is None or not self.kind.needs:
            return None
        width = known.cameras[known.reference].pinhole.width_px
        own = next((camera for camera in rig.cameras if camera.name == known.reference), None)
        return None if own is None else next((one for one, factor in BINNING.items() if own.width_px // factor == width), None)

    @property
    def is_checking(self) -> bool:
        """Whether the result is being checked with views held back."""
        return self._check is not None

    def forget_result(self) -> None:
        """Begin without a result."""
        self.stop_check()
        self.result = None

    def conclude(self) -> None:
        """Solve the collected observations from scratch and evaluate the result."""
        collected, rig = self.collecting.collected, self.collecting.capture.rig
        if collected is None or self._job is not None:
            return
        self.forget_result()
        snapshot, known = collected.snapshot(), self._known
        self._job = self._solving.run(
            "Evaluating the result",
            lambda job: results.conclude(job, snapshot, known, _truth_of(rig, snapshot)),
            self._keep,
            on_stopped=self._end_job,
            on_failed=self._tell_failure,
            quiet=True,
        )
        self._job.progressed.connect(self.collecting.progressed)
        self.collecting.changed.emit()

    @Slot(object)
    def _keep(self, found: results.Result) -> None:
        self._job, self.result = None, found
        if found.snapshot.setup.lenses:
            self._check = self._solving.run(
                "Checking with views held back",
                lambda job: results.cross_validate(job, found),
                self._keep_checked,
                on_stopped=self._check_stopped,
                quiet=True,
            )
            self._check.progressed.connect(self._show_check)
        self.concluded.emit(found)

    @Slot(float, str)
    def _show_check(self, share: float, _note: str) -> None:
        if self.is_checking:
            self.checking.emit(share)

    @Slot(object)
    def _keep_checked(self, found: results.Result) -> None:
        if self.sender() is self._check and self.result is not None:
            self._check, self.result = None, found
            self.checked.emit(found)

    @Slot()
    def _check_stopped(self) -> None:
        if self.sender() is self._check:
            self._check = None
            self.checked.emit(self.result)

    def stop_check(self) -> None:
        """End the check with views held back; the result stays as it is."""
        if self._check is not None:
            self._check.cancel()

    @Slot()
    def _end_job(self) -> None:
        self._job = None
        self.collecting.changed.emit()

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        self.collecting.told.emit(error.message, error.hint, "error")

    def accept(self) -> bool:
        """Make the result the calibration of the session and of the open project; returns whether that succeeded."""
        if self.result is None:
            return False
        try:
            words = results.accept(self.result, self._session)
        except MeasureError as error:
            self.collecting.told.emit(error.message, error.hint, "error")
            return False
        self._session.tell(*words, "done")
        return True

    def close(self) -> None:
        """Stop running jobs; everything collected is on disk."""
        if self._job is not None:
            self._job.cancel()
        self.forget_result()
        self.collecting.close()


def _truth_of(rig: RigDescription | None, snapshot: Snapshot) -> Known:
    """Return the ground truth of a virtual rig for display; runs on a job's thread."""
    from measureapp.calibrate.draft.draft import Known

    truth = None if rig is None else truth_of(rig, snapshot.setup.board)
    return Known() if truth is None else Known(truth.cameras, truth)
