"""Symbols of the geometrical characteristics (ISO 1101) as outlines: fonts have not all of them, so window and documents draw these."""

from __future__ import annotations

Segment = tuple[float, float, float, float]  # x, y of its ends in a unit square, y downwards
ARC_Y, ARC_RADIUS = 0.75, 0.5  # half circle of a profile, above its base
STROKE = 0.11  # of the square
LINES: dict[str, tuple[Segment, ...]] = {
    "straightness": ((0.0, 0.5, 1.0, 0.5),),
    "flatness": ((0.3, 0.2, 1.0, 0.2), (1.0, 0.2, 0.7, 0.8), (0.7, 0.8, 0.0, 0.8), (0.0, 0.8, 0.3, 0.2)),
    "cylindricity": ((0.0, 0.95, 0.25, 0.05), (0.75, 0.95, 1.0, 0.05)),
    "parallelism": ((0.1, 1.0, 0.5, 0.0), (0.5, 1.0, 0.9, 0.0)),
    "perpendicularity": ((0.5, 0.0, 0.5, 1.0), (0.0, 1.0, 1.0, 1.0)),
    "angularity": ((1.0, 0.1, 0.0, 1.0), (0.0, 1.0, 1.0, 1.0)),
    "position": ((0.5, 0.0, 0.5, 1.0), (0.0, 0.5, 1.0, 0.5)),
    "circular_runout": ((0.15, 1.0, 0.85, 0.0), (0.85, 0.0, 0.47, 0.2), (0.85, 0.0, 0.8, 0.42)),
    "total_runout": (
        *((0.0, 1.0, 0.45, 0.1), (0.45, 0.1, 0.18, 0.3), (0.45, 0.1, 0.46, 0.48)),
        *((0.5, 1.0, 0.95, 0.1), (0.95, 0.1, 0.68, 0.3), (0.95, 0.1, 0.96, 0.48), (0.0, 1.0, 0.5, 1.0)),
    ),
    "surface_profile": ((0.0, 0.75, 1.0, 0.75),),
}
CIRCLES: dict[str, tuple[float, ...]] = {  # radii
    "roundness": (0.45,),
    "cylindricity": (0.3,),
    "position": (0.34,),
    "concentricity": (0.48, 0.24),
    "coaxiality": (0.48, 0.24),
}
ARCS = ("line_profile", "surface_profile")


def symbol_svg(characteristic: str, colour: str = "#1F2933") -> str:
    """Return a symbol as a square SVG picture with a little room around it."""
    parts = [f"M{x0:g} {y0:g}L{x1:g} {y1:g}" for x0, y0, x1, y1 in LINES.get(characteristic, ())]
    for radius in CIRCLES.get(characteristic, ()):
        parts.append(f"M{0.5 - radius:g} 0.5a{radius:g} {radius:g} 0 1 0 {2 * radius:g} 0a{radius:g} {radius:g} 0 1 0 {-2 * radius:g} 0")
    if characteristic in ARCS:
        parts.append(f"M{0.5 - ARC_RADIUS:g} {ARC_Y:g}A{ARC_RADIUS:g} {ARC_RADIUS:g} 0 0 1 {0.5 + ARC_RADIUS:g} {ARC_Y:g}")
    style = f'fill="none" stroke="{colour}" stroke-width="{STROKE:g}" stroke-linecap="round" stroke-linejoin="round"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.1 -0.1 1.2 1.2"><path d="{"".join(parts)}" {style}/></svg>'
