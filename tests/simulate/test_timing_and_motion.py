"""Effects of timing, moving and glossy surfaces: each has the magnitude it states."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.data.rig import RigDescription
from measureapp.simulate.effects.bit_planes import light_of_levels, shown_levels
from measureapp.simulate.effects.effects import draw_effects
from measureapp.simulate.effects.motions import flange_play
from measureapp.simulate.kernels import pixel_rays
from measureapp.simulate.optics import SeeingCamera
from measureapp.simulate.options import AxisEffects, LensEffects, RigErrors, TimingEffects, WorldOptions
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import PLAIN_LIGHT, World
from tests.simulate.test_effects import EXPOSURE_US


def test_bit_planes_give_even_levels_in_whole_frames_and_uneven_ones_in_parts() -> None:
    """Realism: 20 ms at 60 Hz, most significant plane first, displace a phase of four steps by 97 mrad rms; 4.8 frames by some 20 mrad."""
    levels = np.arange(256) / 255
    np.testing.assert_allclose(light_of_levels(50_000, 16_667), levels, atol=1e-3)
    steps = 2 * np.pi * np.arange(4) / 4
    phase = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    grey = np.round(127.5 + 127.5 * np.cos(phase[:, None] - steps)).astype(np.uint8)
    off = {}
    for exposure in (20_000, 80_000):
        seen = light_of_levels(exposure, 16_667)[grey]
        error = np.angle(np.exp(1j * (np.arctan2(seen @ np.sin(steps), seen @ np.cos(steps)) - phase)))
        off[exposure] = error.std()
    assert off[20_000] == pytest.approx(0.097, rel=0.25)
    assert off[80_000] == pytest.approx(0.020, rel=0.35)
    stack = shown_levels(grey[None], 20_000, 16_667, 0.0)
    np.testing.assert_allclose(stack[0], grey / 255, atol=1e-6)


def test_late_rows_and_late_triggers_show_some_of_the_next_image(
    paper: RigDescription, look_from: Callable[..., None], ideal: WorldOptions
) -> None:
    dark = ideal.light.model_copy(update={"ambient": 0.0})
    seen = {}
    for name, timing in {"none": TimingEffects(), "rolling": TimingEffects(rolling_share=0.2), "late": TimingEffects(late_us=3000)}.items():
        world = World(paper, make_part("flat"), 1, options=ideal.model_copy(update={"light": dark, "timing": timing}))
        world.table_holds = "part"
        look_from(world, 5.0, 60.0)
        world.load_patterns(np.stack([np.ones((768, 1024)), np.zeros((768, 1024))]))
        world.show(0)
        seen[name] = world.mean_image("left", EXPOSURE_US)
    lit = seen["none"] > 0.2
    rows = np.nonzero(lit)[0]
    lost = 1.0 - (seen["rolling"] - 0.004)[lit] / (seen["none"] - 0.004)[lit]
    np.testing.assert_allclose(lost, 0.2 * rows / (len(lit) - 1), atol=0.01)  # of what is not the black level
    late = 1.0 - (seen["late"] - 0.004)[lit] / (seen["none"] - 0.004)[lit]
    assert np.ptp(late) < 0.01 and 0.0 < late.mean() < 4 * 3000 / EXPOSURE_US


def test_coma_displaces_what_is_out_of_focus_and_nothing_else(paper: RigDescription) -> None:
    """At the image's edge 80 mm behind the plane in focus by its magnitude, 0.7 to 1.3 of it as drawn."""
    camera = paper.cameras[0]
    effects = draw_effects(paper, make_part("flat"), WorldOptions(lenses=LensEffects(coma_px=4.0)), 3).cameras[camera.name]
    pinhole = World(paper, make_part("flat"), 3).truth().calibration.cameras.cameras[camera.name].pinhole
    seeing = SeeingCamera(pinhole, coma=effects.coma)
    rays = np.empty((2, 6), np.float32)
    row = camera.height_px // 2
    box = np.array([row, row + 1, camera.width_px - 2, camera.width_px])
    pixel_rays(0, 2, box, *seeing.parameters, np.eye(4), rays)
    origin, way = rays[0, :3].astype(float), rays[0, 3:].astype(float)
    edge = np.array([[camera.width_px - 2.0, row]])
    off = {}
    for depth in (paper.standoff_mm, paper.standoff_mm + 80.0):
        point = origin + way * (depth - origin[2]) / way[2]
        off[depth] = np.linalg.norm(pinhole.project(point[None]) - edge)
    scale = camera.width_px / 2592
    assert off[paper.standoff_mm] < 0.01
    assert 0.5 * 4.0 * scale < off[paper.standoff_mm + 80.0] < 1.4 * 4.0 * scale


def test_the_flange_creeps_after_a_move_and_comes_to_rest(paper: RigDescription, look_from: Callable[..., None]) -> None:
    options = WorldOptions(errors=RigErrors(axes=False), motions=AxisEffects(settling_mm=0.05, settling_s=3.0))
    still, creeping = (World(paper, make_part("flat"), 1, options=each) for each in (WorldOptions(errors=RigErrors(axes=False)), options))
    for world in (still, creeping):
        world.table_holds = "part"
        look_from(world, 5.0, 60.0)
        world.show(PLAIN_LIGHT)
    left = []
    for _ in range(3 * 40):  # 12 s
        left.append(np.linalg.norm((still.guide_from_camera().inverse() @ creeping.guide_from_camera()).translation_mm))
        creeping.image("left", EXPOSURE_US)
    assert left[0] == pytest.approx(0.05, abs=5e-4)
    assert left[30] == pytest.approx(0.05 * np.exp(-1), abs=6e-4)  # 30 images of one of three cameras: 3 s
    assert left[-1] < 0.002


def test_the_flange_stays_behind_by_half_its_play_along_every_axis_that_moved() -> None:
    behind = flange_play(np.array([0.0, 10.0, 5.0]), np.array([3.0, -10.0, 5.0]), 0.1)
    np.testing.assert_allclose(behind, [-0.05, 0.05, 0.0])
