import numpy as np
import trimesh

from measureapp.data.mesh import Mesh
from measureapp.inspection.alignment.point_to_plane import register
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import AlignmentSettings
from measureapp.inspection.surface.nominal import NominalSurface


def test_faces_that_fit_already_do_not_leave_the_others_out():
    """Walls in place with little scatter, the top 0.5 mm too low: a scale from the scatter alone would drop the top."""
    rng = np.random.default_rng(11)
    box = trimesh.creation.box((100, 80, 250))
    points, faces = trimesh.sample.sample_surface(box, 30_000, seed=11)
    normals = box.face_normals[faces]
    seen = normals[:, 2] > -0.5
    points, normals = points[seen], normals[seen]
    noisy = points + 0.01 * rng.standard_normal((len(points), 1)) * normals - [0.0, 0.0, 0.5]
    surface = NominalSurface(Mesh(box.vertices, box.faces, "nominal"))
    found = register(MeasuredPoints(noisy, normals), surface, np.eye(4), AlignmentSettings(), reach_mm=3.0)
    assert np.allclose(found.matrix[:3, 3], [0.0, 0.0, 0.5], atol=0.003)
