"""Advice for calibrating cameras, and the projector as one of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.camera import LEAST_VIEWS
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.shortfalls import ADVISED_COVERAGE, ADVISED_VIEWS
from measureapp.calibrate.draft.advice import Gauge, Ghost, Notes, outline_px, outlines_px
from measureapp.calibrate.draft.draft import Draft
from measureapp.calibrate.guidance.lens_views import (
    CENTRES,
    SPAN_TARGET,
    TILT_TARGET_DEG,
    TILTS,
    LensViews,
    lens_views,
    rough_lens,
)
from measureapp.calibrate.guidance.next_view import best_view, board_before
from measureapp.geometry.pinhole import PinholeCamera

SHARED_TARGET = 5  # views that two cameras have in common
FILLED = 0.5  # of the image's width: required size of the board before the first view
_IMAGES = {"camera": "the image", "projector": "the projector's image"}
LEAST_FOR_INFORMATION = 4  # views, below which the covariance is unreliable


def advise_lenses(draft: Draft, notes: Notes, *, fixed_board: bool = False) -> None:
    """Note what the cameras, or the projector, still lack; with a fixed board the robot moves instead of it."""
    cameras = draft.setup.lenses
    views, fixed = views_of(draft), fixed_board
    for one in views:
        notes.gauges += _gauges(one)
    few = [LEAST_VIEWS - one.count for one in views if one.count < LEAST_VIEWS]
    if few:
        notes.wish(f"Show the board in {max(few)} more {'position' if max(few) == 1 else 'positions'}, sharp and whole")
    for one in views:
        if one.count and (region := one.empty_region(ADVISED_COVERAGE)) is not None:
            notes.wish(f"Show the board {region} of {_IMAGES[one.what]}", one.camera)
    for one in views:
        if one.count and (way := one.least_tilt()) is not None:
            notes.wish(_tilt_wish(way, one.what, fixed), one.camera)
    for one in views:
        if (change := one.next_distance()) is not None:
            notes.wish(f"Take poses {change}" if fixed else f"Hold the board {change}", one.camera)
    _note_shared_views(cameras, draft.counted, notes)
    missing = max((ADVISED_VIEWS - one.count for one in views), default=ADVISED_VIEWS)
    if not few and missing > 0:
        what = "one more view with" if missing == 1 else f"{missing} more views, each with"
        notes.wish(f"Take {what} another tilt and place, to average the noise")


def _tilt_wish(way: str, what: str, fixed: bool) -> str:
    edge = TILTS[way][2]
    if fixed:
        return f"Take a pose in which the board's {edge} is farther from the {what}, the board tilted by 20° to 45°"
    return f"Tilt the board more {way} (its {edge} away from the {what}), by 20° to 45°"


def views_of(draft: Draft) -> list[LensViews]:
    """Return the views of those whose lenses are calibrated; one without an image has none."""
    sightings = [found.of(camera, one.id) for one in draft.counted for camera, found in one.seen.items()]
    views = []
    for camera in draft.setup.lenses:
        pinhole = _lens(draft, camera)
        if pinhole is not None:
            views.append(lens_views(camera, pinhole, sightings, draft.setup.board))
    return views


def ghost_for_lenses(draft: Draft) -> Ghost | None:
    """Return where to show the board: by the information it adds where the cameras are solved, before that where views are missing."""
    solved, views = draft.solved, views_of(draft)
    seen = [one for one in views if one.count]
    board = draft.setup.board
    solution = None if solved is None else solved.camera_solution
    if solution is not None and min((one.count for one in views), default=0) >= LEAST_FOR_INFORMATION:
        middles = np.array([place.apply(board.middle_mm) for place in solution.boards.values()])
        place = best_view(solution, float(np.median(middles[:, 2])), draft.setup.lenses)
        return None if place is None else Ghost(outlines_px(solution.calibration, place, board))
    for one in seen or views:
        region, way = one.empty_region(ADVISED_COVERAGE) or "in the middle", one.least_tilt() if one.count else None
        axis, sign, _ = TILTS.get(way or "", (0, 0.0, ""))
        normal = (sign, 0.0) if axis == 0 else (0.0, sign)
        distance = float(np.median(one.distances_mm)) if one.count else _filling_distance_mm(one.pinhole, board.flat_corners_mm[:, 0].max())
        outline = outline_px(one.pinhole, board_before(one.pinhole, board, CENTRES[region], normal, distance), board)
        if outline is not None:
            return Ghost({one.camera: outline})
    return None


def _filling_distance_mm(pinhole: PinholeCamera, width_mm: float) -> float:
    return float(pinhole.matrix[0, 0]) * width_mm / (FILLED * pinhole.width_px)


def _lens(draft: Draft, camera: str) -> PinholeCamera | None:
    solved = draft.solved
    if solved is not None:
        projector = solved.cameras.projector
        return projector.pinhole if camera == PROJECTOR and projector is not None else solved.cameras.cameras[camera].pinhole
    size = draft.sizes_px.get(camera)
    return None if size is None else rough_lens(size)


def _gauges(one: LensViews) -> list[Gauge]:
    tilt = min(one.tilts_deg.values())
    camera = "" if one.camera == PROJECTOR else one.camera  # there is one projector only
    return [
        Gauge("Views", one.count, ADVISED_VIEWS, "", camera),
        Gauge("Coverage of the image", 100 * one.coverage, 100 * ADVISED_COVERAGE, "%", camera),
        Gauge("Tilt, all directions", tilt, TILT_TARGET_DEG, "°", camera),
        Gauge("Spread of distances", 100 * one.distance_span, 100 * SPAN_TARGET, "%", camera),
    ]


def _note_shared_views(cameras: Sequence[str], observations: Sequence[Observation], notes: Notes) -> None:
    for other in cameras[1:]:
        count = sum(cameras[0] in one.seen and other in one.seen for one in observations)
        notes.gauges.append(Gauge(f"Views shared by {cameras[0]} and {other}", count, SHARED_TARGET, ""))
        if observations and count < SHARED_TARGET:
            notes.wish(f"Show the board where cameras {cameras[0]} and {other} both see it, {_times(SHARED_TARGET - count)}")


def _times(count: int) -> str:
    return "once more" if count == 1 else f"{count} more times"
