"""The 3-D preview of a plan: the cell with the axes at a viewpoint, what it sees of the part, and all other viewpoints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from ui.look.language.words import tr
from ui.look.theme import Theme
from ui.look.wording import percent
from ui.pages.layers import rgb
from ui.pages.plan.cell_bodies import Triangles, cell_triangles, surface_of
from ui.pages.viewport_page import Composer, Picture
from ui.viewport.colouring import UNKNOWN
from ui.viewport.layers import Label, LineLayer
from ui.widgets.coverage_legend import Swatch
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.plan import Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.plan_coverage import PlanCoverage
    from measureapp.planning.collision.cell import Cell
    from measureapp.planning.collision.motion import Placement
    from ui.controllers.plan_part import PreparedPart
    from ui.controllers.plan_prediction import Prediction

Shown = Literal["coverage", "selected", "part"]
SHOWN = {"coverage": "Coverage", "selected": "This viewpoint", "part": "Part"}
SHOWN_TIPS = {
    "coverage": "How many viewpoints measure each place of the part; hatched: none",
    "selected": "What the selected viewpoint measures; hatched: nothing",
    "part": "The part in one colour",
}
ARM = {"light": (150, 162, 170), "dark": (120, 132, 140)}
STAND = {"light": (205, 211, 215), "dark": (74, 84, 91)}
PART = {"light": (196, 204, 208), "dark": (150, 162, 168)}
ONCE, TWICE, OFTEN = (237, 174, 73), (104, 190, 170), (15, 139, 141)  # by one viewpoint, by two, by three or more
CAMERA_LINES, PROJECTOR_LINES = (15, 139, 141), (230, 150, 30)
OTHERS_DRAWN, OTHER_MM = 400, 70.0  # length of the line that stands for another viewpoint
LABELS = 6
OPENING = (1.0, -1.25, 0.9)  # from behind the table, so that the robot does not hide the part
ROOM_MM = 480.0  # above the table that is shown first


@dataclass(frozen=True, eq=False)
class Scenery:
    """What the preview shows."""

    rig: RigDescription
    viewpoint: Viewpoint | None  # at which the axes stand
    selected: tuple[Viewpoint, ...]
    prediction: Prediction | None
    part: PreparedPart | None
    shown: Shown


def composer(scenery: Scenery, theme: Theme) -> Composer:
    """Return the composer of bodies, frusta and labels."""

    def compose(job: Job) -> Picture:
        job.check()
        parts = [*_part(scenery, theme), *_cell(scenery, theme)]
        return Picture(surface=surface_of(parts), lines=tuple(lines(scenery, theme)), labels=tuple(labels(scenery, theme)))

    return compose


def _cell(scenery: Scenery, theme: Theme) -> list[Triangles]:
    if scenery.prediction is None:
        return []
    cell = scenery.prediction.checker.cell
    colours = {
        "arm": ARM[theme.shade],
        "head": rgb(theme, "accent"),
        "ground": STAND[theme.shade],
        "obstacle": STAND[theme.shade],
        "keep-out box": rgb(theme, "verdict_not_proven"),
    }
    found = placed(cell, scenery)
    if found is None:
        return []
    shown, placement = found
    if scenery.viewpoint is not None and scenery.viewpoint.id in scenery.prediction.check.sentences():
        colours["head"] = rgb(theme, "verdict_fail")
    return list(cell_triangles(shown, placement, colours, rgb(theme, "verdict_fail")))


def placed(cell: Cell, scenery: Scenery) -> tuple[Cell, Placement] | None:
    """Return the cell and where its axes are; out of the robot's reach, a cell in which only the head is drawn."""
    from measureapp.errors import LimitError
    from measureapp.planning.collision.cell import Cell
    from measureapp.planning.collision.motion import Placement

    viewpoint = scenery.viewpoint
    if viewpoint is None:
        return None
    if free := cell.free_at(viewpoint):
        return cell, free[0]
    try:
        return cell, cell.placements(viewpoint)[0]
    except LimitError:
        return Cell.of(scenery.rig, None), Placement.at(viewpoint, None)


def _part(scenery: Scenery, theme: Theme) -> list[Triangles]:
    part = scenery.part
    if part is None:
        return []
    turn = guide_from_part(scenery)
    corners = part.corners_mm @ turn[:3, :3].T + turn[:3, 3]
    return [Triangles(corners, part.normals @ turn[:3, :3].T, _part_colours(scenery, part, PART[theme.shade]))]


