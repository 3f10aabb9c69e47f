"""Clouds and meshes of the core as layers of the 3-D view."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, Literal

import numpy as np

from ui.look.theme import Theme
from ui.viewport.colouring import UNKNOWN, by_grey, plain, upper_end
from ui.viewport.layers import CloudLayer, SurfaceLayer
from ui.viewport.overlay.legend import Histogram, Legend
from ui.viewport.prepared_surface import SurfacePart, coarse

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
    from measureapp.data.measurement import ViewResult
    from measureapp.data.mesh import Mesh
    from measureapp.geometry.transform import RigidTransform
    from ui.session import Comparison
    from ui.viewport.overlay.legend import Legend

DENSE_TRIANGLES = 150_000  # so dense that smoothed edges are invisible
RESIDUAL_RANGE = 3.0  # in rms of a view: contains nearly all of its points
SCALE_SAMPLES = 20_000  # of each cloud, for the end of the scale
MARK_MM = 1.5  # half the size of a cross
PROXY_SAMPLES, FAR_SPACINGS = 200_000, 6.0
ColourBy = Literal["view", "sigma", "grey", "residual"]


def cross(place_mm: np.ndarray) -> list[np.ndarray]:
    """Return the lines of a mark at a clicked place."""
    return [place_mm + MARK_MM * np.outer([-1.0, 1.0], axis) for axis in np.eye(3)]


def rgb(theme: Theme, token: str) -> tuple[int, int, int]:
    """Return a colour of the theme as three numbers."""
    colour = theme.colour(token)
    return colour.red(), colour.green(), colour.blue()


def view_colour(theme: Theme, index: int) -> tuple[int, int, int]:
    """Return the colour of the view with this index as three numbers."""
    colour = theme.view(index)
    return colour.red(), colour.green(), colour.blue()


def place_view(view: ViewResult, placement: ViewPlacement | None, *, fine: bool) -> PointCloud:
    """Return the cloud of a view in the part's frame, at its kinematic or registered position."""
    pose = view.part_from_camera
    if placement is not None:
        pose = placement.part_from_camera if fine else placement.kinematic
    return view.cloud.seen_from(pose)


class PlacedClouds:
    """Cache of clouds in the part's frame, so that a change of colours does not transform them again."""

    def __init__(self) -> None:
        self._kept: dict[tuple[str, bool], tuple[ViewResult, ViewPlacement | None, PointCloud]] = {}

    def get(self, view: ViewResult, placement: ViewPlacement | None, *, fine: bool) -> PointCloud:
        """Return the cloud of a view at its kinematic or registered position."""
        key = (view.viewpoint_id, fine)
        kept = self._kept.get(key)
        if kept is None or kept[0] is not view or kept[1] is not placement:
            kept = self._kept[key] = (view, placement, place_view(view, placement, fine=fine))
        return kept[2]


def placements_of(stitched: StitchedCloud | None) -> dict[str, ViewPlacement]:
    """Return the placements of the views, as far as registered."""
    return {} if stitched is None else {placement.viewpoint_id: placement for placement in stitched.placements}


def scale_end(colour_by: ColourBy, clouds: Collection[PointCloud | StitchedCloud], placements: Collection[ViewPlacement]) -> float:
    """Return the upper end of the colour scale in mm."""
    if colour_by == "residual":
        return upper_end(RESIDUAL_RANGE * np.array([placement.residual_mm for placement in placements]))
    return upper_end(sigma_sample(clouds))


def scale_legend(colour_by: ColourBy, end_mm: float, values_mm: np.ndarray, *, merged: bool) -> Legend | None:
    """Return the default legend of a colouring that has a scale; ``values_mm``: a sample, for the histogram."""
    if colour_by == "sigma":
        return Legend("Standard deviation σ", 0.0, end_mm, ramp="growing", histogram=Histogram.of(values_mm), usual=(0.0, end_mm))
    if colour_by != "residual":
        return None
    if merged:
        return Legend("Residual (rms)", 0.0, end_mm, ramp="growing", usual=(0.0, end_mm))
    return Legend("Residual", -end_mm, end_mm, usual=(-end_mm, end_mm))


