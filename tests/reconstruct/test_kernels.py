"""Kernels against independent statements of what they compute; `test_reference` compares them with their NumPy versions."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.arrays import read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.clean import clean_grid
from measureapp.reconstruct.cleaning.depth_grid import Lens
from measureapp.reconstruct.cleaning.gather import gather_normals
from measureapp.reconstruct.kernels.fuse import Camera, fuse_pairs
from measureapp.reconstruct.kernels.match import STRIP, match
from measureapp.reconstruct.kernels.structures import Candidates, Limits
from measureapp.reconstruct.matching.match import CameraSet
from measureapp.reconstruct.matching.tables import pair_tables
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.jacobian import PixelJacobian
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings
from tests.reconstruct.conftest import Head, sphere

FLOAT32 = 2e-3  # rounding of float32 sums, relative
OUTLIER = (20, 126)  # row, column: windows of the next chunk of pixels reach it, too


def test_a_row_is_matched_where_phase_and_epipolar_line_are_right(head: Head) -> None:
    """Every matched pixel's point, seen by the other camera, has the pixel's phase: stated with the exact pinhole model."""
    maps = head.phase_maps(sphere((0, 0, 560), 60))
    views = {name: PhaseView.of(maps[name], 3.0) for name in ("left", "right")}
    rectifier = Rectifier(head.cameras)
    skip = (views["left"].state != 0).view(np.uint8)
    tables = pair_tables("left", ("right",), views, maps["left"], rectifier)["right"]
    row, width = 120, skip.shape[1]
    padded = -(-width // STRIP) * STRIP
    out = Candidates(*(np.zeros((1, padded), dtype) for dtype in (np.float32, np.float32, np.float32, np.int32, np.uint8)))
    cameras = CameraSet(views, rectifier, ReconstructSettings(), BufferPool())
    camera, partner = cameras.camera("left", skip), cameras.partner("left", "right", tables)
    count = match(camera.flat_rays, camera.phase, skip, partner, row, row + 1, 0, width, out)
    depth = out.depth[0, :width]
    found = np.flatnonzero(depth > 0)
    assert count == len(found) > 0.6 * (skip[row] == 0).sum()
    left, right = head.cameras.cameras["left"], head.cameras.cameras["right"]
    rays = left.pinhole.normalise(np.column_stack([found, np.full(len(found), row)]).astype(float))
    points = np.column_stack([rays, np.ones(len(found))]) * depth[found, None]
    seen = right.pinhole.project(right.reference_from_camera.inverse().apply(points))
    u, v = seen.T
    j, i = np.floor(u).astype(int), np.floor(v).astype(int)
    a, b, phase = u - j, v - i, maps["right"].phase_rad.astype(float)
    bilinear = (1 - a) * (1 - b) * phase[i, j] + a * (1 - b) * phase[i, j + 1] + (1 - a) * b * phase[i + 1, j] + a * b * phase[i + 1, j + 1]
    valid = (maps["right"].state == 0).astype(int)
    whole = (valid[i, j] + valid[i, j + 1] + valid[i + 1, j] + valid[i + 1, j + 1]) == 4
    off = np.abs(bilinear - maps["left"].phase_rad[row, found])[whole]
    assert whole.mean() > 0.9
    assert off.max() < 0.02  # of 0.7 rad per px: a place may lie 0.1 px out of its four pixels, and the sphere bends at its border
    assert np.median(off) < 2e-4


def test_two_candidates_are_fused_by_least_squares() -> None:
    random = np.random.default_rng(3)
    width = 200
    sigma = random.uniform(0.005, 0.02, (1, width)).astype(np.float32)
    variance = random.uniform(2e-5, 4e-4, (2, 1, width)).astype(np.float32)
    gain = (random.uniform(0.05, 0.2, (2, 1, width)) * np.array([1, -1])[:, None, None]).astype(np.float32)
    depth = (550 + random.normal(0, 0.02, (2, 1, width))).astype(np.float32)
    z, z_sigma = np.zeros((1, width), np.float32), np.zeros((1, width), np.float32)
    px_per_mm, limits = tuple(np.float32(c) for c in (0, 0, 1e-6)), Limits(np.float32(100), np.float32(0.5))
    rays, nothing = read_only(np.zeros((1, width, 2), np.float32)), np.zeros((1, width), np.uint8)
    camera = Camera(rays, rays.reshape(1, -1), read_only(sigma), read_only(sigma), nothing)
    found = Candidates(depth, gain, variance, np.zeros(depth.shape, np.int32), np.zeros(depth.shape, np.uint8))
    fuse_pairs(camera, found, px_per_mm, limits, 0, 1, 0, width, z, z_sigma)
    for x in range(width):
        # unknowns: z and the projector's phase less the pixel's; equations: phase − own = 0 ± σ and gain · (z − depth) − (phase − own) = 0 ± σ
        model = np.array([[0, 1], [gain[0, 0, x], -1], [gain[1, 0, x], -1]], float)
        right = np.array([0, gain[0, 0, x] * (float(depth[0, 0, x]) - 550), gain[1, 0, x] * (float(depth[1, 0, x]) - 550)])
        weights = 1 / np.array([sigma[0, x] ** 2, variance[0, 0, x], variance[1, 0, x]], float)
        normal = model.T @ (weights[:, None] * model)
        solved = np.linalg.solve(normal, model.T @ (weights * right))
        assert z[0, x] - 550 == pytest.approx(solved[0], abs=1e-4)  # a float32 near 550 mm
        assert z_sigma[0, x] == pytest.approx(np.sqrt(np.linalg.inv(normal)[0, 0]), rel=FLOAT32)


@pytest.mark.parametrize("scene", ["whole", "holes", "an outlier"])
def test_normals_are_those_of_planes_through_the_points_left_in_the_window(scene: str) -> None:
    random = np.random.default_rng(4)
    height, width, focal = 40, 150, 511.0
    u, v = np.meshgrid(np.arange(width) - 75.0, np.arange(height) - 20.0)
    rays = np.stack([u / focal, v / focal], axis=-1).astype(np.float32)
    depth = (550 / (1 - 0.3 * rays[..., 0] - 0.2 * rays[..., 1]) + random.normal(0, 0.02, u.shape)).astype(np.float32)
    if scene == "holes":
        depth[random.random(depth.shape) < 0.2] = 0
    if scene == "an outlier":
        depth[OUTLIER] += 8  # within a depth step, so that windows had it among their points before it was removed
    sigma = np.full(depth.shape, 0.02, np.float32)
    state = np.where(depth > 0, 0, 1).astype(np.uint8)
    settings = ReconstructSettings(min_island_px=1)
    lens = Lens(rays, PixelJacobian.of(rays), 1 / focal)
    grid = clean_grid(depth, sigma, np.zeros(depth.shape, np.uint8), state, lens, [], settings)
    pixel, normals = gather_normals(grid, 0)
    left = np.where(grid.state == 0, depth, 0).astype(float)
    assert (left[OUTLIER] == 0) == (scene == "an outlier" or depth[OUTLIER] == 0)
    places = (-4, -2, 0, 2, 4)
    around = np.flatnonzero(np.abs(pixel - np.array(OUTLIER)).max(axis=1) <= 5)
    for k in {*range(0, len(pixel), 37), *around.tolist()}:
        row, column = pixel[k]
        near = [(row + i, column + j) for i in places for j in places if 0 <= row + i < height and 0 <= column + j < width]
        near = [place for place in near if left[place] > 0]
        assert len(near) > 6
        # 1 / z is linear on a plane: (a, b, c) · (x, y, 1) = 1 / z with the plane's normal along (a, b, c)
        model = np.array([[*rays[place], 1] for place in near], float)
        a, b, c = np.linalg.lstsq(model, np.array([1 / left[place] for place in near]), rcond=None)[0]
        expected = -np.array([a, b, c]) / np.linalg.norm([a, b, c])
        assert np.degrees(np.arccos(np.clip(expected @ normals[k], -1, 1))) < 0.1


def test_normals_of_points_that_several_cameras_see_are_gathered_within_all_arrays(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run as plain Python, whose arrays refuse what lies outside of them; a compiled kernel reads on."""
    v, u = np.indices((8, 24), float)
    rays = np.stack([(u - 12) / 500, (v - 4) / 500], axis=-1).astype(np.float32)
    depth, sigma = np.full(u.shape, 550, np.float32), np.full(u.shape, 0.02, np.float32)
    others = np.full(u.shape, 3, np.uint8)  # both of the other cameras
    centres = [np.array([100.0, 0, 0]), np.array([-100.0, 0, 0])]
    settings = ReconstructSettings(min_island_px=1)
    grid = clean_grid(depth, sigma, others, np.zeros(u.shape, np.uint8), Lens(rays, PixelJacobian.of(rays), 1 / 500), centres, settings)
    expected = gather_normals(grid, len(centres))
    assert len(expected[0]) == u.size
    monkeypatch.setattr(kernels, "gather_points", kernels.gather_points.py_func)
    pixel, normals = gather_normals(grid, len(centres))
    np.testing.assert_array_equal(pixel, expected[0])
    np.testing.assert_allclose(normals, expected[1], atol=FLOAT32)


