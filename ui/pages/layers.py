"""Nouns of the core as layers of the 3-D view."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Literal

import numpy as np

from ui.look.theme import Theme
from ui.viewport.colouring import GROWING, along, by_grey, plain, upper_end
from ui.viewport.layers import CloudLayer

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
    from measureapp.data.measurement import ViewResult

ColourBy = Literal["view", "sigma", "grey", "residual"]


def rgb(theme: Theme, token: str) -> tuple[int, int, int]:
    """Return a colour of the theme as three numbers."""
    colour = theme.colour(token)
    return colour.red(), colour.green(), colour.blue()


def view_colour(theme: Theme, index: int) -> tuple[int, int, int]:
    """Return the colour of the view with this index as three numbers."""
    colour = theme.view(index)
    return colour.red(), colour.green(), colour.blue()


def placed(view: ViewResult, placement: ViewPlacement | None, *, fine: bool) -> PointCloud:
    """Return the cloud of a view in the part's frame, by the axes alone or after fine stitching."""
    pose = view.part_from_camera
    if placement is not None:
        pose = placement.part_from_camera if fine else placement.kinematic
    return view.cloud.seen_from(pose)


def scale_end(colour_by: ColourBy, clouds: Collection[PointCloud | StitchedCloud], placements: Collection[ViewPlacement]) -> float:
    """Return the upper end of the colour scale in mm."""
    if colour_by == "residual":
        return upper_end(np.array([placement.residual_mm for placement in placements]))
    return upper_end(np.concatenate([cloud.sigma_mm for cloud in clouds]) if clouds else np.empty(0))


def view_layer(
    theme: Theme, cloud: PointCloud, index: int, placement: ViewPlacement | None, colour_by: ColourBy, end_mm: float
) -> CloudLayer:
    """Return one view's points, coloured."""
    count = len(cloud)
    if colour_by == "sigma":
        colours = along(GROWING, cloud.sigma_mm, 0.0, end_mm)
    elif colour_by == "grey":
        colours = by_grey(cloud.grey)
    elif colour_by == "residual":
        residual = placement.residual_mm if placement is not None else np.nan
        colours = along(GROWING, np.full(count, residual), 0.0, end_mm)
    else:
        colours = plain(view_colour(theme, index), count)
    return CloudLayer(cloud.points_mm, colours, cloud.normals)


def stitched_layer(theme: Theme, stitched: StitchedCloud, colour_by: ColourBy, end_mm: float, visible: Collection[int]) -> CloudLayer:
    """Return the merged points of the visible views, coloured."""
    keep = np.isin(stitched.view, list(visible))
    view = stitched.view[keep]
    if colour_by == "sigma":
        colours = along(GROWING, stitched.sigma_mm[keep], 0.0, end_mm)
    elif colour_by == "grey":
        colours = by_grey(stitched.grey[keep])
    elif colour_by == "residual":
        residuals = np.array([placement.residual_mm for placement in stitched.placements])
        colours = along(GROWING, residuals[view], 0.0, end_mm)
    else:
        palette = np.array([view_colour(theme, index) for index in range(len(stitched.placements))], np.uint8)
        colours = palette[view]
    return CloudLayer(stitched.points_mm[keep], colours, stitched.normals[keep])
