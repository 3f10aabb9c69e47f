"""Deviation maps of a report: colours on the nominal, unlit, with hatching where nothing was measured."""

from __future__ import annotations

from functools import partial

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.colour_scale import ColourScale
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.statistics import Extreme, compute_statistics
from measureapp.report.model import DeviationSummary, Flag, Picture
from measureapp.report.part_pictures import OBLIQUE
from measureapp.report.picture import SUPERSAMPLING, Seen, SurfaceScene, ViewDirection, png
from measureapp.report.words import number

NOT_MEASURED = np.array([0.62, 0.64, 0.67])  # of vertices, where there can be no hatching
HATCH_DARK, HATCH_LIGHT = np.array([0.45, 0.47, 0.50]), np.array([0.86, 0.87, 0.88])
HATCH_PX = 12
BINS = 40
VIEWS = (("oblique view", OBLIQUE), ("from the opposite side, below", ViewDirection(122.0, -34.0)))
WIDE = (760, 500)
NEAR_MM = 2.0  # as in the unmeasured share
NEIGHBOURS = 6
BLUR_MM = 0.05  # distance within which neighbours weigh alike
FACING = 0.3  # cosine between the nominal's normal here and at the point
FLAG = "#182126"


def summarise_deviation(
    nominal: Mesh,
    deviation: Deviation,
    surface: Mesh | None = None,
    *,
    scale: DeviationScale = DeviationScale(),  # noqa: B008 - immutable
) -> DeviationSummary:
    """Summarise a deviation, without pictures: statistics and histogram.

    Parameters
    ----------
    surface : measured surface in the nominal's frame; None where there is none
    scale : colours, tolerance band and range of the inspection program
    """
    statistics = compute_statistics(
        deviation, nominal, tolerance_mm=scale.tolerance_mm, range_mm=scale.range_mm, search_mm=NEAR_MM, surface=surface
    )
    colours = ColourScale.of(scale, statistics.range_mm)
    near = deviation.distances_mm[np.abs(deviation.distances_mm) <= NEAR_MM]
    counts, _ = np.histogram(np.clip(near, colours.low, colours.high), bins=BINS, range=(colours.low, colours.high))
    histogram = tuple(float(share) for share in counts / max(counts.sum(), 1))
    return DeviationSummary(deviation.alignment.name, statistics, colours, histogram)


def render_deviation(nominal: Mesh, deviation: Deviation, summary: DeviationSummary) -> tuple[Picture, ...]:
    """Return the maps of a deviation, with flags at its extremes."""
    statistics, scale = summary.statistics, summary.scale
    extremes = {name: one for name, one in (("min", statistics.minimum), ("max", statistics.maximum)) if one is not None}
    scene = SurfaceScene(nominal)
    look_up = partial(_deviation_at, deviation)
    shown = {name: _shown_in(extreme, scene) for name, extreme in extremes.items()}

    def draw(view: int, _end: int) -> Picture:
        where, direction = VIEWS[view]
        seen = scene.see(direction, *WIDE)
        colours = _colours(scene, seen, look_up, scale)
        flags = tuple(_extreme_flag(name, extremes[name], seen, hidden=hidden) for name, (at, hidden) in shown.items() if at == view)
        return Picture(f"Deviation on the nominal, {where}", png(scene.picture(seen, colours, lit=False)), flags)

    return tuple(in_bands(draw, len(VIEWS), len(VIEWS)))


def _shown_in(extreme: Extreme, scene: SurfaceScene) -> tuple[int, bool]:
    """Return the first view that shows a point, and False; or the first view of all, and True where the part hides it in each."""
    hidden = [bool(scene.occluded(extreme.point_mm[None], direction.axes()[2], abs(extreme.value_mm) + 0.2)[0]) for _, direction in VIEWS]
    return (0, True) if all(hidden) else (hidden.index(False), False)


def _colours(scene: SurfaceScene, seen: Seen, look_up: partial[FloatArray], scale: ColourScale) -> FloatArray:
    """Return the colours of the pixels that show the nominal; deviations are looked up for one pixel of each block of the supersampling."""
    from measureapp.report.kernels import first_of_blocks

    block_of, first = np.empty((2, len(seen.pixels)), np.int64)
    chosen = seen.pixels[first[: first_of_blocks(seen.pixels, seen.frame.width, SUPERSAMPLING, block_of, first)]]
    corners = scene.mesh.vertices_mm[np.asarray(scene.mesh.triangles)[seen.triangle.reshape(-1)[chosen]]]
    points = np.einsum("nk,nkd->nd", seen.weights.reshape(-1, 3)[chosen], corners)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    values = look_up(points, normals)
    colours = (scale.colours(np.nan_to_num(values)) / 255.0)[block_of]
    missing = np.isnan(values)[block_of]
    colours[missing] = _hatching(seen.pixels[missing], seen.frame.width)
    return np.asarray(colours)


def _deviation_at(deviation: Deviation, points_mm: FloatArray, normals: FloatArray) -> FloatArray:
    """Return the mean deviation (N,) of the nearest measured points on the same side of the part; NaN where there is none within 2 mm."""
    from measureapp.report.kernels import mean_of_facing

    away, near = deviation.tree.query(points_mm, k=NEIGHBOURS, distance_upper_bound=NEAR_MM, workers=-1)
    made = np.empty(len(points_mm))
    mean_of_facing(away, near, deviation.nominal_normals, normals, deviation.distances_mm, FACING, BLUR_MM, made)
    return made


def _hatching(pixels: IntArray, width: int) -> FloatArray:
    rows, columns = np.divmod(pixels, width)
    stripe: BoolArray = (rows + columns) % HATCH_PX < HATCH_PX // 2
    return np.where(stripe[:, None], HATCH_DARK, HATCH_LIGHT)


def _extreme_flag(name: str, extreme: Extreme, seen: Seen, *, hidden: bool) -> Flag:
    """Return the flag of the smallest or largest deviation."""
    (place,), _ = seen.frame.place(extreme.point_mm[None])
    word = {"min": ("Minimum", "Minimum (behind)"), "max": ("Maximum", "Maximum (behind)")}[name][hidden]
    return Flag((float(place[0]), float(place[1])), (word, f"{number(extreme.value_mm, signed=True)} mm"), FLAG)
