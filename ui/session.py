"""The mutable model of the window. Controllers change it, widgets observe it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, Signal

from ui.look.language.words import spoken, tr
from ui.messages import BUSY, CALIBRATION, CANCEL, DEVICES, PROJECT, STOPPED, Level, Message, Messages
from ui.settings.settings import AS_WINDOW, Settings
from ui.workers.mailbox import Mailboxes

if TYPE_CHECKING:
    import numpy as np

    from measureapp.acquire.events import ImageTaken
    from measureapp.acquire.states import DeviceState
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.deviation_scale import DeviationScale
    from measureapp.data.fringe import AxisReadback
    from measureapp.data.measurement import Inspection, Measurement, ViewResult
    from measureapp.data.plan import ScanPlan
    from measureapp.data.rig import RigDescription
    from measureapp.data.validity import Validity
    from measureapp.devices.rig import Rig
    from measureapp.inspection.section_curves import SectionCurves
    from measureapp.inspection.surface.deviation import Deviation
    from measureapp.inspection.surface.deviation_index import DeviationIndex
    from measureapp.inspection.surface.deviation_map import DeviationMap
    from measureapp.inspection.surface.nominal import NominalSurface
    from measureapp.inspection.surface.smoothing import Smoothed
    from measureapp.inspection.surface.statistics import DeviationStatistics
    from measureapp.register.clouds.filter_chain import FilterChain

ViewpointStatus = Literal["waiting", "moving", "settling", "capturing", "checking", "storing", "stored", "processed", "skipped", "failed"]
RunState = Literal["idle", "running", "pausing", "paused"]
Role = Literal["operator", "engineer"]
GraphicsState = Literal["preparing", "ready", "failed"]


def _usual_scale() -> DeviationScale:
    from measureapp.data.deviation_scale import DeviationScale  # brings pydantic, for which the window does not wait

    return DeviationScale()


@dataclass(frozen=True, eq=False)
class Comparison:
    """Deviations of one cloud from the nominal, and the areas of the nominal that were not measured."""

    stitched: StitchedCloud
    deviation: Deviation
    unmeasured_mm: np.ndarray  # (M, 3), in the nominal frame
    unmeasured_normals: np.ndarray  # (M, 3)
    surface: NominalSurface | None = None  # the drawing, ready to be cut
    sections: SectionCurves | None = None  # of the inspection program
    index: DeviationIndex | None = None  # neighbours of the points, for probes
    statistics: DeviationStatistics | None = None  # the numbers of legend, window, report and JSON
    smoothed: Smoothed | None = None  # for the eye only
    map: DeviationMap | None = None  # on the nominal
    scale: DeviationScale = field(default_factory=_usual_scale)  # of the inspection program


@dataclass(frozen=True)
class ViewpointState:
    """Progress of one viewpoint."""

    id: str
    status: ViewpointStatus = "waiting"
    note: str = ""


@dataclass(frozen=True)
class RunNow:
    """The run of a plan at this moment; a pause has a cause and a remedy."""

    state: RunState = "idle"
    cause: str = ""
    remedy: str = ""


@dataclass(frozen=True)
class DriverRow:
    """One device driver, or the reason why it could not be loaded."""

    name: str
    kind: str
    version: str = ""
    problem: str = ""
    allowed: bool = True  # False: a driver from outside that nobody has allowed yet


@dataclass(frozen=True)
class CellState:
    """What is known of the connected rig: its devices, where it stands, and why it was stopped."""

    connected: bool = False
    devices: tuple[DeviceState, ...] = ()
    readback: AxisReadback | None = None
    stopped: str = ""  # reason; empty while the rig may run
    live: bool = False  # images are being shown


class Session(QObject):
    """The open project with its results so far."""

    projectChanged = Signal()
    rigChanged = Signal()
    cellChanged = Signal()
    planChanged = Signal()
    calibrationChanged = Signal()
    viewpointsChanged = Signal()
    runChanged = Signal()
    cloudsChanged = Signal()
    inspectionChanged = Signal()
    reportChanged = Signal()
    comparisonChanged = Signal()
    busyChanged = Signal()
    messageAdded = Signal(object)
    graphicsChanged = Signal()
    appearanceChanged = Signal()
    unsavedAsked = Signal(object)  # what goes on when edits are saved or discarded

    def __init__(self, settings: Settings | None = None, parent: QObject | None = None) -> None:
        """``settings``: what is remembered from start to start; None: only while the program runs."""
        super().__init__(parent)
        self.settings = settings or Settings()
        self.images: Mailboxes[ImageTaken] = Mailboxes()  # one for each camera
        self.messages = Messages(self)
        self.messages.added.connect(self.messageAdded)
        self.is_letting_go = False  # of a closed project: even what is out of sight must not keep it
        self.busy_with = ""
        self.unsaved = ""  # what would be lost with the open project, in a sentence
        self.role: Role = "engineer"
        self.graphics: GraphicsState = "preparing"
        self.graphics_problem = ""
        self.rig: RigDescription | None = None
        self.rig_file: Path | None = None  # of the user; None: it comes with the program or from a project
        self.cell = CellState()
        self.connection: Rig | None = None  # of the Rig page
        self.moving = False  # a job runs that may move axes
        self.run = RunNow()
        self.drivers: tuple[DriverRow, ...] = ()
        self._reset()

    @property
    def scale_ppm(self) -> float:
        """Relative standard uncertainty of all lengths from board or rig, in ppm; 0: exact."""
        from measureapp.pipeline.lengths import length_scale

        return length_scale(self.cameras, self.rig).ppm

    @property
    def report_language(self) -> str:
        """Language of the reports that people read: the chosen one, else that of the window."""
        chosen = self.settings.text("report_language")
        return spoken() if chosen == AS_WINDOW else chosen

    def _emit_results_changed(self) -> None:
        """Emit the change signals of everything computed from the images."""
        for signal in (
            self.calibrationChanged,
            self.viewpointsChanged,
            self.cloudsChanged,
            self.inspectionChanged,
            self.reportChanged,
            self.comparisonChanged,
        ):
            signal.emit()

    def _reset(self) -> None:
        self.project_name = ""
        self.part = ""
        self.folder: Path | None = None
        self.plan: ScanPlan | None = None
        self.calibration: RigCalibration | None = None
        self.validity: Validity | None = None
        self.cameras: CameraArrayCalibration | None = None  # of the calibration, or calibrated alone
        self.viewpoints: dict[str, ViewpointState] = {}
        self.views: tuple[ViewResult, ...] = ()
        self.stitched: StitchedCloud | None = None
        self.filters: FilterChain | None = None  # of the stitched cloud
        self.filtered: StitchedCloud | None = None  # after the filters
        self.inspection: Inspection | None = None
        self.measurement: Measurement | None = None
        self.comparison: Comparison | None = None
        self.files: Mapping[str, Path] = {}

    def open_project(self, name: str, part: str, folder: Path | None) -> None:
        """Replace the open project; all data of the former one is discarded."""
        self._reset()
        self.messages.end(PROJECT)
        self.project_name, self.part, self.folder = name, part, folder
        self.is_letting_go = True
        try:
            self.projectChanged.emit()
            self.planChanged.emit()
            self._emit_results_changed()
        finally:
            self.is_letting_go = False

    def set_rig(self, rig: RigDescription | None, drivers: tuple[DriverRow, ...] | None = None, file: Path | None = None) -> None:
        """Set the rig, the user's file that describes it, and the drivers."""
        self.rig, self.rig_file = rig, file
        self.drivers = self.drivers if drivers is None else drivers
        self.rigChanged.emit()

    def set_drivers(self, drivers: tuple[DriverRow, ...]) -> None:
        """Set the list of drivers."""
        self.drivers = drivers
        self.rigChanged.emit()

    def set_cell(self, cell: CellState) -> None:
        """Set what is known of the connected rig."""
        self.cell = cell
        if not cell.connected or all(device.status.ready for device in cell.devices):
            self.messages.end(DEVICES)
        if not cell.stopped:
            self.messages.end(STOPPED)
        self.cellChanged.emit()

    def set_moving(self, moving: bool) -> None:
        """Set whether a job runs that may move axes."""
        if moving != self.moving:
            self.moving = moving
            self.cellChanged.emit()

    def set_plan(self, plan: ScanPlan | None) -> None:
        """Set the scan plan."""
        self.plan = plan
        if plan is not None and not self.viewpoints:
            self.start_viewpoints(tuple(viewpoint.id for viewpoint in plan))
        self.planChanged.emit()

    def set_calibration(self, calibration: RigCalibration | None) -> None:
        """Set the calibration of the rig, which resets its validity."""
        self.messages.end(CALIBRATION)
        self.calibration, self.validity = calibration, None
        self.cameras = None if calibration is None else calibration.cameras
        self.calibrationChanged.emit()

    def set_cameras(self, cameras: CameraArrayCalibration) -> None:
        """Set the calibration of the cameras, for a rig that is not calibrated."""
        self.cameras = cameras
        self.calibrationChanged.emit()

    def set_validity(self, validity: Validity | None) -> None:
        """Set the validity of the calibration."""
        self.validity = validity
        self.calibrationChanged.emit()

    def start_viewpoints(self, ids: tuple[str, ...]) -> None:
        """Set all viewpoints to waiting, in scan order."""
        self.viewpoints = {id_: ViewpointState(id_) for id_ in ids}
        self.viewpointsChanged.emit()

    def await_viewpoints(self, ids: tuple[str, ...]) -> None:
        """Set these viewpoints to waiting; others keep their state, in the order of the plan."""
        known = {**self.viewpoints, **{id_: ViewpointState(id_) for id_ in ids}}
        planned = [viewpoint.id for viewpoint in self.plan] if self.plan is not None else []
        ordered = [id_ for id_ in planned if id_ in known]
        self.viewpoints = {id_: known[id_] for id_ in (*ordered, *(id_ for id_ in known if id_ not in ordered))}
        self.viewpointsChanged.emit()

    def set_run(self, run: RunNow) -> None:
        """Set the state of the run."""
        self.run = run
        self.runChanged.emit()

    def set_viewpoint(self, id_: str, status: ViewpointStatus, note: str = "") -> None:
        """Set the progress of one viewpoint."""
        self.viewpoints[id_] = ViewpointState(id_, status, note)
        self.viewpointsChanged.emit()

    def set_stored(self, ids: Iterable[str]) -> None:
        """Set viewpoints whose images are stored, all at once."""
        self.viewpoints |= {id_: ViewpointState(id_, "stored") for id_ in ids}
        self.viewpointsChanged.emit()

    def add_view(self, view: ViewResult) -> None:
        """Add the cloud of one viewpoint, or replace it."""
        self.views = (*(old for old in self.views if old.viewpoint_id != view.viewpoint_id), view)
        quality = view.quality
        self.viewpoints[view.viewpoint_id] = ViewpointState(
            view.viewpoint_id, "processed" if quality.accepted else "failed", quality.reason
        )
        self.viewpointsChanged.emit()
        self.cloudsChanged.emit()

    def set_stitched(self, stitched: StitchedCloud | None) -> None:
        """Set the stitched cloud."""
        self.stitched, self.filters, self.filtered = stitched, None, None
        self.cloudsChanged.emit()

    def set_filters(self, filters: FilterChain | None) -> None:
        """Set the filters of the stitched cloud; None or an empty chain: none."""
        self._filter(filters)
        self.cloudsChanged.emit()

    def _filter(self, filters: FilterChain | None) -> None:
        self.filters = filters if filters is not None and filters.filters else None
        self.filtered = None if self.filters is None or self.stitched is None else self.stitched.where(self.filters.kept_mask)

    def set_inspection(self, inspection: Inspection | None) -> None:
        """Set the inspection results."""
        self.inspection = inspection
        self.inspectionChanged.emit()

    def replace_inspection(self, inspection: Inspection) -> None:
        """Replace the inspection of the measurement, by another program on the same clouds."""
        if self.measurement is not None:
            self.measurement = replace(self.measurement, inspection=inspection)
        self.set_inspection(inspection)

    def set_files(self, files: Mapping[str, Path]) -> None:
        """Set the files of the results, which were written anew."""
        self.files = dict(files)
        self.reportChanged.emit()

    def set_comparison(self, comparison: Comparison | None) -> None:
        """Set the deviations from the nominal."""
        self.comparison = comparison
        self.comparisonChanged.emit()

    def set_measurement(self, measurement: Measurement, files: Mapping[str, Path], filters: FilterChain | None = None) -> None:
        """Set all results of a measurement, and the filters of its stitched cloud."""
        self.measurement = measurement
        self.files = dict(files)
        self.calibration = measurement.calibration
        self.validity = measurement.validity
        self.cameras = measurement.calibration.cameras
        self.views = measurement.views
        self.stitched = measurement.stitched
        self._filter(filters)
        self.inspection = measurement.inspection
        self.comparison = None
        for view in measurement.views:
            status: ViewpointStatus = "processed" if view.quality.accepted else "failed"
            self.viewpoints[view.viewpoint_id] = ViewpointState(view.viewpoint_id, status, view.quality.reason)
        self._emit_results_changed()

    def set_busy(self, title: str) -> None:
        """Set the title of the running job; empty: none."""
        self.busy_with = title
        if not title:
            self.messages.end(BUSY)
        self.busyChanged.emit()

    def refuse_during_job(self) -> bool:
        """Return whether a job runs; if so, say that it must end first."""
        if self.busy_with:
            self.tell(
                tr("{busy_with} is still running.", busy_with=self.busy_with),
                "Wait until it has finished, or cancel it.",
                "warning",
                cause=BUSY,
                remedy=CANCEL,
            )
        return bool(self.busy_with)

    def ask_about_unsaved(self, go_on: Callable[[], object]) -> bool:
        """Return whether edits would be lost; if so, ask, and ``go_on`` when they are saved or discarded."""
        if self.unsaved:
            self.unsavedAsked.emit(go_on)
        return bool(self.unsaved)

    def set_graphics(self, state: GraphicsState, problem: str = "") -> None:
        """Set the state of the 3-D graphics."""
        self.graphics, self.graphics_problem = state, problem
        self.graphicsChanged.emit()

    def set_role(self, role: Role) -> None:
        """Switch between operator and engineer."""
        self.role = role
        self.appearanceChanged.emit()

    def tell(self, text: str, hint: str = "", level: Level = "info", *, cause: str = PROJECT, remedy: str = "") -> Message:
        """Add a message to the status strip and the list of messages, and return it.

        A warning or error stays open until its cause ends (`Messages.end`); without a cause, until another project is opened.
        ``remedy``: the action that helps, by its id.
        """
        return self.messages.add(text, hint, level, cause=cause, remedy=remedy)
