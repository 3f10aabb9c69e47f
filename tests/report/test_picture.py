from __future__ import annotations

import io

import cv2
import numpy as np

from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import sample_mesh
from measureapp.report.picture import ViewDirection, cloud_picture, png, surface_picture

TOP = ViewDirection(-90.0, 89.99)


def test_the_axes_of_a_view_are_right_handed_and_level() -> None:
    for direction in (ViewDirection(-58, 34), ViewDirection(120, -10), TOP):
        axes = direction.axes()
        assert np.allclose(axes @ axes.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(axes) > 0
        assert abs(axes[0, 2]) < 1e-12 and axes[1, 2] >= 0


def test_a_box_seen_from_above_fills_its_share_of_the_picture(block: Mesh) -> None:
    image = surface_picture(block, TOP, 200, 150)
    covered = np.any(image < 240, axis=2)
    assert image.shape == (150, 200, 3)
    assert abs(covered.mean() - 1 / 1.06**2) < 0.02  # 80 × 60 mm in a picture of 4:3 with the margin
    assert image[0, 0].min() == 255


def test_faces_that_turn_differently_are_shaded_differently_and_evenly(block: Mesh) -> None:
    image = surface_picture(block, ViewDirection(-58, 34), 240, 180).astype(int)
    levels, counts = np.unique(image[..., 1], return_counts=True)
    assert np.sum(counts[levels < 250] > 1500) == 3  # three faces, each of one grey level


def test_colours_of_vertices_are_seen(block: Mesh) -> None:
    red = np.tile([1.0, 0.0, 0.0], (len(block.vertices_mm), 1))
    image = surface_picture(block, TOP, 80, 60, red)
    assert image[30, 40, 0] > 200 and image[30, 40, 1:].max() == 0


def test_a_dense_cloud_looks_like_its_surface(block: Mesh) -> None:
    points = sample_mesh(block, 60_000)
    cloud = cloud_picture(points.points_mm, points.normals, ViewDirection(-58, 34), 240, 180).astype(int)
    surface = surface_picture(block, ViewDirection(-58, 34), 240, 180).astype(int)
    assert np.mean(np.abs(cloud - surface).max(axis=2) > 30) < 0.05  # but for the outlines, where points are splats


def test_a_written_png_is_read_back_as_it_was() -> None:
    image = np.random.default_rng(1).integers(0, 256, (7, 11, 3)).astype(np.uint8)
    read = cv2.imdecode(np.frombuffer(io.BytesIO(png(image)).getvalue(), np.uint8), cv2.IMREAD_COLOR)
    assert np.array_equal(read[..., ::-1], image)
