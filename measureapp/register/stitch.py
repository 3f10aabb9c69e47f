"""Fine stitching: all views together, with the kinematic poses as priors, then merged."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
from measureapp.data.view_errors import CalibrationErrors, FormErrors, ViewErrors, motions_of
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.joint.groundwork import LEAST_POINTS, Groundwork, in_parallel
from measureapp.register.joint.registration import Registration, View
from measureapp.register.merge import merge
from measureapp.register.settings import StitchSettings


def stitch(
    clouds: Sequence[PointCloud],
    kinematic: Sequence[RigidTransform],
    settings: StitchSettings | None = None,
    progress: Progress | None = None,
    *,
    stations: Sequence[Hashable] | None = None,
    prior_covariance: FloatArray | None = None,
    calibration: CalibrationErrors | None = None,
    accepted: Collection[str] = (),
    groundwork: Groundwork | None = None,
) -> StitchedCloud:
    """Register all views finely and merge them.

    Overlapping pairs are found by the kinematic poses and registered; then all poses are estimated together with the
    kinematic poses as priors, so that nothing slides where the surface does not hold it; every view says which motions
    that are. A view that would move further than the priors allow is left out and says so, unless it is accepted. The result does
    not depend on the order of the views.

    Parameters
    ----------
    clouds : one per view, in frame ``camera``
    kinematic : part_from_camera by the axes, one per cloud
    stations : one label per view, equal for views between which only the table turned (`register.place.stations`);
        these share the robot's error. None: every view stands alone.
    prior_covariance : (6N, 6N), of the errors of all poses by the axes, as motions of each camera in its own frame (shift mm,
        turn rad), from the joint calibration of the rig. None: by the standard deviations of the settings and the stations.
    calibration : what the cameras' calibration leaves open, as errors of the clouds and of the poses by the axes; None where not known
    accepted : viewpoints that are used however far they have to move
    groundwork : where these clouds were added while the scan went on; the result is the same without

    Raises
    ------
    RegistrationError
        No cloud has enough points, or poses and clouds do not go together.
    """
    settings, progress = settings or StitchSettings(), progress or NoProgress()
    _require_alike(len(clouds), len(kinematic), len(stations or clouds), prior_covariance)
    order = sorted(range(len(clouds)), key=lambda i: (clouds[i].viewpoint_id, i))
    chosen = [i for i in order if len(clouds[i]) >= LEAST_POINTS]
    if not chosen:
        raise RegistrationError("No cloud has enough points to be stitched.", f"At least one needs {LEAST_POINTS} points.")
    groundwork = groundwork or Groundwork(settings)
    groundwork.finish()
    progress.report(0.0, 1, "preparing views")
    spacing = float(np.median(in_parallel(groundwork.spacing_mm, [clouds[i] for i in chosen])))
    voxel = groundwork.voxel_mm([clouds[i] for i in chosen], settings)
    prepared = in_parallel(lambda i: groundwork.prepared(clouds[i], voxel), chosen)
    views = [
        View(clouds[i], kinematic[i], stations[i] if stations is not None else i, cloud) for i, cloud in zip(chosen, prepared, strict=True)
    ]
    rows = (6 * np.array(chosen)[:, None] + np.arange(6)).ravel()
    prior = None if prior_covariance is None else np.asarray(prior_covariance)[np.ix_(rows, rows)]
    own = None if calibration is None else replace(calibration, by_axes=np.asarray(calibration.by_axes)[rows])
    registration = Registration(
        views, groundwork, settings, PartOf(progress, 0.15, 0.7), prior_covariance=prior, calibration=own, accepted=accepted
    )
    placed, ring, errors = registration.result()
    by_cloud = dict(zip(chosen, placed, strict=True))
    placements = tuple(by_cloud.get(i) or _left_out(clouds[i], kinematic[i]) for i in range(len(clouds)))
    merged = _merged(clouds, placements, settings, spacing, PartOf(progress, 0.7, 1.0))
    return replace(merged, ring=ring, errors=_of_all(errors, chosen, placements))


def _require_alike(clouds: int, poses: int, stations: int, prior_covariance: FloatArray | None) -> None:
    if not clouds == poses == stations:
        raise RegistrationError(f"{clouds} clouds and {poses} poses do not go together.", "Give one pose per cloud.")
    if prior_covariance is not None and np.shape(prior_covariance) != (6 * clouds,) * 2:
        raise RegistrationError(
            f"A covariance of shape {np.shape(prior_covariance)} does not go with {clouds} poses.", "Give one of six numbers per view."
        )


def _of_all(errors: ViewErrors, chosen: Sequence[int], placements: Sequence[ViewPlacement]) -> ViewErrors:
    """Return the errors of the chosen views as those of all placements; views that were left out have no points to err."""
    centres = np.zeros((len(placements), 3))
    centres[chosen] = errors.centres_mm
    by_stitching, by_calibration = (
        motions_of(chosen, motions, len(placements)) for motions in (errors.by_stitching, errors.by_calibration)
    )
    return replace(
        errors,
        poses=tuple(placement.part_from_camera for placement in placements),
        centres_mm=centres,
        by_stitching=by_stitching,
        by_calibration=by_calibration,
        form=None if errors.form is None else _form_of_all(errors.form, chosen, len(placements)),
        common=None
        if errors.common is None
        else replace(errors.common, motions=motions_of(chosen, errors.common.motions, len(placements))),
    )


def _form_of_all(form: FormErrors, chosen: Sequence[int], count: int) -> FormErrors:
    sizes, reaches = np.zeros(count), np.ones(count)
    sizes[chosen], reaches[chosen] = form.sizes_mm, form.reaches_mm
    return FormErrors(form.nodes_mm, np.asarray(chosen, int)[form.view], sizes, reaches, motions_of(chosen, form.motions, count))


def _left_out(cloud: PointCloud, kinematic: RigidTransform) -> ViewPlacement:
    reason = f"only {len(cloud)} points: left out"
    return ViewPlacement(cloud.viewpoint_id, kinematic, kinematic, 0.0, 0.0, 0.0, 0.0, reason, False)


def _merged(
    clouds: Sequence[PointCloud], placements: tuple[ViewPlacement, ...], settings: StitchSettings, spacing_mm: float, progress: Progress
) -> StitchedCloud:
    used = [i for i, placement in enumerate(placements) if placement.used]
    if not used:
        raise RegistrationError("No view can be used.", "Check the calibration: every view contradicts the axes.")
    used.sort(key=lambda i: placements[i].viewpoint_id)
    poses = [placements[i].part_from_camera for i in used]
    voxel = settings.merge_voxel_mm or spacing_mm
    merged = merge(
        in_parallel(lambda i: clouds[i].seen_from(placements[i].part_from_camera), used),
        [pose.translation_mm for pose in poses],
        voxel,
        views=used,
        island_mm2=settings.island_mm2,
        progress=progress,
    )
    notes = {"spacing_mm": spacing_mm, "merge_voxel_mm": voxel, "views_used": float(len(used))}
    frame = poses[0].to_frame
    return StitchedCloud(
        merged.points_mm, merged.normals, merged.sigma_mm, merged.grey, merged.view, placements, frame, notes, drawn_view=merged.drawn_view
    )
