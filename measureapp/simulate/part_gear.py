"""Sample part: the metal gear with a polished centre."""

from __future__ import annotations

from math import pi, radians

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.simulate.part import POLISHED, STEEL, Part
from measureapp.simulate.solids import Soup, arc, circle, polyline

TEETH = 24
TIP_RADIUS_MM, ROOT_RADIUS_MM, TOP_MM = 80.0, 70.0, 30.0
TIP_HALF_RAD, FOOT_HALF_RAD = radians(2.0), radians(4.75)  # half a tooth, as an angle at the axis
BOSS_RADIUS_MM, BOSS_TOP_MM, BORE_RADIUS_MM = 35.0, 36.0, 20.0
SHINY_RADIUS_MM = 45.0
FLANK_STEP_MM = 1.0


def gear() -> Part:
    """Return the spur gear: 24 trapezoidal teeth, boss and bore; inside r = 45 the metal is polished."""
    outline, shiny = _outline(), circle(SHINY_RADIUS_MM)
    boss, bore = circle(BOSS_RADIUS_MM), circle(BORE_RADIUS_MM)
    soup = Soup()
    soup.face([outline, bore], 0.0, up=False)
    soup.wall(outline, 0.0, TOP_MM)
    soup.face([outline, shiny], TOP_MM, up=True)
    soup.face([shiny, boss], TOP_MM, up=True)
    soup.wall(boss, TOP_MM, BOSS_TOP_MM)
    soup.face([boss, bore], BOSS_TOP_MM, up=True)
    soup.wall(bore[::-1], 0.0, BOSS_TOP_MM)
    mesh = Mesh(*soup.merge(), "nominal")
    centres = mesh.vertices_mm[mesh.triangles].mean(axis=1)
    polished = (np.hypot(centres[:, 0], centres[:, 1]) < SHINY_RADIUS_MM) & (centres[:, 2] > 0.0)
    dimensions = {
        "tip_diameter": 2 * TIP_RADIUS_MM,
        "boss_diameter": 2 * BOSS_RADIUS_MM,
        "bore_diameter": 2 * BORE_RADIUS_MM,
        "boss_step": BOSS_TOP_MM - TOP_MM,
    }
    return Part("gear", mesh, (STEEL, POLISHED), polished.astype(np.uint8), dimensions)


def _outline() -> FloatArray:
    """Root arc, rising flank, tip arc, falling flank of every tooth, counter-clockwise."""
    pitch = 2 * pi / TEETH
    pieces = []
    for tooth in range(TEETH):
        middle = tooth * pitch
        root = arc(ROOT_RADIUS_MM, middle - pitch + FOOT_HALF_RAD, middle - FOOT_HALF_RAD)
        tip = arc(TIP_RADIUS_MM, middle - TIP_HALF_RAD, middle + TIP_HALF_RAD)
        fall_to = arc(ROOT_RADIUS_MM, middle + FOOT_HALF_RAD, middle + FOOT_HALF_RAD, count=1)[:1]
        rise = polyline(np.concatenate([root[-1:], tip[:1]]), FLANK_STEP_MM)
        fall = polyline(np.concatenate([tip[-1:], fall_to]), FLANK_STEP_MM)
        pieces += [root[:-1], rise[:-1], tip[:-1], fall[:-1]]
    return np.concatenate(pieces)