@pytest.mark.parametrize("sampled", [0, 1])
def test_pixels_near_used_ones_are_not_matched_again(sampled: int) -> None:
    random = np.random.default_rng(5)
    state = (random.random((61, 83)) < 0.1).astype(np.uint8) * 3
    used = (random.random(state.shape) < 0.02).astype(np.uint8)
    marked = np.empty_like(state)
    for start, stop in ((0, 20), (20, 61)):
        kernels.mark_used(read_only(state), used, 7, np.uint8(sampled), np.uint8(PointState.UNMATCHED), start, stop, marked)
    near = cv2.dilate(used, np.ones((5, 5), np.uint8))
    near[::7, ::7] = used[::7, ::7] * sampled
    seen = np.where(near != 0, PointState.SEEN_BY_ANOTHER, PointState.UNMATCHED)
    assert (marked == np.where(state != 0, PointState.NO_PHASE, seen)).all()


@pytest.mark.parametrize("every", [1, 2])
def test_records_of_pixels_hold_phase_slopes_and_sigma(every: int) -> None:
    """In an image whose width fits no vector: a plane's phase rises alike everywhere, up to the border of a hole."""
    v, u = np.mgrid[0:9, 0:1061].astype(np.float32)
    state = np.zeros(u.shape, np.uint8)
    state[4, 500] = 1
    phase, sigma = 0.07 * u + 0.01 * v, 0.01 + 1e-5 * u
    pixels, _, samples = slopes_of(phase, sigma, state, every)
    assert np.array_equal(pixels[..., 0], phase)
    valid = state == 0
    assert np.allclose(pixels[..., 3], sigma, rtol=1e-6)
    assert np.allclose(pixels[valid][:, 1], 0.07, atol=1e-5)  # rounding of a float32 near 70 rad
    assert np.allclose(pixels[valid][:, 2], 0.01, atol=1e-5)
    assert (pixels[4, 500, 1:3] == 0).all()
    assert np.array_equal(np.moveaxis(samples, 0, -1), pixels[::every, ::every, :3])


