"""What a prediction starts from: a project, or a plan with a rig and an inspection program."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import Measurement
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError, PlanError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.prediction.form_errors import measured_form_mm, usual_form_mm
from measureapp.pipeline.prediction.light import PartLight
from measureapp.pipeline.prediction.measured_light import light_of_views
from measureapp.pipeline.prediction.rig_model import RigModel
from measureapp.pipeline.prediction.typical_rig import typical_rig
from measureapp.pipeline.prediction.uncertainty import Job
from measureapp.pipeline.prediction.views import PredictedScene, standing_on_table
from measureapp.progress import Progress
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.program_file import read_program


@dataclass(frozen=True, slots=True, eq=False)
class PredictionSetup:
    """Plan, scene and job of a prediction."""

    plan: ScanPlan
    scene: PredictedScene
    job: Job


def setup_of_project(
    project: ProjectFolder, progress: Progress, light: PartLight | None = None, form_mm: float | None = None
) -> PredictionSetup:
    """Prepare the prediction of a project's plan; the part stands where the last measurement found it, else as the plan states.

    Parameters
    ----------
    light : of the part; None: as the last measurement found it, else as `PartLight` assumes
    form_mm : standard deviation of the clouds' errors of form; None: as the last measurement found it, else as on usual rigs

    Raises
    ------
    PlanError
        The project has no scan plan.
    InputError
        It has no inspection program, or no nominal.
    CalibrationError
        It is not calibrated, and its rig cannot be calibrated by the views planned for it.
    """
    plan = project.plan()
    if plan is None:
        raise PlanError(f"{project.path} has no scan plan.", "Plan the scan first.")
    job = job_of_project(project)
    measurement = project.measurement()
    rig = rig_of_project(project) or typical_rig(project.rig(), plan, project.settings.board, arm_of(project.rig()), progress)
    rig = with_form_errors(rig, form_mm, measurement)
    place = None if measurement is None else placed_nominal(measurement)
    surface = NominalSurface(job.nominal)
    if place is None:
        place = standing_on_table(surface, rig, plan.part_pose)
    if light is None and measurement is not None:
        light = light_of_views(measurement.views, measurement.calibration, project.rig())
    return PredictionSetup(plan, PredictedScene.of(rig, surface, place, light), job)


def setup_of_files(
    plan: ScanPlan,
    description: RigDescription,
    program: Path,
    progress: Progress,
    *,
    calibrated: ProjectFolder | None = None,
    part_from_nominal: RigidTransform | None = None,
    light: PartLight | None = None,
    form_mm: float | None = None,
) -> PredictionSetup:
    """Prepare the prediction of a plan on a rig, with the calibration of a project, or a typical one.

    Parameters
    ----------
    program : inspection program that names its nominal
    part_from_nominal : pose on the table, in the calibration's frame `part`; None: as the plan states
    form_mm : standard deviation of the clouds' errors of form; None: as the last scan of ``calibrated`` found it, else as on usual rigs

    Raises
    ------
    InputError
        The program or its nominal cannot be read.
    CalibrationError
        The project has no calibration, or the rig cannot be calibrated by the views planned for it.
    """
    read = read_program(program)
    if not read.nominal:
        raise InputError(f"{program} names no nominal.", 'Add `nominal = "FILE.stl"`: points are predicted on it.')
    job = Job(read, read_mesh(program.parent / read.nominal, "nominal", unit=read.nominal_unit))
    if calibrated is None:
        rig = typical_rig(description, plan, DEFAULT_BOARD, arm_of(description), progress)
    else:
        rig = rig_with(calibrated, calibrated.require_calibration())
        if _sizes(rig.description) != _sizes(description):
            message = f"{calibrated.path} was calibrated with other cameras than those of {description.name}, or at another resolution."
            raise InputError(message, "Name a project of this rig, or omit the calibration.")
    rig = with_form_errors(rig, form_mm, None if calibrated is None else calibrated.measurement())
    surface = NominalSurface(job.nominal)
    place = part_from_nominal or standing_on_table(surface, rig, plan.part_pose)
    return PredictionSetup(plan, PredictedScene.of(rig, surface, place, light), job)


def _sizes(rig: RigDescription) -> dict[str, tuple[int, int]]:
    return {camera.name: (camera.width_px, camera.height_px) for camera in rig.cameras}


def rig_of_project(project: ProjectFolder) -> RigModel | None:
    """Return the calibrated rig of a project; None if it is not calibrated."""
    calibration = project.calibration()
    return None if calibration is None else rig_with(project, calibration)


def rig_with(project: ProjectFolder, calibration: RigCalibration) -> RigModel:
    """Return the rig of a project with its calibration."""
    made = f"calibration of {calibration.provenance.created or 'unknown date'}"
    return RigModel(project.rig(), calibration, project.rig_uncertainty(), made, project.noise())


def with_form_errors(rig: RigModel, form_mm: float | None, measurement: Measurement | None) -> RigModel:
    """Return the rig with stated errors of form (mm), with those that a scan has shown, or with those of usual rigs; its source says which."""
    measured = measured_form_mm(measurement)
    if form_mm is not None:
        size_mm, origin = form_mm, "as stated"
    elif measured is not None:
        size_mm, origin = measured, "as the last scan shows"
    else:
        size_mm, origin = usual_form_mm(rig.description), "as usual rigs have"
    return replace(rig, form_mm=size_mm, source=f"{rig.source}; clouds with errors of form of {size_mm:.4f} mm, {origin}")


def job_of_project(project: ProjectFolder) -> Job:
    """Return program and nominal of a project. Raises InputError if it has none."""
    if project.program is None or project.nominal is None:
        missing = "inspection program" if project.program is None else "nominal"
        raise InputError(f"{project.path} has no {missing}.", "Add it on the page Inspect, or scan with a part program.")
    return Job(read_program(project.program), read_mesh(project.nominal, "nominal"))


def placed_nominal(measurement: Measurement) -> RigidTransform | None:
    """Return part_from_nominal as a measurement found it; None without an inspection."""
    if measurement.inspection is None:
        return None
    found = measurement.inspection.alignment.nominal_from_part
    return RigidTransform(found.matrix, "nominal", "part").inverse()
