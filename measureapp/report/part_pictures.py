"""Pictures of a report: the measured part, and every dimension that does not pass."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.data.dimension import SEVERITY, Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.report.model import DimensionPicture, Flag, Picture
from measureapp.report.picture import SURFACE_COLOUR, Seen, SurfaceScene, ViewDirection, cloud_picture, png
from measureapp.report.words import COLOURS, format_name, number

OBLIQUE, TOP = ViewDirection(-58.0, 34.0), ViewDirection(-90.0, 89.9)
DIRECTIONS = (
    OBLIQUE,
    *(ViewDirection(azimuth, 34.0) for azimuth in (32.0, 122.0, 212.0)),
    *(ViewDirection(azimuth, -34.0) for azimuth in (-58.0, 122.0)),
)
FILLED_IN = np.array([0.36, 0.39, 0.42])
NEAR_FEATURE_MM, BESIDE_MM = 1.0, 0.5
MOST_PLACES = 400
MOST_PICTURES = 8
SIZE = (680, 480)


def placed_mesh(measurement: Measurement) -> Mesh | None:
    """Return the measured surface, in the nominal's frame if known, so that all parts have the same orientation; None without a mesh."""
    mesh, inspection = measurement.mesh, measurement.inspection
    return mesh if mesh is None or inspection is None else mesh.seen_from(inspection.alignment.nominal_from_part)


def scene_of(measurement: Measurement) -> SurfaceScene | None:
    """Return the placed mesh, to be drawn several times; None without a mesh."""
    mesh = placed_mesh(measurement)
    return None if mesh is None else SurfaceScene(mesh)


def render_part(measurement: Measurement, scene: SurfaceScene | None = None) -> tuple[Picture, ...]:
    """Return pictures of the measured surface (or cloud) from obliquely above and from the top."""
    scene = scene or scene_of(measurement)
    if scene is None:
        return _cloud_pictures(measurement)
    filled = scene.mesh.measured is not None and not scene.mesh.measured.all()
    drawn, views = scene, (("oblique view", OBLIQUE), ("top view", TOP))

    def draw(view: int, _end: int) -> Picture:
        where, direction = views[view]
        seen = drawn.see(direction, *SIZE)
        caption = f"Measured surface (dark: filled, not measured), {where}" if filled else f"Measured surface, {where}"
        return Picture(caption, png(drawn.picture(seen, _surface_colours(drawn, seen))))

    return tuple(in_bands(draw, len(views), len(views)))


def render_failing(measurement: Measurement, scene: SurfaceScene | None) -> tuple[DimensionPicture, ...]:
    """Return a picture of each dimension that does not pass, the worst first, with its features coloured and a flag; at most `MOST_PICTURES`."""
    if scene is None or measurement.inspection is None:
        return ()
    features = {feature.name: feature for feature in measurement.inspection.features}
    failing = sorted(
        (one for one in measurement.inspection.dimensions if one.verdict not in (Verdict.PASS, Verdict.NO_TOLERANCE)),
        key=lambda one: SEVERITY.index(one.verdict),
    )
    made: list[DimensionPicture] = []
    for dimension in failing:
        own = [features[name] for name in dimension.features if name in features]
        picture = _dimension_picture(dimension, own, scene) if own else None
        if picture is not None:
            made.append(DimensionPicture(dimension.name, picture))
        if len(made) == MOST_PICTURES:
            break
    return tuple(made)


def _dimension_picture(dimension: Dimension, features: Sequence[Feature], scene: SurfaceScene) -> Picture | None:
    """Draw the features of a dimension from where most of them is visible; None where the surface has none of them."""
    regions = {feature.name: on_feature(scene.mesh, feature) for feature in features}
    places = {name: _spread(scene.mesh.vertices_mm[region]) for name, region in regions.items() if region.any()}
    if not places:
        return None
    points = np.concatenate(list(places.values()))
    owners = np.repeat(np.arange(len(places)), [len(some) for some in places.values()])
    visible = {direction: ~scene.occluded(points, direction.axes()[2], 1.0) for direction in DIRECTIONS}
    best = max(DIRECTIONS, key=lambda direction: _visible_score(visible[direction], owners))
    seen = scene.see(best, *SIZE)
    colours = _surface_colours(scene, seen)
    tint = np.clip(scene.at_corners(seen, np.any(list(regions.values()), axis=0)[:, None].astype(float)), 0, 1)
    colours = colours + 0.75 * tint * (_rgb(COLOURS[dimension.verdict]) - colours)
    anchors = [anchor for k in range(len(places)) if (anchor := _anchor(points, visible[best], owners == k, seen)) is not None]
    flags = (Flag(anchors[0], flag_text(dimension), COLOURS[dimension.verdict], tuple(anchors[1:])),) if anchors else ()
    name = format_name(dimension.name)
    return Picture(name if anchors else f"{name} (hidden in this view)", png(scene.picture(seen, colours)), flags)


