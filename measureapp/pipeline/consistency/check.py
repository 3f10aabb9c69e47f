"""Checks of a stitched cloud against its error model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import LoopClosure, StitchedCloud
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
PROPERTIES: dict[str, tuple[Callable[[Sequence[ViewResult], Deviations, Sequence[FloatArray]], Classes], str]]


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
    heights = [
        placement.part_from_camera.apply(view.cloud.points_mm)[:, 2] for view, placement in zip(views, stitched.placements, strict=True)
    ]
    checks = []
    for name, (classify, cause) in PROPERTIES.items():
        own, other = classify(views, deviations, heights)
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


def _of_points(deviations: Deviations, values: Sequence[IntArray]) -> Classes:
    """Return the classes of both points from those of all points of each view."""
    sides = ((deviations.own_view, deviations.own_point), (deviations.other_view, deviations.other_point))
    starts = np.cumsum([0, *(len(part) for part in values[:-1])])
    every = np.concatenate(values).astype(np.int64)
    own, other = (every[starts[view] + point] for view, point in sides)
    return own, other


def _by_pixel(views: Sequence[ViewResult], deviations: Deviations, _heights: Sequence[FloatArray]) -> Classes:
    highest = np.maximum(np.max([view.cloud.pixel.max(axis=0) for view in views if len(view.cloud)], axis=0), 1)
    cells = []
    for view in views:
        pixel = np.asarray(view.cloud.pixel)
        cell = np.minimum(PIXEL_CELLS * pixel // (highest + 1), PIXEL_CELLS - 1)
        cells.append(np.where(pixel.min(axis=1) < 0, -1, PIXEL_CELLS * cell[:, 0] + cell[:, 1]))
    return _of_points(deviations, cells)


def _by_direction(views: Sequence[ViewResult], deviations: Deviations, _heights: Sequence[FloatArray]) -> Classes:
    steps = round(2 / TILT_STEP)
    cells = [np.clip((np.asarray(view.cloud.normals[:, :2]) + 1) // TILT_STEP, 0, steps - 1).astype(np.int64) for view in views]
    return _of_points(deviations, [steps * cell[:, 0] + cell[:, 1] for cell in cells])


def _by_brightness(views: Sequence[ViewResult], deviations: Deviations, _heights: Sequence[FloatArray]) -> Classes:
    borders = np.quantile(np.concatenate([view.cloud.grey[::50] for view in views]), np.arange(1, GREYS) / GREYS)
    return _of_points(deviations, [np.searchsorted(borders, view.cloud.grey) for view in views])


def _by_time(views: Sequence[ViewResult], deviations: Deviations, _heights: Sequence[FloatArray]) -> Classes:
    """Early and late views, each in a coarse grid of the image: views as a whole were registered, so that only bending is left."""
    half = max(-(-len(views) // 2), 1)
    order = {view.viewpoint_id: place for place, view in enumerate(sorted(views, key=lambda one: one.viewpoint_id))}
    late = np.array([order[view.viewpoint_id] // half for view in views])
    own, other = _by_pixel(views, deviations, _heights)

    def cells(pixel: IntArray, view: IntArray) -> IntArray:
        coarse = (TIMES // 2) * (pixel // PIXEL_CELLS // 2) + pixel % PIXEL_CELLS // 2
        return np.where(pixel < 0, -1, TIMES**2 * late[view] + coarse)

    return cells(own, deviations.own_view), cells(other, deviations.other_view)


def _by_table(views: Sequence[ViewResult], deviations: Deviations, heights: Sequence[FloatArray]) -> Classes:
    low, high = (
        float(limit([part.min() if limit is np.min else part.max() for part in heights if len(part)])) for limit in (np.min, np.max)
    )
    angles = [int(view.readback.table_rad / (2 * np.pi) * ANGLES) % ANGLES for view in views]
    levels = [np.clip(HEIGHTS * (part - low) / max(high - low, 1e-9), 0, HEIGHTS - 1).astype(np.int64) for part in heights]
    return _of_points(deviations, [HEIGHTS * angle + level for angle, level in zip(angles, levels, strict=True)])


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
