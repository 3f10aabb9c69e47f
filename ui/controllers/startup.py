"""Background tasks after the window is shown: heavy imports, the rig, the drivers, compilation of kernels."""

from __future__ import annotations

import gc
import importlib
import importlib.util
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from measureapp.open3d_library import open3d
from measureapp.progress import PartOf, Progress
from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import DriverRow, Session

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription
    from measureapp.devices.plugin_loader import PluginRow
    from ui.workers.job import Job

OPEN3D = "open3d"
WARM_UP = (
    *("scipy.optimize", "scipy.spatial", "numba", OPEN3D, "trimesh", "measureapp.pipeline.warm_up", "measureapp.pipeline.sample"),
    *("measureapp.fringe.patterns.check", "measureapp.planning.edit", "measureapp.planning.frusta"),  # the first click on the page Plan
    *("measureapp.pipeline.plan_check", "measureapp.pipeline.plan_coverage", "measureapp.project.calibration.certificate_file"),  # a wizard
    *("measureapp.planning.coverage.head", "measureapp.acquire.control", "measureapp.acquire.time_left", "ui.charts.plotting"),
    *("measureapp.inspection.programming.edits", "ui.wizards.wizard"),  # the first edit of a dimension; the first wizard
)
IMPORTED_SHARE = 0.3
LONGEST_YIELD_S, YIELD_S = 20.0, 0.05
DEFAULT_RIG = "paper"
NEVER = 1_000_000


class StartupController(QObject):
    """Loads everything that is not needed to show the window."""

    rigLoaded = Signal()  # or that it could not be
    imported = Signal()  # all packages; no thread holds the interpreter for long any more

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner = runner
        self.is_window_filling = False  # the window makes its pages; loading kernels would hold the interpreter meanwhile

    @Slot()
    def begin(self) -> None:
        """Load the rig, which the window displays before it is told to `go_on`."""
        self._runner.run("Loading the rig", load_rig, self._show_rig, on_stopped=self._lack_rig, quiet=True)

    @Slot()
    def go_on(self) -> None:
        """Load the 3-D view, then prepare for the first measurement."""
        self._runner.run("Preparing the 3-D view", load_graphics, self._graphics_ready, on_stopped=self._graphics_failed, quiet=True)
        self._prepare(import_all, self._show_imported)

    def _prepare(self, work: Callable[[Progress], None], show: Callable[[object], None]) -> None:
        self._runner.run("Preparing the measurement", lambda job: work(Yielding(job, self._is_waited_for)), show, quiet=True)

    def _is_waited_for(self) -> bool:
        return self.is_window_filling or bool(self._session.busy_with)

    @Slot(object)
    def _show_rig(self, found: tuple[RigDescription | None, tuple[DriverRow, ...]]) -> None:
        rig, drivers = found
        if self._session.rig is None:
            self._session.set_rig(rig, drivers)
        else:
            self._session.set_drivers(drivers)
        self.rigLoaded.emit()

    @Slot()
    def _lack_rig(self) -> None:
        self.rigLoaded.emit()

    @Slot(object)
    def _graphics_ready(self, problem: str) -> None:
        self._session.set_graphics("failed" if problem else "ready", problem)

    @Slot()
    def _graphics_failed(self) -> None:
        self._session.set_graphics("failed", "The 3-D view could not be loaded. Install the graphics libraries listed in the help.")

    @Slot(object)
    def _show_imported(self, _nothing: object) -> None:
        self.imported.emit()
        self._prepare(load_kernels, self._warm)

    @Slot(object)
    def _warm(self, _nothing: object) -> None:
        self._session.tell("Ready.")


def load_rig(job: Job) -> tuple[RigDescription | None, tuple[DriverRow, ...]]:
    """Read the default rig and list the drivers; runs on a job's thread."""
    job.check()
    with made_to_last():
        from measureapp.project.rig_file import read_rig

        return read_rig(DEFAULT_RIG), list_drivers()


def list_drivers() -> tuple[DriverRow, ...]:
    """List all driver plugins, with the reason for those that cannot be loaded."""
    from measureapp.devices.plugin_loader import examine

    return tuple(driver_row(found) for found in examine())


def driver_row(found: PluginRow) -> DriverRow:
    """Return one row of the list of drivers."""
    return DriverRow(found.id, ", ".join(found.kinds), found.version, f"{found.problem} {found.hint}".strip(), found.allowed)


def load_graphics(job: Job) -> str:
    """Import VTK, which takes a second; runs on a job's thread. Returns the problem, if any."""
    job.check()
    with made_to_last():
        from ui.viewport.backend import missing_graphics

        return missing_graphics()


@contextmanager
def made_to_last() -> Iterator[None]:
    """Keep the garbage collector from searching what is imported meanwhile, now and later.

    Modules stay until the end. Python searches all of them for garbage whenever there is a quarter more, 0.1 to 0.2 s each time, while the window stands still.
    """
    kept = gc.get_threshold()
    gc.set_threshold(*kept[:2], NEVER)
    try:
        yield
    finally:
        gc.freeze()
        gc.set_threshold(*kept)


class Yielding:
    """Progress of work in the background that waits, between its steps, for a job that somebody is waiting for."""

    def __init__(self, progress: Progress, is_waited_for: Callable[[], bool]) -> None:
        self._progress, self._is_waited_for = progress, is_waited_for

    def report(self, done: float, total: float, note: str = "") -> None:
        """Report, then wait, for `LONGEST_YIELD_S` at most, because a long job needs the kernels itself."""
        self._progress.report(done, total, note)
        end = time.monotonic() + LONGEST_YIELD_S
        while self._is_waited_for() and time.monotonic() < end:
            time.sleep(YIELD_S)
            self._progress.check()

    def check(self) -> None:
        """Raise Cancelled if the work is cancelled."""
        self._progress.check()


def import_all(job: Progress) -> None:
    """Import the packages of the first measurement; runs on a job's thread."""
    with made_to_last():
        for done, name in enumerate(WARM_UP):
            job.report(IMPORTED_SHARE * done, len(WARM_UP), "Preparing the measurement")
            if importlib.util.find_spec(name) is None:
                raise MeasureError(
                    tr("The package {name} is missing.", name=name), "Run `python3 installer/bootstrap.py run` to repair the installation."
                )
            open3d() if name == OPEN3D else importlib.import_module(name)


def load_kernels(job: Progress) -> None:
    """Compile or load the kernels of the first measurement; runs on a job's thread."""
    from measureapp.pipeline.compile_apart import compile_apart
    from measureapp.pipeline.warm_up import warm_up

    job.report(IMPORTED_SHARE, 1.0, "Preparing the measurement")  # waits for the window
    compile_apart(job)
    warm_up(PartOf(job, IMPORTED_SHARE, 1.0, "Preparing the measurement: "))
