"""Every effect of the simulated world has the magnitude it states, is drawn from the seed, and is absent unless it is asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.rig import RigDescription
from measureapp.simulate.effects.board_print import draw_print
from measureapp.simulate.effects.form import made_part, with_surroundings
from measureapp.simulate.effects.motions import draw_guide_motion, draw_table_motion
from measureapp.simulate.effects.sensor import HOT_FROM, draw_pixels
from measureapp.simulate.effects.shake import displaced
from measureapp.simulate.effects.sharpness import Sharpness, gaussian
from measureapp.simulate.effects.warmth import draw_warmth
from measureapp.simulate.effects.waves import draw_waves
from measureapp.simulate.kinematics import ARCSEC
from measureapp.simulate.options import (
    AxisEffects,
    BoardEffects,
    LensEffects,
    PartEffects,
    ProjectorEffects,
    RigErrors,
    SensorEffects,
    WarmthEffects,
    WorldOptions,
)
from measureapp.simulate.part import Part
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import PLAIN_LIGHT, World
from measureapp.simulate.worlds import read_world

EXPOSURE_US = 60_000
ALONE = (
    "hot_ppm",
    "bit_planes",
    "late_us",
    "shake_px",
    "table_backlash_arcsec",
    "guide_backlash_mm",
)  # effects that not every named world has


def rng(seed: int = 5) -> np.random.Generator:
    return np.random.default_rng(seed)


def lit(paper: RigDescription, look_from: Callable[..., None], options: WorldOptions, part: Part, seed: int = 1) -> np.ndarray:
    """Return the mean image of the left camera under the lamp."""
    world = World(paper, part, seed, options=options)
    world.table_holds = "part"
    look_from(world, 5.0, 40.0)
    world.show(PLAIN_LIGHT)
    return world.mean_image("left", EXPOSURE_US)


def test_a_wave_field_has_its_rms_and_its_wavelengths() -> None:
    field = draw_waves(rng(), 0.3, (50.0, 200.0), components=2, dimensions=2)
    places = rng(6).uniform(0, 20_000, (20_000, 2))
    np.testing.assert_allclose(np.sqrt(np.mean(field.at(places) ** 2, axis=0)), 0.3, rtol=0.1)
    steps = field.at(places + np.array([1.0, 0.0])) - field.at(places)
    assert np.abs(steps).max() < 0.3 * np.sqrt(2 * 12) * 2 * np.pi / 50.0


def test_without_effects_nothing_is_drawn(paper: RigDescription) -> None:
    options = WorldOptions()
    part = make_part("gypsum")
    assert draw_warmth(options, paper, rng()) is draw_print(options, rng()) is None
    assert draw_table_motion(options.motions, rng()) is draw_guide_motion(options.motions, paper, rng()) is None
    assert draw_pixels(options.pixels, 40, 30, 6000.0, rng()) is None
    assert made_part(part, options, rng()) is part


def test_the_table_moves_in_the_stated_range_and_not_at_0_degrees() -> None:
    motion = draw_table_motion(AxisEffects(table_radial_mm=0.007, table_axial_mm=0.005, table_tilt_arcsec=10), rng())
    assert motion is not None
    course = [motion.at(angle) for angle in np.linspace(0, 2 * np.pi, 361)]
    np.testing.assert_array_equal(course[0].matrix, np.eye(4))
    ranges = np.ptp([one.translation_mm for one in course], axis=0)
    np.testing.assert_allclose(ranges, [0.014, 0.014, 0.010], rtol=0.01)
    tilts = np.ptp([[one.rotation[2, 1], one.rotation[0, 2]] for one in course], axis=0)
    np.testing.assert_allclose(tilts, 20 * ARCSEC, rtol=0.01)


def test_the_slide_turns_the_head_by_its_angles_times_the_lever(paper: RigDescription, look_from: Callable[..., None]) -> None:
    """20 arcsec at a lever of about 0.9 m are some 0.1 mm, as large as what an ideal guide does not do at all."""
    part, moved = make_part("gypsum"), {}
    for name, motions in {"ideal": AxisEffects(), "turning": AxisEffects(guide_angle_arcsec=20)}.items():
        world = World(paper, part, 2, options=WorldOptions(motions=motions))
        look_from(world, 0.0, 40.0, guide_mm=200.0)
        moved[name] = world.guide_from_camera()
    off = np.linalg.norm(moved["turning"].translation_mm - moved["ideal"].translation_mm)
    assert 0.005 < off < 3 * 2 * 20 * ARCSEC * 1500.0


def test_cameras_projector_and_robot_drift_until_they_are_warm(paper: RigDescription) -> None:
    options = WorldOptions(
        warmth=WarmthEffects(camera_drift_px=1.0, focal_drift=1e-4, minutes=10, warm_share=0.4),
        projector=ProjectorEffects(drift_px=0.5),
        motions=AxisEffects(robot_growth_mm=0.2),
    )
    warmth = draw_warmth(options, paper, rng())
    assert warmth is not None
    assert warmth.since_beginning(0.0) == 0.0
    assert warmth.since_beginning(600.0) == pytest.approx(0.6 * (1 - np.exp(-1)))
    assert np.linalg.norm(warmth.flange_mm(1e9)) == pytest.approx(0.6 * 0.2)
    pinhole = World(paper, make_part("gypsum"), 1).truth().calibration.cameras.cameras["left"].pinhole
    shift = warmth.camera("left", pinhole, 1e9).matrix[:2, 2] - pinhole.matrix[:2, 2]
    np.testing.assert_allclose(shift, 0.6 * warmth.cameras["left"][:2])
    scale = paper.cameras[0].width_px / 2592
    drawn = [draw_warmth(options, paper, rng(seed)) for seed in range(200)]
    assert np.std([one.cameras["left"][0] for one in drawn if one is not None]) == pytest.approx(scale, rel=0.2)


def test_a_board_shows_its_print_errors_where_its_true_corners_are(paper: RigDescription, look_from: Callable[..., None]) -> None:
    perfect, corners = corners_seen(paper, look_from, WorldOptions(board_bow_mm=0.0))
    world, found = corners_seen(paper, look_from, WorldOptions(board=BoardEffects(scale_ppm=3000, local_mm=0.05), board_bow_mm=0.0))
    shift = world.true_board_corners_mm() - world.board.corners_mm
    assert 0.03 < np.sqrt(np.mean(shift[:, :2] ** 2)) < 0.8
    np.testing.assert_array_equal(shift[:, 2], 0.0)
    wanted = projected_corners(world, world.true_board_corners_mm()) - projected_corners(perfect, perfect.board.corners_mm)
    off = (found - corners) - wanted  # what the detector of corners does by itself is in both
    assert np.sqrt(np.mean(off**2)) < 0.3 * np.sqrt(np.mean(wanted**2))


def corners_seen(paper: RigDescription, look_from: Callable[..., None], options: WorldOptions) -> tuple[World, np.ndarray]:
    """Return a world with the board on its table and the corners (N, 2) in the image of the left camera."""
    world = World(paper, make_part("flat"), 1, options=options)
    world.table_holds = "board"
    look_from(world, 0.0, 45.0, height_mm=90.0)
    world.show(PLAIN_LIGHT)
    return world, board_corners(world.mean_image("left", EXPOSURE_US), world)


def board_corners(image: np.ndarray, world: World) -> np.ndarray:
    import cv2

    grey = np.clip(255 * image / image.max(), 0, 255).astype(np.uint8)
    start = projected_corners(world, world.board.corners_mm).astype(np.float32).reshape(-1, 1, 2)
    stop = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_MAX_ITER, 100, 1e-4)
    return np.asarray(cv2.cornerSubPix(grey, start.copy(), (3, 3), (-1, -1), stop)).reshape(-1, 2)


def projected_corners(world: World, corners_mm: np.ndarray) -> np.ndarray:
    camera = world.truth().calibration.cameras.cameras["left"]
    camera_from_board = (world.scene_from_camera() @ camera.reference_from_camera).inverse()
    return camera.pinhole.project(camera_from_board.apply(corners_mm))


def test_a_lens_residual_displaces_the_image_by_its_rms(paper: RigDescription, look_from: Callable[..., None]) -> None:
    residual_px = 1.2  # at a quarter of the resolution: 0.3 px
    _, straight = corners_seen(paper, look_from, WorldOptions(board_bow_mm=0.0))
    _, bent = corners_seen(paper, look_from, WorldOptions(lenses=LensEffects(residual_px=residual_px), board_bow_mm=0.0))
    assert 0.1 < np.sqrt(np.mean((bent - straight) ** 2)) < 0.6  # 0.3 over the whole image; the board covers part of it


def test_a_blurred_image_has_the_stated_variance_at_its_centre_and_in_its_corners() -> None:
    shape = (300, 2592 // 6)
    scale = shape[1] / 2592
    sharpness = Sharpness(corner_px=6.0, defocus_px=0.0, part_px=3.0, focus_mm=550.0, centre=(0.5, 0.5), glare=0.0)
    wanted = sharpness.blur_px(shape, np.array([550.0, 0.0, 0.0]), of_part=True)
    np.testing.assert_allclose(wanted[4, 4], 3.0 * scale)
    np.testing.assert_allclose(wanted[0, 0], scale * np.hypot(3.0, 6.0 * (np.hypot(0.5, 0.5) / 0.7) ** 2))
    defocused = replace(sharpness, corner_px=0.0, part_px=0.0, defocus_px=2.0)
    np.testing.assert_allclose(defocused.blur_px(shape, np.array([600.0, 100.0, 0.0]), of_part=True)[4, 8], 2.0 * scale)
    points = np.zeros(shape, np.float32)
    points[150, 216] = 1.0
    seen = sharpness.blurred(points, np.array([550.0, 0.0, 0.0]), of_part=True)
    assert seen.sum() == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("sigma", [0.075, 0.3, 0.6, 0.7, 1.5])
def test_a_blur_has_its_variance_even_where_it_is_narrower_than_a_pixel(sigma: float) -> None:
    point = np.zeros((41, 41), np.float32)
    point[20, 20] = 1.0
    across = gaussian(point, sigma).sum(axis=0)
    assert across.sum() == pytest.approx(1.0, abs=1e-5)
    assert across @ (np.arange(41) - 20.0) ** 2 == pytest.approx(sigma**2, rel=0.04)


def test_glare_moves_light_into_the_dark_and_keeps_its_sum() -> None:
    image = np.zeros((256, 512), np.float32)
    image[64:192, 128:256] = 1.0
    seen = Sharpness(0.0, 0.0, 0.0, 550.0, (0.5, 0.5), glare=0.04).blurred(image, np.array([550.0, 0.0, 0.0]), of_part=True)
    assert seen[128, 192] == pytest.approx(0.96 + 0.04 * 0.5, abs=0.02)
    assert 0.0 < seen[128, 400] < 0.02
    assert seen.mean() == pytest.approx(image.mean(), rel=0.02)


def test_pixels_differ_by_their_gain_and_the_response_bends() -> None:
    pixels = draw_pixels(SensorEffects(gain_spread=0.01, curvature=0.02), 200, 200, 6000.0, rng())
    assert pixels is not None
    assert pixels.gain.std() == pytest.approx(0.01, rel=0.05)
    ramp = np.linspace(0, 1, 200 * 200, dtype=np.float32).reshape(200, 200)
    even = replace(pixels, gain=np.ones((200, 200), np.float32), dark=np.zeros((200, 200), np.float32))
    bend = even.apply(ramp) - ramp
    assert abs(bend[0, 0]) < 1e-6 and abs(bend[-1, -1]) < 1e-6
    assert 0.25 * 0.02 < np.abs(bend).max() <= 0.0201


def test_hot_pixels_are_as_many_as_stated_and_brighter_than_all_others() -> None:
    pixels = draw_pixels(SensorEffects(hot_ppm=1000), 500, 400, 6000.0, rng())
    assert pixels is not None
    hot = pixels.dark > 0
    assert np.count_nonzero(hot) == pytest.approx(200, abs=4 * 200**0.5)
    assert pixels.dark[hot].min() >= HOT_FROM
    assert pixels.dark.max() <= 1.0
    other = draw_pixels(SensorEffects(hot_ppm=1000), 500, 400, 6000.0, rng(6))
    assert other is not None
    assert np.count_nonzero(hot & (other.dark > 0)) < 5


def test_a_displaced_pattern_keeps_its_shape_and_its_modulation() -> None:
    columns = np.arange(256.0)
    for shift in (-1.3, -0.5, 0.0, 0.2, 2.75):
        pattern = np.tile(np.cos(2 * np.pi * columns / 32), (3, 1)).astype(np.float32)
        wanted = np.cos(2 * np.pi * (columns - shift) / 32)
        np.testing.assert_allclose(displaced(pattern, shift)[:, 4:-4], np.tile(wanted, (3, 1))[:, 4:-4], atol=0.005)


def test_vibration_displaces_the_fringes_by_its_standard_deviation(
    paper: RigDescription, look_from: Callable[..., None], ideal: WorldOptions
) -> None:
    """On a ramp over the columns the light of a pixel is proportional to the projector's column that it sees."""
    width, height = paper.projector.width_px, paper.projector.height_px
    dark = ideal.light.model_copy(update={"ambient": 0.0})
    seen = []
    for seed, images in ((1, 300), (1, 2), (2, 2)):
        options = ideal.model_copy(update={"light": dark, "projector": ProjectorEffects(shake_px=0.4)})
        world = World(paper, make_part("flat"), seed, options=options)
        world.table_holds = "part"
        look_from(world, 5.0, 60.0)
        world.load_patterns(np.tile(np.arange(width) / width, (1, height, 1)).astype(np.float32))
        column = world.true_light("left")[..., 0]
        near = (column > 0.45 * width) & (column < 0.55 * width)
        taken = []
        for _ in range(images):
            world.show(0)
            taken.append(world.mean_image("left", EXPOSURE_US)[near])
        seen.append(np.array(taken))
    light, scale = seen[0], width / 1024
    moved = np.median(light / light.mean(axis=0) - 1.0, axis=1) * 0.5 * width
    assert moved.std() == pytest.approx(0.4 * scale, rel=0.15)  # 300 draws: 4 % (k = 1)
    assert np.array_equal(seen[1], seen[0][:2]) and not np.array_equal(seen[1], seen[2])


