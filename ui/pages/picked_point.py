"""Where a point in the picture comes from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ui.look.wording import NOTHING, millimetres, percent, quantity, several
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
    from measureapp.data.measurement import ViewResult


OFF = "How far each lies from the merged surface, and its σ"
SAME_PLACE_MM = 1.0  # a view with a point this near measured the place too


@dataclass(frozen=True)
class Sighting:
    """A view that measured a place, too."""

    viewpoint_id: str
    sigma_mm: float
    off_mm: float  # from the merged surface, along its normal


@dataclass(frozen=True, eq=False)
class PickedPoint:
    """One point in the part's frame, and how it was measured."""

    viewpoint_id: str
    position_mm: np.ndarray  # (3,)
    sigma_mm: float
    grey: float
    pixel: tuple[int, int] | None  # row, column; None where it is not known
    cameras: int  # how many cameras saw it
    camera: int = 0  # place, in the calibration, of the camera whose pixel it is
    nearest_mm: float | None = None  # from a merged point to the measured one whose pixel is told
    seen_by: tuple[Sighting, ...] = ()  # of a merged point
    deviation_mm: float | None = None  # from the drawing


def view_point(viewpoint_id: str, cloud: PointCloud, place: int) -> PickedPoint:
    """Return one point of a placed view."""
    line, across = (int(value) for value in cloud.pixel[place])
    bits = int(cloud.cameras[place])
    return PickedPoint(
        viewpoint_id,
        cloud.points_mm[place],
        float(cloud.sigma_mm[place]),
        float(cloud.grey[place]),
        (line, across) if line >= 0 else None,
        bits.bit_count(),
        max(0, (bits & -bits).bit_length() - 1),
    )


def merged_point(stitched: StitchedCloud, row: int, views: Sequence[ViewResult]) -> PickedPoint:
    """Return one point of the merged cloud, with the pixel of the measured point next to it in the view that weighs most."""
    position, sigma, grey = stitched.points_mm[row], float(stitched.sigma_mm[row]), float(stitched.grey[row])
    if not stitched.placements:  # of a file
        return PickedPoint(stitched.view_names[int(stitched.view[row])], position, sigma, grey, None, 0)
    placement = stitched.placements[int(stitched.view[row])]
    seen = _sightings(stitched, row, views)
    cloud = next((view.cloud for view in views if view.viewpoint_id == placement.viewpoint_id), None)
    if cloud is None or not len(cloud):
        return PickedPoint(placement.viewpoint_id, position, sigma, grey, None, 0, seen_by=seen)
    place, distance = _nearest(cloud, placement, position)
    nearest = view_point(placement.viewpoint_id, cloud, place)
    return PickedPoint(
        placement.viewpoint_id, position, sigma, grey, nearest.pixel, nearest.cameras, nearest.camera, distance, seen_by=seen
    )


def _nearest(cloud: PointCloud, placement: ViewPlacement, position_mm: np.ndarray) -> tuple[int, float]:
    away = cloud.points_mm - placement.part_from_camera.inverse().apply(position_mm[None])[0]
    squares = np.einsum("nd,nd->n", away, away)
    place = int(np.argmin(squares))
    return place, float(np.sqrt(squares[place]))


def _sightings(stitched: StitchedCloud, row: int, views: Sequence[ViewResult]) -> tuple[Sighting, ...]:
    """Return every used view with a point near a merged one, and how far off that point lies along the surface's normal."""
    position, normal = stitched.points_mm[row], stitched.normals[row].astype(float)
    placements = {placement.viewpoint_id: placement for placement in stitched.placements}
    found = []
    for view in views:
        placement = placements.get(view.viewpoint_id)
        if placement is None or not placement.used or not len(view.cloud):
            continue
        place, distance = _nearest(view.cloud, placement, position)
        if distance < SAME_PLACE_MM:
            point = placement.part_from_camera.apply(view.cloud.points_mm[place][None])[0]
            found.append(Sighting(view.viewpoint_id, float(view.cloud.sigma_mm[place]), float((point - position) @ normal)))
    return tuple(found)


def point_properties(point: PickedPoint) -> Properties:
    """Return what there is to know about one point."""
    x, y, z = (quantity(float(value), "mm") for value in point.position_mm)
    pixel = NOTHING if point.pixel is None else f"{point.pixel[0]}, {point.pixel[1]}"
    measured = [
        ("View", point.viewpoint_id),
        ("Pixel (row, column)", pixel),
        ("Standard deviation σ", millimetres(point.sigma_mm) if point.sigma_mm > 0 else NOTHING),
        ("Brightness", percent(point.grey, 0)),
        ("Seen by", several(point.cameras, "camera") if point.cameras else NOTHING),
    ]
    if point.nearest_mm is not None:
        measured.append(("Nearest point of the view", millimetres(point.nearest_mm)))
    if point.deviation_mm is not None:
        measured.append(("Deviation from the drawing", millimetres(point.deviation_mm, signed=True)))
    groups = [Group("Place on the part", (("x", x), ("y", y), ("z", z))), Group("How it was measured", tuple(measured))]
    if point.seen_by:
        rows = ((one.viewpoint_id, f"{millimetres(one.off_mm, signed=True)}, σ {millimetres(one.sigma_mm)}") for one in point.seen_by)
        groups.append(Group("Views that measured this place", (("", OFF), *rows)))
    return Properties("Point", tuple(groups))
