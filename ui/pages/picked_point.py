"""Where a point in the picture comes from."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ui.look.wording import NOTHING, millimetres, percent, quantity, several
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud
    from measureapp.data.measurement import ViewResult


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


def merged_point(stitched: StitchedCloud, visible: Collection[int], place: int, views: Sequence[ViewResult]) -> PickedPoint:
    """Return one point of the merged cloud, with the pixel of the measured point next to it in the view that weighs most."""
    row = int(np.flatnonzero(np.isin(stitched.view, list(visible)))[place])
    position, placement = stitched.points_mm[row], stitched.placements[int(stitched.view[row])]
    sigma, grey = float(stitched.sigma_mm[row]), float(stitched.grey[row])
    cloud = next((view.cloud for view in views if view.viewpoint_id == placement.viewpoint_id), None)
    if cloud is None or not len(cloud):
        return PickedPoint(placement.viewpoint_id, position, sigma, grey, None, 0)
    distances = np.linalg.norm(cloud.points_mm - placement.part_from_camera.inverse().apply(position[None])[0], axis=1)
    nearest = view_point(placement.viewpoint_id, cloud, int(np.argmin(distances)))
    return PickedPoint(
        placement.viewpoint_id, position, sigma, grey, nearest.pixel, nearest.cameras, nearest.camera, float(distances.min())
    )


def point_properties(point: PickedPoint) -> Properties:
    """Return what there is to know about one point."""
    x, y, z = (quantity(float(value), "mm") for value in point.position_mm)
    pixel = NOTHING if point.pixel is None else f"{point.pixel[0]}, {point.pixel[1]}"
    measured = [
        ("View", point.viewpoint_id),
        ("Pixel (row, column)", pixel),
        ("Standard deviation σ", millimetres(point.sigma_mm)),
        ("Brightness", percent(point.grey, 0)),
        ("Seen by", several(point.cameras, "camera") if point.cameras else NOTHING),
    ]
    if point.nearest_mm is not None:
        measured.append(("Nearest point of the view", millimetres(point.nearest_mm)))
    return Properties("Point", (Group("Place on the part", (("x", x), ("y", y), ("z", z))), Group("How it was measured", tuple(measured))))
