"""From the clouds of the views to a part, and from the part to its dimensions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from typing import Any

import numpy as np

from measureapp.acquire.events import Event, InspectionReady, StitchReady, SurfaceFailed, ValidityKnown
from measureapp.arrays import FloatArray
from measureapp.calibrate.rig.cloud_errors import calibration_errors
from measureapp.calibrate.rig.stitch_uncertainty import view_uncertainty
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Inspection, Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.rig import RigDescription
from measureapp.data.validity import Validity
from measureapp.data.view_choices import ViewChoices
from measureapp.data.view_errors import CalibrationErrors
from measureapp.errors import RegistrationError
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from measureapp.pipeline.chosen_views import chosen, with_refused
from measureapp.pipeline.noise import noise_words
from measureapp.pipeline.validity import validity_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.register.joint.pose_prior import PosePrior
from measureapp.register.joint.registration_cache import RegistrationCache
from measureapp.register.place import number_stations
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch
from measureapp.register.surface.closed import reconstruct_surface

TYPICAL_RADIUS_MM = 100.0  # of points about the table's axis
KNOWN_STATION_MM, KNOWN_STATION_DEG = 0.03, 0.004  # repeatability of the robot and what the board leaves unknown


def assemble(
    project: ProjectFolder,
    calibrated: RigCalibration,
    views: Sequence[ViewResult],
    on_event: Callable[[Event], None],
    progress: Progress,
    watch: Stopwatch,
    registration_cache: RegistrationCache | None = None,
    *,
    choices: ViewChoices | None = None,
    former: Measurement | None = None,
) -> Measurement:
    """Stitch the clouds of all views, make the surface, measure the dimensions and keep everything.

    Parameters
    ----------
    groundwork : what was done of stitching while the views came
    choices : views used or refused by hand; None: as the project keeps them
    former : where the clouds are those of a measurement: its validity of the calibration and its settings hold for them; None: told anew

    Raises
    ------
    RegistrationError
        No view gave a cloud worth stitching.
    """
    validity = None if former is None else former.validity
    if validity is None:
        validity = validity_of(project, calibrated, views)
        on_event(ValidityKnown(validity))
    choices = project.view_choices() if choices is None else choices
    good = _worth_stitching(views, choices, validity)
    with watch.stage("stitching"):
        stitched = _stitched(project, calibrated, good, choices, PartOf(progress, 0.0, 0.5), registration_cache)
        stitched = with_refused(stitched, views, choices)
    on_event(StitchReady(stitched))
    with watch.stage("surface"):
        mesh = _surface(stitched, on_event, PartOf(progress, 0.5, 0.7))
    with watch.stage("inspection"):
        inspection = _inspected(project, stitched, inspection_settings(calibrated, project.rig(), good), PartOf(progress, 0.7, 0.9))
    if inspection is not None:
        on_event(InspectionReady(inspection))
    measurement = Measurement(
        project=project.name,
        part=project.settings.part,
        rig=project.rig().name,
        measured_at=datetime.now(UTC).isoformat(timespec="seconds"),
        calibration=calibrated,
        views=tuple(views),
        stitched=stitched,
        mesh=mesh,
        inspection=inspection,
        settings=_settings(project) if former is None else former.settings,
        timings_s=dict(watch.seconds),
        validity=validity,
    )
    with watch.stage("saving"):
        project.save_measurement(measurement, PartOf(progress, 0.9, 1.0))
    progress.report(1.0, 1.0, "measured")
    return measurement


def _surface(stitched: StitchedCloud, on_event: Callable[[Event], None], progress: Progress) -> Mesh | None:
    """Return the surface; None where there is none, as for want of memory: nothing is measured on it."""
    try:
        return reconstruct_surface(stitched, progress=progress)
    except RegistrationError as error:
        on_event(SurfaceFailed(error.message, error.hint))
        return None


def _worth_stitching(views: Sequence[ViewResult], choices: ViewChoices, validity: Validity) -> list[ViewResult]:
    """Return the views that are good or wanted by hand; raises RegistrationError with the reasons where there is none."""
    good = chosen(views, choices)
    if not good:
        reasons = "; ".join(sorted({view.quality.reason or "refused by hand" for view in views})) or "no view gave points"
        told = " ".join(("", *validity.all_warnings))
        raise RegistrationError(f"There is nothing to stitch: {reasons}.{told}", "Look at the images; change exposures or viewpoints.")
    return good


def _stitched(
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
        prior=PosePrior(number_stations([view.readback for view in good]), _placed_by_axes(project, good), _left_open(project, good)),
        accepted=choices.used,
        registration_cache=registration_cache,
    )


def _placed_by_axes(project: ProjectFolder, views: Sequence[ViewResult]) -> FloatArray | None:
    """Return the covariance of where the calibrated axes place the views, all together; None where the calibration did not keep it."""
    rig = project.rig_uncertainty()
    if rig is None:
        return None
    return view_uncertainty(rig, [view.readback for view in views], _approaches(project, views)).pose_covariance


def _left_open(project: ProjectFolder, views: Sequence[ViewResult]) -> CalibrationErrors | None:
    """Return how the cameras' calibration errs in clouds and poses; None where the project's calibration did not keep it."""
    rig = project.rig_uncertainty()
    clouds = [np.asarray(view.cloud.points_mm) for view in views if len(view.cloud)]
    if rig is None or not clouds:
        return None
    corners = np.stack([np.min([cloud.min(axis=0) for cloud in clouds], axis=0), np.max([cloud.max(axis=0) for cloud in clouds], axis=0)])
    return calibration_errors(rig, [view.readback for view in views], corners)


def _approaches(project: ProjectFolder, views: Sequence[ViewResult]) -> list[str] | None:
    """Return by which approach of the robot each view was taken; None where that is not known of all of them."""
    stored = set(project.stored_viewpoints())
    known = [approach for view in views if view.viewpoint_id in stored and (approach := project.frames.approach(view.viewpoint_id))]
    return known if len(known) == len(views) else None


def stitch_settings(calibration: RigCalibration, views: Sequence[ViewResult]) -> StitchSettings:
    """Return the settings of stitching where no covariance is known: the priors are tight where the robot's error was measured at every station of the scan."""
    known = all(calibration.station(view.readback) is not None for view in views)
    return StitchSettings(pose_sigma_mm=KNOWN_STATION_MM, pose_sigma_deg=KNOWN_STATION_DEG) if known else StitchSettings()