def test_table_and_guide_stay_behind_by_half_their_play_on_the_side_from_which_they_come(
    paper: RigDescription, look_from: Callable[..., None]
) -> None:
    still = RigErrors(axes=False)
    motions = AxisEffects(table_backlash_arcsec=20, guide_backlash_mm=0.03)
    free, stiff = (
        World(paper, make_part("flat"), 1, options=WorldOptions(errors=still, motions=each)) for each in (motions, AxisEffects())
    )
    for goal, side in ((0.5, -1.0), (0.8, -1.0), (0.5, 1.0)):
        for world in (free, stiff):
            world.turn_table(goal)
            world.move_guide(100.0 * goal)
        assert free.readback().table_rad == stiff.readback().table_rad
        late_mm = (stiff.guide_from_camera().inverse() @ free.guide_from_camera()).translation_mm
        assert np.linalg.norm(late_mm) == pytest.approx(0.015, rel=1e-3)
        travel = free.guide_from_camera().translation_mm - stiff.guide_from_camera().translation_mm
        assert np.sign(travel[np.argmax(np.abs(travel))]) == side
    for world in (free, stiff):
        world.move_guide(0.0)
    turned = (free.scene_from_camera() @ stiff.scene_from_camera().inverse()).rotation
    assert abs(np.arcsin(turned[1, 0])) == pytest.approx(10 * ARCSEC, rel=1e-3)


