from __future__ import annotations

import io

import cv2
import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import sample_mesh
from measureapp.report.kernels import average, first_of_blocks, mean_of_facing
from measureapp.report.picture import SurfaceScene, ViewDirection, cloud_picture, png, surface_picture

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


def test_each_pixel_shows_the_triangle_that_a_ray_meets_first() -> None:
    """A lying cylinder with needles on its caps, drawn into a depth buffer and compared with its closed form."""
    import trimesh

    made = trimesh.creation.cylinder(40.0, 30.0, sections=720)
    mesh = Mesh(made.vertices, made.faces, "nominal")
    scene = SurfaceScene(mesh)
    seen = scene.see(ViewDirection(20, 35), 200, 150)
    frame = seen.frame
    at = np.einsum("nk,nkd->nd", seen.weights[seen.hit], mesh.vertices_mm[np.asarray(mesh.triangles)[seen.triangle[seen.hit]]])
    rows, columns = np.nonzero(seen.hit)
    across = (columns + 0.5 - frame.width / 2) * frame.mm_per_px
    up = (frame.height / 2 - 0.5 - rows) * frame.mm_per_px
    assert np.abs(at @ frame.axes[:2].T - frame.centre[:2] - np.column_stack([across, up])).max() < 1e-9  # on the pixel's own ray
    on_cap = np.abs(np.abs(at[:, 2]) - 15) < 1e-6
    radius = np.linalg.norm(at[:, :2], axis=1)
    assert (on_cap | (np.abs(radius - 40) < 40 * (1 - np.cos(np.pi / 720)) + 1e-6)).all()
    towards = frame.axes[2]
    assert not scene.occluded(at, towards, 1e-2)[np.linalg.norm(at, axis=1) < 39].any()  # nothing lies before what is seen
    filled = seen.hit.astype(np.uint8)
    assert np.array_equal(cv2.morphologyEx(filled, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8)), filled)  # nothing shows between triangles


def test_a_view_of_several_pictures_is_drawn_once(block: Mesh) -> None:
    scene, from_above = SurfaceScene(block), ViewDirection(-58, 34)
    seen = scene.see(from_above, 60, 40)
    assert scene.see(from_above, 60, 40) is seen
    assert scene.see(from_above, 40, 60).depth.shape == (120, 80)
    assert not np.array_equal(scene.see(ViewDirection(32, 34), 60, 40).depth, seen.depth)


def test_smooth_normals_are_those_of_their_statement() -> None:
    """Σ area · n (n·own) over the triangles at a corner: what faces another way does not contribute."""
    import trimesh

    made = trimesh.creation.cylinder(30.0, 20.0, sections=24)
    mesh = Mesh(made.vertices, made.faces, "nominal")
    triangles = np.asarray(mesh.triangles)
    corners = mesh.vertices_mm[triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    own = cross / np.linalg.norm(cross, axis=1, keepdims=True)
    stated = np.array(
        [
            [sum(cross[t] * (own[t] @ own[k]) for t in np.flatnonzero((triangles == v).any(axis=1))) for v in triangles[k]]
            for k in range(len(triangles))
        ]
    )
    stated /= np.linalg.norm(stated, axis=2, keepdims=True)
    scene = SurfaceScene(mesh)
    seen = scene.see(ViewDirection(-58, 34), 60, 40)
    expected = np.einsum("nk,nkd->nd", seen.weights[seen.hit], stated[seen.triangle[seen.hit]])
    assert len(expected) > 1000
    np.testing.assert_allclose(scene.normals_at(seen), expected, atol=1e-12)


def test_blocks_are_averaged_on_white_and_darkened_where_the_depth_jumps() -> None:
    rng = np.random.default_rng(2)
    depth = np.where(rng.random((8, 12)) < 0.3, np.inf, rng.integers(0, 4, (8, 12)) / 2)
    hit = np.isfinite(depth)
    colours, shade = rng.random((hit.sum(), 3)), rng.uniform(0.3, 1.1, hit.sum())
    made = np.empty((4, 6, 3), np.uint8)
    average(colours, shade, depth, 0.75, 9.0, 2, made)
    image = np.ones((8, 12, 3))
    image[hit] = colours * shade[:, None]
    filled = np.pad(np.where(hit, depth, 9.0), 1, mode="edge")
    middle = filled[1:-1, 1:-1]
    beside = (filled[:-2, 1:-1], filled[2:, 1:-1], filled[1:-1, :-2], filled[1:-1, 2:])
    image[np.any([other - middle > 0.75 for other in beside], axis=0)] *= 0.45
    expected = np.clip(np.rint(image.reshape(4, 2, 6, 2, 3).mean(axis=(1, 3)) * 255), 0, 255)
    assert np.abs(made - expected).max() <= 1  # rounding


def test_blocks_are_numbered_once_each_with_their_first_pixel() -> None:
    pixels = np.flatnonzero(np.random.default_rng(3).random((10, 16)) < 0.4)
    number, first = np.empty((2, len(pixels)), np.int64)
    count = first_of_blocks(pixels, 16, 2, number, first)
    rows, columns = np.divmod(pixels, 16)
    blocks = rows // 2 * 8 + columns // 2
    assert count == len(set(blocks))
    for block in range(count):
        own = np.flatnonzero(number == block)
        assert len(set(blocks[own])) == 1 and first[block] == own[0]


def test_neighbours_that_face_the_same_way_are_averaged_by_their_distance() -> None:
    normals, values = np.array([[0, 0, 1], [0, 0, 1], [0, 0, -1]], np.float32), np.array([0.1, 0.4, 9.0])
    away = np.array([[0.0, 0.1, 0.2], [0.3, np.inf, np.inf], [np.inf, np.inf, np.inf]])
    near, means = np.array([[0, 2, 1], [2, 3, 3], [3, 3, 3]]), np.empty(3)  # 3: none, as the search tree says
    mean_of_facing(away, near, normals, np.tile([0.0, 0.0, 1.0], (3, 1)), values, 0.3, 0.05, means)
    assert means[0] == pytest.approx((0.1 / 0.05 + 0.4 / 0.25) / (1 / 0.05 + 1 / 0.25))
    assert np.isnan(means[1:]).all()
