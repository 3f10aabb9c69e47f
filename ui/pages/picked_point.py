"""Source of a picked point: view, pixel, and the views that measured it."""

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


OFF = "Distance from the merged surface, and σ"
SAME_PLACE_MM = 1.0  # a view with a point this close has measured the same location


@dataclass(frozen=True)
class Sighting:
    """A view that measured the same location."""

    viewpoint_id: str
    sigma_mm: float
    distance_mm: float  # from the merged surface, along its normal


@dataclass(frozen=True, eq=False)
class PickedPoint:
    """One point in the part's frame, with its source."""

    viewpoint_id: str
    position_mm: np.ndarray  # (3,)
    sigma_mm: float
    grey: float
    pixel: tuple[int, int] | None  # row, column; None where it is not known
    cameras: int  # number of cameras that measured it
    camera: int = 0  # index, in the calibration, of the camera of `pixel`
    nearest_mm: float | None = None  # from a merged point to the measured point of `pixel`
    sightings: tuple[Sighting, ...] = ()  # of a merged point
    deviation_mm: float | None = None  # from the nominal


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


def quick_point(stitched: StitchedCloud, row: int) -> PickedPoint:
    """Return one point of the merged cloud without its pixel and the views that measured it, which take longer to find."""
    view = stitched.view_names[int(stitched.view[row])]
    return PickedPoint(view, stitched.points_mm[row], float(stitched.sigma_mm[row]), float(stitched.grey[row]), None, 0)


def merged_point(stitched: StitchedCloud, row: int, views: Sequence[ViewResult]) -> PickedPoint:
    """Return one point of the merged cloud, with the pixel of the nearest measured point in the view of greatest weight."""
    position, sigma, grey = stitched.points_mm[row], float(stitched.sigma_mm[row]), float(stitched.grey[row])
    if not stitched.placements:  # of a file
        return PickedPoint(stitched.view_names[int(stitched.view[row])], position, sigma, grey, None, 0)
    placement = stitched.placements[int(stitched.view[row])]
    seen = _sightings(stitched, row, views)
    cloud = next((view.cloud for view in views if view.viewpoint_id == placement.viewpoint_id), None)
    if cloud is None or not len(cloud):
        return PickedPoint(placement.viewpoint_id, position, sigma, grey, None, 0, sightings=seen)
    place, distance = _nearest(cloud, placement, position)
    nearest = view_point(placement.viewpoint_id, cloud, place)
    return PickedPoint(
        placement.viewpoint_id, position, sigma, grey, nearest.pixel, nearest.cameras, nearest.camera, distance, sightings=seen
    )


def _nearest(cloud: PointCloud, placement: ViewPlacement, position_mm: np.ndarray) -> tuple[int, float]:
    away = cloud.points_mm - placement.part_from_camera.inverse().apply(position_mm[None])[0]
    squares = np.einsum("nd,nd->n", away, away)
    place = int(np.argmin(squares))
    return place, float(np.sqrt(squares[place]))


def _sightings(stitched: StitchedCloud, row: int, views: Sequence[ViewResult]) -> tuple[Sighting, ...]:
    """Return every used view with a point near a merged one, and its distance along the surface normal."""
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
    """Return the properties of one point."""
    x, y, z = (quantity(float(value), "mm") for value in point.position_mm)
    pixel = NOTHING if point.pixel is None else f"{point.pixel[0]}, {point.pixel[1]}"
    measured = [
        ("View", point.viewpoint_id),
        ("Pixel (row, column)", pixel),
        ("Standard deviation σ", millimetres(point.sigma_mm) if point.sigma_mm > 0 else NOTHING),
        ("Brightness", percent(point.grey, 0)),
        ("Measured by", several(point.cameras, "camera") if point.cameras else NOTHING),
    ]
    if point.nearest_mm is not None:
        measured.append(("Nearest point of the view", millimetres(point.nearest_mm)))
    if point.deviation_mm is not None:
        measured.append(("Deviation from the nominal", millimetres(point.deviation_mm, signed=True)))
    groups = [Group("Position on the part", (("x", x), ("y", y), ("z", z))), Group("Source", tuple(measured))]
    if point.sightings:
        rows = (
            (one.viewpoint_id, f"{millimetres(one.distance_mm, signed=True)}, σ {millimetres(one.sigma_mm)}") for one in point.sightings
        )
        groups.append(Group("Views that measured this point", (("", OFF), *rows)))
    return Properties("Point", tuple(groups))