def sigma_sample(clouds: Collection[PointCloud | StitchedCloud]) -> np.ndarray:
    """Return some standard deviations of each cloud."""
    parts = [cloud.sigma_mm[:: max(1, len(cloud) // SCALE_SAMPLES)] for cloud in clouds]
    return np.concatenate(parts) if parts else np.empty(0)


def view_layer(
    theme: Theme, cloud: PointCloud, index: int, colour_by: ColourBy, legend: Legend | None, residuals_mm: np.ndarray | None = None
) -> CloudLayer:
    """Return one view's points, coloured; ``residuals_mm`` (N,) are signed, for colouring by residual."""
    count = len(cloud)
    if colour_by == "grey":
        colours = by_grey(cloud.grey)
    elif colour_by in {"sigma", "residual"} and legend is not None:
        left = np.full(count, np.nan) if residuals_mm is None else residuals_mm
        colours = legend.colours(cloud.sigma_mm if colour_by == "sigma" else left)
    else:
        colours = plain(view_colour(theme, index), count)
    return CloudLayer(cloud.points_mm, colours, cloud.normals, to_read=colour_by in {"sigma", "residual"})


def stitched_layer(
    theme: Theme,
    stitched: StitchedCloud,
    colour_by: ColourBy,
    legend: Legend | None,
    visible: Collection[int],
    places: Mapping[str, int],
    residuals_mm: np.ndarray | None = None,
) -> CloudLayer:
    """Return the merged points of the visible views, coloured.

    ``places`` is the index of each view, which defines its colour; ``residuals_mm`` (N,) is the rms residual at each merged point.
    """
    keep = np.isin(stitched.view, list(visible))
    view = stitched.view[keep]
    if colour_by == "grey":
        colours = by_grey(stitched.grey[keep])
    elif colour_by in {"sigma", "residual"} and legend is not None:
        left = np.full(len(view), np.nan) if residuals_mm is None else residuals_mm[keep]
        colours = legend.colours(stitched.sigma_mm[keep] if colour_by == "sigma" else left)
    else:
        palette = np.array([view_colour(theme, places.get(found.viewpoint_id, 0)) for found in stitched.placements], np.uint8)
        colours = palette[view]
    return CloudLayer(
        stitched.points_mm.astype(np.float32)[keep], colours, stitched.normals[keep], to_read=colour_by in {"sigma", "residual"}
    )


def deviation_layers(comparison: Comparison, normals: np.ndarray, legend: Legend, *, smooth: bool = False) -> list[CloudLayer]:
    """Return the points coloured by their deviation, and the unmeasured parts of the nominal in grey."""
    found, smoothed = comparison.deviation, comparison.smoothed
    distances = smoothed.distances_mm if smooth and smoothed is not None else found.distances_mm
    grey = (int(UNKNOWN[0]), int(UNKNOWN[1]), int(UNKNOWN[2]))
    return [
        CloudLayer(found.points_mm, legend.colours(distances), normals, to_read=True),
        CloudLayer(comparison.unmeasured_mm, plain(grey, len(comparison.unmeasured_mm)), comparison.unmeasured_normals, to_read=True),
    ]


def deviation_surface(comparison: Comparison, legend: Legend) -> SurfaceLayer | None:
    """Return the nominal coloured by the mean deviation of the points nearby, grey where nothing was measured; None without a nominal."""
    found = comparison.map
    if found is None:
        return None
    colours = legend.colours(np.where(found.measured, found.distances_mm, np.nan))
    return SurfaceLayer(found.mesh.vertices_mm, found.mesh.triangles, colours, to_read=True)


def points_layer(stitched: StitchedCloud, frame: RigidTransform, shade: tuple[int, int, int]) -> CloudLayer:
    """Return the merged points in another frame, in one colour."""
    return CloudLayer(frame.apply(stitched.points_mm), plain(shade, len(stitched)), frame.rotate(stitched.normals))


def filled_share(mesh: Mesh) -> float:
    """Return the share of a surface's area that was filled, not measured; dimensions are never evaluated there."""
    if mesh.measured is None or mesh.measured.all():
        return 0.0
    first, second, third = (mesh.vertices_mm[mesh.triangles[:, corner]] for corner in range(3))
    areas = np.linalg.norm(np.cross(second - first, third - first), axis=1)
    return float(areas[~mesh.measured[mesh.triangles].all(axis=1)].sum() / max(float(areas.sum()), 1e-12))


def mesh_layer(mesh: Mesh, frame: RigidTransform, shade: tuple[int, int, int]) -> SurfaceLayer:
    """Return the measured surface in another frame; filled parts are hatched."""
    colours = plain(shade, len(mesh.vertices_mm))
    if mesh.measured is not None:
        colours[~mesh.measured] = UNKNOWN
    vertices = frame.apply(mesh.vertices_mm)
    normals = vertex_normals(vertices, mesh.triangles) if len(mesh.triangles) > DENSE_TRIANGLES else None
    return SurfaceLayer(vertices, mesh.triangles, colours, normals=normals)


def vertex_normals(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return normals (V, 3): the mean of the triangles around a vertex, weighted by their areas."""
    first, second, third = (vertices[triangles[:, corner]] for corner in range(3))
    faces = np.cross(second - first, third - first)
    corners = triangles.ravel()
    summed = np.stack([np.bincount(corners, np.repeat(faces[:, axis], 3), len(vertices)) for axis in range(3)], axis=1)
    return summed / np.maximum(np.linalg.norm(summed, axis=1, keepdims=True), 1e-12)


def coarse_mesh(mesh: Mesh) -> SurfacePart:
    """Return a surface of at most 50 000 triangles, for a moving picture; slow for millions of triangles."""
    vertices = np.asarray(mesh.vertices_mm, np.float32)
    triangles = np.asarray(mesh.triangles, np.int64)
    return coarse(SurfacePart(vertices, triangles, vertex_normals(vertices, triangles).astype(np.float32), None))


def proxy_layer(part: SurfacePart, layers: Collection[CloudLayer]) -> SurfaceLayer | None:
    """Return a coarse surface in the colours of the points near its vertices; hatched where there are none."""
    from scipy.spatial import cKDTree

    steps = [max(1, len(layer.points_mm) * len(layers) // PROXY_SAMPLES) for layer in layers]
    points = [layer.points_mm[::step] for layer, step in zip(layers, steps, strict=True)]
    if not len(part.triangles) or not sum(len(one) for one in points):
        return None
    colours = np.concatenate([layer.colours[::step] for layer, step in zip(layers, steps, strict=True)])
    distances, nearest = cKDTree(np.concatenate(points)).query(part.vertices_mm)
    made = colours[nearest].copy()
    made[distances > FAR_SPACINGS * max(float(np.median(distances)), 1e-6)] = UNKNOWN
    to_read = any(layer.to_read for layer in layers)
    return SurfaceLayer(part.vertices_mm, part.triangles, made, normals=part.normals, to_read=to_read)
