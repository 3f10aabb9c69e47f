"""Pictures of a report: the measured part, and its coloured deviation from the nominal."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.surface.deviation import Deviation, signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.report.model import DeviationSummary, Picture
from measureapp.report.picture import SURFACE_COLOUR, ViewDirection, cloud_picture, png, surface_picture

OBLIQUE, TOP = ViewDirection(-58.0, 34.0), ViewDirection(-90.0, 89.9)
BLUE, WHITE, RED = np.array([0.13, 0.34, 0.67]), np.array([0.97, 0.97, 0.97]), np.array([0.76, 0.15, 0.18])
NOT_MEASURED = np.array([0.62, 0.64, 0.67])
FILLED_IN = np.array([0.36, 0.39, 0.42])
BINS = 40
NICE_LIMITS_MM = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
WIDE = (840, 500)


def render_part(measurement: Measurement) -> tuple[Picture, ...]:
    """Return pictures of the measured surface (or cloud) from obliquely above and from the top."""
    mesh = measurement.mesh
    what, colours = "Measured points" if mesh is None else "Measured surface", None
    if mesh is not None and mesh.measured is not None and not mesh.measured.all():
        what, colours = "Measured surface (dark: filled, not measured)", np.where(mesh.measured[:, None], SURFACE_COLOUR, FILLED_IN)
    return tuple(
        Picture(f"{what}, {where}", png(_render(measurement, None, direction, colours)))
        for where, direction in (("oblique view", OBLIQUE), ("top view", TOP))
    )


def summarise_deviation(measurement: Measurement, nominal: Mesh, deviation: Deviation) -> DeviationSummary:
    """Summarise a deviation: picture, colour scale and histogram."""
    limit = nice_limit(deviation.p95_mm)
    transform = deviation.alignment.nominal_from_part
    if measurement.mesh is None:
        colours = diverging_colours(deviation.distances_mm / limit)
    else:
        colours = _mesh_colours(measurement.mesh, transform, NominalSurface(nominal), limit)
    image = _render(measurement, transform, OBLIQUE, colours, *WIDE)
    clipped = np.clip(deviation.distances_mm, -limit, limit)
    counts, _ = np.histogram(clipped, bins=BINS, range=(-limit, limit))
    figures = {name: float(getattr(deviation, f"{name}_mm")) for name in ("mean", "rms", "p95", "min", "max")}
    return DeviationSummary(
        deviation.alignment.name,
        figures,
        deviation.unmeasured_share,
        limit,
        tuple(float(share) for share in counts / max(counts.sum(), 1)),
        Picture("Deviation of the measured surface from the nominal", png(image)),
    )


def nice_limit(p95_mm: float) -> float:
    """Return the end of the colour scale: the next round number above 1.2 times the 95th percentile.

    >>> nice_limit(0.07), nice_limit(0.3)
    (0.1, 0.5)
    """
    return next((limit for limit in NICE_LIMITS_MM if limit >= 1.2 * p95_mm), 2 * p95_mm)


def diverging_colours(values: FloatArray) -> FloatArray:
    """Return diverging colours (N, 3) of values in −1…1: blue, white, red."""
    share = np.abs(np.clip(values, -1, 1))[:, None]
    return WHITE + share * (np.where(values[:, None] < 0, BLUE, RED) - WHITE)


def _mesh_colours(mesh: Mesh, nominal_from_part: RigidTransform, nominal: NominalSurface, limit_mm: float) -> FloatArray:
    colours = diverging_colours(signed_distances(nominal_from_part.apply(mesh.vertices_mm), nominal) / limit_mm)
    if mesh.measured is not None:
        colours[~mesh.measured] = NOT_MEASURED
    return colours


def _render(
    measurement: Measurement,
    transform: RigidTransform | None,
    direction: ViewDirection,
    colours: FloatArray | None,
    width: int = 680,
    height: int = 480,
) -> ImageArray:
    """Render mesh or cloud, in the nominal's frame if known, so that all parts have the same orientation."""
    placed = transform or (None if measurement.inspection is None else measurement.inspection.alignment.nominal_from_part)
    mesh, cloud = measurement.mesh, measurement.stitched
    if mesh is not None:
        shown = mesh if placed is None else mesh.seen_from(placed)
        return surface_picture(shown, direction, width, height, colours)
    points = cloud.points_mm if placed is None else placed.apply(cloud.points_mm)
    normals = cloud.normals if placed is None else placed.rotate(np.asarray(cloud.normals, float))
    return cloud_picture(points, normals, direction, width, height, colours)
