"""Assembly of a measurement: stitching of the clouds, surface, dimensions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from itertools import chain
from typing import Any

import numpy as np

from measureapp.calibrate.rig.axis_patterns import axis_patterns
from measureapp.calibrate.rig.cloud_errors import calibration_errors
from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty, view_uncertainty
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Inspection, Measurement, ViewResult
from measureapp.data.part_temperature import PartTemperature
from measureapp.data.rig import RigDescription
from measureapp.data.surroundings import SURROUNDINGS, SURROUNDINGS_KEPT, Surroundings
from measureapp.data.validity import Validity
from measureapp.data.view_choices import ViewChoices
from measureapp.data.view_errors import CalibrationErrors
from measureapp.errors import RegistrationError
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from measureapp.pipeline.axes_check import without_contradictions
from measureapp.pipeline.chosen_views import add_refused, select_views
from measureapp.pipeline.consistency.check import check_consistency, with_unexplained
from measureapp.pipeline.events import Event, InspectionReady, ResultKept, StitchReady, ValidityKnown
from measureapp.pipeline.kept_results import StitchedViews, kept_stitched, stitched_made_from
from measureapp.pipeline.lengths import length_scale, temperature_of
from measureapp.pipeline.noise import describe_noise
from measureapp.pipeline.surface import SurfaceBeside
from measureapp.pipeline.surroundings import exclude_surroundings
from measureapp.pipeline.validity import validity_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.identification_file import read_identification
from measureapp.project.large_clouds import map_large
from measureapp.register.joint.axis_doubt import AxisPattern
from measureapp.register.joint.pose_prior import PosePrior
from measureapp.register.joint.registration_cache import RegistrationCache
from measureapp.register.place import number_stations
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch

RECALIBRATE = "calibrate the rig again."
DOUBTED = {  # pattern -> what is left between views, what is doubted, the remedy
    "table": ("follows the angle of the table", "the model of the table's error motions", f"Check the table for play, and {RECALIBRATE}"),
    "guide": (
        "follows the position of the guide",
        "the model of the guide's error motions",
        f"Check the guide for play, and {RECALIBRATE}",
    ),
    "robot": ("differs from one pose of the robot to the next", "the calibrated robot", f"Let it warm up, and {RECALIBRATE}"),
    "views": (
        "differs from view to view, whatever the axes read",
        "the repeatability of the axes",
        f"Check that head and part are fixed, and {RECALIBRATE}",
    ),
}
TYPICAL_RADIUS_MM = 100.0  # typical distance of points from the table's axis
KNOWN_STATION_MM, KNOWN_STATION_DEG = 0.03, 0.004  # repeatability of the robot and uncertainty of the board's pose, combined


@dataclass(frozen=True)
class Revision:
    """Other view choices for a measurement whose clouds, calibration validity and settings still apply; or what may be kept of it."""

    former: Measurement
    choices: ViewChoices | None = None  # None: those stored; its stitched cloud and surface are kept where they would come out as they are


def assemble(
    project: ProjectFolder,
    calibrated: RigCalibration,
    views: Sequence[ViewResult],
    on_event: Callable[[Event], None],
    progress: Progress,
    watch: Stopwatch,
    registration_cache: RegistrationCache | None = None,
    revision: Revision | None = None,
) -> Measurement:
    """Stitch the clouds of all views, compute the surface, evaluate the dimensions and store everything.

    Parameters
    ----------
    registration_cache : registration results prepared while the views were taken
    revision : the last results, with new view choices or to be kept where they would come out as they are; None: all is determined anew

    Raises
    ------
    RegistrationError
        No view has a usable cloud, or read-backs and images disagree in many views.
    """
    offered, revision = (revision.former, None) if revision is not None and revision.choices is None else (None, revision)
    validity = None if revision is None else revision.former.validity
    if validity is None:
        validity = validity_of(project, calibrated, views)
        on_event(ValidityKnown(validity))
    choices = (None if revision is None else revision.choices) or project.view_choices()
    made_from = stitched_made_from(project, calibrated, views, choices, _approaches(project, views))
    progress.check()
    joined = kept_stitched(offered, made_from)
    if joined is None:
        views = without_contradictions(views, calibrated) if revision is None else views
        joined = _stitched(project, calibrated, views, choices, validity, PartOf(progress, 0.0, 0.5), watch, registration_cache)
    else:
        on_event(ResultKept("stitched"))
    good = _require_usable(joined.views, choices, validity)
    validity = replace(validity, axes=joined.stitched.axis_doubt)
    progress.check()
    on_event(StitchReady(joined.stitched))
    with SurfaceBeside(joined.stitched, joined.mesh) as surface:
        with watch.stage("inspection"):
            settings = project_settings(project, calibrated, good)
            inspection = inspect_stitched(project, joined.stitched, settings, PartOf(progress, 0.5, 0.7))
        if inspection is not None:
            on_event(InspectionReady(inspection))
        with watch.stage("surface"):
            mesh = surface.wait(on_event, PartOf(progress, 0.7, 0.9))
    measurement = Measurement(
        project=project.name,
        part=project.settings.part,
        rig=project.rig().name,
        measured_at=datetime.now(UTC).isoformat(timespec="seconds"),
        calibration=calibrated,
        views=tuple(joined.views),
        stitched=joined.stitched,
        mesh=mesh,
        inspection=inspection,
        settings=_with_surroundings(_settings(project, good) if revision is None else revision.former.settings, joined.surroundings),
        timings_s=dict(watch.seconds),
        validity=validity,
        consistency=joined.consistency,
        stitched_from=made_from,
    )
    with watch.stage("saving"):
        if joined.mesh is not None:
            project.update_inspection(measurement, recomputed=True)  # clouds and surface are stored
        else:
            project.save_measurement(measurement, PartOf(progress, 0.9, 1.0), recomputed=revision is None)
    progress.report(1.0, 1.0, "measured")
    return measurement


def _require_usable(views: Sequence[ViewResult], choices: ViewChoices, validity: Validity) -> list[ViewResult]:
    """Return the views that are good or accepted by the user; raises RegistrationError with the reasons if there is none."""
    good = select_views(views, choices)
    if not good:
        reasons = "; ".join(sorted({view.quality.reason or "refused by hand" for view in views})) or "no view has points"
        notes = " ".join(("", *validity.all_warnings))
        raise RegistrationError(f"There is nothing to stitch: {reasons}.{notes}", "Check the images; change exposures or viewpoints.")
    return good


def _stitched(
    project: ProjectFolder,
    calibrated: RigCalibration,
    views: Sequence[ViewResult],
    choices: ViewChoices,
    validity: Validity,
    progress: Progress,
    watch: Stopwatch,
    registration_cache: RegistrationCache | None,
) -> StitchedViews:
    """Stitch the clouds of the usable views and check them with the error model; raises RegistrationError."""
    good = _require_usable(views, choices, validity)
    with watch.stage("surroundings"):
        part, surroundings = _without_surroundings(project, calibrated, good, choices)
        for view in chain(views, part):  # all of which were read
            view.cloud.give_up_pages()
    with watch.stage("stitching"):
        stitched = _stitch(project, calibrated, part, choices, progress, registration_cache)
    progress.check()
    with watch.stage("checks"):
        consistency = check_consistency(part, stitched)
        stitched = add_refused(with_unexplained(stitched, consistency), views, choices)
    said = SURROUNDINGS_KEPT if choices.keep_surroundings else surroundings.sentence
    return StitchedViews(views, stitched, consistency, said)


def _without_surroundings(
    project: ProjectFolder, calibrated: RigCalibration, views: Sequence[ViewResult], choices: ViewChoices
) -> tuple[Sequence[ViewResult], Surroundings]:
    """Return the views without table, fixtures and background; as they are without a nominal, or where the user keeps everything."""
    if project.nominal is None or choices.keep_surroundings:
        return views, Surroundings()
    plan = project.plan()
    pose = None if plan is None else plan.part_pose
    part, surroundings = exclude_surroundings(views, read_mesh(project.nominal, "nominal"), pose, calibrated, project.rig())
    return [own if own is view else _on_disk(project, own) for view, own in zip(views, part, strict=True)], surroundings


def _on_disk(project: ProjectFolder, view: ViewResult) -> ViewResult:
    return replace(view, cloud=map_large(view.cloud, project.path))


def _with_surroundings(settings: Mapping[str, Any], said: str) -> dict[str, Any]:
    """Return the settings of a measurement with what was excluded as surroundings, or that they were kept."""
    others = {name: value for name, value in settings.items() if name != SURROUNDINGS}
    return {**others, SURROUNDINGS: said} if said else others


def _stitch(
    project: ProjectFolder,
    calibrated: RigCalibration,
    good: Sequence[ViewResult],
    choices: ViewChoices,
    progress: Progress,
    registration_cache: RegistrationCache | None,
) -> StitchedCloud:
    return stitch(
        [view.cloud for view in good],
        [view.part_from_camera for view in good],
        stitch_settings(calibrated, good),
        progress,
        prior=pose_prior(project.rig_uncertainty(), good, _approaches(project, good)),
        accepted=choices.used,
        registration_cache=registration_cache,
    )


def pose_prior(rig: RigUncertainty | None, views: Sequence[ViewResult], approaches: Sequence[str] | None = None) -> PosePrior:
    """Return what is known about the kinematic positions of views before registration.

    Parameters
    ----------
    rig : joint covariance of the calibration; None: the stations alone are known
    approaches : the robot's approach of each view; None: neighbouring views with equal robot poses are one approach
    """
    readbacks = [view.readback for view in views]
    stations = number_stations(readbacks)
    if rig is None:
        return PosePrior(stations)
    covariance = view_uncertainty(rig, readbacks, approaches).pose_covariance
    return PosePrior(stations, covariance, camera_errors(rig, views), named_patterns(rig, readbacks))


def named_patterns(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> tuple[AxisPattern, ...]:
    """Return the patterns in which the axes may depart from their calibration, with the words for each."""
    found = axis_patterns(rig, readbacks)
    return tuple(AxisPattern(*DOUBTED[name], motions) for name, motions in found.items())


def camera_errors(rig: RigUncertainty, views: Sequence[ViewResult]) -> CalibrationErrors | None:
    """Propagate the uncertainty of the camera calibration to clouds and poses; None where it is not known, or there are no points."""
    clouds = [np.asarray(view.cloud.points_mm) for view in views if len(view.cloud)]
    if not clouds:
        return None
    corners = np.stack([np.min([cloud.min(axis=0) for cloud in clouds], axis=0), np.max([cloud.max(axis=0) for cloud in clouds], axis=0)])
    return calibration_errors(rig, [view.readback for view in views], corners)


def _approaches(project: ProjectFolder, views: Sequence[ViewResult]) -> list[str] | None:
    """Return the id of the robot's approach of each view; None unless all are known."""
    stored = set(project.stored_viewpoints())
    known = [approach for view in views if view.viewpoint_id in stored and (approach := project.frames.approach(view.viewpoint_id))]
    return known if len(known) == len(views) else None