def test_a_made_part_deviates_from_its_drawing_by_its_form_error_and_stays_closed() -> None:
    nominal = make_part("sphere_plate")
    made = made_part(nominal, WorldOptions(part=PartEffects(form_mm=0.03)), rng())
    shift = made.mesh.vertices_mm - nominal.mesh.vertices_mm
    assert 0.01 < np.sqrt(np.mean(np.sum(shift**2, axis=1))) < 0.09
    _, place, count = np.unique(np.round(nominal.mesh.vertices_mm, 6), axis=0, return_inverse=True, return_counts=True)
    for twin in np.flatnonzero(count > 1)[:20]:
        assert np.ptp(shift[place.reshape(-1) == twin], axis=0).max() == 0.0
    warm = made_part(nominal, WorldOptions(warmth=WarmthEffects(part_excess_k=2.0)), rng())
    growth = np.ptp(warm.mesh.vertices_mm[:, 0]) / np.ptp(nominal.mesh.vertices_mm[:, 0]) - 1.0
    assert 11.5e-6 <= growth <= 23e-6


def test_the_table_and_clamps_are_in_the_picture_and_not_of_the_part(paper: RigDescription, look_from: Callable[..., None]) -> None:
    part = make_part("gypsum")
    options = WorldOptions(part=PartEffects(fixture=True))
    alone, surrounded = (lit(paper, look_from, chosen, part) for chosen in (WorldOptions(), options))
    assert np.count_nonzero(surrounded > 0.02) > 1.5 * np.count_nonzero(alone > 0.02)
    assert World(paper, part, 1, options=options).part is part
    assert len(with_surroundings(part).mesh.triangles) == len(with_surroundings(part).material)


