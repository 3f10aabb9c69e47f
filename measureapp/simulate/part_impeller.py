"""Sample part: the impeller."""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, pi, sin

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.simulate.part import ALUMINIUM, Part
from measureapp.simulate.solids import Soup, arc, circle

PLATE_RADIUS_MM, PLATE_TOP_MM = 140.0, 12.0
HUB_RADIUS_MM, HUB_TOP_MM, BORE_RADIUS_MM = 45.0, 60.0, 20.0
BLADES, BLADE_TOP_MM, BLADE_THICKNESS_MM, BLADE_END_RADIUS_MM = 7, 52.0, 5.0, 130.0
BLADE_RADIUS_MM, BLADE_CENTRE_MM = 110.0, 90.0  # of the blade's mid-line, and its centre's distance from the axis


def impeller() -> Part:
    """Return the impeller: back plate, hub with bore and seven curved blades.

    Blade k's mid-line is an arc of radius 110 about a centre at distance 90 and polar angle γ = 360°·k/7. Of the two
    arcs from the hub to r = 130 it is the counter-clockwise one: at radius ρ its polar angle is
    γ + acos((ρ² + 90² − 110²) / (2·90·ρ)). The flanks are the concentric arcs 2.5 mm to both sides; the outer ends are
    cut by the cylinder r = 130, the inner ends by the hub.
    """
    blades = [_blade(2.0 * pi * k / BLADES) for k in range(BLADES)]
    hub = _hub_outline(blades)
    soup = Soup()
    plate, bore = circle(PLATE_RADIUS_MM), circle(BORE_RADIUS_MM)
    soup.face([plate, bore], 0.0, up=False)
    soup.wall(plate, 0.0, PLATE_TOP_MM)
    soup.face([plate, _star_outline(blades)], PLATE_TOP_MM, up=True)
    for blade in blades:
        soup.wall(np.concatenate([blade.right, blade.end[1:], blade.left[1:]]), PLATE_TOP_MM, BLADE_TOP_MM, closed=False)
        soup.face([np.concatenate([blade.right, blade.end[1:], blade.left[1:-1], blade.foot[:-1]])], BLADE_TOP_MM, up=True)
    for gap in _gaps(blades):
        soup.wall(gap, PLATE_TOP_MM, BLADE_TOP_MM, closed=False)
    soup.wall(hub, BLADE_TOP_MM, HUB_TOP_MM)
    soup.face([hub, bore], HUB_TOP_MM, up=True)
    soup.wall(bore[::-1], 0.0, HUB_TOP_MM)
    mesh = Mesh(*soup.merge(), "nominal")
    return Part("impeller", mesh, (ALUMINIUM,), np.zeros(len(mesh.triangles), np.uint8), _dimensions())


def _dimensions() -> dict[str, float]:
    return {
        "outer_diameter": 2 * PLATE_RADIUS_MM,
        "hub_diameter": 2 * HUB_RADIUS_MM,
        "bore_diameter": 2 * BORE_RADIUS_MM,
        "blade_height": BLADE_TOP_MM - PLATE_TOP_MM,
        "blade_thickness": BLADE_THICKNESS_MM,
        "blade_pitch": 200.0 * sin(pi / BLADES),
    }


@dataclass(frozen=True, slots=True, eq=False)
class _Blade:
    """Plan of one blade: `right` flank outwards, `end` counter-clockwise, `left` flank inwards, `foot` on the hub from left to right."""

    right: FloatArray
    end: FloatArray
    left: FloatArray
    foot: FloatArray


def _blade(angle_rad: float) -> _Blade:
    centre = (BLADE_CENTRE_MM * float(np.cos(angle_rad)), BLADE_CENTRE_MM * float(np.sin(angle_rad)))
    outer, right = (_flank(BLADE_RADIUS_MM + side * BLADE_THICKNESS_MM / 2, angle_rad, centre) for side in (1, -1))
    left = outer[::-1]
    return _Blade(right, _between(right[-1], left[0], BLADE_END_RADIUS_MM), left, _between(right[0], left[-1], HUB_RADIUS_MM)[::-1])


def _flank(radius_mm: float, angle_rad: float, centre: tuple[float, float]) -> FloatArray:
    """The flank from the hub to the end radius."""
    ends = [_on_flank(rho, radius_mm, angle_rad) - centre for rho in (HUB_RADIUS_MM, BLADE_END_RADIUS_MM)]
    start, stop = (float(np.arctan2(y, x)) for x, y in ends)
    sweep = (stop - start + pi) % (2 * pi) - pi
    return arc(radius_mm, start, start + sweep, centre)


def _on_flank(rho_mm: float, radius_mm: float, angle_rad: float) -> FloatArray:
    polar = angle_rad + acos((rho_mm**2 + BLADE_CENTRE_MM**2 - radius_mm**2) / (2 * BLADE_CENTRE_MM * rho_mm))
    return rho_mm * np.array([np.cos(polar), np.sin(polar)])


def _between(start: FloatArray, end: FloatArray, radius_mm: float) -> FloatArray:
    """The arc about the z axis, counter-clockwise from ``start`` to ``end``."""
    first, last = float(np.arctan2(start[1], start[0])), float(np.arctan2(end[1], end[0]))
    sweep = (last - first) % (2 * pi)
    points = arc(radius_mm, first, first + sweep)
    points[0], points[-1] = start, end
    return points


def _gaps(blades: list[_Blade]) -> list[FloatArray]:
    """The hub's outline between neighbouring blades, counter-clockwise."""
    return [
        _between(blade.left[-1], following.right[0], HUB_RADIUS_MM)
        for blade, following in zip(blades, blades[1:] + blades[:1], strict=True)
    ]


def _hub_outline(blades: list[_Blade]) -> FloatArray:
    pieces = []
    for blade, gap in zip(blades, _gaps(blades), strict=True):
        pieces += [blade.foot[::-1][:-1], gap[:-1]]
    return np.concatenate(pieces)


def _star_outline(blades: list[_Blade]) -> FloatArray:
    """Hub and blades seen from above."""
    pieces = []
    for blade, gap in zip(blades, _gaps(blades), strict=True):
        pieces += [blade.right[:-1], blade.end[:-1], blade.left[:-1], gap[:-1]]
    return np.concatenate(pieces)
