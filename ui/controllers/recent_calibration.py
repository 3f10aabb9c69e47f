"""A calibration that was accepted while no project was open: offered again until something else is calibrated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from measureapp.errors import InputError
from ui.controllers.jobs import JobRunner
from ui.controllers.stored_sessions import newest_result
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration
    from ui.workers.job import Job


class RecentCalibrationController(QObject):
    """Finds the newest accepted calibration below the user's home, and makes it the one in use."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner

    @property
    def saved(self) -> str:
        """When the newest one was accepted (ISO 8601); empty where there is none."""
        found = newest_result()
        return "" if found is None else found[1]

    @Slot()
    def take_up(self) -> None:
        """Make it the calibration in use."""
        found = newest_result()
        if found is not None:
            self._runner.run("Opening the calibration", lambda job: read_accepted(job, found[0]), self._show, quiet=True)

    @Slot(object)
    def _show(self, found: RigCalibration | CameraArrayCalibration) -> None:
        from measureapp.data.calibration import RigCalibration

        if isinstance(found, RigCalibration):
            self._session.set_calibration(found)
        else:
            self._session.set_cameras(found)
        self._session.tell("The calibration of the last session is in use again.", "", "done")


def read_accepted(job: Job, folder: Path) -> RigCalibration | CameraArrayCalibration:
    """Read a rig, or the cameras where no rig was known; runs on a job's thread. Raises InputError where the files are damaged."""
    job.check()
    from measureapp.calibration_session.accepting import CAMERAS, RIG, read_result
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration

    found = read_result(folder if (folder / RIG).is_file() else folder / CAMERAS)
    if not isinstance(found, RigCalibration | CameraArrayCalibration):
        raise InputError(tr("{folder} holds no calibration of cameras or a rig.", folder=folder), "Calibrate again.")
    return found
