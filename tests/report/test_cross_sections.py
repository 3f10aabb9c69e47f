"""Cross-sections use the room of the page: a flat one is as wide as the page."""

from __future__ import annotations

import re

import numpy as np
import pytest

from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.measured_points import sample_mesh
from measureapp.inspection.surface.colour_scale import ColourScale
from measureapp.inspection.surface.deviation import compute_deviation
from measureapp.report.cross_sections import MARGIN, MOST_HEIGHT, WIDTH, render_sections


def box(*size_mm: float) -> Mesh:
    import trimesh

    made = trimesh.creation.box(size_mm)
    return Mesh(made.vertices, made.faces, "nominal")


def drawn(svg: str) -> tuple[float, float, float, float]:
    """Return width and height of a drawing, and of the outline in it."""
    width, height = (float(re.search(rf'{name}="(\d+)"', svg)[1]) for name in ("width", "height"))
    places = np.array([place.split(",") for place in re.findall(r"[ML](-?[\d.]+,-?[\d.]+)", svg)], float)
    return width, height, *np.ptp(places, axis=0)


@pytest.mark.parametrize("size_mm", [(200.0, 100.0, 20.0), (60.0, 100.0, 90.0)])
def test_a_section_fills_its_picture_and_takes_no_more_of_the_page_than_it_needs(size_mm):
    nominal = box(*size_mm)
    deviation = compute_deviation(sample_mesh(nominal, 2000), nominal, Alignment("none", RigidTransform.identity("nominal", "part"), 0.0))
    upright, _ = render_sections(nominal, deviation, ColourScale(-0.2, 0.2))
    width, height, across, up = drawn(upright.png.decode())
    assert across / up == pytest.approx(size_mm[0] / size_mm[2], rel=0.01)
    assert width == WIDTH and height <= MOST_HEIGHT
    assert across > 0.85 * (WIDTH - 2 * MARGIN) or (height == MOST_HEIGHT and up > 0.8 * height)
    assert up > 0.35 * height  # the rest is for the whiskers
