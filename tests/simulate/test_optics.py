"""Rendered images agree with projections worked out another way, and with the noise model."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.rig import RigDescription
from measureapp.simulate.optics import FLOOR
from measureapp.simulate.options import WorldOptions
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import PLAIN_LIGHT, World

STEPS, PITCH_PX = 4, 32.0


def fringes(world: World) -> FloatArray:
    projector = world.description.projector
    phase = 2 * np.pi * np.arange(projector.width_px) / PITCH_PX
    rows = np.array([0.5 + 0.5 * np.cos(phase - 2 * np.pi * n / STEPS) for n in range(STEPS)])
    return np.repeat(rows[:, None], projector.height_px, axis=1)


def wrapped_column_px(images: FloatArray) -> FloatArray:
    """The projector's column modulo the pitch, by the four-step formula."""
    n = np.arange(STEPS)[:, None, None]
    sine, cosine = (images * np.sin(2 * np.pi * n / STEPS)).sum(0), (images * np.cos(2 * np.pi * n / STEPS)).sum(0)
    return np.arctan2(sine, cosine) * PITCH_PX / (2 * np.pi) % PITCH_PX


def true_projector_pixels(world: World, camera: str, pixels: FloatArray, height_mm: float) -> FloatArray:
    """Meet the rays of pixels (N, 2) with the plane z = height of the part and project, all in double precision."""
    truth = world.truth()
    calibration = truth.calibration.cameras.cameras[camera]
    scene_from_reference = world.scene_from_camera()
    scene_from_camera = scene_from_reference @ calibration.reference_from_camera
    rays = scene_from_camera.rotate(calibration.pinhole.rays(pixels))
    origin = scene_from_camera.translation_mm
    points = origin + rays * ((height_mm - origin[2]) / rays[:, 2])[:, None]
    return truth.projector.project((scene_from_reference @ truth.camera_from_projector).inverse().apply(points))


def test_the_phase_seen_is_the_true_projector_column(paper: RigDescription, ideal: WorldOptions, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("flat"), seed=5, options=ideal)
    world.table_holds = "part"
    look_from(world, 10.0, 60.0, table_deg=20.0, guide_mm=-50.0)
    world.load_patterns(fringes(world))
    rng = np.random.default_rng(1)
    pixels = np.column_stack([rng.integers(230, 420, 500), rng.integers(170, 320, 500)])
    for camera in ("left", "right", "upper"):
        images = []
        for step in range(STEPS):
            world.show(step)
            images.append(world.mean_image(camera, 60_000).astype(float))
        seen = wrapped_column_px(np.array(images))[pixels[:, 1], pixels[:, 0]]
        truth = true_projector_pixels(world, camera, pixels, 20.0)[:, 0]
        off = (seen - truth + PITCH_PX / 2) % PITCH_PX - PITCH_PX / 2
        assert np.abs(off).max() < 1e-3


def test_a_matt_surface_reflects_by_lambert_s_law_and_the_inverse_square(
    paper: RigDescription, ideal: WorldOptions, look_from: Callable[..., None]
) -> None:
    world = World(paper, make_part("flat"), seed=5, options=ideal)
    world.table_holds = "part"
    look_from(world, 0.0, 50.0)
    world.load_patterns(np.ones((1, 768, 1024)))
    world.show(0)
    pixels = np.column_stack([np.arange(250, 400, 10), np.arange(180, 330, 10)])
    truth = world.truth()
    scene_from_camera = world.scene_from_camera()
    rays = scene_from_camera.rotate(truth.calibration.cameras.cameras["left"].pinhole.rays(pixels))
    origin = scene_from_camera.translation_mm
    points = origin + rays * ((20.0 - origin[2]) / rays[:, 2])[:, None]
    to_light = (scene_from_camera @ truth.camera_from_projector).translation_mm - points
    distance = np.linalg.norm(to_light, axis=1)
    albedo, light = world.part.materials[0].albedo, ideal.light
    expected = light.projector * albedo * (to_light[:, 2] / distance) * (paper.standoff_mm / distance) ** 2 + light.ambient * albedo
    seen = world.mean_image("left", light.reference_exposure_us)[pixels[:, 1], pixels[:, 0]] - FLOOR
    np.testing.assert_allclose(seen, expected, rtol=1e-4)


