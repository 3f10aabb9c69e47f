"""The project folder: all data of one measured part, self-contained.

project.json        part, rig and calibration board
journal.sqlite      what was stored when, with the checksum of every file (`journal/`); journal.seal.json: its own checksum
plan.json           scan plan
calibration/        views/ (images of the board and read-backs), cameras.json, rig.json, rig_uncertainty.npz,
                    noise.json (measured camera noise), former/, checks/, history.jsonl
stacks/             raw fringe images: permanent
inspection/         program.toml and its nominal, in mm; former/: replaced nominals; report.typ: template of the report
view_choices.json   views accepted or refused by hand
decode_limits.json  limits of the pixels that are decoded, where they are not the usual ones
storage.json        what becomes of raw images: kept, compressed or dropped
results/            clouds, stitched cloud, mesh, measurement.json: recomputed by `process`; filters.npz, filtered_cloud.ply;
                    deviation.npz, report_pictures.npz (`kept_arrays`)
report/             reports
identification.json part, serial number, order, operator, climate
series/             runs that were filed in a series of parts
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measureapp.data.board import BoardView
from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.data.plan import ScanPlan
from measureapp.data.project_settings import DEFAULT_BOARD, ProjectSettings
from measureapp.data.rig import RigDescription
from measureapp.data.storage_rules import StorageRules
from measureapp.data.validity import CheckRecord
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import CalibrationError, Damaged, InputError, StorageError
from measureapp.progress import NoProgress
from measureapp.project import filter_file, inputs, results, takeover, template_folder
from measureapp.project.atomic import remove, replacing, write_text
from measureapp.project.calibration import board_views, store
from measureapp.project.folder_lock import lock_folder
from measureapp.project.frame_store import FrameStore
from measureapp.project.geometry.files import write_mesh
from measureapp.project.geometry.step_files import STEP_KINDS
from measureapp.project.journal import database, publish, seal
from measureapp.project.journal.state import Journal
from measureapp.project.text_document import read_model
from measureapp.project.upkeep import require_project

if TYPE_CHECKING:
    from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty
    from measureapp.data.cloud import StitchedCloud
    from measureapp.fringe.noise.model import CameraNoise
    from measureapp.fringe.noise.photon_transfer import NoiseEstimate
    from measureapp.progress import Progress
    from measureapp.register.clouds.filter_chain import FilterChain

__all__ = ["DEFAULT_BOARD", "ProjectFolder", "ProjectSettings"]
PROGRAM, NOMINAL, FORMER = "program.toml", "nominal", "former"
VIEW_CHOICES, STORAGE = "view_choices.json", "storage.json"


class ProjectFolder:
    """One project on disk; open or create it with the class methods."""

    def __init__(self, path: Path, settings: ProjectSettings) -> None:
        self.path = path
        self.settings = settings
        self.journal = Journal(path)
        self.frames = FrameStore(path / "stacks", self.journal)

    @classmethod
    def create(cls, path: Path, settings: ProjectSettings) -> ProjectFolder:
        """Create a project in ``path``, or open the existing one if its settings are the same.

        Raises
        ------
        InputError
            The folder contains something else.
        StorageError
            It cannot be written.
        """
        path = Path(path)
        if (path / "project.json").exists():
            found = cls.open(path)
            if not found.settings.same_job(settings):
                raise InputError(f"{path} contains another project ({found.name}).", "Choose another folder, or delete that one first.")
            return found
        if path.exists() and (not path.is_dir() or any(path.iterdir())):
            raise InputError(f"{path} is not an empty folder.", "Choose a new or an empty folder for the project.")
        database.require_short(path)
        write_text(path / "project.json", settings.model_dump_json(indent=2))
        takeover.create_journal(path)
        seal.write(path)
        return cls(path, settings)

    @classmethod
    def open(cls, path: Path) -> ProjectFolder:
        """Open the project in ``path``. Raises InputError when there is none, StorageError when it is damaged."""
        path = Path(path)
        require_project(path)
        Journal(path).check(path / "project.json")
        return cls(path, read_model(path / "project.json", ProjectSettings))

    @property
    def name(self) -> str:
        """Name of the project."""
        return self.settings.name

    @contextmanager
    def lock(self, *, yields: bool = False) -> Iterator[None]:
        """Lock the project for changes, and finish or sweep what a program that died has left.

        A project of an earlier version gets its journal now. ``yields``: for a moment only, so that others wait rather than fail.

        Raises
        ------
        StorageError
            Another window or command has locked it, or it is read-only.
        """
        database.require_short(self.path)
        with lock_folder(self.path, yields=yields):
            if self.journal.contents() is None:
                takeover.take_over(self.path)
            publish.recover(self.path)
            try:
                yield
            finally:
                with suppress(StorageError):  # the seal is a second guard: without it the lines still prove themselves
                    seal.write(self.path)

    def rig(self) -> RigDescription:
        """Return the rig of the project."""
        return self.settings.rig

    def plan(self) -> ScanPlan | None:
        """Return the scan plan, if there is one."""
        path = self.path / "plan.json"
        self.journal.check(path)
        return read_model(path, ScanPlan) if path.exists() else None

    def save_plan(self, plan: ScanPlan) -> None:
        """Store the scan plan; where images are stored already, it may only add viewpoints. Raises InputError for any other change."""
        if self.frames.list_stored() and not ((former := self.plan()) and plan.extends(former)):
            raise InputError(f"{self.path} contains images of another plan.", "Scan into a new project, or only add viewpoints.")
        write_text(self.path / "plan.json", plan.model_dump_json(indent=2))

    def stored_viewpoints(self) -> tuple[str, ...]:
        """Return the ids of the viewpoints whose images are stored completely."""
        return self.frames.list_stored()

    def save_board_view(self, view: BoardView) -> None:
        """Store the images of one view of the board."""
        board_views.save(self.path / "calibration" / "views", view)

    def board_views(self, progress: Progress | None = None) -> tuple[BoardView, ...]:
        """Load all stored views of the board, in the order of acquisition. Raises StorageError naming a damaged file."""
        folder = self.path / "calibration" / "views"
        self.journal.check(*folder.glob("*/*"))
        return board_views.load_all(folder, progress)

    def board_view_count(self) -> int:
        """Return how many views of the board are stored; none is read."""
        return len(board_views.list_stored(self.path / "calibration" / "views"))

    def save_calibration(self, calibration: RigCalibration, uncertainty: RigUncertainty | None = None, made_from: str = "") -> None:
        """Store the calibration of the rig and, if known, its uncertainty and what it was solved from; a former one is archived."""
        store.save(self.path / "calibration", calibration, uncertainty, made_from)

    def calibration(self) -> RigCalibration | None:
        """Return the calibration of the rig, if there is one. Raises StorageError when it is damaged or was modified."""
        self.journal.check(*(self.path / "calibration" / name for name in (store.CAMERAS, store.RIG)))
        return store.load(self.path / "calibration")

    def require_calibration(self) -> RigCalibration:
        """Return the calibration of the rig. Raises CalibrationError when there is none, StorageError when it is damaged."""
        calibration = self.calibration()
        if calibration is None:
            raise CalibrationError(f"{self.path} has no calibration.", "Calibrate the rig into this project first.")
        return calibration

    def record_check(self, line: CheckRecord) -> None:
        """Append the result of a scan or a check to the history of the calibration."""
        store.record(self.path / "calibration", line)

    def calibration_history(self) -> tuple[CheckRecord, ...]:
        """Return the results of scans and checks for this and former calibrations, oldest first. Raises StorageError."""
        self.journal.check_once(self.path / "calibration" / store.HISTORY)
        return store.history(self.path / "calibration")

    def save_check_view(self, check: str, view: BoardView) -> None:
        """Store the images of one view of the board of the check named ``check``."""
        board_views.save(self.path / "calibration" / "checks" / check, view)

    def rig_uncertainty(self) -> RigUncertainty | None:
        """Return the uncertainty of the calibration, if it is stored. Raises StorageError when it is damaged."""
        from measureapp.project.calibration.rig_uncertainty_file import read_rig_uncertainty

        calibration, path = self.calibration(), self.path / "calibration" / store.RIG_UNCERTAINTY
        self.journal.check(path)
        return read_rig_uncertainty(path, calibration) if calibration is not None and path.exists() else None

    def save_noise(self, estimates: Mapping[str, NoiseEstimate]) -> None:
        """Store the measured noise of the cameras; images are decoded with it from then on.

        Raises
        ------
        InputError
            The rig has no such camera.
        CalibrationError
            The images of a camera did not fit the noise model; names the camera.
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
                f"The noise model does not fit: {'; '.join(poor)}.",
                "Point the cameras at a stationary surface with bright and dark areas, and measure again.",
            )
        write_noise(self._noise_file, estimates)

    def noise(self) -> dict[str, CameraNoise]:
        """Return the measured noise of the cameras. Raises InputError when the file is damaged."""
        from measureapp.project.fringes.noise_file import read_noise

        self.journal.check(self._noise_file)
        return read_noise(self._noise_file) if self._noise_file.exists() else {}

    def copy_noise_from(self, other: ProjectFolder) -> None:
        """Copy the camera noise of another project with the same cameras, if it has any. Raises StorageError."""
        if other._noise_file.exists():
            with replacing(self._noise_file) as temporary:
                shutil.copyfile(other._noise_file, temporary)

    @property
    def _noise_file(self) -> Path:
        return self.path / "calibration" / "noise.json"

    def save_inspection(self, program: Path | None, nominal: Path | None) -> None:
        """Copy the inspection program and the nominal into the project."""
        folder = self.path / "inspection"
        for source, name in ((program, PROGRAM), (nominal, "" if nominal is None else f"{NOMINAL}{nominal.suffix.lower()}")):
            if source is not None:
                with replacing(folder / name) as temporary:
                    shutil.copyfile(source, temporary)

    def program_text(self, *, has_nominal: bool) -> str:
        """Return the text of the inspection program, or an empty program if there is none. Raises StorageError."""
        if self.program is None:
            return f'name = {json.dumps(self.settings.part)}\nalignment = "{"best-fit" if has_nominal else "none"}"\n'
        try:
            return self.program.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise StorageError(f"{self.program} cannot be read: {error}.", "Restore it from a backup, or write a new one.") from error

    def save_program(self, text: str) -> None:
        """Store another inspection program. Raises StorageError."""
        write_text(self.path / "inspection" / PROGRAM, text)

    def save_nominal(self, source: Path, nominal: Mesh) -> None:
        """Store another nominal, read from the file ``source``: a mesh in millimetres, STEP as it is; the former one is archived."""
        folder = self.path / "inspection"
        if self.nominal is not None:
            with replacing(folder / FORMER / f"{len(self.former_nominals()) + 1:04d}{self.nominal.suffix}") as temporary:
                shutil.copyfile(self.nominal, temporary)
        kept = folder / (f"{NOMINAL}{source.suffix.lower()}" if source.suffix.lower() in STEP_KINDS else f"{NOMINAL}.stl")
        if kept.suffix == ".stl":
            write_mesh(kept, nominal)
        else:
            with replacing(kept) as temporary:
                shutil.copyfile(source, temporary)
        remove(*(set(folder.glob(f"{NOMINAL}.*")) - {kept}))

    def save_report_template(self, template: bytes) -> None:
        """Store a template (Typst) that the PDF report uses from then on. Raises StorageError."""
        with replacing(self.path / "inspection" / template_folder.LAYOUT) as temporary:
            temporary.write_bytes(template)

    @property
    def report_template(self) -> Path | None:
        """Folder or file of the report's template, if the project has its own. Raises Damaged."""
        path = self.path / "inspection" / template_folder.LAYOUT
        folder = path.with_name(template_folder.FOLDER)
        for file in (path, *sorted(folder.glob("*"))):
            self.journal.check_once(file)
        return folder if (folder / template_folder.FILE).exists() else path if path.exists() else None

    def former_nominals(self) -> tuple[Path, ...]:
        """Return the archived nominals, oldest first."""
        return tuple(sorted((self.path / "inspection" / FORMER).glob("[0-9]*")))

    @property
    def program(self) -> Path | None:
        """File of the inspection program, if there is one. Raises Damaged."""
        path = self.path / "inspection" / PROGRAM
        self.journal.check_once(path)
        return path if path.exists() else None

    @property
    def nominal(self) -> Path | None:
        """File of the nominal, if there is one. Raises Damaged."""
        path = next(iter(sorted((self.path / "inspection").glob(f"{NOMINAL}.*"))), None)
        if path is not None:
            self.journal.check_once(path)
        return path

    def view_choices(self) -> ViewChoices:
        """Return the views accepted or refused by hand. Raises StorageError when the file is damaged."""
        path = self.path / VIEW_CHOICES
        self.journal.check(path)
        return read_model(path, ViewChoices) if path.exists() else ViewChoices()

    def save_view_choices(self, choices: ViewChoices) -> None:
        """Store the views accepted or refused by hand. Raises StorageError."""
        write_text(self.path / VIEW_CHOICES, choices.model_dump_json(indent=2))

    def storage_rules(self) -> StorageRules:
        """Return what becomes of raw images. Raises StorageError when the file is damaged."""
        path = self.path / STORAGE
        self.journal.check(path)
        return read_model(path, StorageRules) if path.exists() else StorageRules()

    def save_storage_rules(self, rules: StorageRules) -> None:
        """Store what becomes of raw images. Raises StorageError."""
        write_text(self.path / STORAGE, rules.model_dump_json(indent=2))

    @property
    def results(self) -> Path:
        """Folder of the results."""
        return self.path / "results"

    def save_measurement(self, measurement: Measurement, progress: Progress = NoProgress(), *, recomputed: bool = True) -> None:  # noqa: B008
        """Store a measurement, and apply the stored filters to its stitched cloud.

        ``recomputed``: its clouds were computed just now, and not only stitched again.
        """
        results.save(self.results, measurement, self._inputs(measurement, recomputed=recomputed), self.journal.compared_images())
        filter_file.reapply_filters(self.results, measurement.stitched, progress)

    def update_inspection(self, measurement: Measurement, *, recomputed: bool = False) -> None:
        """Store a measurement whose clouds and surface are those of the last one, ``recomputed`` or only inspected again."""
        results.save_document(self.results, measurement, self._inputs(measurement, recomputed=recomputed), self.journal.compared_images())

    def _inputs(self, measurement: Measurement, *, recomputed: bool) -> dict[str, Any]:
        contents = self.journal.contents()
        if contents is None:
            return {}
        now, before = inputs.current_inputs(contents), contents.results.get("inputs", {})
        if not recomputed:
            return inputs.inspected_again(before, now) if before else {}
        used = {view.viewpoint_id for view in measurement.views}
        return {**now, "stacks": {name: value for name, value in now["stacks"].items() if name in used}}

    def stale_results(self) -> tuple[str, ...]:
        """Return in sentences what has changed since the results were computed. Raises StorageError."""
        contents = self.journal.contents()
        return () if contents is None else inputs.changes(contents.results.get("inputs", {}), inputs.current_inputs(contents))

    def filters(self, stitched: StitchedCloud) -> FilterChain | None:
        """Load the filters of the stitched cloud, if any. Raises StorageError when they are damaged or belong to another cloud."""
        try:
            self.journal.check(self.results / filter_file.FILTERS)
        except Damaged as error:
            raise filter_file.unusable(self.results / filter_file.FILTERS, "is not what was stored") from error
        return filter_file.load_filters(self.results, stitched)

    def measurement(self, *, clouds: bool = True) -> Measurement | None:
        """Load the last measurement, if any; without ``clouds``, those of its views stay unread. Raises StorageError when it is damaged."""
        contents = self.journal.contents()
        files = [self.path / name for name in (contents.files if contents else ()) if name.startswith("results/")]
        read = [path for path in files if clouds or path.parent.name != results.CLOUDS]
        self.journal.check(*(path for path in read if path.name not in (*results.KEPT, filter_file.FILTERS, filter_file.FILTERED)))
        self.journal.take_as_compared(results.read_compared(self.results))
        calibration = self.calibration()
        return None if calibration is None else results.load(self.results, calibration, clouds=clouds)

    @property
    def report_pdf(self) -> Path:
        """File of the PDF report."""
        return self.path / "report" / "report.pdf"

    @property
    def report_csv(self) -> Path:
        """File of the table of dimensions."""
        return self.path / "report" / "report.csv"

    @property
    def report_json(self) -> Path:
        """File of the report's JSON."""
        return self.path / "report" / "report.json"
