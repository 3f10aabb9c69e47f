"""Checks of a stitched cloud against its error model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import LoopClosure, StitchedCloud, ViewPlacement
from measureapp.data.consistency import Consistency, ConsistencyCheck
from measureapp.data.measurement import ViewResult
from measureapp.pipeline.consistency.dependence import Dependence, compare_with_expected, estimate_dependence
from measureapp.pipeline.consistency.deviations import Deviations, compare_views

GREYS = 8  # classes of equal numbers of points
PIXEL_CELLS = 6  # along each side of the image
TILT_STEP = 0.25  # of the components of the normal across the optical axis
TIMES = 6  # classes of consecutive views
ANGLES, HEIGHTS = 12, 3  # classes of the table's angle, and of the height on the part

Classes = tuple[IntArray, IntArray]  # (N,) of the own and of the other point
PROPERTIES: dict[str, tuple[Callable[[Sequence[ViewResult], Deviations, Sequence[ViewPlacement]], Classes], str]]


def check_consistency(views: Sequence[ViewResult], stitched: StitchedCloud) -> Consistency:
    """Check the deviations between the views of a stitched cloud against its error model.

    Parameters
    ----------
    views : those that were stitched, in any order

    Returns
    -------
    No checks where the views have no error model or do not overlap.
    """
    if stitched.errors is None:
        return Consistency()
    by_name = {view.viewpoint_id: view for view in views}
    ordered = [by_name[placement.viewpoint_id] for placement in stitched.placements]
    deviations = compare_views([view.cloud for view in ordered], stitched, stitched.errors)
    checks = [] if deviations is None else _check_properties(ordered, deviations, stitched)
    if stitched.loop_closure is not None:
        checks.append(_check_loop(stitched.loop_closure))
    return Consistency(tuple(checks))


def with_unexplained(stitched: StitchedCloud, consistency: Consistency) -> StitchedCloud:
    """Return the cloud with what its error model does not explain as a contribution of its own."""
    if stitched.errors is None:
        return stitched
    return replace(stitched, errors=replace(stitched.errors, unexplained_mm=consistency.unexplained_mm))


def _check_properties(views: Sequence[ViewResult], deviations: Deviations, stitched: StitchedCloud) -> list[ConsistencyCheck]:
    checks = []
    for name, (classify, cause) in PROPERTIES.items():
        own, other = classify(views, deviations, stitched.placements)
        for view in views:  # of all of which one column was read
            view.cloud.give_up_pages()
        found = estimate_dependence(deviations.distance_mm, deviations.expected_mm, own, other)
        if found is not None:
            checks.append(_check(name, found, cause))
    return checks


def _check(name: str, found: Dependence, cause: str) -> ConsistencyCheck:
    return ConsistencyCheck(name, found.observed_mm, found.expected_mm, found.unexplained_mm, found.probability, cause)


def _check_loop(closure: LoopClosure) -> ConsistencyCheck:
    cause = "axes that move otherwise than calibrated, such as run-out of the table, or a part that moved"
    steps = len(closure.viewpoints)  # among which the joint estimate shares the gap
    found = compare_with_expected(closure.gap_mm / steps, closure.sigma_mm / steps, closure.freedom, closure.loops)
    return _check("loop closure", found, cause)


def _of_points(deviations: Deviations, classify: Callable[[int, IntArray], FloatArray | IntArray]) -> Classes:
    """Return the classes of both points from ``classify``, which gives those of some points of a view; never of whole clouds at once."""
    found = []
    for views, points in ((deviations.own_view, deviations.own_point), (deviations.other_view, deviations.other_point)):
        classes = np.empty(len(views), np.int64)
        for view in np.unique(views):
            rows = views == view
            classes[rows] = classify(int(view), points[rows])
        found.append(classes)
    return found[0], found[1]


def _by_pixel(views: Sequence[ViewResult], deviations: Deviations, _placements: Sequence[ViewPlacement]) -> Classes:
    highest = np.maximum(np.max([view.cloud.pixel.max(axis=0) for view in views if len(view.cloud)], axis=0), 1)

    def classify(view: int, points: IntArray) -> IntArray:
        pixel = np.asarray(views[view].cloud.pixel[points], np.int64)
        cell = np.minimum(PIXEL_CELLS * pixel // (highest + 1), PIXEL_CELLS - 1)
        return np.where(pixel.min(axis=1) < 0, -1, PIXEL_CELLS * cell[:, 0] + cell[:, 1])

    return _of_points(deviations, classify)


def _by_direction(views: Sequence[ViewResult], deviations: Deviations, _placements: Sequence[ViewPlacement]) -> Classes:
    steps = round(2 / TILT_STEP)

    def classify(view: int, points: IntArray) -> FloatArray:
        cell = np.clip((np.asarray(views[view].cloud.normals[points, :2]) + 1) // TILT_STEP, 0, steps - 1)
        return steps * cell[:, 0] + cell[:, 1]

    return _of_points(deviations, classify)


def _by_brightness(views: Sequence[ViewResult], deviations: Deviations, _placements: Sequence[ViewPlacement]) -> Classes:
    borders = np.quantile(np.concatenate([view.cloud.grey[::50] for view in views]), np.arange(1, GREYS) / GREYS)
    return _of_points(deviations, lambda view, points: np.searchsorted(borders, views[view].cloud.grey[points]))


def _by_time(views: Sequence[ViewResult], deviations: Deviations, placements: Sequence[ViewPlacement]) -> Classes:
    """Early and late views, each in a coarse grid of the image: views as a whole were registered, so that only bending is left."""
    half = max(-(-len(views) // 2), 1)
    order = {view.viewpoint_id: place for place, view in enumerate(sorted(views, key=lambda one: one.viewpoint_id))}
    late = np.array([order[view.viewpoint_id] // half for view in views])
    own, other = _by_pixel(views, deviations, placements)

    def cells(pixel: IntArray, view: IntArray) -> IntArray:
        coarse = (TIMES // 2) * (pixel // PIXEL_CELLS // 2) + pixel % PIXEL_CELLS // 2
        return np.where(pixel < 0, -1, TIMES**2 * late[view] + coarse)

    return cells(own, deviations.own_view), cells(other, deviations.other_view)


def _by_table(views: Sequence[ViewResult], deviations: Deviations, placements: Sequence[ViewPlacement]) -> Classes:
    def heights(view: int, points: IntArray | slice) -> FloatArray:
        pose = placements[view].part_from_camera
        return np.asarray(views[view].cloud.points_mm[points] @ pose.rotation[2] + pose.translation_mm[2])

    ends = [(part.min(), part.max()) for view in range(len(views)) if len(part := heights(view, slice(None)))]
    low, high = float(min(ends)[0]), float(max(end for _, end in ends))
    angles = [int(view.readback.table_rad / (2 * np.pi) * ANGLES) % ANGLES for view in views]

    def classify(view: int, points: IntArray) -> FloatArray:
        level = np.clip(HEIGHTS * (heights(view, points) - low) / max(high - low, 1e-9), 0, HEIGHTS - 1)
        return HEIGHTS * angles[view] + np.floor(level)

    return _of_points(deviations, classify)


PROPERTIES = {
    "camera pixel": (_by_pixel, "the lens model of the cameras, or a camera that moved since the calibration"),
    "surface direction": (
        _by_direction,
        "blur or light that depends on the direction of the surface, such as a part less sharp than the board",
    ),
    "brightness": (_by_brightness, "light scattered below the surface, gloss, or a camera that responds nonlinearly"),
    "time": (_by_time, "cameras or projector that drift while they warm up"),
    "table angle": (_by_table, "error motions of the table, or a part that moved"),
}
