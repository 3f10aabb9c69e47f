"""The 3-D picture of the clouds: visible views, colours, and picking of points."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

import numpy as np

from ui.look.look import Look
from ui.pages.clicked_distance import ClickedPoint
from ui.pages.clouds.residuals import Residuals
from ui.pages.layers import ColourBy, PlacedClouds, placements_of, stitched_layer, view_layer
from ui.pages.picked_point import PickedPoint, merged_point, view_point
from ui.pages.viewport_page import Composer, Picture
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from ui.viewport.layers import CloudLayer


class CloudPicture:
    """Composes the clouds of a stage, without hidden views; caches placed clouds and residuals."""

    def __init__(self, look: Look, session: Session, hidden: Collection[str]) -> None:
        self._look, self._session, self._hidden = look, session, hidden
        self.placed, self.residuals = PlacedClouds(), Residuals()

    def merged(self, stage: str) -> StitchedCloud | None:
        """Return the merged cloud of a stage, complete or filtered; None for stages of single views."""
        return {"merged": self._session.stitched, "filtered": self._session.filtered}.get(stage)

    def composer(self, stage: str, colour_by: ColourBy, end_mm: float) -> Composer:
        """Return the composer of the visible views; the colour scale ends at ``end_mm``."""
        if self.merged(stage) is not None:
            return self._merged_composer(stage, colour_by, end_mm)
        placements, views, stitched = placements_of(self._session.stitched), self._session.views, self._session.stitched
        theme, visible = self._look.theme, self._visible_views()

        def compose(job: Job) -> Picture:
            layers: list[CloudLayer] = []
            for index in visible:
                job.check()
                cloud = self.placed.get(views[index], placements.get(views[index].viewpoint_id), fine=stage == "after")
                left = self.residuals.of(cloud, stitched) if colour_by == "residual" and stitched is not None else None
                layers.append(view_layer(theme, cloud, index, colour_by, end_mm, left))
            return Picture(tuple(layers))

        return compose

    def _merged_composer(self, stage: str, colour_by: ColourBy, end_mm: float) -> Composer:
        merged, views = self.merged(stage), self._session.views
        assert merged is not None
        placements, theme, visible = placements_of(self._session.stitched), self._look.theme, self._visible_merged(merged)
        places = {view.viewpoint_id: index for index, view in enumerate(views)}

        def compose(job: Job) -> Picture:
            left = None
            if colour_by == "residual":
                used = [view for view in views if (found := placements.get(view.viewpoint_id)) is not None and found.used]
                fine = [self.placed.get(view, placements[view.viewpoint_id], fine=True) for view in used]
                left = self.residuals.merged(fine, merged, job.check)
            return Picture((stitched_layer(theme, merged, colour_by, end_mm, visible, places, left),))

        return compose

    def picked(self, stage: str, layer: int, place: int) -> PickedPoint:
        """Return the point at a place of a layer of the picture of this stage."""
        stitched = self.merged(stage)
        if stitched is not None:
            row_of = np.flatnonzero(np.isin(stitched.view, self._visible_merged(stitched)))
            return merged_point(stitched, int(row_of[place]), self._session.views)
        view = self._session.views[self._visible_views()[layer]]
        placement = placements_of(self._session.stitched).get(view.viewpoint_id)
        return view_point(view.viewpoint_id, self.placed.get(view, placement, fine=stage == "after"), place)

    def clicked(self, stage: str, point: PickedPoint) -> ClickedPoint:
        """Return a point for measuring, with the error model of its view if known."""
        known = self._session.stitched if stage != "before" else None
        names = () if known is None else known.view_names
        number = names.index(point.viewpoint_id) if point.viewpoint_id in names else None
        errors = None if known is None else known.errors
        return ClickedPoint(point.position_mm, point.sigma_mm, point.viewpoint_id, number, errors, self._session.scale_ppm)

    def _visible_views(self) -> list[int]:
        return [index for index, view in enumerate(self._session.views) if view.viewpoint_id not in self._hidden]

    def _visible_merged(self, stitched: StitchedCloud) -> list[int]:
        return [index for index, found in enumerate(stitched.placements) if found.viewpoint_id not in self._hidden]