def slopes_of(phase: np.ndarray, sigma: np.ndarray, state: np.ndarray, every: int = 1) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    height, width = phase.shape
    pixels, quad = np.empty((height, width, 4), np.float32), np.empty(phase.shape, np.uint8)
    samples = np.empty((3, -(-height // every), -(-width // every)), np.float32)
    maps = tuple(read_only(each).reshape(-1) for each in (phase, sigma, state))
    kernels.measure_gradients(*maps, phase.shape, np.float32(3), every, 0, height, pixels.reshape(-1), quad.reshape(-1), samples)
    return pixels, quad, samples


def test_slopes_of_a_part_of_an_image_are_those_of_the_whole_beyond_its_border() -> None:
    random = np.random.default_rng(8)
    v, u = np.mgrid[0:24, 0:150].astype(np.float32)
    phase = (0.07 * u + 0.01 * v + random.normal(0, 0.01, u.shape)).astype(np.float32)
    phase[:, 90:] += 4.0  # a depth step
    sigma, state = np.full(u.shape, 0.01, np.float32), (random.random(u.shape) < 0.05).astype(np.uint8)
    part = (slice(5, 19), slice(29, 140))
    inner = (slice(3, -3), slice(3, -3))
    whole, cut = slopes_of(phase, sigma, state), slopes_of(*(np.ascontiguousarray(each[part]) for each in (phase, sigma, state)))
    for of_whole, of_cut in zip(whole[:2], cut[:2], strict=True):
        assert np.array_equal(of_whole[part][inner], of_cut[inner])
    assert set(np.unique(whole[1])) == {0, 1, 2, 3}
