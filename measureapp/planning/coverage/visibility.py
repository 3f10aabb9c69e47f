"""Which surface points are measured from a viewpoint, with which standard deviation, and the first reason why not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.planning.coverage.head import Eye, Head, heads_at
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.noise import sigma_along_ray
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.scene import RAY_OFFSET_MM, PartScene
from measureapp.progress import NoProgress, Progress

FULL_WIDTH_PX = 2592  # of the cameras for which the image margin is stated
RAYS_AT_ONCE = 400_000


class Unseen(IntEnum):
    """The first condition that fails for a point at a viewpoint, in the order of the tests."""

    SEEN = 0
    FIELD = 1  # outside the depth of field, or the image of the projector or of all but one camera
    INCIDENCE = 2  # the surface faces away, or is too oblique
    LIGHT = 3  # near the mirror direction, where gloss saturates
    HIDDEN = 4  # by part, table or fixture


@dataclass(frozen=True, slots=True, eq=False)
class Visibility:
    """What V viewpoints see of N samples."""

    sigma_mm: FloatArray  # (V, N) float32, standard deviation along the ray of a camera; NaN: not seen
    reason: IntArray  # (V, N) uint8, an `Unseen`

    @property
    def seen(self) -> BoolArray:
        """Whether a sample is measured, (V, N)."""
        return self.reason == Unseen.SEEN


def seen_by(
    viewpoints: Sequence[Viewpoint],
    samples: SurfaceSamples,
    rig: RigDescription,
    scene: PartScene,
    limits: VisibilityLimits | None = None,
    progress: Progress | None = None,
) -> Visibility:
    """Predict what viewpoints measure: which samples, with which standard deviation.

    A sample is seen if the projector and at least two cameras (one, if the rig has only one) have it in their images and in the depth of
    field, at an admissible incidence, away from the mirror direction, with a free line of sight. Cameras that fail do not count.

    Parameters
    ----------
    viewpoints : V viewpoints of ``rig``
    samples : N points of the surface, in the frame `part` (see `head.part_from_head`), from `samples.sample_surface`
    rig : nominal description
    scene : what hides points, from `PartScene.of`
    limits : default: `VisibilityLimits()`
    progress : also the cancellation point

    Returns
    -------
    Visibility
        ``sigma_mm`` (V, N) float32, NaN where not seen; ``reason`` (V, N) uint8, the first condition that fails (`Unseen`).
    """
    return seen_from(heads_at(viewpoints, rig), samples, Head.of(rig), scene, limits, progress)


def seen_from(
    part_from_head: FloatArray,
    samples: SurfaceSamples,
    head: Head,
    scene: PartScene,
    limits: VisibilityLimits | None = None,
    progress: Progress | None = None,
) -> Visibility:
    """Predict what a head measures from poses (V, 4, 4), which need not be within reach; otherwise as `seen_by`."""
    limits, progress = limits or VisibilityLimits(), progress or NoProgress()
    views, count = len(part_from_head), len(samples)
    sigma = np.full((views, count), np.nan, np.float32)
    reason = np.empty((views, count), np.uint8)
    pending: list[_Pending] = []
    waiting = 0
    for view, pose in enumerate(part_from_head):
        left = _before_rays(pose, samples, head, limits, reason[view])
        pending.append(_Pending(view, *left, pose))
        waiting += len(left[0]) * (1 + len(head.cameras))
        if waiting > RAYS_AT_ONCE or view == views - 1:
            _cast(pending, samples, head, scene, limits, sigma, reason)
            progress.report(view + 1, views, "visibility")
            pending, waiting = [], 0
    return Visibility(sigma, reason)


@dataclass(frozen=True, slots=True, eq=False)
class _Pending:
    """Samples of one view that only rays can still exclude."""

    view: int
    index: IntArray  # (n,)
    cameras: BoolArray  # (n, C), which of the cameras have passed so far
    pose: FloatArray  # (4, 4), part_from_head


@dataclass(frozen=True, slots=True, eq=False)
class _Sighting:
    """All samples as one device has them."""

    inside: BoolArray  # (N,), in its image
    cosine: FloatArray  # (N,), of the incidence
    direction: FloatArray  # (N, 3), unit, from the sample to the device


def _before_rays(
    pose: FloatArray, samples: SurfaceSamples, head: Head, limits: VisibilityLimits, reason: IntArray
) -> tuple[IntArray, BoolArray]:
    """Apply all conditions but the lines of sight, write ``reason`` (N,), and return what is left: indices and cameras."""
    rotation = pose[:3, :3].astype(np.float32)
    points = (samples.points_mm - pose[:3, 3].astype(np.float32)) @ rotation
    reason[:] = Unseen.FIELD
    near, far = head.depth_mm
    index = np.flatnonzero((points[:, 2] >= near) & (points[:, 2] <= far))
    index = index[_sight(head.projector, points[index], None, _margin_px(head.projector, limits)).inside]
    points, normals = points[index], samples.normals[index] @ rotation
    light = _sight(head.projector, points, normals, 0.0)
    sights = [_sight(camera, points, normals, _margin_px(camera, limits)) for camera in head.cameras]
    steep = np.cos(np.deg2rad(limits.camera_incidence_deg))
    cameras = np.column_stack([sight.inside for sight in sights])
    passed = _narrow(reason, index, np.ones(len(index), bool), cameras, Unseen.INCIDENCE, head.least_cameras)
    cameras &= np.column_stack([sight.cosine >= steep for sight in sights])
    passed &= light.cosine >= np.cos(np.deg2rad(limits.projector_incidence_deg))
    passed = _narrow(reason, index, passed, cameras, Unseen.LIGHT, head.least_cameras)
    if limits.mirror_deg > 0.0:
        mirrored = 2.0 * light.cosine[:, None] * normals - light.direction
        glare = np.cos(np.deg2rad(limits.mirror_deg))
        cameras &= np.column_stack([np.einsum("ni,ni->n", mirrored, sight.direction) < glare for sight in sights])
    passed = _narrow(reason, index, passed, cameras, Unseen.HIDDEN, head.least_cameras)
    return index[passed], cameras[passed]


def _narrow(reason: IntArray, index: IntArray, passed: BoolArray, cameras: BoolArray, following: Unseen, least_cameras: int) -> BoolArray:
    """Return what has passed with enough cameras; its reason is now the condition that follows."""
    passed = passed & (cameras.sum(axis=1) >= least_cameras)
    reason[index[passed]] = following
    return passed


def _margin_px(eye: Eye, limits: VisibilityLimits) -> float:
    """Return the image margin of a device: the same share of every width, for binned cameras as well."""
    return limits.image_margin_px * eye.width_px / FULL_WIDTH_PX


def _sight(eye: Eye, points: FloatArray, normals: FloatArray | None, margin_px: float) -> _Sighting:
    """Return samples (N, 3) in the frame `head` as ``eye`` has them; without normals only whether they are in the image."""
    rays = points - eye.position_mm.astype(np.float32)
    x, y, z = (rays @ eye.head_from_eye.astype(np.float32)).T
    half_x, half_y = (eye.width_px / 2.0 - margin_px) / eye.focal_px, (eye.height_px / 2.0 - margin_px) / eye.focal_px
    inside = (z > 0.0) & (np.abs(x) <= half_x * z) & (np.abs(y) <= half_y * z)
    if normals is None:
        return _Sighting(inside, np.empty(0), np.empty((0, 3)))
    direction = -rays / np.linalg.norm(rays, axis=1, keepdims=True)
    return _Sighting(inside, np.einsum("ni,ni->n", direction, normals), direction)


def _cast(
    pending: Sequence[_Pending],
    samples: SurfaceSamples,
    head: Head,
    scene: PartScene,
    limits: VisibilityLimits,
    sigma: FloatArray,
    reason: IntArray,
) -> None:
    """Cast the lines of sight of several views at once; write σ and reason of what is seen."""
    free = _free_cameras(pending, samples, head, scene)
    start = 0
    for one in pending:
        cameras = free[start : start + len(one.index)]
        start += len(one.index)
        seen = cameras.sum(axis=1) >= head.least_cameras
        index = one.index[seen]
        reason[one.view, index] = Unseen.SEEN
        rotation = one.pose[:3, :3].astype(np.float32)
        points = (samples.points_mm[index] - one.pose[:3, 3].astype(np.float32)) @ rotation
        sigma[one.view, index] = sigma_along_ray(points, samples.normals[index] @ rotation, cameras[seen], head, limits)


def _free_cameras(pending: Sequence[_Pending], samples: SurfaceSamples, head: Head, scene: PartScene) -> BoolArray:
    """Return which cameras have a free line of sight, none where the projector has not; rows of all pending views in turn."""
    index = np.concatenate([one.index for one in pending])
    view = np.repeat(np.arange(len(pending)), [len(one.index) for one in pending])
    cameras = np.concatenate([one.cameras for one in pending])
    poses = np.array([one.pose for one in pending])
    origins = samples.points_mm[index] + RAY_OFFSET_MM * samples.normals[index]

    def hidden(eye: Eye, rows: IntArray) -> BoolArray:
        eyes_mm = poses[:, :3, :3] @ eye.position_mm + poses[:, :3, 3]
        return scene.hidden(origins[rows], eyes_mm[view[rows]])

    rows = np.arange(len(index))
    cameras[hidden(head.projector, rows)] = False
    for number, camera in enumerate(head.cameras):
        rows = np.flatnonzero(cameras[:, number])
        cameras[rows[hidden(camera, rows)], number] = False
    return cameras
