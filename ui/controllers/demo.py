"""The demo: a ready-made scan on the virtual rig, which is calibrated first."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.data.length_unit import LengthUnit, likely_unit
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_control import RigControl
from ui.controllers.scanning import ScanController
from ui.look.demo_settings import DemoSettings
from ui.look.language.words import tr
from ui.look.paths import demo_folder, next_demo_folder
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.pipeline.run import ScanRequest
    from ui.workers.job import Job


@dataclass(frozen=True)
class MeshQuestion:
    """A mesh file, the longest side of its bounding box in file units, and the likely unit."""

    path: Path
    span: float
    likely: LengthUnit


class DemoController(QObject):
    """Chooses the part and settings of the ready-made scan, and starts it as any other scan."""

    meshReady = Signal(object, object)  # Path, LengthUnit
    unitAsked = Signal(object)  # MeshQuestion

    def __init__(
        self, session: Session, runner: JobRunner, rig: RigControl, scanning: ScanController, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._rig, self._scanning = rig, scanning
        self.folder: Path | None = None
        self.settings = DemoSettings()

    @Slot(object)
    def choose(self, settings: DemoSettings) -> None:
        """Set the settings of the next run."""
        self.settings = settings

    @Slot(object)
    def inspect_mesh(self, path: Path) -> None:
        """Check whether a mesh can be used as a part, and whether its unit has to be requested."""
        self._runner.run("Reading the mesh", lambda job: read_mesh_size(path, job), self._offer_mesh)

    @Slot(object)
    def _offer_mesh(self, found: MeshQuestion) -> None:
        if found.likely is LengthUnit.MM:
            self.meshReady.emit(found.path, found.likely)
        else:
            self.unitAsked.emit(found)

    @Slot()
    def run(self) -> None:
        """Choose the virtual rig, calibrate it, scan, stitch, measure and report."""
        if self._session.refuse_during_job() or self._session.ask_about_unsaved(self.run):
            return
        settings = self.settings
        folder = next_demo_folder(self.folder or demo_folder(settings))
        self._rig.disconnect_rig()
        self._session.open_project(folder.name, settings.part, folder)
        self._scanning.run(tr("Demo: {stem}", stem=Path(settings.part).stem), lambda _job: _request(settings, folder), "demo")


def _request(settings: DemoSettings, folder: Path) -> ScanRequest:
    """Return the scan of the demo; runs on a job's thread."""
    from measureapp.pipeline.sample import SampleScan, sample_request

    chosen = SampleScan(
        settings.part,
        settings.resolution,
        settings.viewpoints,
        settings.seed,
        settings.patterns,
        settings.unit,
        conditions=settings.world,
    )
    return sample_request(chosen, folder)


def read_mesh_size(path: Path, job: Job) -> MeshQuestion:
    """Read the size of a mesh; runs on a job's thread. Raises InputError when it cannot be used."""
    import numpy as np

    from measureapp.project.geometry.files import read_mesh

    job.report(0, 1, path.name)
    span = float(np.ptp(read_mesh(path).vertices_mm, axis=0).max())
    return MeshQuestion(path, span, likely_unit(span))
