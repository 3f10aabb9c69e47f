"""What no viewpoint can see, and the first condition that prevents it, as connected areas of the surface."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.planning.coverage.head import Head
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.scene import RAY_OFFSET_MM, PartScene
from measureapp.planning.coverage.visibility import seen_from
from measureapp.progress import Progress

CONTACT_MM = 1.0  # distance to table or fixture below which the surface touches it
TILTS_DEG = (0.0, 22.0, 44.0, 60.0, 80.0)  # of an imagined head against the normal
TURNS = 6
ROLLS_DEG = (0.0, 90.0)
CLUSTERS = 60
LINK_FACTOR = 1.8  # of the spacing of samples, within which unseen ones form one area


class Cause(StrEnum):
    """Why a part of the surface cannot be measured: the first condition that fails."""

    SUPPORT = "touches the support"
    NO_PAIR = "no free line of sight for a camera pair and the projector"
    INCIDENCE = "too oblique from every side that is free"
    REACH = "out of reach of the robot"
    COLLISION = "only from where something would collide"
    LIGHT = "only near the mirror direction"


ORDER = tuple(Cause)
UNKNOWN = -1


@dataclass(frozen=True, slots=True)
class UnreachableArea:
    """A connected area that no viewpoint sees."""

    cause: Cause
    area_mm2: float
    share: float  # of the whole surface
    place_mm: tuple[float, float, float]  # of the sample nearest to its centroid, frame `part`
    samples: tuple[int, ...]  # indices


def find_causes(
    samples: SurfaceSamples,
    head: Head,
    scene: PartScene,
    limits: VisibilityLimits,
    candidates: tuple[FloatArray, FloatArray] | None,
    progress: Progress,
) -> IntArray:
    """Return the index in `ORDER` of what prevents each of N samples, none of which the viewpoints at hand see, (N,) int.

    Conditions are relaxed one after the other: for a head anywhere in space, whatever the incidence and light; then at an admissible
    incidence; then only at poses within reach; then only where nothing collides.

    Parameters
    ----------
    candidates : part_from_head (V, 4, 4) of all poses within reach, and of those of them at which nothing touches; None: they are not
        known, and what a head anywhere in space would measure is `UNKNOWN`
    """
    cause = np.full(len(samples), UNKNOWN)

    def blame(what: Cause, sees: Callable[[SurfaceSamples], BoolArray]) -> None:
        left = np.flatnonzero(cause == UNKNOWN)
        if len(left):
            cause[left[~sees(samples.subset(left))]] = ORDER.index(what)

    progress.report(0, 5, "what cannot be seen")
    blame(Cause.SUPPORT, lambda some: ~touches_support(some, scene))
    blame(Cause.NO_PAIR, lambda some: _seen_from_anywhere(some, head, scene, limits.without_incidence(), progress))
    blame(Cause.INCIDENCE, lambda some: _seen_from_anywhere(some, head, scene, limits.without_light(), progress))
    if candidates is None:
        return cause
    reachable, free = candidates
    blame(Cause.REACH, lambda some: _seen_from_any(reachable, some, head, scene, limits.without_light(), progress))
    blame(Cause.COLLISION, lambda some: _seen_from_any(free, some, head, scene, limits.without_light(), progress))
    return np.where(cause == UNKNOWN, ORDER.index(Cause.LIGHT), cause)


def as_areas(unseen: IntArray, cause: IntArray, samples: SurfaceSamples) -> tuple[UnreachableArea, ...]:
    """Group unseen samples, given by indices, into connected areas of one cause, the largest first."""
    points = samples.points_mm[unseen]
    spacing = float(np.sqrt(np.median(samples.areas_mm2)))
    pairs = cKDTree(points).query_pairs(LINK_FACTOR * spacing, output_type="ndarray")
    same = (cause[pairs[:, 0]] == cause[pairs[:, 1]]) & (_facing(samples.normals[unseen], pairs) > 0.0)
    pairs = pairs[same]
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(unseen), len(unseen)))
    count, label = connected_components(graph, directed=False)
    areas = [_area(unseen[label == group], ORDER[int(cause[label == group][0])], samples) for group in range(count)]
    return tuple(sorted(areas, key=lambda area: (-area.area_mm2, area.samples)))


def touches_support(samples: SurfaceSamples, scene: PartScene) -> BoolArray:
    """Return which samples (N,) touch the table or a fixture."""
    return scene.gap_to_support_mm(samples.points_mm + RAY_OFFSET_MM * samples.normals, samples.normals) <= CONTACT_MM


def _facing(normals: FloatArray, pairs: IntArray) -> FloatArray:
    return np.asarray(np.einsum("ni,ni->n", normals[pairs[:, 0]], normals[pairs[:, 1]]))


def _area(members: IntArray, cause: Cause, samples: SurfaceSamples) -> UnreachableArea:
    area, points = samples.areas_mm2[members], samples.points_mm[members].astype(float)
    centre = area @ points / max(float(area.sum()), 1e-300)
    x, y, z = (float(value) for value in points[np.linalg.norm(points - centre, axis=1).argmin()])
    total = float(area.sum())
    return UnreachableArea(cause, total, total / samples.area_mm2, (x, y, z), tuple(int(one) for one in members))


def _seen_from_any(
    poses: FloatArray, samples: SurfaceSamples, head: Head, scene: PartScene, limits: VisibilityLimits, progress: Progress
) -> BoolArray:
    if not len(poses):
        return np.zeros(len(samples), bool)
    return np.asarray(seen_from(poses, samples, head, scene, limits, progress).seen.any(axis=0))


def _seen_from_anywhere(samples: SurfaceSamples, head: Head, scene: PartScene, limits: VisibilityLimits, progress: Progress) -> BoolArray:
    """Return which samples a head sees that is aimed at them, or at a neighbour, from directions all around their normals."""
    seen = np.zeros(len(samples), bool)
    for members in clusters(samples, CLUSTERS):
        progress.check()
        some = samples.subset(members)
        middle = int(np.linalg.norm(some.points_mm - some.points_mm.mean(axis=0), axis=1).argmin())
        poses = heads_around(some.points_mm[middle], some.normals[middle], head.standoff_mm)
        seen[members] = seen_from(poses, some, head, scene, limits).seen.any(axis=0)
    return seen


def clusters(samples: SurfaceSamples, count: int) -> list[IntArray]:
    """Split samples into at most ``count`` groups by place and normal: each joins the nearest of samples that are far apart."""
    scale = max(float(np.ptp(samples.points_mm, axis=0).max()), 1e-9)
    features = np.hstack([samples.points_mm / scale * 2.0, samples.normals * 0.5])
    centres = [0]
    distance = np.linalg.norm(features - features[0], axis=1)
    while len(centres) < min(count, len(samples)) and distance.max() > 0.05:
        centres.append(int(distance.argmax()))
        distance = np.minimum(distance, np.linalg.norm(features - features[centres[-1]], axis=1))
    nearest = cKDTree(features[centres]).query(features)[1]
    return [np.flatnonzero(nearest == number) for number in range(len(centres))]


def heads_around(target_mm: FloatArray, normal: FloatArray, distance_mm: float) -> FloatArray:
    """Return poses (V, 4, 4) of a head aimed at a target from directions around a normal, in frame `part`, wherever the robot reaches."""
    helper = np.eye(3)[int(np.abs(normal).argmin())]
    side = np.cross(normal, helper)
    side /= np.linalg.norm(side)
    other = np.cross(normal, side)
    poses = []
    for tilt in np.deg2rad(TILTS_DEG):
        for turn in np.linspace(0.0, 2.0 * np.pi, TURNS if tilt else 1, endpoint=False):
            outward = np.cos(tilt) * normal + np.sin(tilt) * (np.cos(turn) * side + np.sin(turn) * other)
            poses += [_aimed(target_mm, outward, distance_mm, roll) for roll in ROLLS_DEG]
    return np.array(poses)


def _aimed(target_mm: FloatArray, outward: FloatArray, distance_mm: float, roll_deg: float) -> FloatArray:
    forward = -outward / np.linalg.norm(outward)
    up = np.array([0.0, 0.0, 1.0]) if abs(forward[2]) < 0.99 else np.array([1.0, 0.0, 0.0])
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    down, roll = np.cross(forward, right), np.deg2rad(roll_deg)
    pose = np.eye(4)
    pose[:3, 0] = np.cos(roll) * right + np.sin(roll) * down
    pose[:3, 1] = np.cos(roll) * down - np.sin(roll) * right
    pose[:3, 2] = forward
    pose[:3, 3] = target_mm - distance_mm * forward
    return pose