def _part_colours(scenery: Scenery, part: PreparedPart, plain: tuple[int, int, int]) -> np.ndarray:
    found = scenery.prediction
    coverage = None if found is None or found.part is not part else found.coverage
    if scenery.shown == "part" or coverage is None or found is None:
        return np.tile(np.array(plain, np.uint8), (len(part.corners_mm), 1))
    if scenery.shown == "coverage":
        scale = np.array([UNKNOWN, ONCE, TWICE, OFTEN], np.uint8)
        return scale[np.minimum(coverage.counts, 3)][part.sample_of]
    row = -1 if scenery.viewpoint is None else found.row(scenery.viewpoint.id)
    seen = coverage.seen[row] if row >= 0 else np.zeros(len(coverage.samples), bool)
    return np.where(seen[:, None], np.array(OFTEN, np.uint8), UNKNOWN)[part.sample_of]


def guide_from_part(scenery: Scenery) -> np.ndarray:
    """Return where the part is drawn, (4, 4): turned as at the viewpoint shown."""
    from measureapp.planning.frusta import guide_from_part

    if scenery.viewpoint is not None:
        return guide_from_part(scenery.viewpoint, scenery.rig).matrix
    turn = np.eye(4)
    turn[:3, 3] = scenery.rig.table.centre_in_guide_mm
    return turn


def lines(scenery: Scenery, theme: Theme) -> list[LineLayer]:
    """Return the frusta of the selected viewpoint, and a line for each other viewpoint, turned with the part."""
    from measureapp.planning.frusta import frusta

    found: list[LineLayer] = []
    if scenery.viewpoint is not None:
        fields = frusta(scenery.viewpoint, scenery.rig)
        for is_projector, colour in ((False, CAMERA_LINES), (True, PROJECTOR_LINES)):
            edges = tuple(edge for field in fields if field.is_projector == is_projector for edge in field.edges())
            if edges:
                found.append(LineLayer(edges, colour, 1.5))
    if scenery.prediction is not None:
        found += _others(scenery, theme, scenery.prediction)
    return found


def _others(scenery: Scenery, theme: Theme, prediction: Prediction) -> list[LineLayer]:
    from measureapp.planning.coverage.head import heads_at

    turn, sentences = guide_from_part(scenery), prediction.check.sentences()
    viewpoints = tuple(prediction.plan)[:OTHERS_DRAWN]
    poses = turn @ heads_at(viewpoints, scenery.rig)
    chosen = {viewpoint.id for viewpoint in scenery.selected}
    by_colour: dict[tuple[int, int, int], list[np.ndarray]] = {}
    for viewpoint, pose in zip(viewpoints, poses, strict=True):
        token = "verdict_fail" if viewpoint.id in sentences else "accent" if viewpoint.id in chosen else "faint"
        line = np.stack([pose[:3, 3], pose[:3, 3] + OTHER_MM * pose[:3, 2]])
        by_colour.setdefault(rgb(theme, token), []).append(line)
    return [LineLayer(tuple(edges), colour, 4.0) for colour, edges in by_colour.items()]


def labels(scenery: Scenery, theme: Theme) -> list[Label]:
    """Return the names of the selected viewpoints."""
    from measureapp.planning.coverage.head import heads_at

    turn = guide_from_part(scenery)
    some: Sequence[Viewpoint] = scenery.selected[:LABELS]
    if not some:
        return []
    poses = turn @ heads_at(some, scenery.rig)
    colours = rgb(theme, "text"), rgb(theme, "surface")
    return [Label(viewpoint.id, pose[:3, 3], *colours) for viewpoint, pose in zip(some, poses, strict=True)]


def framed(scenery: Scenery) -> np.ndarray:
    """Return the points (N, 3) on which the camera is opened: the table with the room above it."""
    x, y, z = scenery.rig.table.centre_in_guide_mm
    radius = scenery.rig.table.diameter_mm / 2.0
    return np.array([[x + i * radius, y + j * radius, height] for i in (-1, 1) for j in (-1, 1) for height in (z - 60.0, z + ROOM_MM)])


def coverage_legend(coverage: PlanCoverage) -> tuple[tuple[Swatch, ...], str]:
    """Return the colours of the coverage with the share of each."""
    shares = [coverage.share(coverage.counts == count) for count in (0, 1, 2)]
    words = ("Not measured {percent}", "Once {percent}", "Twice {percent}", "More often {percent}")
    colours = (None, ONCE, TWICE, OFTEN)
    swatches = tuple(
        (colour, tr(word, percent=percent(share))) for colour, word, share in zip(colours, words, (*shares, 1.0 - sum(shares)), strict=True)
    )
    return swatches, tr("Predicted coverage {predicted}", predicted=percent(coverage.predicted))