def flag_text(dimension: Dimension) -> tuple[str, ...]:
    """Return the lines of the flag of a dimension."""
    if dimension.measured is None:
        return (format_name(dimension.name), "not measured")
    unit = "°" if dimension.unit == "°" else f" {dimension.unit}"
    return (format_name(dimension.name), f"{number(dimension.measured)}{unit}", f"deviation {number(dimension.deviation, signed=True)}")


def on_feature(mesh: Mesh, feature: Feature) -> BoolArray:
    """Return which vertices of a mesh in the feature's frame belong to it: inside its extent, and near it where its shape is simple."""
    points = mesh.vertices_mm
    if feature.boundary_mm is None:
        return np.linalg.norm(points - feature.point_mm, axis=1) < 3 * NEAR_FEATURE_MM
    low, high = feature.boundary_mm.min(axis=0) - BESIDE_MM, feature.boundary_mm.max(axis=0) + BESIDE_MM
    inside: BoolArray = np.all((points >= low) & (points <= high), axis=1)
    offset = points - feature.point_mm
    if feature.shape == "plane" and feature.direction is not None:
        inside &= np.abs(offset @ feature.direction) < NEAR_FEATURE_MM
    elif feature.shape == "cylinder" and feature.direction is not None and feature.radius_mm is not None:
        inside &= np.abs(np.linalg.norm(np.cross(offset, feature.direction), axis=1) - feature.radius_mm) < NEAR_FEATURE_MM
    elif feature.shape == "sphere" and feature.radius_mm is not None:
        inside &= np.abs(np.linalg.norm(offset, axis=1) - feature.radius_mm) < NEAR_FEATURE_MM
    return inside


def _spread(points_mm: FloatArray) -> FloatArray:
    return points_mm[:: max(1, len(points_mm) // MOST_PLACES)]


def _visible_score(visible: BoolArray, owners: IntArray) -> float:
    """Return how much is visible: of every feature something first, then as much as possible."""
    shares = [float(visible[owners == k].mean()) for k in np.unique(owners)]
    return round(sum(share > 0.02 for share in shares) + 0.5 * float(np.mean(shares)), 2)


def _anchor(points: FloatArray, visible: BoolArray, own: BoolArray, seen: Seen) -> tuple[float, float] | None:
    """Return where a flag points to: the visible point of a feature nearest the middle of those."""
    chosen = points[visible & own]
    if not len(chosen):
        return None
    places, _ = seen.frame.place(chosen)
    nearest = places[np.argmin(np.linalg.norm(places - np.median(places, axis=0), axis=1))]
    return float(nearest[0]), float(nearest[1])


def _surface_colours(scene: SurfaceScene, seen: Seen) -> FloatArray:
    measured = scene.mesh.measured
    if measured is None or measured.all():
        return np.tile(SURFACE_COLOUR, (len(seen.pixels), 1))
    return scene.at_corners(seen, np.where(measured[:, None], SURFACE_COLOUR, FILLED_IN))


def _cloud_pictures(measurement: Measurement) -> tuple[Picture, ...]:
    cloud, inspection = measurement.stitched, measurement.inspection
    points, normals = cloud.points_mm, cloud.normals
    if inspection is not None:
        placed = inspection.alignment.nominal_from_part
        points, normals = placed.apply(points), placed.rotate(np.asarray(normals, float))
    views: Mapping[str, ViewDirection] = {"oblique view": OBLIQUE, "top view": TOP}
    return tuple(
        Picture(f"Measured points, {where}", png(cloud_picture(points, normals, direction, *SIZE))) for where, direction in views.items()
    )


def _rgb(colour: str) -> FloatArray:
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
