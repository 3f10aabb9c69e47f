"""Templates of projects: a project without its data, as a part program that also has the rig and names a calibration."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.part_program import CalibrationReference, PartProgram, PartProgramFacts
from measureapp.data.rig import RigDescription
from measureapp.errors import CalibrationError, InputError, PlanError
from measureapp.pipeline.part_program import store_part_program
from measureapp.project.documents import calibration_id
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder, ProjectSettings
from measureapp.project.identification_file import read_identification


def template_of_project(project: ProjectFolder, name: str = "", part_number: str = "", remarks: str = "") -> PartProgram:
    """Return a template: rig, board, plan, part, inspection program, report template, rules for raw images, what identifies the part
    whichever specimen it is, and where the rig is calibrated.

    No image, calibration or result is in it. The calibration is named by the folder of the project and its id.

    Parameters
    ----------
    name : of the part; default: that of the project

    Raises
    ------
    PlanError
        The project has no scan plan.
    InputError, StorageError
        A file of the project cannot be read.
    """
    plan, calibration = project.plan(), project.calibration()
    if plan is None:
        raise PlanError(f"{project.path} has no scan plan.", "Plan the scan first: a template is a start for scans.")
    named = None if calibration is None else CalibrationReference(folder=str(project.path.resolve()), id=calibration_id(calibration))
    same = {"serial_number": "", "order": "", "operator": "", "remarks": "", "part_temperature": ""} | dict.fromkeys(
        ("temperature_c", "humidity_percent")
    )
    facts = PartProgramFacts(
        name=name or project.settings.part,
        part_number=part_number,
        remarks=remarks,
        raw=project.storage_rules().raw,
        identification=read_identification(project.path).model_copy(update={**same, "temperature_source": ""}),
        calibration=named,
        board=project.settings.board,
    )
    nominal = None if project.nominal is None else (project.nominal.suffix.lower(), project.nominal.read_bytes())
    return PartProgram(
        facts,
        plan,
        None if project.program is None else project.program.read_bytes(),
        nominal,
        None if project.report_template is None else project.report_template.read_bytes(),
        rig=project.rig(),
    )


def new_project(template: PartProgram, folder: Path, *, name: str = "", rig: RigDescription | None = None) -> ProjectFolder:
    """Create a project from a template, ready to be scanned: everything but the calibration, which `calibration_of` finds.

    Parameters
    ----------
    name : of the project; default: that of the folder
    rig : in place of the template's

    Raises
    ------
    InputError
        The folder is not empty, or there is no rig.
    StorageError
        It cannot be written.
    """
    wanted = rig or template.rig
    if wanted is None:
        raise InputError(f"The part program {template.facts.name} has no rig.", "Give one: --rig RIG.")
    folder = Path(folder)
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError(f"{folder} is not an empty folder.", "Choose a new or an empty folder for the project.")
    facts = template.facts
    settings = ProjectSettings(name=name or folder.name, part=facts.name, rig=wanted, board=facts.board or DEFAULT_BOARD)
    project = ProjectFolder.create(folder, settings)
    with project.lock():
        project.save_plan(template.plan)
        store_part_program(project, template)
        source = calibration_of(template)
        if source is not None and rig is None:
            project.save_calibration(source.require_calibration(), source.rig_uncertainty())
            project.copy_noise_from(source)
    return project


def calibration_of(template: PartProgram) -> ProjectFolder | None:
    """Return the project with the calibration that a template names; None where it names none, or the project is not at its place any more.

    Its present calibration is taken, also where it is newer than the template: a rig is calibrated again now and then.
    """
    named = template.facts.calibration
    if named is None:
        return None
    try:
        project = ProjectFolder.open(Path(named.folder))
        project.require_calibration()
    except (InputError, CalibrationError):
        return None
    return project
