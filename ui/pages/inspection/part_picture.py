"""The 3-D picture of a measured part: surface, points, or deviations from the nominal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.pages.inspection.deviation_display import DeviationDisplay
from ui.pages.layers import deviation_layers, deviation_surface, filled_share, mesh_layer, points_layer
from ui.pages.viewport_page import Composer, Picture
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.mesh import Mesh

SHAPES = {"surface": "Surface", "points": "Points", "deviation": "Deviation"}
SHAPE_TIPS = {
    "surface": "Measured surface; hatched where it was filled, not measured",
    "points": "Merged points",
    "deviation": "Deviation from the nominal, in mm, on the CAD model or on the measured points",
}
GREYS = {"light": (196, 204, 208), "dark": (150, 162, 168)}  # of the part


def part_composer(session: Session, wanted: str, shade: str, display: DeviationDisplay) -> Composer | None:
    """Return the composer of the part in the nominal's frame; None while nothing is measured."""
    inspection, stitched, comparison, mesh = session.inspection, session.stitched, session.comparison, mesh_of(session)
    if inspection is None or stitched is None:
        return None
    legend, on_cad, smooth = display.legend, display.on == "cad", display.smooth
    nominal_from_part, grey = inspection.alignment.nominal_from_part, GREYS[shade]

    def compose(_job: Job) -> Picture:
        if wanted == "deviation" and comparison is not None and legend is not None:
            if on_cad and (surface := deviation_surface(comparison, legend)) is not None:
                return Picture(surface=surface)
            normals = nominal_from_part.rotate(comparison.stitched.normals)
            return Picture(tuple(deviation_layers(comparison, normals, legend, smooth=smooth)))
        if wanted == "surface" and mesh is not None:
            return Picture(surface=mesh_layer(mesh, nominal_from_part, grey))
        return Picture((points_layer(stitched, nominal_from_part, grey),))

    return compose


def mesh_of(session: Session) -> Mesh | None:
    """Return the measured surface, if there is one."""
    return None if session.measurement is None else session.measurement.mesh


def filled_in(session: Session, wanted: str) -> float:
    """Return the share of the shown surface that was filled, not measured."""
    mesh = mesh_of(session)
    return filled_share(mesh) if mesh is not None and wanted == "surface" else 0.0