def test_light_from_below_the_surface_moves_the_projector_pixel(paper: RigDescription, look_from: Callable[..., None]) -> None:
    columns = {}
    for depth in (0.0, 0.1):
        world = World(paper, make_part("flat"), 1, options=WorldOptions(part=PartEffects(penetration_mm=depth)))
        world.table_holds = "part"
        look_from(world, 15.0, 45.0)
        columns[depth] = world.true_light("left")
    seen = columns[0.0][..., 0] > 0
    moved = np.hypot(*(columns[0.1] - columns[0.0])[seen][:, :2].T)
    assert 0.01 < np.median(moved) < 0.4  # 0.1 mm seen at some 40° from the normal; a column is 0.3 mm wide


def test_the_named_worlds_grow_from_ideal_to_bad() -> None:
    assert read_world("ideal") == WorldOptions()
    for group in ("pixels", "lenses", "projector", "motions", "warmth", "board", "part"):
        values = [getattr(read_world(name), group).model_dump() for name in ("ideal", "good", "usual", "bad")]
        for field in values[0]:
            if field in ("minutes", "warm_share", "seconds_per_image", "settling_s", "frame_us", "fixture") or field in ALONE:
                continue
            course = [one[field] for one in values]
            assert course == sorted(course) and course[0] == 0 < course[1], f"{group}.{field}"
