"""All calibrations of a connected rig: it takes images of the board from all sides, and they are solved together."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from measureapp.acquire.control import RunControl
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import ImageTaken, ViewpointFailed
from measureapp.acquire.motion import checked
from measureapp.acquire.tasks.board import BoardTask
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of
from measureapp.calibration_session.detection import DETECTION_THREADS
from measureapp.data.board import AnyBoard, BoardView
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, DeviceError, InputError
from measureapp.pipeline.calibrate import SolvedViews, solve_views
from measureapp.pipeline.connecting import connected
from measureapp.pipeline.events import CalibrationReady, Event
from measureapp.pipeline.kept_results import calibration_made_from
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.collision.build import PartSolid
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder, ProjectSettings
from measureapp.project.geometry.robot_file import arm_of

OnEvent = Callable[[Event], None]
MOST_BLIND = 3  # first viewpoints without the board, after which the run ends
PUT_THE_BOARD = (
    "Put the board on its stand in the centre of the table, tilted towards the robot, and check light, lens caps and the board's settings."
)


@dataclass(frozen=True, slots=True)
class CalibrationRequest:
    """Rig and project of an automatic calibration."""

    rig: RigDescription
    folder: Path
    plan: ScanPlan | None = None  # whose robot stations are calibrated, too; None: the plan of the project, if it has one
    board: AnyBoard | None = None  # of a new project; an existing one keeps its own
    name: str = ""  # of a new project; empty: that of its folder


@dataclass(frozen=True, slots=True, eq=False)
class CalibratedRig:
    """Result of an automatic calibration."""

    solved: SolvedViews
    taken: tuple[str, ...]  # viewpoints of this run
    kept: tuple[str, ...]  # views that were stored before
    failed: tuple[ViewpointFailed, ...]

    @property
    def unseen(self) -> Mapping[str, str]:
        """Viewpoints from which no camera detected the board, with the reason."""
        seen = {residual.name for residual in self.solved.solution.residuals}
        return {one.id: one.reason for one in self.solved.refused if one.id not in seen}


def calibrate_into_project(
    request: CalibrationRequest, on_event: OnEvent, progress: Progress, control: RunControl | None = None, held: Rig | None = None
) -> tuple[CalibratedRig, ProjectFolder]:
    """Take the missing calibration views with the rig, store them in the project, and calibrate the rig from all of them.

    Parameters
    ----------
    control : pauses, resumes and skips from other threads
    held : the connected rig; it stays connected. None: it is connected for the run, and released after it

    Raises
    ------
    InputError, StorageError
        The project is of another rig, contains something else or cannot be written.
    CalibrationError
        The board is not seen, or the views do not determine the rig; what was taken is stored.
    DeviceError
        From the rig.
    """
    project = _project_of(request)
    watch = Stopwatch()
    with connected(request.rig, held) as rig:
        project = ProjectFolder.create(request.folder, project.settings)
        with project.lock():
            if request.plan is not None and not project.stored_viewpoints():
                project.save_plan(request.plan)
            return calibrate_rig(rig, project, on_event, progress, watch, control), project


def _project_of(request: CalibrationRequest) -> ProjectFolder:
    """Open the project, or prepare a new one without writing anything."""
    if not (request.folder / "project.json").exists():
        name = request.name or request.folder.name
        return ProjectFolder(request.folder, ProjectSettings(name=name, part=name, rig=request.rig, board=request.board or DEFAULT_BOARD))
    project = ProjectFolder.open(request.folder)
    if project.rig() != request.rig:
        raise InputError(
            f"{request.folder} is a project of {project.rig().name}, which is described differently than {request.rig.name} is now.",
            "Calibrate into a new project, or use the rig description with which this one was made.",
        )
    if request.board is not None and request.board != project.settings.board:
        raise InputError(f"{request.folder} was made with another board ({project.settings.board.label}).", "Calibrate into a new project.")
    return project


def calibrate_rig(
    rig: Rig, project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch, control: RunControl | None = None
) -> CalibratedRig:
    """Take the missing images of the board from all sides, keep them, and solve the whole rig from all; raises as `calibrate_into_project`."""
    viewpoints = calibration_viewpoints(rig.description, project.plan(), arm=arm_of(rig.description), progress=progress)
    stored = {view.viewpoint_id for view in project.board_views(progress)}
    waiting: list[Viewpoint] = [viewpoint for viewpoint in viewpoints if viewpoint.id not in stored]
    failed: tuple[ViewpointFailed, ...] = ()
    with watch.stage("calibration images"):
        if waiting:
            task = _WatchedBoardTask(project, seen=bool(stored))
            failed = Engine(checked(rig, PartSolid.board_on_stand())).run(
                "calibration", waiting, task, _of_images(on_event), PartOf(progress, 0.0, 0.6), control
            )
    missed = {failure.viewpoint_id for failure in failed}
    taken = tuple(viewpoint.id for viewpoint in waiting if viewpoint.id not in missed)
    solved = solve_calibration(project, on_event, PartOf(progress, 0.6, 1.0), watch)
    return CalibratedRig(solved, taken, tuple(sorted(stored)), failed)


class _WatchedBoardTask(BoardTask):
    """A `BoardTask` that ends the run where the first viewpoints do not see the board: sixty more would not see it either."""

    def __init__(self, project: ProjectFolder, *, seen: bool) -> None:
        super().__init__(project.save_board_view)
        self._board = project.settings.board
        self._seen = seen
        self._blind: list[str] = []

    def check(self, result: BoardView) -> None:
        """Until the board was seen once, refuse images without it. Raises DeviceError, CalibrationError."""
        super().check(result)
        if not self._seen:
            self._require_board(result)

    def _require_board(self, view: BoardView) -> None:
        reasons = []
        for camera, pixels in view.images.items():
            try:
                find_board(pixels, self._board)
            except CalibrationError as error:
                reasons.append(f"{camera}: {error.message}")
            else:
                self._seen = True
                return
        self._blind.append(view.viewpoint_id)
        what = f"No camera detects the {self._board.label}"
        if len(self._blind) >= MOST_BLIND:
            raise CalibrationError(f"{what} from {', '.join(self._blind)}. {' '.join(reasons)}", PUT_THE_BOARD)
        raise DeviceError(f"{what}. {' '.join(reasons)}", PUT_THE_BOARD)


def _of_images(on_event: OnEvent) -> OnEvent:
    """Pass on images and failures only: the viewpoints of a calibration are none of a scan."""

    def receive(event: Event) -> None:
        if isinstance(event, (ImageTaken, ViewpointFailed)):
            on_event(event)

    return receive


def solve_calibration(
    project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch, threads: int = DETECTION_THREADS
) -> SolvedViews:
    """Calibrate the rig from the stored images of the board; raises CalibrationError when they do not suffice."""
    with watch.stage("calibration"):
        made_from = calibration_made_from(project)
        solved = solve_views(project.board_views(progress), project.settings.board, project.rig(), progress, threads)
        project.save_calibration(solved.solution.calibration, uncertainty_of(solved.solution), made_from)
    on_event(CalibrationReady(solved.solution.calibration, solved.verdict.reasons))
    return solved
