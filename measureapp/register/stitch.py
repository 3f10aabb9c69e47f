"""Registration and merging of all views, with the kinematic poses as priors."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
from measureapp.data.view_errors import FormErrors, ViewErrors, expand_motions
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.joint.pose_prior import NO_PRIOR, PosePrior
from measureapp.register.joint.registration import PreparedView, Registration
from measureapp.register.joint.registration_cache import LEAST_POINTS, RegistrationCache, map_in_parallel
from measureapp.register.merge import merge
from measureapp.register.settings import StitchSettings


def stitch(
    clouds: Sequence[PointCloud],
    kinematic: Sequence[RigidTransform],
    settings: StitchSettings | None = None,
    progress: Progress | None = None,
    *,
    prior: PosePrior = NO_PRIOR,
    accepted: Collection[str] = (),
    registration_cache: RegistrationCache | None = None,
) -> StitchedCloud:
    """Register all views and merge them.

    Overlapping pairs are found at the kinematic poses and registered; then all poses are estimated jointly with the kinematic poses as
    priors, so that motions the surface does not constrain keep their kinematic values. These motions are listed per view. A view whose
    correction exceeds the limit of its prior is excluded, unless it is accepted. The result does not depend on the order of the views.

    Parameters
    ----------
    clouds : one per view, in frame ``camera``
    kinematic : kinematic poses part_from_camera, one per cloud
    prior : what is known about the errors of the kinematic poses
    accepted : viewpoints that are used even if they contradict their kinematic position
    registration_cache : cache to which these clouds were added during the scan; the result is the same without it

    Raises
    ------
    RegistrationError
        No cloud has enough points, or the numbers of poses and clouds differ.
    """
    settings, progress = settings or StitchSettings(), progress or NoProgress()
    stations = prior.stations
    _require_matching_sizes(len(clouds), len(kinematic), len(stations or clouds), prior.covariance)
    order = sorted(range(len(clouds)), key=lambda i: (clouds[i].viewpoint_id, i))
    chosen = [i for i in order if len(clouds[i]) >= LEAST_POINTS]
    if not chosen:
        raise RegistrationError("No cloud has enough points for registration.", f"At least one cloud needs {LEAST_POINTS} points.")
    cache = registration_cache or RegistrationCache(settings)
    cache.finish()
    progress.report(0.0, 1, "preparing views")
    spacing = float(np.median(map_in_parallel(cache.spacing_mm, [clouds[i] for i in chosen])))
    voxel = cache.voxel_mm([clouds[i] for i in chosen], settings)
    prepared = map_in_parallel(lambda i: cache.prepare(clouds[i], voxel), chosen)
    views = [
        PreparedView(clouds[i], kinematic[i], stations[i] if stations is not None else i, cloud)
        for i, cloud in zip(chosen, prepared, strict=True)
    ]
    rows = (6 * np.array(chosen)[:, None] + np.arange(6)).ravel()
    registration = Registration(views, cache, settings, PartOf(progress, 0.15, 0.7), prior=prior.select(rows), accepted=accepted)
    placed, loop_closure, errors = registration.run()
    by_cloud = dict(zip(chosen, placed, strict=True))
    placements = tuple(by_cloud.get(i) or _exclude(clouds[i], kinematic[i]) for i in range(len(clouds)))
    merged = _merge_views(clouds, placements, settings, spacing, PartOf(progress, 0.7, 1.0))
    expanded = _expand_errors(errors, chosen, placements)
    return replace(merged, loop_closure=loop_closure, errors=expanded, axis_doubt=registration.axis_doubt)


def _require_matching_sizes(clouds: int, poses: int, stations: int, prior_covariance: FloatArray | None) -> None:
    if not clouds == poses == stations:
        raise RegistrationError(f"There are {clouds} clouds but {poses} poses.", "Give one pose per cloud.")
    if prior_covariance is not None and np.shape(prior_covariance) != (6 * clouds,) * 2:
        raise RegistrationError(
            f"The covariance of {clouds} poses has shape {np.shape(prior_covariance)}.", "Give six rows and columns per view."
        )


def _expand_errors(errors: ViewErrors, chosen: Sequence[int], placements: Sequence[ViewPlacement]) -> ViewErrors:
    """Expand the errors of the registered views to all placements; excluded views have zero errors."""
    centres = np.zeros((len(placements), 3))
    centres[chosen] = errors.centres_mm
    stitching_motions, calibration_motions = (
        expand_motions(chosen, motions, len(placements)) for motions in (errors.stitching_motions, errors.calibration_motions)
    )
    return replace(
        errors,
        poses=tuple(placement.part_from_camera for placement in placements),
        centres_mm=centres,
        stitching_motions=stitching_motions,
        calibration_motions=calibration_motions,
        form=None if errors.form is None else _expand_form_errors(errors.form, chosen, len(placements)),
        systematic=None
        if errors.systematic is None
        else replace(errors.systematic, motions=expand_motions(chosen, errors.systematic.motions, len(placements))),
    )


def _expand_form_errors(form: FormErrors, chosen: Sequence[int], count: int) -> FormErrors:
    sizes, reaches = np.zeros(count), np.ones(count)
    sizes[chosen], reaches[chosen] = form.sizes_mm, form.reaches_mm
    return FormErrors(form.nodes_mm, np.asarray(chosen, int)[form.view], sizes, reaches, expand_motions(chosen, form.motions, count))


def _exclude(cloud: PointCloud, kinematic: RigidTransform) -> ViewPlacement:
    reason = f"only {len(cloud)} points: excluded"
    return ViewPlacement(cloud.viewpoint_id, kinematic, kinematic, 0.0, 0.0, 0.0, 0.0, reason, False)


def _merge_views(
    clouds: Sequence[PointCloud], placements: tuple[ViewPlacement, ...], settings: StitchSettings, spacing_mm: float, progress: Progress
) -> StitchedCloud:
    used = [i for i, placement in enumerate(placements) if placement.used]
    if not used:
        raise RegistrationError("No view can be used: each contradicts its kinematic position.", "Check the calibration.")
    used.sort(key=lambda i: placements[i].viewpoint_id)
    poses = [placements[i].part_from_camera for i in used]
    voxel = settings.merge_voxel_mm or spacing_mm
    merged = merge(
        [clouds[i] for i in used],
        [pose.translation_mm for pose in poses],
        voxel,
        poses=poses,
        views=used,
        island_mm2=settings.island_mm2,
        progress=progress,
    )
    notes = {"spacing_mm": spacing_mm, "merge_voxel_mm": voxel, "views_used": float(len(used))}
    frame = poses[0].to_frame
    return StitchedCloud(
        merged.points_mm,
        merged.normals,
        merged.sigma_mm,
        merged.grey,
        merged.view,
        placements,
        frame,
        notes,
        sampled_view=merged.sampled_view,
    )
