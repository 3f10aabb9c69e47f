"""Cross-sections of a report: the nominal's outline, and the measured deviation drawn perpendicular to it, enlarged."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.colour_scale import ColourScale
from measureapp.inspection.surface.deviation import Deviation
from measureapp.report.model import Picture
from measureapp.report.svg import Panel, svg
from measureapp.report.words import number

WIDTH, MOST_HEIGHT, LEAST_HEIGHT, MARGIN, HEAD = 760, 400, 120, 40, 10
HALF_THICKNESS_MM = 0.4
MOST_POINTS = 1500
LONGEST_SHARE = 0.05  # of the section's size, for a deviation at the end of the scale
LEAST_SHADE = 0.25
INK = "#182126"
NORMAL_TO = (("y", 1, (0, 2)), ("z", 2, (0, 1)))  # axis, its index, the axes drawn to the right and up


def render_sections(nominal: Mesh, deviation: Deviation, scale: ColourScale) -> tuple[Picture, ...]:
    """Return sections through the middle of the nominal, one upright and one level; deviations beyond the scale are cut off."""
    low, high = nominal.vertices_mm.min(axis=0), nominal.vertices_mm.max(axis=0)
    middle = (low + high) / 2
    made = (_section(nominal, deviation, scale, name, axis, drawn, float(middle[axis])) for name, axis, drawn in NORMAL_TO)
    return tuple(picture for picture in made if picture is not None)


def _section(
    nominal: Mesh, deviation: Deviation, scale: ColourScale, name: str, axis: int, drawn: tuple[int, int], at_mm: float
) -> Picture | None:
    segments = cut_mesh(nominal, axis, at_mm)[:, :, list(drawn)]
    if not len(segments):
        return None
    size = float(np.ptp(segments.reshape(-1, 2), axis=0).max())
    gain = LONGEST_SHARE * size / max(abs(scale.low), abs(scale.high))
    whiskers, colours = _whiskers(deviation, scale, axis, drawn, at_mm, gain)
    low, high = segments.reshape(-1, 2).min(axis=0), segments.reshape(-1, 2).max(axis=0)
    edge = 1.2 * LONGEST_SHARE * size
    low, high = low - edge, high + edge
    needed = (WIDTH - 2 * MARGIN) * (high[1] - low[1]) / (high[0] - low[0])  # a flat section is drawn as wide as the page
    height = round(float(np.clip(needed, LEAST_HEIGHT, MOST_HEIGHT - 2 * HEAD))) + 2 * HEAD
    panel = Panel((MARGIN, HEAD, WIDTH - 2 * MARGIN, height - 2 * HEAD), (float(low[0]), float(low[1]), float(high[0]), float(high[1])))
    for whisker, colour in zip(whiskers.tolist(), colours, strict=True):
        panel.line(whisker, colour, 1.6)
    panel.lines(segments, INK, 0.9)
    caption = f"Section at {name} = {number(at_mm, 2)} mm: nominal in black, deviation enlarged {gain:.0f} times"
    return Picture(caption, svg(WIDTH, height, [panel]).encode())


def cut_mesh(mesh: Mesh, axis: int, at_mm: float) -> FloatArray:
    """Return the segments (S, 2, 3) in which the plane of constant coordinate ``axis`` cuts a mesh."""
    corners = mesh.vertices_mm[np.asarray(mesh.triangles)]
    height = corners[:, :, axis] - at_mm
    height = np.where(height == 0, 1e-9, height)
    crossing = (height > 0).any(axis=1) & (height < 0).any(axis=1)
    corners, height = corners[crossing], height[crossing]
    alone = np.argmax((height > 0) == ((height > 0).sum(axis=1) == 1)[:, None], axis=1)  # the corner on a side of its own
    rows = np.arange(len(corners))
    ends = []
    for step in (1, 2):
        other = (alone + step) % 3
        share = height[rows, alone] / (height[rows, alone] - height[rows, other])
        ends.append(corners[rows, alone] + share[:, None] * (corners[rows, other] - corners[rows, alone]))
    return np.stack(ends, axis=1) if len(corners) else np.empty((0, 2, 3))


def _whiskers(
    deviation: Deviation, scale: ColourScale, axis: int, drawn: tuple[int, int], at_mm: float, gain: float
) -> tuple[FloatArray, list[str]]:
    """Return lines from the nominal to the enlarged deviation (N, 2, 2), and their colours."""
    near = np.flatnonzero(np.abs(deviation.points_mm[:, axis] - at_mm) < HALF_THICKNESS_MM)
    near = near[:: max(1, len(near) // MOST_POINTS)]
    distances, normals = deviation.distances_mm[near], deviation.nominal_normals[near].astype(float)
    feet = (deviation.points_mm[near] - distances[:, None] * normals)[:, list(drawn)]
    tips = feet + gain * np.clip(distances, scale.low, scale.high)[:, None] * normals[:, list(drawn)]
    rgb = np.rint(scale.colours(_outside_the_band(distances, scale))).astype(int)
    return np.stack([feet, tips], axis=1), ["#{:02x}{:02x}{:02x}".format(*one) for one in rgb]


def _outside_the_band(distances: FloatArray, scale: ColourScale) -> FloatArray:
    """Return deviations at least a quarter of the way from the band to an end: the colour of the band cannot be seen on white paper."""
    start, end = scale.tolerance or (0.0, 0.0)
    below, above = start - LEAST_SHADE * (start - scale.low), end + LEAST_SHADE * (scale.high - end)
    return np.where(distances < 0, np.minimum(distances, below), np.maximum(distances, above))