def test_a_flat_s_pixels_scatter_as_the_noise_model_says(paper: RigDescription, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("flat"), seed=5)
    world.table_holds = "part"
    look_from(world, 0.0, 55.0)
    world.load_patterns(np.full((1, 768, 1024), 160, np.uint8))
    world.show(0)
    mean = world.mean_image("left", 60_000)[180:300, 250:400] * 255.0
    images = np.array([world.image("left", 60_000)[180:300, 250:400] for _ in range(12)], float)
    variance = mean / (6000 / 255) + (7 / (6000 / 255)) ** 2 + 1 / 12
    assert 40 < mean.mean() < 200
    assert images.mean(axis=0) - mean == pytest.approx(np.zeros_like(mean), abs=float(6 * np.sqrt(variance.max() / 12)))
    assert float(np.mean(images.var(axis=0, ddof=1) / variance)) == pytest.approx(1.0, rel=float(5 * np.sqrt(2 / images.size)) + 0.01)


def test_a_board_s_corners_are_found_where_they_are(paper: RigDescription, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("flat"), seed=5)
    world.table_holds = "board"
    look_from(world, 0.0, 48.0, height_mm=90.0)
    world.show(PLAIN_LIGHT)
    for name in ("left", "right"):
        camera = world.truth().calibration.cameras.cameras[name]
        image = world.image(name, 100_000)
        found, coarse = cv2.findChessboardCornersSB(image, (14, 11), flags=cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_ACCURACY)
        assert found
        until = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
        corners = cv2.cornerSubPix(image, coarse.reshape(-1, 1, 2).copy(), (6, 6), (-1, -1), until).reshape(-1, 2)
        camera_from_board = (world.scene_from_camera() @ camera.reference_from_camera).inverse()
        truth = camera.pinhole.project(camera_from_board.apply(world.true_board_corners_mm()))
        off = corners - truth[np.linalg.norm(corners[:, None] - truth, axis=2).argmin(axis=1)]
        assert np.sqrt((off**2).sum(axis=1).mean()) < 0.1
        assert np.abs(off.mean(axis=0)).max() < 0.02  # 154 corners: three standard deviations of the mean


def test_the_cell_between_the_first_corners_is_black(paper: RigDescription, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("flat"), seed=5)
    world.table_holds = "board"
    look_from(world, 0.0, 48.0, height_mm=90.0)
    world.show(PLAIN_LIGHT)
    left = world.truth().calibration.cameras.cameras["left"]
    cells = np.array([[7.5, 7.5, 0.0], [22.5, 7.5, 0.0]])  # mm; the second lies one square further along x
    column, row = np.round(left.pinhole.project(world.scene_from_camera().inverse().apply(cells))).astype(int).T
    black, white = world.image("left", 100_000)[row, column].astype(int)
    assert white > 3 * black


def test_what_the_part_hides_from_the_projector_stays_dark(
    paper: RigDescription, ideal: WorldOptions, look_from: Callable[..., None]
) -> None:
    world = World(paper, make_part("gypsum"), seed=2, options=ideal)
    world.table_holds = "part"
    look_from(world, 0.0, 35.0)
    world.load_patterns(np.full((1, 768, 1024), 255, np.uint8))
    world.show(0)
    image = world.mean_image("left", 100_000)
    on_part = image > 0.01
    ambient_only = on_part & (image < 0.06)
    assert on_part.mean() > 0.05
    assert 0.02 < ambient_only.sum() / on_part.sum() < 0.5
    assert image.max() > 0.5


def test_facing_gypsum_saturates_a_little_at_the_longest_exposure_only(paper: RigDescription, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("gypsum"), seed=2)
    world.table_holds = "part"
    look_from(world, 0.0, 85.0 - 10.0, height_mm=60.0)
    world.load_patterns(np.full((1, 768, 1024), 255, np.uint8))
    world.show(0)
    assert 1.0 < world.mean_image("left", 100_000).max() < 1.4
    assert world.mean_image("left", 60_000).max() < 1.0


def test_the_gear_s_centre_shines(paper: RigDescription, look_from: Callable[..., None]) -> None:
    world = World(paper, make_part("gear"), seed=2)
    world.table_holds = "part"
    look_from(world, 0.0, 70.0, height_mm=30.0)
    world.load_patterns(np.full((1, 768, 1024), 255, np.uint8))
    world.show(0)
    assert world.mean_image("upper", 20_000).max() > 1.0  # saturates even at the shortest exposure
    image = world.mean_image("left", 20_000)
    assert image.max() < 0.8  # and not seen from another side
