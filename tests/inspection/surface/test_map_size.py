"""The coloured nominal has a limited number of triangles where it is drawn."""

from __future__ import annotations

import numpy as np
import trimesh

from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.deviation_map import _longest_edge_mm, _subdivide
from measureapp.inspection.surface.nominal import NominalSurface


def test_long_thin_triangles_do_not_multiply_beyond_the_limit() -> None:
    plate = trimesh.creation.cylinder(radius=50.0, height=1.0, sections=400)
    surface = NominalSurface(Mesh(np.asarray(plate.vertices), plate.faces, "nominal"))
    fine, _ = _subdivide(surface, _longest_edge_mm(surface, None))
    coarse, _ = _subdivide(surface, _longest_edge_mm(surface, 20_000))
    assert len(coarse.triangles) <= 20_000 < len(fine.triangles)
