"""The project folder: everything about one measured part, self-contained.

project.json        what is measured, on which rig, with which board
plan.json           the scan plan
calibration/        views/ (images of the board and read-backs), cameras.json, rig.json, rig_uncertainty.npz,
                    noise.json (of the cameras, where it was measured), former/, checks/, history.jsonl
stacks/             raw fringe images: permanent
inspection/         program.toml and the nominal it names, in mm; former/: nominals before it
view_choices.json   views used or refused by hand
results/            clouds, stitched cloud, mesh, measurement.json: recomputed by `process`; filters.npz, filtered_cloud.ply
report/             documents
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeVar

from pydantic import BaseModel, ValidationError

from measureapp.data.board import AnyBoard, BoardView, CheckerboardDescription
from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.data.model import Model, first_problem
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.data.validity import CheckRecord
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import CalibrationError, InputError, StorageError
from measureapp.progress import NoProgress
from measureapp.project import filter_file, results
from measureapp.project.atomic import replacing, write_text
from measureapp.project.calibration import board_views, store
from measureapp.project.calibration.store import RIG_UNCERTAINTY
from measureapp.project.claim import claimed
from measureapp.project.frame_store import FrameStore
from measureapp.project.geometry.files import write_mesh
from measureapp.project.geometry.step_files import STEP_KINDS

if TYPE_CHECKING:
    from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty
    from measureapp.data.cloud import StitchedCloud
    from measureapp.fringe.noise.model import CameraNoise
    from measureapp.fringe.noise.photon_transfer import NoiseEstimate
    from measureapp.progress import Progress
    from measureapp.register.clouds.filter_chain import FilterChain

FORMAT = 1  # of the project's own files
DEFAULT_BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
ModelT = TypeVar("ModelT", bound=BaseModel)
PROGRAM, NOMINAL, FORMER = "program.toml", "nominal", "former"
VIEW_CHOICES = "view_choices.json"


class ProjectSettings(Model):
    """What a project measures, fixed when it is created."""

    schema_version: Literal[1] = 1
    name: str
    part: str
    rig: RigDescription
    board: AnyBoard = DEFAULT_BOARD


class ProjectFolder:
    """One project on disk; open or create it with the class methods."""

    def __init__(self, path: Path, settings: ProjectSettings) -> None:
        self.path = path
        self.settings = settings
        self.frames = FrameStore(path / "stacks")

    @classmethod
    def create(cls, path: Path, settings: ProjectSettings) -> ProjectFolder:
        """Make a new project in ``path``, or continue the one there when its settings are the same.

        Raises
        ------
        InputError
            The folder holds something else.
        StorageError
            It cannot be written.
        """
        path = Path(path)
        if (path / "project.json").exists():
            found = cls.open(path)
            if found.settings != settings:
                raise InputError(f"{path} holds another project ({found.name}).", "Choose another folder, or delete that one first.")
            return found
        if path.exists() and (not path.is_dir() or any(path.iterdir())):
            raise InputError(f"{path} is not an empty folder.", "Choose a new or an empty folder for the project.")
        write_text(path / "project.json", settings.model_dump_json(indent=2))
        return cls(path, settings)

    @classmethod
    def open(cls, path: Path) -> ProjectFolder:
        """Open the project in ``path``. Raises InputError when there is none, StorageError when it is damaged."""
        path = Path(path)
        if not (path / "project.json").is_file():
            raise InputError(f"{path} is not a MeasureApp project.", "Name a folder with a project.json in it.")
        return cls(path, _read_model(path / "project.json", ProjectSettings))

    @property
    def name(self) -> str:
        """The project's name."""
        return self.settings.name

    def claimed(self) -> AbstractContextManager[None]:
        """Hold the project while it is changed. Raises StorageError where another window or command does so, or it is read-only."""
        return claimed(self.path)

    def rig(self) -> RigDescription:
        """Return the rig the project was made for."""
        return self.settings.rig

    def plan(self) -> ScanPlan | None:
        """Return the scan plan, if there is one."""
        path = self.path / "plan.json"
        return _read_model(path, ScanPlan) if path.exists() else None

    def save_plan(self, plan: ScanPlan) -> None:
        """Keep the scan plan. Raises InputError when images of another plan are stored already."""
        if self.frames.stored() and self.plan() != plan:
            raise InputError(f"{self.path} holds images of another plan.", "Measure into a new project.")
        write_text(self.path / "plan.json", plan.model_dump_json(indent=2))

    def stored_viewpoints(self) -> tuple[str, ...]:
        """Return the ids of the viewpoints whose images lie complete on disk."""
        return self.frames.stored()

    def save_board_view(self, view: BoardView) -> None:
        """Keep the images of one sighting of the board."""
        board_views.save(self.path / "calibration" / "views", view)

    def verify(self) -> tuple[tuple[str, ...], dict[str, tuple[str, ...]]]:
        """Compare every stored byte with its checksum; return the ids of all viewpoints and, by id, what is wrong in words."""
        views = self.path / "calibration" / "views"
        checked = (*self.frames.stored(), *board_views.stored(views))
        damaged = {viewpoint: problems for viewpoint in self.frames.stored() if (problems := self.frames.damaged(viewpoint))}
        return checked, damaged | board_views.damaged(views)

    def board_views(self) -> tuple[BoardView, ...]:
        """Return every stored sighting of the board, as they were taken."""
        return board_views.load_all(self.path / "calibration" / "views")

    def save_calibration(self, calibration: RigCalibration, uncertainty: RigUncertainty | None = None) -> None:
        """Keep the calibration of the rig, and what it leaves open where that is known; a former one is set aside."""
        folder = self.path / "calibration"
        store.save(folder, calibration)
        if uncertainty is not None:
            from measureapp.project.calibration.rig_uncertainty_file import write_rig_uncertainty

            write_rig_uncertainty(folder / RIG_UNCERTAINTY, uncertainty)

    def calibration(self) -> RigCalibration | None:
        """Return the calibration of the rig, if there is one. Raises StorageError when it is damaged or was changed."""
        return store.load(self.path / "calibration")

    def needed_calibration(self) -> RigCalibration:
        """Return the calibration of the rig. Raises CalibrationError when there is none, StorageError when it is damaged."""
        calibration = self.calibration()
        if calibration is None:
            raise CalibrationError(f"{self.path} has no calibration.", "Calibrate the rig into it first.")
        return calibration

    def record_check(self, line: CheckRecord) -> None:
        """Add what a scan or a check said about the calibration to its history."""
        store.record(self.path / "calibration", line)

    def calibration_history(self) -> tuple[CheckRecord, ...]:
        """Return what scans and checks said about this and former calibrations, oldest first."""
        return store.history(self.path / "calibration")

    def save_check_view(self, check: str, view: BoardView) -> None:
        """Keep the images of one sighting of the board of a check called ``check``."""
        board_views.save(self.path / "calibration" / "checks" / check, view)

    def rig_uncertainty(self) -> RigUncertainty | None:
        """Return what the calibration leaves open, where it was kept. Raises StorageError when it is damaged."""
        from measureapp.project.calibration.rig_uncertainty_file import read_rig_uncertainty

        calibration, path = self.calibration(), self.path / "calibration" / RIG_UNCERTAINTY
        return read_rig_uncertainty(path, calibration) if calibration is not None and path.exists() else None

    def save_noise(self, estimates: Mapping[str, NoiseEstimate]) -> None:
        """Keep the measured noise of the cameras, with which images are decoded from then on.

        Raises
        ------
        InputError
            The rig has no such camera.
        CalibrationError
            The images of a camera did not fit the model of noise; names it.
        StorageError
            It cannot be written.
        """
        from measureapp.project.fringes.noise_file import write_noise

        known = [camera.name for camera in self.settings.rig.cameras]
        unknown = [name for name in estimates if name not in known]
        if unknown:
            raise InputError(f"The rig of {self.path} has no camera {', '.join(unknown)}.", f"Name its cameras: {', '.join(known)}.")
        poor = [f"{name}: {estimate.verdict}" for name, estimate in estimates.items() if not estimate.accepted]
        if poor:
            raise CalibrationError(
                f"The noise of {'; '.join(poor)}.", "Let the cameras see a still surface with bright and dark areas, and measure again."
            )
        write_noise(self._noise_file, estimates)

    def noise(self) -> dict[str, CameraNoise]:
        """Return the noise of the cameras that was measured. Raises InputError when the file is damaged."""
        from measureapp.project.fringes.noise_file import read_noise

        return read_noise(self._noise_file) if self._noise_file.exists() else {}

    def take_noise_over(self, other: ProjectFolder) -> None:
        """Keep what another project knows of the noise of the same cameras, if anything. Raises StorageError."""
        if other._noise_file.exists():
            with replacing(self._noise_file) as temporary:
                shutil.copyfile(other._noise_file, temporary)

    @property
    def _noise_file(self) -> Path:
        return self.path / "calibration" / "noise.json"

    def save_inspection(self, program: Path | None, nominal: Path | None) -> None:
        """Copy the inspection program and the nominal into the project, which then needs nothing outside."""
        folder = self.path / "inspection"
        folder.mkdir(parents=True, exist_ok=True)
        if program is not None:
            shutil.copyfile(program, folder / PROGRAM)
        if nominal is not None:
            shutil.copyfile(nominal, folder / f"{NOMINAL}{nominal.suffix.lower()}")

    def program_text(self, *, has_nominal: bool) -> str:
        """Return the inspection program as it is written; where there is none one without features. Raises StorageError."""
        if self.program is None:
            return f'name = {json.dumps(self.settings.part)}\nalignment = "{"best-fit" if has_nominal else "none"}"\n'
        try:
            return self.program.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise StorageError(f"{self.program} cannot be read: {error}.", "Restore it from a backup, or write it anew.") from error

    def save_program(self, text: str) -> None:
        """Keep another inspection program. Raises StorageError."""
        write_text(self.path / "inspection" / PROGRAM, text)

    def save_drawing(self, drawing: Path, nominal: Mesh) -> None:
        """Keep another drawing, read from the file ``drawing`` already; a mesh is kept in millimetres, STEP states its unit itself.

        The one before is set aside.
        """
        folder = self.path / "inspection"
        if self.nominal is not None:
            with replacing(folder / FORMER / f"{len(self.former_drawings()) + 1:04d}{self.nominal.suffix}") as temporary:
                shutil.copyfile(self.nominal, temporary)
        kept = folder / (f"{NOMINAL}{drawing.suffix.lower()}" if drawing.suffix.lower() in STEP_KINDS else f"{NOMINAL}.stl")
        if kept.suffix == ".stl":
            write_mesh(kept, nominal)
        else:
            with replacing(kept) as temporary:
                shutil.copyfile(drawing, temporary)
        for other in set(folder.glob(f"{NOMINAL}.*")) - {kept}:
            other.unlink()

    def former_drawings(self) -> tuple[Path, ...]:
        """Return the drawings that were set aside, oldest first."""
        return tuple(sorted((self.path / "inspection" / FORMER).glob("[0-9]*")))

    @property
    def program(self) -> Path | None:
        """The inspection program, if there is one."""
        path = self.path / "inspection" / PROGRAM
        return path if path.exists() else None

    @property
    def nominal(self) -> Path | None:
        """The nominal's mesh file, if there is one."""
        return next(iter(sorted((self.path / "inspection").glob(f"{NOMINAL}.*"))), None)

    def view_choices(self) -> ViewChoices:
        """Return which views are used or refused by hand. Raises StorageError when the file is damaged."""
        path = self.path / VIEW_CHOICES
        return _read_model(path, ViewChoices) if path.exists() else ViewChoices()

    def save_view_choices(self, choices: ViewChoices) -> None:
        """Keep which views are used or refused by hand. Raises StorageError."""
        write_text(self.path / VIEW_CHOICES, choices.model_dump_json(indent=2))

    @property
    def results(self) -> Path:
        """The folder of what was computed."""
        return self.path / "results"

    def save_measurement(self, measurement: Measurement, progress: Progress = NoProgress()) -> None:  # noqa: B008 - stateless
        """Keep everything a measurement gave, and apply the filters of the cloud before to its stitched one."""
        results.save(self.results, measurement)
        filter_file.filter_again(self.results, measurement.stitched, progress)

    def save_inspected(self, measurement: Measurement) -> None:
        """Keep a measurement of which only the inspection is another."""
        results.save_document(self.results, measurement)

    def filters(self, stitched: StitchedCloud) -> FilterChain | None:
        """Return the filters of the stitched cloud, if there are any. Raises StorageError when they are damaged or of another cloud."""
        return filter_file.load_filters(self.results, stitched)

    def measurement(self) -> Measurement | None:
        """Return the last measurement, if there is one. Raises StorageError when it is damaged."""
        calibration = self.calibration()
        return None if calibration is None else results.load(self.results, calibration)

    @property
    def report_pdf(self) -> Path:
        """Where the PDF report lies, once written."""
        return self.path / "report" / "report.pdf"

    @property
    def report_csv(self) -> Path:
        """Where the table of dimensions lies, once written."""
        return self.path / "report" / "report.csv"

    @property
    def report_json(self) -> Path:
        """Where the report's JSON lies, once written."""
        return self.path / "report" / "report.json"


def _read_json(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore the file from a backup, or make a new project.") from error


def _read_model(path: Path, kind: type[ModelT]) -> ModelT:
    document = _read_json(path)
    version = document.get("schema_version", FORMAT) if isinstance(document, dict) else FORMAT
    if version != FORMAT:
        raise StorageError(
            f"{path} has format {version}; this version reads format {FORMAT}.", "Use the version of MeasureApp that wrote it."
        )
    try:
        return kind.model_validate(document)
    except ValidationError as error:
        raise StorageError(
            f"{path}: {first_problem(error, 'the file')}.", "Restore the file from a backup, or make a new project."
        ) from error
