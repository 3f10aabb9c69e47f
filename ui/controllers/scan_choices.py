"""What a person chooses for a scan, and what the check before it found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from measureapp.errors import InputError, MeasureError
from ui.controllers.stored_sessions import project_on_disk

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan
    from measureapp.data.raw_policy import RawPolicy
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.preflight import Preflight
    from measureapp.pipeline.run import ScanRequest
    from ui.session import Session
    from ui.workers.job import Job

Exposures = Literal["plan", "once", "each"]
MakeRequest = Callable[["Job"], "ScanRequest"]
MOST_FOLDERS = 1000
PROGRAM = "program.toml"
NO_PLAN = InputError("There is no scan plan.", "Make one on the page Plan, or choose a plan file.")


@dataclass(frozen=True)
class ScanChoices:
    """Project, plan and exposures of a scan with the chosen rig."""

    folder: Path | None = None  # of the project, new or existing
    part: str = ""  # name of the part of a new project
    nominal: Path | None = None
    program: Path | None = None
    calibrated: Path | None = None  # another project whose calibration is copied
    plan_file: Path | None = None  # None: the plan of the page Plan
    exposures: Exposures = "plan"
    seconds: float = 10.0  # of exposures per viewpoint, where a probe chooses them
    raw: RawPolicy | None = None  # what becomes of raw images; None: as the project states

    @property
    def is_existing(self) -> bool:
        """Whether the project exists."""
        return self.folder is not None and (self.folder / "project.json").is_file()

    @property
    def has_documents(self) -> bool:
        """Whether the project exists with a nominal or an inspection program, which a scan does not replace."""
        return self.is_existing and self.folder is not None and any((self.folder / "inspection").glob("*.*"))


@dataclass(frozen=True, eq=False)
class CheckedScan:
    """What was found before a scan; ``problem`` where not even that could be checked."""

    choices: ScanChoices
    found: Preflight | None = None
    stored: int = 0  # viewpoints that are kept
    planned: int = 0
    problem: MeasureError | None = None

    @property
    def problems(self) -> tuple[MeasureError, ...]:
        """Everything that prevents the scan."""
        if self.problem is not None:
            return (self.problem,)
        return () if self.found is None else self.found.problems


def suggested_choices(session: Session, planned: Path | None = None) -> ScanChoices:
    """Return the open project if it was made for this scan, else a new folder with its part, documents and calibration.

    ``planned`` is the nominal for which the plan was made; an inspection program beside it belongs to it.
    """
    folder = project_on_disk(session)
    if folder is not None and not session.views and not any((folder / "stacks").glob("*")):
        chosen = ScanChoices(folder)
        if chosen.has_documents:
            return chosen
        if not _is_calibration_alone(session):
            return ScanChoices(folder, "", planned, _program_beside(planned))
    home = Path.home() / "MeasureApp"
    new = next((home / f"scan-{number}" for number in range(1, MOST_FOLDERS) if not (home / f"scan-{number}").exists()), None)
    if folder is None:
        return ScanChoices(new, session.part or _part_name(planned), planned, _program_beside(planned))
    calibrated = folder if session.calibration is not None else None
    nominal, program = documents_of(folder)
    if nominal is None and program is None:
        part = _part_name(planned) if _is_calibration_alone(session) else session.part
        return ScanChoices(new, part, planned, _program_beside(planned), calibrated)
    return ScanChoices(new, session.part, nominal, program, calibrated)


def documents_of(project: Path) -> tuple[Path | None, Path | None]:
    """Return nominal and inspection program of a project; None for what it does not have."""
    nominal = next(iter(sorted((project / "inspection").glob("nominal.*"))), None)
    program = project / "inspection" / PROGRAM
    return nominal, program if program.is_file() else None


def _is_calibration_alone(session: Session) -> bool:
    """Return whether the open project was made by a calibration, which names no part."""
    return session.calibration is not None and session.part == session.project_name


def _part_name(nominal: Path | None) -> str:
    """Return the name of a part after its nominal: that of the file, or of its folder where the file is named nominal."""
    if nominal is None:
        return ""
    return nominal.parent.name if nominal.stem == "nominal" else nominal.stem


def _program_beside(nominal: Path | None) -> Path | None:
    """Return the inspection program in the folder of a nominal; None if there is none."""
    program = None if nominal is None else nominal.parent / PROGRAM
    return program if program is not None and program.is_file() else None


def request_maker(choices: ScanChoices, session: Session) -> MakeRequest:
    """Return the function that makes the request of a scan on a job's thread; it raises InputError where something is missing."""
    rig, plan = session.rig, session.plan

    def make(job: Job) -> ScanRequest:
        job.check()
        return _request(choices, rig, plan)

    return make


def _request(choices: ScanChoices, rig: RigDescription | None, plan: ScanPlan | None) -> ScanRequest:
    from measureapp.pipeline.run import NewProject, ScanRequest
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.plan_file import read_plan

    if rig is None:
        raise InputError("No rig is chosen.", "Choose one on the page Rig.")
    if choices.folder is None:
        raise InputError("No project folder is chosen.", "Choose a new folder, or the folder of a project.")
    if choices.plan_file is not None:
        plan = read_plan(choices.plan_file)
    if plan is None:
        raise NO_PLAN
    created = None
    if not choices.is_existing:
        created = NewProject(choices.folder.name, choices.part or choices.folder.name, choices.program, choices.nominal)
    elif (choices.program or choices.nominal) and not choices.has_documents:
        kept = ProjectFolder.open(choices.folder).settings
        created = NewProject(kept.name, kept.part, choices.program, choices.nominal, kept.board)
    return ScanRequest(
        plan,
        rig,
        choices.folder,
        resume=True,
        calibrated=choices.calibrated,
        bracket_s=None if choices.exposures == "plan" else choices.seconds,
        per_viewpoint=choices.exposures == "each",
        created=created,
        raw=choices.raw,
    )
