"""The 3-D picture of the clouds: visible views, colours, and picking of points."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

import numpy as np

from ui.look.look import Look
from ui.pages.clicked_distance import ClickedPoint
from ui.pages.clouds.residuals import Residuals
from ui.pages.layers import ColourBy, PlacedClouds, coarse_mesh, placements_of, proxy_layer, stitched_layer, view_layer
from ui.pages.picked_point import PickedPoint, merged_point, quick_point, view_point
from ui.pages.viewport_page import Composer, Picture
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.mesh import Mesh
    from ui.viewport.layers import CloudLayer, SurfaceLayer
    from ui.viewport.overlay.legend import Legend
    from ui.viewport.prepared_surface import SurfacePart

PROXY_POINTS = 50_000  # fewer are drawn in time as they are


class CloudPicture:
    """Composes the clouds of a stage, without hidden views; caches placed clouds and residuals."""

    def __init__(self, look: Look, session: Session, hidden: Collection[str]) -> None:
        self._look, self._session, self._hidden = look, session, hidden
        self.placed, self.residuals = PlacedClouds(), Residuals()
        self._coarse: tuple[Mesh, SurfacePart] | None = None

    def merged(self, stage: str) -> StitchedCloud | None:
        """Return the merged cloud of a stage, complete or filtered; None for stages of single views."""
        return {"merged": self._session.stitched, "filtered": self._session.filtered}.get(stage)

    def composer(self, stage: str, colour_by: ColourBy, legend: Legend | None) -> Composer:
        """Return the composer of the visible views in the colours of a legend."""
        if self.merged(stage) is not None:
            return self._merged_composer(stage, colour_by, legend)
        placements, views, stitched = placements_of(self._session.stitched), self._session.views, self._session.stitched
        theme, visible, mesh = self._look.theme, self._visible_views(), self._mesh(stage)

        def compose(job: Job) -> Picture:
            layers: list[CloudLayer] = []
            for index in visible:
                job.check()
                cloud = self.placed.get(views[index], placements.get(views[index].viewpoint_id), fine=stage == "after")
                left = self.residuals.of(cloud, stitched) if colour_by == "residual" and stitched is not None else None
                layers.append(view_layer(theme, cloud, index, colour_by, legend, left))
            return Picture(tuple(layers), proxy=self._proxy(mesh, layers))

        return compose

    def _merged_composer(self, stage: str, colour_by: ColourBy, legend: Legend | None) -> Composer:
        merged, views = self.merged(stage), self._session.views
        assert merged is not None
        placements, theme, visible = placements_of(self._session.stitched), self._look.theme, self._visible_merged(merged)
        mesh = self._mesh(stage)
        places = {view.viewpoint_id: index for index, view in enumerate(views)}

        def compose(job: Job) -> Picture:
            left = None
            if colour_by == "residual":
                used = [view for view in views if (found := placements.get(view.viewpoint_id)) is not None and found.used]
                fine = [self.placed.get(view, placements[view.viewpoint_id], fine=True) for view in used]
                left = self.residuals.merged(fine, merged, job.check)
            layer = stitched_layer(theme, merged, colour_by, legend, visible, places, left)
            return Picture((layer,), proxy=self._proxy(mesh, [layer]))

        return compose

    def _mesh(self, stage: str) -> Mesh | None:
        """Return the surface of the clouds of a stage, if it is exactly theirs."""
        measured = self._session.measurement
        fits = stage in {"after", "merged"} and not self._hidden and measured is not None and measured.stitched is self._session.stitched
        return measured.mesh if fits and measured is not None else None

    def _proxy(self, mesh: Mesh | None, layers: list[CloudLayer]) -> SurfaceLayer | None:
        """Return the coarse surface in the colours of the points, on a job's thread."""
        if mesh is None or not len(mesh.triangles) or sum(len(layer.points_mm) for layer in layers) < PROXY_POINTS:
            return None
        if self._coarse is None or self._coarse[0] is not mesh:
            self._coarse = (mesh, coarse_mesh(mesh))
        return proxy_layer(self._coarse[1], layers)

    def picked(self, stage: str, layer: int, place: int) -> PickedPoint:
        """Return the point at a place of a layer of the picture of this stage; its source is found by `traced`."""
        stitched = self.merged(stage)
        if stitched is not None:
            return quick_point(stitched, self._row(stitched, place))
        view = self._session.views[self._visible_views()[layer]]
        placement = placements_of(self._session.stitched).get(view.viewpoint_id)
        return view_point(view.viewpoint_id, self.placed.get(view, placement, fine=stage == "after"), place)

    def tracer(self, stage: str, place: int) -> Callable[[], PickedPoint] | None:
        """Return what finds the pixel and the views of a merged point, on a job's thread; None for a point of a view, which knows them."""
        stitched, views = self.merged(stage), self._session.views
        if stitched is None:
            return None
        row = self._row(stitched, place)
        return lambda: merged_point(stitched, row, views)

    def _row(self, stitched: StitchedCloud, place: int) -> int:
        """Return the row of the merged cloud of a point of its picture."""
        if not self._hidden:
            return place
        return int(np.flatnonzero(np.isin(stitched.view, self._visible_merged(stitched)))[place])

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
