"""Jobs of operator mode: read programs and runs, check before the start, file a finished run. They run on a job's thread."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from measureapp.errors import InputError, MeasureError
from ui.controllers.operator_nouns import Entered, Filed, ProgramCard, verdict_of
from ui.look.language.words import tr
from ui.look.wording import with_hint

if TYPE_CHECKING:
    from measureapp.data.measurement import Measurement
    from measureapp.data.part_program import PartProgram
    from measureapp.data.rig import RigDescription
    from measureapp.data.series import SeriesRun
    from measureapp.pipeline.run import ScanRequest
    from measureapp.project.operator_settings import OperatorSettings
    from ui.workers.job import Job

RESERVE_BYTES = 1e9  # beside the images of a part
MOST_RUNS = 1000
CALL = "Call the engineer."


@dataclass(frozen=True, eq=False)
class Shelf:
    """Everything that the home screen shows."""

    settings: OperatorSettings
    cards: tuple[ProgramCard, ...]
    runs: tuple[SeriesRun, ...]  # of all programs, in order of measurement
    problems: tuple[str, ...] = ()  # series that cannot be read
    unreleased: tuple[ProgramCard, ...] = ()  # programs that the engineer has not released as they are


def read_shelf(job: Job, file: Path, rig: RigDescription | None) -> Shelf:
    """Read settings, part programs and runs; sample programs are made where no folder of programs was set or made before."""
    from measureapp.pipeline.sample_program import write_sample_programs
    from measureapp.project.operator_settings import read_operator_settings

    job.report(0, 2, "Reading the part programs")
    settings = read_operator_settings(file)
    if not settings.programs and not settings.programs_folder.exists():
        write_sample_programs(settings.programs_folder)
    runs, problems = _read_runs()
    folder = settings.programs_folder
    try:
        paths = sorted(path for path in folder.iterdir() if path.suffix.lower() == ".mpart")
    except OSError as error:
        raise InputError(
            tr("The part programs in {folder} cannot be read: {value}.", folder=folder, value=error.strerror or error), CALL
        ) from error
    cards = [_card(path, settings, runs, rig) for path in paths]
    ordered = sorted(cards, key=lambda card: (bool(card.problem), card.name.casefold()))
    offered, held = (tuple(card for card in ordered if (card.program is None or card.is_released) == may) for may in (True, False))
    return Shelf(settings, offered, runs, problems, held)


def _card(path: Path, settings: OperatorSettings, runs: tuple[SeriesRun, ...], rig: RigDescription | None) -> ProgramCard:
    from measureapp.acquire.time_left import planned_seconds
    from measureapp.project.part_program_file import is_released, read_part_program

    try:
        program = read_part_program(path)
    except MeasureError as error:
        return ProgramCard(path, problem=with_hint(error.message.replace(str(path), path.name), error.hint.replace(str(path), path.name)))
    name = program.facts.name
    last = next((run for run in reversed(runs) if run.program == name), None)
    seconds = settings.usual_seconds(name)
    if seconds is None and rig is not None:
        seconds = sum(planned_seconds(program.plan, tuple(program.plan), rig).values())
    return ProgramCard(path, program, "", last, seconds, is_released(program))


def release_programs(job: Job, paths: Sequence[Path], by: str) -> tuple[str, ...]:
    """Release part programs as their next revisions, and return their names. Raises InputError, StorageError."""
    from measureapp.project.part_program_file import release_file

    now, names = datetime.now(UTC).isoformat(timespec="seconds"), []
    for done, path in enumerate(paths):
        job.report(done, len(paths), path.name)
        names.append(release_file(path, by, now).facts.name)
    return tuple(names)


def _read_runs() -> tuple[tuple[SeriesRun, ...], tuple[str, ...]]:
    from measureapp.project.series.store import SeriesStore, list_programs

    runs: list[SeriesRun] = []
    problems = []
    for program in list_programs():
        try:
            runs += SeriesStore(program).runs()
        except MeasureError as error:
            problems.append(with_hint(error.message, error.hint))
    from measureapp.project.series.database import seconds

    return tuple(sorted(runs, key=lambda run: seconds(run.measured_at))), tuple(problems)


def find_obstacles(job: Job, rig: RigDescription, program: PartProgram, settings: OperatorSettings) -> tuple[str, ...]:
    """Return in sentences what prevents the start of a measurement, besides what the connected rig says."""
    job.check()
    found = []
    for check in (lambda: _check_calibration(rig, settings), lambda: _check_disk(rig, program, settings)):
        try:
            check()
        except MeasureError as error:
            found.append(with_hint(error.message, error.hint))
    return tuple(found)


def _check_calibration(rig: RigDescription, settings: OperatorSettings) -> None:
    """Raise InputError where the rig has no calibration that may be used; a virtual one can calibrate itself."""
    from measureapp.calibrate.cameras.validity import shortfalls
    from measureapp.pipeline.sample_program import VIRTUAL_DRIVER
    from measureapp.pipeline.validity import known_validity
    from measureapp.project.folder import ProjectFolder

    folder = calibrated_project(rig, settings)
    if folder is None:
        if rig.driver == VIRTUAL_DRIVER:
            return
        raise InputError(tr("{name} has no calibration.", name=rig.name), CALL)
    project = ProjectFolder.open(folder)
    validity = known_validity(project, project.require_calibration(), None)
    if validity.drift is not None and validity.drift.status == "drifted":
        raise InputError(validity.drift.sentence, CALL)
    rules = rig.calibration_rules
    outdated = shortfalls(project.require_calibration().provenance, datetime.now(UTC), None, rules, rig.standoff_mm)
    if outdated and rules.when_exceeded == "refuse":
        raise InputError(" ".join(outdated), CALL)


def _check_disk(rig: RigDescription, program: PartProgram, settings: OperatorSettings) -> None:
    from measureapp.data.scan_cost import stack_bytes

    folder = settings.parts_folder
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / ".writable"
        probe.touch()
        probe.unlink()
        free = shutil.disk_usage(folder).free
    except OSError as error:
        raise InputError(tr("{folder} cannot be written to: {value}.", folder=folder, value=error.strerror or error), CALL) from error
    needed = sum(stack_bytes(program.plan, viewpoint, rig) for viewpoint in program.plan) + RESERVE_BYTES
    if free < needed:
        raise InputError(
            tr("The disk has {value:.1f} GB free, and this part needs {value_2:.1f} GB.", value=free / 1e9, value_2=needed / 1e9), CALL
        )


def calibrated_project(rig: RigDescription, settings: OperatorSettings) -> Path | None:
    """Return the project whose calibration is used, if it is of this rig; the part on a virtual table makes no difference."""
    from measureapp.project.folder import ProjectFolder

    folder = Path(settings.calibrated) if settings.calibrated else None
    if folder is None or not (folder / "project.json").is_file():
        return None
    project = ProjectFolder.open(folder)
    return folder if project.calibration() is not None and _same_rig(project.rig(), rig) else None


def _same_rig(one: RigDescription, other: RigDescription) -> bool:
    def stripped(rig: RigDescription) -> RigDescription:
        settings = {name: value for name, value in rig.driver_settings.items() if name not in ("part", "unit", "part_turn_deg")}
        return rig.model_copy(update={"driver_settings": settings})

    return stripped(one) == stripped(other)


def rig_of(rig: RigDescription, program: PartProgram, settings: OperatorSettings) -> RigDescription:
    """Return the rig that measures a part; a virtual one has it on its table."""
    from measureapp.pipeline.sample_program import rig_for_program

    return rig_for_program(rig, program, settings.virtual_resolution, settings.parts_folder)


def next_run_folder(settings: OperatorSettings, program: str, serial: str) -> Path:
    """Return a new folder for a run of a part."""
    from measureapp.project.file_names import safe_file_name

    part = settings.parts_folder / safe_file_name(program) / safe_file_name(serial, fallback="without serial number")
    numbers = range(1, MOST_RUNS)
    return next(part / f"run-{number}" for number in numbers if not (part / f"run-{number}").exists())


def is_stored(folder: Path) -> bool:
    """Return whether the project of a run is where it was stored."""
    try:
        return (folder / "project.json").is_file()
    except OSError:
        return False


def scan_request(rig: RigDescription, program: PartProgram, entered: Entered, settings: OperatorSettings, folder: Path) -> ScanRequest:
    """Return the scan of one part; what is stored in its folder already is kept."""
    from measureapp.pipeline.run import NewProject, ScanRequest
    from measureapp.pipeline.sample_program import VIRTUAL_DRIVER

    used = rig_of(rig, program, settings)
    calibrated = calibrated_project(used, settings)
    facts = program.facts
    identification = facts.identification.model_copy(
        update={
            "part_name": facts.name,
            "part_number": facts.part_number,
            "serial_number": entered.serial,
            "order": entered.order,
            "operator": entered.operator,
            "machine": rig.name,
            "remarks": entered.remarks,
        }
    )
    identified = replace(program, facts=facts.model_copy(update={"identification": identification}))
    name = f"{facts.name} {entered.serial}".strip()
    return ScanRequest(
        program.plan,
        used,
        folder,
        resume=True,
        calibrated=calibrated,
        part_program=identified,
        created=NewProject(name, facts.name),
        calibrate=calibrated is None and used.driver == VIRTUAL_DRIVER,
    )


def file_finished(job: Job, folder: Path, measurement: Measurement, program: PartProgram, reason: str) -> Filed:
    """Add a finished run to the series of its program, and copy its report to where reports are filed by serial number."""
    from measureapp.project.atomic import replacing
    from measureapp.project.file_names import safe_file_name
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.series.filing import file_run

    job.check()
    project = ProjectFolder.open(folder)
    try:
        run, _ = file_run(project, measurement, program=program.facts.name, version=program.facts.version, repeat_reason=reason)
    except MeasureError as error:
        return Filed(problem=with_hint(error.message, error.hint))
    serial = run.identification.serial_number or "without serial number"
    target = folder.parents[2] / "reports" / safe_file_name(f"{serial} {folder.name} {verdict_of(run)}", ".pdf")
    try:
        with replacing(target) as temporary:
            shutil.copyfile(project.report_pdf, temporary)
    except (MeasureError, OSError) as error:
        return Filed(
            run, problem=tr("The result is filed; its report could not be copied to {target}: {error}.", target=target, error=error)
        )
    return Filed(run, target)


def store_settings(
    job: Job, file: Path, settings: OperatorSettings, rig: RigDescription | None, program: PartProgram | None, calibrated: Path | None
) -> OperatorSettings:
    """Store the settings; the project ``calibrated`` becomes the one whose calibration is used, unless the present one fits the rig."""
    from measureapp.project.operator_settings import write_operator_settings

    job.check()
    if calibrated is not None and rig is not None and program is not None:
        fits = calibrated_project(rig_of(rig, program, settings), settings) is not None
        settings = settings if fits else settings.model_copy(update={"calibrated": str(calibrated)})
    write_operator_settings(file, settings)
    return settings
