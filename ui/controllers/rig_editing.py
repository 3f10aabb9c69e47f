"""Editing of rig descriptions: the drivers there are, permission for drivers from outside, saving."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_control import RigControl
from ui.controllers.startup import driver_row
from ui.look.language.words import tr
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription
    from measureapp.devices.plugin_loader import PluginOffer, PluginRow


class RigEditing(QObject):
    """Loads the drivers for the editor and saves what was edited; files are read and written in jobs."""

    offered = Signal(object)  # tuple[PluginOffer, ...]: all plugins, loaded
    permissionAsked = Signal(object, str)  # PluginRow, fingerprint of its files
    saved = Signal(object)  # Path
    refused = Signal(str)  # why the drivers were not listed, or the rig not saved

    def __init__(self, session: Session, runner: JobRunner, rig: RigControl, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._rig = session, runner, rig

    @Slot()
    def list_drivers(self) -> None:
        """Load every driver; `offered` follows."""
        self._runner.run("Loading the drivers", _load_all, self._offer, on_failed=self._refuse, quiet=True)

    @Slot(object)
    def ask_permission(self, row: PluginRow) -> None:
        """Compute the fingerprint of a driver from outside; `permissionAsked` follows."""

        def work(job: Job) -> tuple[PluginRow, str]:
            from measureapp.devices.plugin_permission import fingerprint

            job.check()
            return row, fingerprint(row.folder)

        self._runner.run("Reading the driver", work, self._ask, quiet=True)

    @Slot(object, str)
    def allow(self, row: PluginRow, seen: str) -> None:
        """Allow a driver whose files have this fingerprint, and load it; `offered` follows."""

        def work(job: Job) -> tuple[PluginOffer, ...]:
            from measureapp.devices.plugin_permission import allow

            allow(row.folder, seen)
            return _load_all(job)

        self._runner.run("Allowing the driver", work, self._offer, quiet=True)

    @Slot(object, object)
    def save(self, description: RigDescription, path: Path) -> None:
        """Write a description, and work with it from now on; `saved` or `refused` follows."""
        if self._session.busy_with:
            self.refused.emit(
                tr("Another task is running: {busy_with}. Save the rig when it has ended.", busy_with=self._session.busy_with)
            )
            return

        def work(job: Job) -> Path:
            from measureapp.project.rig_file import write_rig

            job.check()
            write_rig(path, description)
            return path

        self._runner.run("Saving the rig", work, self._use, on_failed=self._refuse, quiet=True)

    @Slot(object)
    def _offer(self, offers: tuple[PluginOffer, ...]) -> None:
        self._session.set_drivers(tuple(driver_row(offer.row) for offer in offers))
        self.offered.emit(offers)

    @Slot(object)
    def _ask(self, found: tuple[PluginRow, str]) -> None:
        self.permissionAsked.emit(*found)

    @Slot(object)
    def _use(self, path: Path) -> None:
        self._rig.choose(path)
        self._session.tell(tr("The rig was saved to {path}.", path=path), "", "done")
        self.saved.emit(path)

    @Slot(object)
    def _refuse(self, error: MeasureError) -> None:
        self.refused.emit(str(error))


def _load_all(job: Job) -> tuple[PluginOffer, ...]:
    from measureapp.devices.plugin_loader import load_all

    job.check()
    return load_all()