def inspection_settings(calibration: RigCalibration, rig: RigDescription, views: Sequence[ViewResult]) -> InspectionSettings:
    """Return the settings of inspection with what is assumed of axes and calibration where stitched clouds do not know how their views err.

    Where the robot's error was measured at the stations of the scan, a view is placed as well as the robot repeats and the
    table turns; elsewhere only as well as the robot's absolute accuracy. The scale is known as well as the focal lengths.
    """
    known = all(calibration.station(view.readback) is not None for view in views)
    table_mm = float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)) * TYPICAL_RADIUS_MM
    placement_mm = float(np.hypot(rig.robot.repeatability_mm, table_mm)) if known else rig.robot.absolute_accuracy_mm
    scales = [
        camera.standard_deviations.get("fx", 0.0) / float(camera.pinhole.matrix[0, 0]) for camera in calibration.cameras.cameras.values()
    ]
    scale_ppm = rig.calibration_rules.scale_ppm
    return InspectionSettings(
        uncertainty=UncertaintySettings(placement_mm=placement_mm, systematic_relative=max(scales), scale_ppm=scale_ppm)
    )


def _inspected(project: ProjectFolder, stitched: StitchedCloud, settings: InspectionSettings, progress: Progress) -> Inspection | None:
    if project.program is None:
        return None
    from measureapp.inspection.dimensions import inspect
    from measureapp.project.geometry.files import read_mesh
    from measureapp.project.program_file import read_program

    nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
    return inspect(stitched, read_program(project.program), nominal, settings, progress=progress)


def _settings(project: ProjectFolder) -> dict[str, Any]:
    plan = project.plan()
    if plan is None:
        return {}
    return {
        "plan": plan.name,
        "patterns": plan.patterns.name,
        "exposures_us": list(plan.bracket.exposures_us),
        "exposure rule": "all unsaturated exposures, weighted by inverse variance",
        "noise": noise_words(project),
    }