def stitch_settings(calibration: RigCalibration, views: Sequence[ViewResult]) -> StitchSettings:
    """Return the stitching settings used without a covariance: tight priors if the robot's error was measured at all stations."""
    known = all(calibration.station(view.readback) is not None for view in views)
    return StitchSettings(pose_sigma_mm=KNOWN_STATION_MM, pose_sigma_deg=KNOWN_STATION_DEG) if known else StitchSettings()


def project_settings(project: ProjectFolder, calibration: RigCalibration, views: Sequence[ViewResult]) -> InspectionSettings:
    """Return the settings with which the part of a project is inspected, the temperature in its header included."""
    return inspection_settings(calibration, project.rig(), views, temperature_of(read_identification(project.path)))


def inspection_settings(
    calibration: RigCalibration, rig: RigDescription, views: Sequence[ViewResult], temperature: PartTemperature | None = None
) -> InspectionSettings:
    """Return the inspection settings, with assumed uncertainties of axes and calibration for clouds without an error model.

    If the robot's error was measured at all stations, a view's position is as uncertain as the robot's repeatability and the table's
    accuracy, otherwise as the robot's absolute accuracy. The scale is as uncertain as the focal lengths.
    """
    known = all(calibration.station(view.readback) is not None for view in views)
    table_mm = float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)) * TYPICAL_RADIUS_MM
    placement_mm = float(np.hypot(rig.robot.repeatability_mm, table_mm)) if known else rig.robot.absolute_accuracy_mm
    scales = [
        camera.standard_deviations.get("fx", 0.0) / float(camera.pinhole.matrix[0, 0]) for camera in calibration.cameras.cameras.values()
    ]
    scale = length_scale(calibration.cameras, rig)
    uncertainty = UncertaintySettings(
        placement_mm=placement_mm, systematic_relative=max(scales), scale_ppm=scale.ppm, scale_source=scale.source
    )
    return InspectionSettings(uncertainty=uncertainty, temperature=temperature)


def inspect_stitched(
    project: ProjectFolder, stitched: StitchedCloud, settings: InspectionSettings, progress: Progress
) -> Inspection | None:
    """Inspect a stitched cloud with the project's program and nominal; None without a program."""
    if project.program is None:
        return None
    from measureapp.inspection.dimensions import inspect
    from measureapp.project.program_file import read_program

    nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
    return inspect(stitched, read_program(project.program), nominal, settings, progress=progress)


def _settings(project: ProjectFolder, views: Sequence[ViewResult]) -> dict[str, Any]:
    plan = project.plan()
    if plan is None:
        return {}
    return {
        "plan": plan.name,
        "patterns": plan.patterns.name,
        "exposures_us": sorted({exposure_us for viewpoint in plan for exposure_us in plan.exposures_of(viewpoint)}, reverse=True),
        "exposure rule": "all unsaturated exposures, weighted by inverse variance",
        "noise": describe_noise(project, views),
    }
