"""A picture of a scan plan: the cell from above and from the side, and all head positions relative to the part."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.planning.aim import head_pose
from measureapp.planning.frusta import Frustum, frusta, guide_from_part
from measureapp.project.atomic import replacing, write_text
from measureapp.report.svg import Panel, svg

WIDTH, HEIGHT, MARGIN, HEADING = 1400, 720, 24, 48
GREY, FAINT, PALE, TEAL, RED, AMBER = "#7d8a92", "#b9c3c8", "#eef2f3", "#0f8b8d", "#d1495b", "#edae49"
FORMATS = (".png", ".svg")
PPI = 144.0
DOTS = 200  # numbered dots; beyond, a plan is a cloud of dots without numbers
OUTLINE_POINTS = 400


@dataclass(frozen=True, slots=True, eq=False)
class Station:
    """One robot pose with a place of the guide, and the numbers of the viewpoints taken from it."""

    viewpoint: Viewpoint
    numbers: tuple[int, ...]

    @property
    def words(self) -> str:
        """The numbers, short."""
        first, last = self.numbers[0], self.numbers[-1]
        run = last - first + 1 == len(self.numbers)
        return f"{first}" if first == last else f"{first}–{last}" if run else f"{first}, … {last}"


def write_plan_picture(
    path: Path, plan: ScanPlan, rig: RigDescription, nominal: Mesh | None = None, bad: frozenset[str] = frozenset()
) -> None:
    """Write the picture as PNG or SVG, by the extension.

    Parameters
    ----------
    nominal : the part, standing on the table at 0° with its origin in the centre of the table's top; None: none is drawn
    bad : ids of viewpoints that are drawn in red

    Raises
    ------
    InputError
        The extension is neither ``.png`` nor ``.svg``.
    """
    path = Path(path)
    if path.suffix.lower() not in FORMATS:
        raise InputError(f"{path} is not the name of a picture.", "End its name in .png or .svg.")
    drawing = plan_svg(plan, rig, nominal, bad)
    if path.suffix.lower() == ".svg":
        write_text(path, drawing)
        return
    picture = _png(drawing)
    with replacing(path) as temporary:
        temporary.write_bytes(picture)


def plan_svg(plan: ScanPlan, rig: RigDescription, nominal: Mesh | None = None, bad: frozenset[str] = frozenset()) -> str:
    """Return the picture as SVG, see `write_plan_picture`."""
    viewpoints = tuple(plan)
    stations = _stations(viewpoints)
    outline = None if nominal is None else nominal.vertices_mm[:: max(1, len(nominal.vertices_mm) // OUTLINE_POINTS)]
    third = (WIDTH - 4 * MARGIN) / 3
    areas = [(MARGIN + place * (third + MARGIN), float(HEADING), third, HEIGHT - HEADING - MARGIN) for place in range(3)]
    panels = [
        _cell(areas[0], rig, stations, outline, bad, (0, 1)),
        _cell(areas[1], rig, stations, outline, bad, (0, 2)),
        _around(areas[2], rig, viewpoints, outline, bad),
    ]
    headings = ("The cell from above", "The cell from the side", "The head relative to the part, from above")
    for panel, area, words in zip(panels, areas, headings, strict=True):
        panel.heading(area[0], 30.0, words)
    return svg(WIDTH, HEIGHT, panels)


def _png(drawing: str) -> bytes:
    import typst

    with tempfile.TemporaryDirectory(prefix="measureapp-plan-") as folder:
        (Path(folder) / "plan.svg").write_text(drawing, encoding="utf-8")
        page = f'#set page(width: {WIDTH * 0.75}pt, height: {HEIGHT * 0.75}pt, margin: 0pt)\n#image("plan.svg", width: 100%)\n'
        (Path(folder) / "main.typ").write_text(page, encoding="utf-8")
        made = typst.compile(str(Path(folder) / "main.typ"), root=folder, format="png", ppi=PPI)
    return bytes(made[0] if isinstance(made, list) else made)


def _stations(viewpoints: Sequence[Viewpoint]) -> tuple[Station, ...]:
    """Return the different robot poses and places of the guide, in the order in which they are first used."""
    found: dict[tuple[object, float], list[int]] = {}
    for number, viewpoint in enumerate(viewpoints, 1):
        found.setdefault((viewpoint.flange, viewpoint.guide_mm), []).append(number)
    return tuple(Station(viewpoints[numbers[0] - 1], tuple(numbers)) for numbers in found.values())


def _cell(
    area: tuple[float, float, float, float],
    rig: RigDescription,
    stations: Sequence[Station],
    outline: FloatArray | None,
    bad: frozenset[str],
    axes: tuple[int, int],
) -> Panel:
    """Draw the cell in the guide frame, projected to two of its axes: guide, table, part, and each station with its frusta."""
    pick = list(axes)
    poses = [head_pose(station.viewpoint.flange, station.viewpoint.guide_mm, rig) for station in stations]
    centre, radius = np.array(rig.table.centre_in_guide_mm), rig.table.diameter_mm / 2
    shoulder = np.array(rig.robot.shoulder_mm)
    low, high = rig.guide.limits_mm if axes == (0, 1) else (-120.0, float(shoulder[2]))
    corners = np.vstack([[-150.0, low], [150.0, high], *(centre[pick] + [[-radius, -radius], [radius, radius]])])
    shown = np.vstack([corners, *(pose.translation_mm[pick][None] for pose in poses)])
    (x0, y0), (x1, y1) = shown.min(axis=0) - 40, shown.max(axis=0) + 40
    panel = Panel(area, (float(x0), float(y0), float(x1), float(y1)))
    _ground(panel, rig, axes)
    if outline is not None:
        placed = guide_from_part(stations[0].viewpoint, rig).apply(outline)
        panel.polygon(_hull(placed[:, pick]), FAINT, GREY, opacity=0.7)
    for station in stations:
        for frustum in frusta(station.viewpoint, rig):
            _field(panel, frustum, pick)
    for station, pose in zip(stations, poses, strict=True):
        base = shoulder + np.array([0.0, station.viewpoint.guide_mm, 0.0])
        panel.line([base[pick], pose.translation_mm[pick]], GREY, 2.0)
    words: dict[tuple[int, int], list[Station]] = {}
    for station, pose in zip(stations, poses, strict=True):
        x, y = panel.at((float(pose.translation_mm[pick[0]]), float(pose.translation_mm[pick[1]])))
        words.setdefault((round(x), round(y)), []).append(station)  # stations that hide each other share their words
    for place, here in words.items():
        colour = RED if any(station.viewpoint.id in bad for station in here) else TEAL
        panel.mark(place, ", ".join(station.words for station in here), colour)
    return panel


def _ground(panel: Panel, rig: RigDescription, axes: tuple[int, int]) -> None:
    """Draw guide and table."""
    x, y, z = rig.table.centre_in_guide_mm
    radius, (low, high) = rig.table.diameter_mm / 2, rig.guide.limits_mm
    if axes == (0, 1):
        panel.polygon([(-90, low - 60), (90, low - 60), (90, high + 60), (-90, high + 60)], PALE, FAINT)
        panel.text((0.0, low - 60), f"guide {low:g}…{high:g} mm", shift=(0.0, 12.0))
        panel.circle((x, y), radius, PALE, FAINT)
        return
    panel.polygon([(-120, 0), (120, 0), (120, -100), (-120, -100)], PALE, FAINT)
    panel.polygon([(x - radius, z), (x + radius, z), (x + radius, z - 30), (x - radius, z - 30)], PALE, FAINT)
    panel.line([(x, z - 60), (x, z + 300)], FAINT, 1.0, dash="6 3 1 3")


def _field(panel: Panel, frustum: Frustum, pick: list[int]) -> None:
    colour = AMBER if frustum.is_projector else TEAL
    outline = np.vstack([frustum.apex_mm, frustum.corners_mm])[:, pick]
    panel.polygon(_hull(outline), colour, opacity=0.05)


def _around(
    area: tuple[float, float, float, float],
    rig: RigDescription,
    viewpoints: Sequence[Viewpoint],
    outline: FloatArray | None,
    bad: frozenset[str],
) -> Panel:
    """Draw all heads relative to the part, because the table turns it."""
    radius = rig.table.diameter_mm / 2
    heads = []
    for viewpoint in viewpoints:
        part_from_head = guide_from_part(viewpoint, rig).inverse() @ head_pose(viewpoint.flange, viewpoint.guide_mm, rig)
        heads.append((part_from_head.translation_mm[:2], part_from_head.rotation[:2, 2]))
    reach = max(radius, *(float(np.abs(position).max()) for position, _ in heads)) + 40
    panel = Panel(area, (-reach, -reach, reach, reach))
    panel.circle((0.0, 0.0), radius, PALE, FAINT)
    if outline is not None:
        panel.polygon(_hull(outline[:, :2]), FAINT, GREY, opacity=0.7)
    for viewpoint, (position, forward) in zip(viewpoints, heads, strict=True):
        panel.line([position, position + forward * 34 / panel.scale], RED if viewpoint.id in bad else TEAL, 1.5)
    for number, (viewpoint, (position, _)) in enumerate(zip(viewpoints, heads, strict=True), 1):
        panel.dot(
            (float(position[0]), float(position[1])),
            str(number) if len(viewpoints) <= DOTS else "",
            RED if viewpoint.id in bad else TEAL,
        )
    return panel


def _hull(points: FloatArray) -> FloatArray:
    """Return the convex hull of points (N, 2); points on a line are returned as they are."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except QhullError:
        return points
